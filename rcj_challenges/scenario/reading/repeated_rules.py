"""Rules that are written once and exist several times: ``repeat_for: [yellow, blue]``.

Works on the merged tree, before params are resolved: the rule is replaced, in its place in the order, by one for each
row. Whatever comes later knows those rules only, and that each value in them stands where the author wrote it.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace

from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.rules.fields import Scalar
from rcj_challenges.scenario.errors import listing, nearest, place_of
from rcj_challenges.scenario.messages.wording import NAME_RULE, format_node, quoted
from rcj_challenges.scenario.models.scenario import MAX_ROWS, Rule
from rcj_challenges.scenario.placeholders import PLACEHOLDERS, filled, placeholders_in
from rcj_challenges.scenario.reading.merge import Merger, Repeated, is_param
from rcj_challenges.scenario.reading.params import THIS, Resolver, params_of
from rcj_challenges.scenario.tree import Entries, Items, Leaf, Mark, Node, Path, Step, copied, in_names

RULES, REPEAT_FOR = "rules", "repeat_for"
_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")
_MAX_LETTERS = 64
_MAX_VALUES = 20_000
"""How many single values all that is repeated may come to: a file of 1 MB that repeats nothing has about as many."""
_FORMS = "a list of names, [yellow, blue], or a mapping of values by name, {yellow: {zone: blue_goal}, …}"


@dataclass
class _Row:
    """One of those for which a rule is written.

    Attributes:
        name: what it is called.
        mark: where its name stands.
        step: its key or its place in the list.
        written: what stands beside its name.
        key_marks: where the keys of that stand.
        values: what the names in the rule stand for.
    """

    name: str
    mark: Mark
    step: Step
    written: Mapping[str, Node] = field(default_factory=dict)
    key_marks: Mapping[str, Mark] = field(default_factory=dict)
    values: dict[str, Leaf | Items] = field(default_factory=dict)


def repeat_rules(root: Entries, merger: Merger) -> None:
    """Replace each rule with ``repeat_for`` by one for each of its rows; what is wrong is added to the problems."""
    rules = root.entries.get(RULES)
    if not isinstance(rules, Entries) or not any(_is_repeated(rule) for rule in rules.entries.values()):
        return
    fresh = Entries({}, rules.mark)
    root.entries[RULES] = fresh
    left = _MAX_VALUES
    taken = {name: rules.key_marks[name] for name, rule in rules.entries.items() if not _is_repeated(rule)}
    for name, rule in rules.entries.items():
        if not isinstance(rule, Entries) or not _is_repeated(rule):
            fresh.put(name, rule, rules.key_marks[name])
            continue
        rows = _Reader(root, name, merger.problems).rows(rule.entries[REPEAT_FOR], taken)
        rule.drop(REPEAT_FOR)
        left -= sum(_count(rule, row.values) for row in rows)
        if left < 0:
            message = f"too much is repeated: written out it would be more than {_MAX_VALUES} single values"
            merger.problems.append(rules.key_marks[name].error("scenario-too-large", message, "", f"{RULES}.{name}"))
            rows = []
        blanks = tuple(_blanks_in(rule))
        used = {*_params_in(rule), *blanks}
        for row in rows:
            unused = tuple(key for key in row.values if key not in used)
            filled_in = tuple(param for key in blanks for param in _params_of(row.values.get(key)))
            merger.repeated[_joined(name, row)] = Repeated(name, tuple(row.values), unused, filled_in)
            fresh.put(_joined(name, row), copied(rule), rules.key_marks[name])
            _fill(root, _joined(name, row), row.values, merger)
        if not rows:  # what is wrong with them is reported; what else is wrong in the rule can be reported too
            fresh.put(name, rule, rules.key_marks[name])
            known = params_of(root)
            unknown = (one for one in _params_in(rule) if one not in known)
            _fill(root, name, dict.fromkeys(unknown, Leaf(None, rule.mark)), merger)


def _is_repeated(rule: Node) -> bool:
    return isinstance(rule, Entries) and REPEAT_FOR in rule.entries


def _joined(rule: str, row: _Row) -> str:
    return f"{rule}_{row.name}"


def _count(node: Node, values: Mapping[str, Leaf | Items]) -> int:
    """Return how many single values stand in a tree when those of a row have been put in."""
    if isinstance(node, Leaf):
        return 1
    if isinstance(node, Items):
        return sum(_count(item, values) for item in node.items)
    name = node.entries.get("param")
    value = values.get(str(name.value)) if isinstance(name, Leaf) else None
    return (len(value.items) if isinstance(value, Items) else 0) + sum(
        _count(inner, values) for inner in node.entries.values()
    )


def _params_in(node: Node) -> Iterator[str]:
    """Yield the names of what is used like a param."""
    if isinstance(node, Entries):
        name = node.entries.get("param")
        if is_param(node) and isinstance(name, Leaf):
            yield str(name.value)
    inner = node.entries.values() if isinstance(node, Entries) else node.items if isinstance(node, Items) else ()
    for one in inner:
        yield from _params_in(one)


def _blanks_in(rule: Entries) -> Iterator[str]:
    """Yield what the sentence of a rule fills in before anything happens."""
    says = rule.entries.get("says")
    if isinstance(says, Leaf) and isinstance(says.value, str):
        yield from (name for name in placeholders_in(says.value) if name not in PLACEHOLDERS)


def _params_of(value: Leaf | Items | None) -> Iterator[str]:
    """Yield the params for which a value of a row stands."""
    for leaf in value.items if isinstance(value, Items) else (value,):
        if isinstance(leaf, Leaf) and leaf.param:
            yield leaf.param


def _fill(root: Entries, name: str, values: Mapping[str, Leaf | Items], merger: Merger) -> None:
    """Put the values of a row, and with them those of params, into a rule."""
    rules = root.entries[RULES]
    if not isinstance(rules, Entries):  # pragma: no cover - it has just been made
        return
    rule = Resolver(root, params_of(root), merger.problems, values).resolved(rules.entries[name], Rule, (RULES, name))
    rules.entries[name] = rule
    says = rule.entries.get("says") if isinstance(rule, Entries) else None
    if isinstance(says, Leaf) and isinstance(says.value, str):
        written = says.value
        # As for params, a placeholder that is filled in when the rule fires takes precedence over a value of its name.
        known = {key: _as_words(value) for key, value in values.items() if key not in PLACEHOLDERS}
        says.value = filled(says.value, {key: value for key, value in known.items() if value is not None})
        begins = known.get(THIS)
        if isinstance(begins, str) and written.startswith(f"{{{THIS}}}"):
            says.value = begins[:1].upper() + says.value[1:]


def _as_words(value: Leaf | Items) -> Scalar | list[Scalar] | None:
    """Return a value as it stands in a sentence, names with blanks."""
    if isinstance(value, Items):
        words = (_as_words(one) for one in value.items if isinstance(one, Leaf))
        return [one for one in words if one is not None and not isinstance(one, list)]
    return value.value.replace("_", " ") if isinstance(value.value, str) else value.value


class _Reader:
    """Reads the rows of one rule."""

    def __init__(self, root: Entries, rule: str, problems: list[Diagnostic]) -> None:
        self.root = root
        self.rule = rule
        self.problems = problems
        self.params = params_of(root)

    def rows(self, node: Node, taken: dict[str, Mark]) -> list[_Row]:
        """Return those rows for which a rule can be written.

        Args:
            node: what stands behind ``repeat_for``.
            taken: where the names of rules stand; those of the rows are added.
        """
        if is_param(node):
            self._add((), node.mark, "a param cannot stand here", f"write {_FORMS}")
            return []
        if isinstance(node, Leaf):
            if node.value is not None:  # else it has been reported as an empty value, or as a null
                self._add((), node.mark, f"expected names, found {format_node(node)}", f"write {_FORMS}")
            return []
        rows = list(self._listed(node) if isinstance(node, Items) else self._by_name(node))
        count = len(node.items if isinstance(node, Items) else node.entries)
        if not 1 <= count <= MAX_ROWS:
            amount = f"at most {MAX_ROWS} names" if count else "at least one name"
            self._add((), node.mark, f"must have {amount}, found {format_node(node)}", f"write {_FORMS}")
            return []
        self._hidden(rows)
        self._same_keys(rows)
        keys = dict.fromkeys(key for row in rows for key in row.written)
        for row in rows:
            self._read(row, keys)
        return [row for row in rows if self._is_free(row, taken)]

    def _listed(self, node: Items) -> Iterator[_Row]:
        seen: set[str] = set()
        for index, item in enumerate(node.items):
            if isinstance(item, Leaf) and item.value is None:
                continue  # reported as an empty entry
            if not isinstance(item, Leaf) or not isinstance(item.value, str):
                self._add((index,), item.mark, f"expected a name, found {format_node(item)}")
            elif item.value in seen:
                self._add((index,), item.mark, f"'{item.value}' stands here twice")
            elif self._is_name(item.value, (index,), item.mark):
                seen.add(item.value)
                yield _Row(item.value, item.mark, index)

    def _by_name(self, node: Entries) -> Iterator[_Row]:
        for name, inner in node.entries.items():
            mark = node.key_marks[name]
            if isinstance(inner, Entries) and len(inner.entries) > MAX_ROWS:
                self._add((name,), mark, f"must have at most {MAX_ROWS} values, found {len(inner.entries)}")
            elif isinstance(inner, Entries):
                if self._is_name(name, (name,), mark):
                    yield _Row(name, mark, name, inner.entries, inner.key_marks)
            elif not isinstance(inner, Leaf) or inner.value is not None:
                message = f"expected a mapping with the values of '{name}', found {format_node(inner)}"
                self._add((name,), inner.mark, message)

    def _is_name(self, name: str, at: Path, mark: Mark) -> bool:
        if _NAME.fullmatch(name) and len(name) <= _MAX_LETTERS:
            return True
        self._add(at, mark, f"{quoted(name)} is not a name", f"write {NAME_RULE}")
        return False

    def _hidden(self, rows: list[_Row]) -> None:
        """Refuse what would hide something: in one file a name should not mean two things."""
        params = self.root.entries.get("params")
        where = params.key_marks if isinstance(params, Entries) else {}
        if THIS in self.params:
            message = "in a rule with repeat_for 'this' is the name for which it is repeated"
            self.problems.append(
                where[THIS].error("name-taken", message, "give the param another name", f"params.{THIS}")
            )
        reported: set[str] = set()
        for row in rows:
            for key in row.written:
                mark = row.key_marks[key]
                if key == THIS:
                    self._add((row.step, key), mark, f"'this' is '{row.name}' itself", "choose another key")
                elif self._is_name(key, (row.step, key), mark) and key in self.params and key not in reported:
                    reported.add(key)
                    message = f"'{key}' is a param of the scenario already{_line(where[key], mark)}"
                    self._add((row.step, key), mark, message, "choose another key")

    def _same_keys(self, rows: list[_Row]) -> None:
        """Report names that have other keys than most; if as many have one set of keys as another, the first counts."""
        if not rows:
            return
        ((usual, _),) = Counter(frozenset(row.written) for row in rows).most_common(1)
        like = next(row for row in rows if row.written.keys() == usual)
        help_ = f"all names need the same keys: {listing(like.written) or 'none'}"
        for row in rows:
            missing = [key for key in like.written if key not in row.written]
            for key in (key for key in row.written if key not in like.written):
                near = nearest(key, missing)
                missing = [one for one in missing if one != near]
                hint = f"did you mean '{near}'? " if near else ""
                self._add((row.step, key), row.key_marks[key], f"'{like.name}' has no '{key}'", f"{hint}{help_}")
            for key in missing:
                message = f"'{key}' is missing, which '{like.name}' has{_line(like.key_marks[key], row.mark)}"
                self._add((row.step,), row.mark, message, help_)

    def _read(self, row: _Row, keys: Iterable[str]) -> None:
        # What a name lacks is reported once, not again wherever it is used.
        row.values = {THIS: Leaf(row.name, row.mark), **{key: Leaf(None, row.mark) for key in keys if key != THIS}}
        for key, node in row.written.items():
            if key != THIS:
                row.values[key] = self._value(node, (row.step, key))

    def _value(self, node: Node, at: Path) -> Leaf | Items:
        """Return a single value or a list of them, params in it resolved."""
        if isinstance(node, Items):
            found = [self._single(item, (*at, index), "a single value") for index, item in enumerate(node.items)]
            return Items([*found], node.mark)
        return self._single(node, at, "a single value or a list of single values")

    def _single(self, node: Node, at: Path, wanted: str) -> Leaf:
        if isinstance(node, Leaf):
            return node
        if isinstance(node, Entries) and is_param(node):
            value = Resolver(self.root, self.params, self.problems).stood_for(node, self._path(at))
            return value if isinstance(value, Leaf) else Leaf(None, node.mark)
        self._add(at, node.mark, f"expected {wanted}, found {format_node(node)}")
        return Leaf(None, node.mark)

    def _is_free(self, row: _Row, taken: dict[str, Mark]) -> bool:
        name = _joined(self.rule, row)
        known = taken.setdefault(name, row.mark)
        if known is not row.mark:
            line = _line(known, row.mark)
            message = f"its rule would have the name '{name}' of another rule{line}"
            self._add((row.step,), row.mark, message, "rename one")
        return known is row.mark

    def _path(self, at: Path) -> Path:
        return (RULES, self.rule, REPEAT_FOR, *at)

    def _add(self, at: Path, mark: Mark, message: str, help_: str = "") -> None:
        self.problems.append(mark.error("wrong-repeat", message, help_, in_names(self.root, self._path(at))))


def _line(other: Mark, here: Mark) -> str:
    if not other.line:
        return ""
    return f" (line {other.line})" if other.file == here.file else f" ({other.file}:{other.line})"


# --- errors and warnings about repeated rules -------------------------------------------------------------------------


def merged(problems: Iterable[Diagnostic], repeated: Mapping[str, Repeated]) -> list[Diagnostic]:
    """Return problems in their order; the same one of several rules that came from one is reported once, of that one.

    Args:
        problems: each at its place, with the path of the rule that it is about.
        repeated: where each rule comes from that is one of a repeated one.
    """
    found = list(problems)
    of_written = [_of_written(problem, repeated) for problem in found]
    about: dict[Diagnostic, dict[str, str]] = {}
    for problem, written in zip(found, of_written, strict=True):
        about.setdefault(written, {})[place_of(problem).path] = _rule_of(problem)
    alike = (
        _about_some(written, about[written].values(), repeated) if len(about[written]) > 1 else problem
        for problem, written in zip(found, of_written, strict=True)
    )
    return list(dict.fromkeys(alike))


def _about_some(written: Diagnostic, names: Iterable[str], repeated: Mapping[str, Repeated]) -> Diagnostic:
    """Return a problem of a written rule with the names of those of its rules that have it, unless all have."""
    of_all = {name for name, one in repeated.items() if one.rule == _rule_of(written)}
    which = "" if of_all <= set(names) else f" ({listing(dict.fromkeys(names))})"
    return replace(written, message=written.message + which)


def _rule_of(problem: Diagnostic) -> str:
    """Return the name of the rule that a problem is about."""
    return re.split(r"[.\[]", place_of(problem).path.partition(".")[2], maxsplit=1)[0]


def _of_written(problem: Diagnostic, repeated: Mapping[str, Repeated]) -> Diagnostic:
    """Return a problem as if the rule that the author wrote had it."""
    place, name = place_of(problem), _rule_of(problem)
    section, _, rest = place.path.partition(".")
    if section != RULES or name not in repeated:
        return problem
    rule = repeated[name].rule
    message, help_ = (re.sub(rf"\b{re.escape(name)}\b", rule, text) for text in (problem.message, problem.help))
    where = replace(place, path=f"{RULES}.{rule}{rest[len(name) :]}")
    return replace(problem, message=message, help=help_, where=where)
