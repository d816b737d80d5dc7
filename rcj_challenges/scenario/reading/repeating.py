"""Entries that are written once and exist for each row of a table: ``repeat_for: teams``.

Works on the merged tree, before params are resolved: the entry is replaced, in its place in the order, by one for each
row. Whatever comes later knows those only, and that each value in them stands where the author wrote it.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import replace
from itertools import product
from math import prod
from operator import itemgetter
from typing import NamedTuple

from rcj_challenges.core.amounts import Noun
from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.rules.fields import Scalar
from rcj_challenges.scenario.codes import NAME_TAKEN, SCENARIO_TOO_LARGE, WRONG_REPEAT
from rcj_challenges.scenario.errors import choice_of, did_you_mean, listing, place_of
from rcj_challenges.scenario.messages.wording import format_node
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.placeholders import PLACEHOLDERS, fill_generally, filled, placeholders_in
from rcj_challenges.scenario.reading.merge import REPEAT_FOR, Merger, Repeated, is_param
from rcj_challenges.scenario.reading.params import THIS, Resolver, params_of
from rcj_challenges.scenario.shape import Shape, step_into
from rcj_challenges.scenario.tree import (
    Entries,
    Items,
    Leaf,
    Mark,
    Node,
    Path,
    child,
    copied,
    entries_of,
    in_names,
    items_of,
    mark_of,
    node_at,
    nodes_in,
    value_of,
)

RULES, TABLES, GROUPS, LAYOUTS = "rules", "tables", "groups", "placements"
_ON_FIELD = frozenset({"robots", "balls", "obstacles", "zones", "gates", "spots"})
_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]{0,63}")
_MAX_VALUES = 20_000
"""How many values all that is repeated may come to: a file of 1 MB that repeats nothing has about as many."""
_FORM = "write tables: {teams: {yellow: {zone: blue_goal}, blue: {zone: yellow_goal}}} and repeat_for: teams"

_Values = Mapping[str, Leaf | Items]


class _Row(NamedTuple):
    """A row of a table, or one row each of several.

    Attributes:
        kinds: of each table the words for any of its rows: `team`.
        names: of each table the row.
        values: what the names of params stand for.
        other: the same of the other row, where a table has two.
    """

    kinds: Mapping[str, str]
    names: tuple[str, ...]
    values: _Values
    other: _Values

    @property
    def name(self) -> str:
        """What is put behind the name of an entry."""
        return "_".join(self.names)


def repeat_entries(root: Entries, merger: Merger) -> None:
    """Replace what has ``repeat_for`` by one for each row of its table; what is wrong is added to the problems."""
    copier = _Copier(root, merger)
    for path in (*((section,) for section in list(root.entries)), ("broadcast", "fields")):
        node = node_at(root, path)
        if isinstance(node, Entries) and path[0] not in (TABLES, "params"):
            copier.copy_named(node, path)
    for name, layout in entries_of(root.entries.get(LAYOUTS)).items():
        if isinstance(layout, Items):
            copier.copy_listed(layout, (LAYOUTS, name))


class _Copier:
    """Puts copies in the place of what is repeated."""

    def __init__(self, root: Entries, merger: Merger) -> None:
        self.root = root
        self.merger = merger
        self.problems = merger.problems
        self.params = params_of(root)
        self.left = _MAX_VALUES
        self.tables: dict[str, list[tuple[str, _Values]]] = {}
        self.taken: set[str] = set()

    def copy_named(self, section: Entries, path: Path) -> None:
        """Put copies, each under a name of its own, into a section."""
        if not any(_is_repeated(entry) for entry in section.entries.values()):
            return
        before, marks = dict(section.entries), dict(section.key_marks)
        section.entries.clear()
        taken = {name: marks[name] for name, entry in before.items() if not _is_repeated(entry)}
        for name, entry in before.items():
            if not isinstance(entry, Entries) or not _is_repeated(entry):
                section.put(name, entry, marks[name])
                continue
            shape = step_into(self._shape(path), Entries(before, section.mark), name)
            at, mark = (*path, name), marks[name]
            rows = [row for row in self._rows(entry, at) if self._is_free(at, row, taken, mark)]
            for row in rows:
                full = f"{name}_{row.name}"
                self.merger.repeated[str(path[0]), full] = Repeated(name, tuple(row.values))
                section.put(full, copied(entry), mark)  # before it is filled: errors name their place in it
                section.put(full, self._filled(section.entries[full], shape, (*path, full), row), mark)
            if not rows:  # what is wrong with them is reported; what else is wrong in the entry can be reported too
                section.put(name, entry, mark)
                section.put(name, self._unfilled(entry, shape, at), mark)
            elif path[0] in _ON_FIELD:
                self._group(name, rows, mark)

    def copy_listed(self, layout: Items, path: Path) -> None:
        """Put copies into a list."""
        shape, written = self._shape(path), list(layout.items)
        layout.items.clear()
        for index, entry in enumerate(written):
            if not isinstance(entry, Entries) or not _is_repeated(entry):
                layout.items.append(entry)
                continue
            at, inner = (*path, index), step_into(shape, Items(written, layout.mark), index)
            rows = self._rows(entry, at)
            layout.items += [self._filled(copied(entry), inner, at, row) for row in rows]
            layout.items += [] if rows else [self._unfilled(entry, inner, at)]

    def _shape(self, path: Path) -> Shape:
        shape: Shape = Scenario
        for depth, step in enumerate(path):
            above = node_at(self.root, path[:depth])
            shape = None if above is None else step_into(shape, above, step)
        return shape

    def _group(self, name: str, rows: list[_Row], mark: Mark) -> None:
        """Let a name stand for all its copies; of crossed tables, the name with a row for those of this row."""
        groups = self.root.entries.setdefault(GROUPS, Entries({}, mark))
        parts = {name: rows}
        for one in dict.fromkeys(one for row in rows if len(row.names) > 1 for one in row.names):
            parts[f"{name}_{one}"] = [row for row in rows if one in row.names]
        for group, members in parts.items():
            if isinstance(groups, Entries) and group not in groups.entries:
                groups.put(group, Items([Leaf(f"{name}_{row.name}", mark) for row in members], mark), mark)

    def _is_free(self, at: Path, row: _Row, taken: dict[str, Mark], mark: Mark) -> bool:
        name = f"{at[-1]}_{row.name}"
        known = taken.setdefault(name, mark)
        if known is not mark:
            message = f"its copy would have the name '{name}' of another entry{_line(known, mark)}"
            self._add(at, mark, message, "rename one")
        return known is mark

    # --- rows ---------------------------------------------------------------------------------------------------------

    def _rows(self, entry: Entries, path: Path) -> list[_Row]:
        """Return the rows for which an entry exists, and take ``repeat_for`` out of it."""
        written, at = entry.entries[REPEAT_FOR], (*path, REPEAT_FOR)
        entry.drop(REPEAT_FOR)
        if isinstance(written, Leaf) and written.value is None:
            return []  # it has been reported as an empty value
        items = written.items if isinstance(written, Items) else [written]
        named = {one.value: one for one in items if isinstance(one, Leaf) and isinstance(one.value, str)}
        if not named or len(named) != len(items):
            self._add(at, written.mark, f"expected the name of a table, found {format_node(written)}", _FORM)
            return []
        tables: list[list[tuple[str, _Values]]] = []
        for name, one in named.items():
            tables.append(self._table(name, one.mark, at))
            if not tables[-1]:
                return []
        columns = [(name, len(items_of(value))) for table in tables for _, row in table for name, value in row.items()]
        longest = dict(sorted(columns, key=itemgetter(1)))  # of a column, in the row where its list is the longest
        size = sum(1 + longest.get(str(value_of(child(one, "param"))), 0) for one in nodes_in(entry))
        self.left -= size * prod(map(len, tables))
        if self.left < 0:
            message = f"too much is repeated: written out it would be more than {_MAX_VALUES} single values"
            self.problems.append(written.mark.error(SCENARIO_TOO_LARGE, message, "", in_names(self.root, path)))
            return []
        kinds = {one: self._kind(one) for one in named}
        return [_crossed(kinds, of_tables, tables) for of_tables in product(*tables)]

    def _kind(self, table: str) -> str:
        is_teams = {row for row, _ in self.tables[table]} <= entries_of(self.root.entries.get("entrants")).keys()
        return "team" if is_teams else table.replace("_", " ").removesuffix("s")

    def _table(self, name: str, mark: Mark, at: Path) -> list[tuple[str, _Values]]:
        """Return the rows of a table by name, with the values of their columns; what is malformed is left out."""
        if name in self.tables:
            return self.tables[name]
        table = node_at(self.root, (TABLES, name))
        if not isinstance(table, Entries):
            if table is None:
                known = entries_of(self.root.entries.get(TABLES))
                self._add(at, mark, f"unknown table '{name[:64]}'", choice_of(name, known, "table") if known else _FORM)
            return []
        rows = {
            row: inner for row, inner in table.entries.items() if isinstance(inner, Entries) and _NAME.fullmatch(row)
        }
        self._check_columns(name, table, rows)
        columns = dict.fromkeys(key for row in rows.values() for key in row.entries if key not in (THIS, name))
        found: list[tuple[str, _Values]] = []
        for row, inner in rows.items():
            own = {key: self._value(one, (TABLES, name, row, key)) for key, one in inner.entries.items()}
            # What a row lacks is reported once, not again wherever it is used.
            is_named = {THIS: Leaf(row, inner.mark), name: Leaf(row, inner.mark)}
            found.append((row, is_named | {key: own.get(key, Leaf(None, inner.mark)) for key in columns}))
        self.tables[name] = found
        return found

    def _check_columns(self, table: str, node: Entries, rows: Mapping[str, Entries]) -> None:
        """Refuse columns that would hide something, and rows that have other columns than the first one."""
        for name in [one for one in (THIS, table) if one in self.params and one not in self.taken]:
            self.taken.add(name)
            message = f"'{name}' is the row for which an entry of table '{table}' is repeated"
            mark = mark_of(self.root, ("params", name), at_key=True)
            self.problems.append(mark.error(NAME_TAKEN, message, "give the param another name", f"params.{name}"))
        first = next(iter(rows), "")
        usual = rows[first].entries if rows else {}
        hidden: set[str] = set()
        for row, inner in rows.items():
            help_, at = f"all rows need the same columns: {listing(usual) or 'none'}", (TABLES, table, row)
            missing = [key for key in usual if key not in inner.entries]
            surplus = [key for key in inner.entries if key not in usual]
            for key, mark in inner.key_marks.items():
                message = f"'{key}' is '{row}' itself" if key in (THIS, table) else ""
                if not message and key in self.params and key not in hidden:
                    hidden.add(key)
                    param = mark_of(self.root, ("params", key), at_key=True)
                    message = f"'{key}' is a param of the scenario already{_line(param, mark)}"
                if message:
                    self._add((*at, key), mark, message, "choose another name for the column")
            for key in surplus:
                hint = did_you_mean(key, missing, help_)
                self._add((*at, key), inner.key_marks[key], f"'{first}' has no '{key}'", hint)
            if missing and not surplus:
                self._add(at, node.key_marks[row], f"'{missing[0]}' is missing, which '{first}' has", help_)

    def _value(self, node: Node, path: Path) -> Leaf | Items:
        """Return a single value or a list of them, params in it resolved; what is neither is reported as such."""
        if isinstance(node, Items):
            found = (self._value(item, (*path, index)) for index, item in enumerate(node.items))
            return Items([one for one in found if isinstance(one, Leaf)], node.mark)
        if isinstance(node, Entries) and is_param(node):
            value = Resolver(self.root, self.params, self.problems).stood_for(node, path)
            return value if isinstance(value, Leaf) else Leaf(None, node.mark)
        return node if isinstance(node, Leaf) else Leaf(None, node.mark)

    # --- copies -------------------------------------------------------------------------------------------------------

    def _filled(self, entry: Node, shape: Shape, path: Path, row: _Row) -> Node:
        """Return an entry with the values of a row, and with them those of params, put into it."""
        resolver = Resolver(self.root, self.params, self.problems, row.values, row.other)
        found = resolver.resolved(entry, shape, path)
        if isinstance(found, Entries) and path[0] == RULES:
            _fill_sentences(found, row)
        return found

    def _unfilled(self, entry: Entries, shape: Shape, path: Path) -> Node:
        uses = [str(value_of(child(one, "param"))) for one in nodes_in(entry) if is_param(one)]
        unknown = {one: Leaf(None, entry.mark) for one in uses if one not in self.params}
        return self._filled(entry, shape, path, _Row({}, (), unknown, unknown))

    def _add(self, at: Path, mark: Mark, message: str, help_: str = "") -> None:
        self.problems.append(mark.error(WRONG_REPEAT, message, help_, in_names(self.root, at)))


def _crossed(
    kinds: Mapping[str, str], rows: tuple[tuple[str, _Values], ...], tables: list[list[tuple[str, _Values]]]
) -> _Row:
    """Return one row of each of several tables as one; only a single table has ``this``."""
    values: dict[str, Leaf | Items] = {}
    other: dict[str, Leaf | Items] = {}
    for (name, own), table in zip(rows, tables, strict=True):
        values |= own
        other |= next((one for row, one in table if row != name), {}) if len(table) == 2 else {}
    if len(rows) > 1:
        values.pop(THIS, None)
        other.pop(THIS, None)
    return _Row(kinds, tuple(name for name, _ in rows), values, other)


def _fill_sentences(rule: Entries, row: _Row) -> None:
    """Fill in the values of a row in what a rule says; for the rule sheet general words for names, and numbers."""
    # As for params, a placeholder that is filled in when the rule fires takes precedence over a column.
    known = {key: _as_words(value) for key, value in row.values.items() if key not in PLACEHOLDERS}
    values = {key: value for key, value in known.items() if value is not None}
    says, sheet = rule.entries.get("says"), rule.entries.get("sheet")
    shown = sheet or says
    if isinstance(shown, Leaf) and isinstance(shown.value, str) and {*placeholders_in(shown.value)} & {*known}:
        rule.put("sheet", Leaf(fill_generally(shown.value, _in_general(row, values)), shown.mark), shown.mark)
    if isinstance(says, Leaf) and isinstance(says.value, str):
        begins, written = values.get(THIS), says.value
        says.value = filled(written, values)
        if isinstance(begins, str) and written.startswith(f"{{{THIS}}}"):
            says.value = begins[:1].upper() + says.value[1:]


def _in_general(row: _Row, values: Mapping[str, Scalar | list[Scalar]]) -> dict[str, tuple[str, str]]:
    """Return words for a row and its names that are true for every row, ``a team``, ``its basket``, and its numbers."""
    found = {
        key: (f"its {key.replace('_', ' ')}" if isinstance(value, str | list) else filled(f"{{{key}}}", values),) * 2
        for key, value in values.items()
    }
    found |= {table: (Noun(kind, table).a, f"the {kind}") for table, kind in row.kinds.items()}
    return found | ({THIS: found[next(iter(row.kinds))]} if len(row.kinds) == 1 else {})


def _is_repeated(entry: Node) -> bool:
    return REPEAT_FOR in entries_of(entry)


def _as_words(value: Leaf | Items) -> Scalar | list[Scalar] | None:
    """Return a value as it stands in a sentence, names with blanks."""
    if isinstance(value, Items):
        words = (_as_words(one) for one in value.items if isinstance(one, Leaf))
        return [one for one in words if one is not None and not isinstance(one, list)]
    return value.value.replace("_", " ") if isinstance(value.value, str) else value.value


def _line(other: Mark, here: Mark) -> str:
    if not other.line:
        return ""
    return f" (line {other.line})" if other.file == here.file else f" ({other.file}:{other.line})"


# --- errors and warnings about what is repeated -----------------------------------------------------------------------


def merged(problems: Iterable[Diagnostic], repeated: Mapping[tuple[str, str], Repeated]) -> list[Diagnostic]:
    """Return problems in their order; the same one of several copies of one entry is reported once, of it."""
    about: dict[Diagnostic, dict[str, Diagnostic]] = {}
    for problem in problems:
        about.setdefault(_of_written(problem, repeated), {})[entry_of(problem)[1]] = problem
    found: list[Diagnostic] = []
    for written, copies in about.items():
        of_all = {name for (section, name), one in repeated.items() if (section, one.entry) == entry_of(written)}
        if len(copies) == 1:
            found += copies.values()
        elif of_all <= copies.keys():
            found.append(written)
        else:
            found.append(replace(written, message=f"{written.message} ({listing(sorted(copies))})"))
    return found


def entry_of(problem: Diagnostic) -> tuple[str, str]:
    """Return the section and the name of the entry that a problem is about."""
    section, _, rest = place_of(problem).path.partition(".")
    return section, re.split(r"[.\[]", rest, maxsplit=1)[0]


def _of_written(problem: Diagnostic, repeated: Mapping[tuple[str, str], Repeated]) -> Diagnostic:
    """Return a problem as if the entry that the author wrote had it."""
    place, (section, name) = place_of(problem), entry_of(problem)
    if (section, name) not in repeated:
        return problem
    entry = repeated[section, name].entry
    message, help_ = (re.sub(rf"\b{re.escape(name)}\b", entry, text) for text in (problem.message, problem.help))
    path = f"{section}.{entry}{place.path[len(section) + 1 + len(name) :]}"
    return replace(problem, message=message, help=help_, where=replace(place, path=path))
