"""Rules that are written once and exist several times: ``repeat_for: [yellow, blue]``.

Works on the merged tree, before params are resolved: the rule is replaced, in its place in the order, by one for each
row. Whatever comes later knows those rules only, and that each value in them stands where the author wrote it.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace

from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.rules.fields import NAME_RULE, Scalar
from rcj_challenges.scenario.codes import NAME_TAKEN, SCENARIO_TOO_LARGE, WRONG_REPEAT
from rcj_challenges.scenario.errors import did_you_mean, listing, place_of
from rcj_challenges.scenario.messages.wording import format_node, quoted
from rcj_challenges.scenario.models.scenario import MAX_ROWS, Rule
from rcj_challenges.scenario.placeholders import PLACEHOLDERS, filled
from rcj_challenges.scenario.reading.merge import Merger, Repeated, is_param
from rcj_challenges.scenario.reading.params import THIS, Resolver, params_of
from rcj_challenges.scenario.tree import Entries, Items, Leaf, Mark, Node, Path, Step, copied, in_names, nodes_in

RULES, REPEAT_FOR = "rules", "repeat_for"
_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]{0,63}")
_MAX_VALUES = 20_000
"""How many values all that is repeated may come to: a file of 1 MB that repeats nothing has about as many."""
_FORMS = "write a list of names, [yellow, blue], or a mapping of values by name, {yellow: {zone: blue_goal}, …}"


@dataclass
class _Row:
    """One of those for which a rule is written."""

    name: str
    mark: Mark  # where its name stands
    step: Step  # its key or its place in the list
    written: Entries  # what stands beside its name
    values: dict[str, Leaf | Items] = field(default_factory=dict)  # what the names in the rule stand for


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
        uses = [str(one.entries["param"].value) for one in nodes_in(rule) if is_param(one)]  # type: ignore[union-attr]
        left -= sum(sum(1 for _ in nodes_in(rule)) + _listed_in(row.values, uses) for row in rows)
        if left < 0:
            message = f"too much is repeated: written out it would be more than {_MAX_VALUES} single values"
            merger.problems.append(rules.key_marks[name].error(SCENARIO_TOO_LARGE, message, "", f"{RULES}.{name}"))
            rows = []
        for row in rows:
            merger.repeated[f"{name}_{row.name}"] = Repeated(name, tuple(row.values))
            fresh.put(f"{name}_{row.name}", copied(rule), rules.key_marks[name])
            _fill(root, f"{name}_{row.name}", row.values, merger)
        if not rows:  # what is wrong with them is reported; what else is wrong in the rule can be reported too
            fresh.put(name, rule, rules.key_marks[name])
            known = params_of(root)
            _fill(root, name, {one: Leaf(None, rule.mark) for one in uses if one not in known}, merger)


def _is_repeated(rule: Node) -> bool:
    return isinstance(rule, Entries) and REPEAT_FOR in rule.entries


def _listed_in(values: Mapping[str, Leaf | Items], uses: Iterable[str]) -> int:
    """Return the number of single values from lists that stand where some params are used."""
    lists = (values.get(name) for name in uses)
    return sum(len(one.items) for one in lists if isinstance(one, Items))


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
        says.value = filled(written, {key: value for key, value in known.items() if value is not None})
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
        if isinstance(node, Leaf) or is_param(node):
            if not isinstance(node, Leaf) or node.value is not None:  # else it has been reported as an empty value
                self._add((), node.mark, f"expected names, found {format_node(node)}", _FORMS)
            return []
        steps: Iterable[tuple[Step, Node]] = enumerate(node.items) if isinstance(node, Items) else node.entries.items()
        rows = [row for step, inner in steps if (row := self._row(node, step, inner)) is not None]
        count = len(node.items if isinstance(node, Items) else node.entries)
        if not 1 <= count <= MAX_ROWS:
            amount = f"at most {MAX_ROWS} names" if count else "at least one name"
            self._add((), node.mark, f"must have {amount}, found {format_node(node)}", _FORMS)
            return []
        self._check_keys(rows)
        keys = dict.fromkeys(key for row in rows for key in row.written.entries if key != THIS)
        for row in rows:
            own = {key: self._value(inner, (row.step, key)) for key, inner in row.written.entries.items()}
            # What a name lacks is reported once, not again wherever it is used.
            row.values = {THIS: Leaf(row.name, row.mark), **{key: own.get(key, Leaf(None, row.mark)) for key in keys}}
        return [row for row in rows if self._is_free(row, taken)]

    def _row(self, node: Items | Entries, step: Step, inner: Node) -> _Row | None:
        """Return the row for an entry of a list or a mapping; None if it is wrong."""
        if isinstance(inner, Leaf) and inner.value is None:
            return None  # reported as an empty entry
        is_listed = isinstance(node, Items)
        name = inner.value if isinstance(inner, Leaf) and is_listed else step
        mark = node.key_marks[str(step)] if isinstance(node, Entries) else inner.mark
        written = inner if isinstance(inner, Entries) and not is_listed else Entries({}, mark)
        if isinstance(inner, Leaf) is not is_listed or not isinstance(name, str) or isinstance(inner, Items):
            wanted = "a name" if is_listed else f"a mapping with the values of '{step}'"
            self._add((step,), inner.mark, f"expected {wanted}, found {format_node(inner)}")
        elif len(written.entries) > MAX_ROWS:
            self._add((step,), mark, f"must have at most {MAX_ROWS} values, found {len(written.entries)}")
        elif self._is_name(name, (step,), mark):
            return _Row(name, mark, step, written)
        return None

    def _is_name(self, name: str, at: Path, mark: Mark) -> bool:
        if _NAME.fullmatch(name):
            return True
        self._add(at, mark, f"{quoted(name)} is not a name", f"write {NAME_RULE}")
        return False

    def _check_keys(self, rows: list[_Row]) -> None:
        """Refuse values that would hide something, and names that have other keys than the first one."""
        params = self.root.entries.get("params")
        where = params.key_marks if isinstance(params, Entries) else {}
        if THIS in where:
            message = "in a rule with repeat_for 'this' is the name for which it is repeated"
            help_ = "give the param another name"
            self.problems.append(where[THIS].error(NAME_TAKEN, message, help_, f"params.{THIS}"))
        hidden: set[str] = set()
        for row in rows:
            usual, marks = rows[0].written.entries, row.written.key_marks
            help_ = f"all names need the same keys: {listing(usual) or 'none'}"
            surplus = [key for key in row.written.entries if key not in usual]
            missing = [key for key in usual if key not in row.written.entries]
            for key, mark in marks.items():
                if key == THIS:
                    self._add((row.step, key), mark, f"'this' is '{row.name}' itself", "choose another key")
                elif self._is_name(key, (row.step, key), mark) and key in where and key not in hidden:
                    hidden.add(key)
                    message = f"'{key}' is a param of the scenario already{_line(where[key], mark)}"
                    self._add((row.step, key), mark, message, "choose another key")
            for key in surplus:
                message = f"'{rows[0].name}' has no '{key}'"
                self._add((row.step, key), marks[key], message, f"{did_you_mean(key, missing)} {help_}".strip())
            if missing and not surplus:
                message = f"'{missing[0]}' is missing, which '{rows[0].name}' has"
                self._add((row.step,), row.mark, message, help_)

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
        name = f"{self.rule}_{row.name}"
        known = taken.setdefault(name, row.mark)
        if known is not row.mark:
            message = f"its rule would have the name '{name}' of another rule{_line(known, row.mark)}"
            self._add((row.step,), row.mark, message, "rename one")
        return known is row.mark

    def _path(self, at: Path) -> Path:
        return (RULES, self.rule, REPEAT_FOR, *at)

    def _add(self, at: Path, mark: Mark, message: str, help_: str = "") -> None:
        self.problems.append(mark.error(WRONG_REPEAT, message, help_, in_names(self.root, self._path(at))))


def _line(other: Mark, here: Mark) -> str:
    if not other.line:
        return ""
    return f" (line {other.line})" if other.file == here.file else f" ({other.file}:{other.line})"


# --- errors and warnings about repeated rules -------------------------------------------------------------------------


def merged(problems: Iterable[Diagnostic], repeated: Mapping[str, Repeated]) -> list[Diagnostic]:
    """Return problems in their order; the same one of several rules that came from one is reported once, of it."""
    pairs = [(problem, _of_written(problem, repeated)) for problem in problems]
    about: dict[Diagnostic, set[str]] = {}
    for problem, written in pairs:
        about.setdefault(written, set()).add(_rule_of(problem))
    found: dict[Diagnostic, None] = {}
    for problem, written in pairs:
        names = sorted(about[written])
        of_all = {name for name, one in repeated.items() if one.rule == _rule_of(written)}
        which = "" if of_all <= about[written] else f" ({listing(names)})"
        found[problem if len(names) == 1 else replace(written, message=written.message + which)] = None
    return list(found)


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
    return replace(
        problem, message=message, help=help_, where=replace(place, path=f"{RULES}.{rule}{rest[len(name) :]}")
    )
