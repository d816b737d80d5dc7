"""Params and overrides: ``{param: NAME}`` for any single value, ``--set PATH=VALUE`` from the command line.

``{param: gap_m, times: -1, plus: 0.02}`` is the param times a number plus a number.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from decimal import Context
from math import isfinite
from typing import get_origin

from rcj_challenges.core.amounts import plain
from rcj_challenges.core.code import Code
from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.scenario.codes import UNKNOWN_PARAM, WRONG_OVERRIDE, WRONG_PARAM_USE
from rcj_challenges.scenario.errors import ScenarioError, choice_of, cut
from rcj_challenges.scenario.messages.wording import expected, format_node
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.reading.merge import Merger, is_param, make_way, of_repeated
from rcj_challenges.scenario.reading.yaml_strict import INT_LIMIT, parse_value
from rcj_challenges.scenario.shape import (
    Shape,
    bare,
    chosen,
    fields,
    is_model,
    is_named,
    may_be_scalar,
    members,
    step_into,
)
from rcj_challenges.scenario.tree import (
    Entries,
    Items,
    Leaf,
    Mark,
    Node,
    Path,
    child,
    entries_of,
    in_names,
    nodes_in,
    value_of,
)

THIS = "this"
"""What the name of a row is called within a repeated rule."""
KEYS = ("param", "times", "plus", "of")
_WORD = re.compile(r"[A-Za-z_]\w*", re.ASCII)
_PATH = re.compile(r"[^.\[\]]+(\.[^.\[\]]+|\[\d+\])*")
_EXACT = Context(prec=60)
"""More digits than a product of two numbers of a file has, so that only the result is rounded, to a float."""
_MAX_EXACT = 2**53
"""Up to here each whole number is a float."""


# --- overrides --------------------------------------------------------------------------------------------------------


def apply_overrides(root: Entries, overrides: Sequence[str], merger: Merger, *, is_resolved: bool = False) -> None:
    """Change the merged tree as the command line asks; what cannot be is added to the merger's problems.

    In one that is resolved no param can be set: that would have no effect.
    """
    for override in overrides:
        mark = Mark(f"--set {override if len(override) <= 80 else override[:77] + '...'}")
        path, equals, text = override.partition("=")
        try:
            if not equals or not path.strip() or not text.strip():
                raise _refused("expected PATH=VALUE", "PATH is a param's name, or a path such as match.half_s")
            if is_resolved and sets_param(root, override):
                help_ = "set the value where it is used, or name the scenario's file"
                raise _refused("the values of params are filled in already where they are used", help_)
            value = parse_value(text, mark.file)
            for node in nodes_in(value):  # they stand in no line of a file
                node.mark = mark
                if isinstance(node, Entries):
                    node.key_marks = dict.fromkeys(node.entries, mark)
            _set(root, _steps(path.strip(), root), value, mark, merger)
        except ScenarioError as error:
            merger.problems += [mark.error(one.code, one.message, one.help) for one in error.diagnostics]


def sets_param(root: Entries, override: str) -> bool:
    """Return whether an override sets a param, or all of them."""
    first, _, rest = override.partition("=")[0].strip().partition(".")
    return first == "params" or (first in params_of(root) and not rest)  # one may be called like a section


def _refused(message: str, help_: str = "") -> ScenarioError:
    return ScenarioError([Mark("").error(WRONG_OVERRIDE, message, help_)])


def _steps(text: str, root: Entries) -> list[str]:
    steps = re.findall(r"[^.\[\]]+", text)
    if not _PATH.fullmatch(text) or len(steps) > 30:
        help_ = "write names with dots and list entries with [0]: rules.goal.actions[0]"
        raise _refused(f"'{text}' is not a path", help_)
    first, params = steps[0], params_of(root)
    if len(steps) == 1 and first in params:
        return ["params", first]
    if first == "extends":
        message = "what a scenario extends is read before anything is set"
        raise _refused(message, "write a file with extends: and what you change")
    if len(steps) == 1 and first not in fields(Scenario):
        kinds = ((section, bare(shape).kind) for section, shape in fields(Scenario).items())
        exact = next((section for section, kind in kinds if is_model(kind) and first in fields(kind)), None)
        help_ = f"did you mean '{exact}.{first}'?" if exact else choice_of(first, [*params, *fields(Scenario)])
        raise _refused(f"unknown param or section '{first}'", help_)
    return steps


def _set(root: Entries, steps: list[str], value: Node, mark: Mark, merger: Merger) -> None:
    node: Node = root
    shape: Shape = Scenario
    path: Path = ()
    for step in steps:
        here, above = in_names(root, path), node
        is_last = len(path) == len(steps) - 1
        if isinstance(above, Items):
            if not step.isdecimal() or int(step) >= len(above.items):
                help_ = f"its entries are [0] to [{len(above.items) - 1}]"
                raise _refused(f"{here} is a list and has no '{step}'", help_)
            path, inner = (*path, int(step)), step_into(shape, above, int(step))
            if is_last and isinstance(value, Leaf) and value.value is None:
                raise _refused("null removes named entries only", f"set the whole list {here}")
            if is_last:
                above.items[int(step)] = merger.adopt(value, inner, path)
            node = above.items[int(step)]
        elif isinstance(above, Entries):
            path, inner = (*path, step), step_into(shape, above, step)
            kind = bare(chosen(shape, above)).kind
            # A new name may bring a whole entry; a single value under a new name is a typing mistake.
            is_new_name = is_named(kind) and step not in above.entries and (not is_last or isinstance(value, Leaf))
            if is_new_name or (is_model(kind) and step not in fields(kind)):
                repeated = of_repeated(step, above) if len(path) == 2 else ""
                known = fields(kind) if is_model(kind) else above.entries
                raise _refused(f"{here or 'a scenario'} has no '{step}'", repeated or choice_of(step, known))
            if is_last:
                make_way(above, {step}, shape)
                merger.merge_entry(above, step, value, mark, shape, path[:-1])
                return
            if step not in above.entries:  # a section that the file leaves at its defaults
                above.put(step, Entries({}, mark), mark)
            node = above.entries[step]
        else:
            raise _refused(f"{here} is a single value, nothing is inside it")
        shape = inner


# --- params -----------------------------------------------------------------------------------------------------------


def resolve_params(root: Entries, merger: Merger) -> None:
    """Replace every ``{param: NAME}`` of the tree by the value for which it stands, at the position of its use."""
    resolver = Resolver(root, params_of(root), merger.problems)
    for key, node in root.entries.items():
        if key != "params":
            root.entries[key] = resolver.resolved(node, fields(Scenario).get(key), (key,))


def params_of(root: Entries) -> dict[str, Node]:
    """Return the scenario's params by name."""
    return entries_of(root.entries.get("params"))


@dataclass
class Resolver:
    """Resolves params in one part of a tree.

    Attributes:
        row: what is known besides within a repeated entry: single values and lists of them; None elsewhere.
        other: the same of the other row of a table of two.
    """

    root: Entries
    params: Mapping[str, Node]
    problems: list[Diagnostic]
    row: Mapping[str, Leaf | Items] | None = None
    other: Mapping[str, Leaf | Items] = field(default_factory=dict)

    def resolved(self, node: Node, shape: Shape, path: Path) -> Node:
        """Return a value with the params in it replaced by what they stand for; the value itself may change."""
        if isinstance(node, Entries):
            if is_param(node) and self._may_stand(node, shape):
                return self.stood_for(node, path)
            for key, inner in node.entries.items():
                if not isinstance(inner, Leaf):  # which is none, nor has any
                    node.entries[key] = self.resolved(inner, step_into(shape, node, key), (*path, key))
        elif isinstance(node, Items):
            for index, item in enumerate(node.items):
                if not isinstance(item, Leaf):
                    node.items[index] = self.resolved(item, step_into(shape, node, index), (*path, index))
        return node

    def _may_stand(self, node: Entries, shape: Shape) -> bool:
        # If nothing is known of the place, a mapping with other keys may be anything.
        if may_be_scalar(shape):
            return shape is not None or node.entries.keys() <= set(KEYS)
        return _name(node) in (self.row or ()) and any(
            get_origin(bare(member).kind) is tuple for member in members(shape)
        )

    def stood_for(self, node: Entries, path: Path) -> Leaf | Items:  # noqa: PLR0911
        """Return the value for which a use of a param stands; what is wrong with it is added to the problems."""
        mark, name, of = node.entries["param"].mark, _name(node), node.entries.get("of")
        unknown = Leaf(None, mark, note="unknown param", param=name)
        row = (self.row or {}) if of is None else self.other
        if of is not None and (name not in row or value_of(of) != "other"):
            help_ = "write of: other, with a column of a table of two rows for which the entry is repeated"
            self._add(WRONG_PARAM_USE, path, of.mark, f"there is no other row with '{cut(name)}'", help_)
            return unknown
        value = row[name] if name in row else self.params.get(name)
        if name in row and isinstance(value, Items):
            if not node.entries.keys() <= {"param", "of"}:
                message = f"param '{name}' is {format_node(value)}"
                self._add(WRONG_PARAM_USE, path, mark, message, "nothing can stand beside it")
                return unknown
            leaves = (item for item in value.items if isinstance(item, Leaf))
            return Items([Leaf(one.value, mark, note=f"param '{name}'", param=one.param) for one in leaves], mark)
        if not isinstance(value, Leaf) or (self.row is not None and value.value is None):
            # A value that is not a scalar, or that a row lacks, is reported where it is defined.
            if value is None:
                self._add(UNKNOWN_PARAM, path, mark, f"unknown param '{cut(name)}'", self._hint(name))
            return unknown
        factors, number = self._factors(node, path), value.value
        if factors is None:
            return unknown
        formula = "".join(f" {key} {factor}" for key, factor in factors.items())
        if factors:
            wrong, help_ = f" is {format_node(value)}", "times and plus are for numbers"
            if isinstance(number, int | float) and not isinstance(number, bool):
                number, wrong, help_ = compute(number, **factors), f"{formula} is too large a number", ""
            else:
                number = None
            if number is None:
                self._add(WRONG_PARAM_USE, path, mark, f"param '{name}'{wrong}", help_)
                return unknown
        return Leaf(number, mark, note=f"param '{name}'{formula}", param=value.param if name in row else name)

    def _factors(self, use: Entries, path: Path) -> dict[str, int | float] | None:
        """Return the numbers beside a param's name by their keys; None if something is wrong with them."""
        factors: dict[str, int | float] = {}
        others = {key: node for key, node in use.entries.items() if key not in ("param", "of")}
        for key, node in others.items():
            number = node.value if isinstance(node, Leaf) else ""
            if key not in KEYS:
                message = f"unknown key '{key[:64]}'"
                self._add(WRONG_PARAM_USE, path, use.key_marks[key], message, choice_of(key, KEYS[1:]))
            elif isinstance(number, str | bool):
                help_ = "not another param: write a number"
                self._add(WRONG_PARAM_USE, (*path, key), node.mark, expected(float, node), help_)
            elif number is not None:  # what is left empty, or is null, has been reported already
                factors[key] = number
        return {key: factors[key] for key in KEYS if key in factors} if len(factors) == len(others) else None

    def _hint(self, name: str) -> str:
        if name == THIS and self.row is None:
            return "'this' can only be used in an entry with repeat_for"
        known = [*(self.row or ()), *self.params]
        if word := next((word for word in _WORD.findall(name) if word in known and word != name), None):
            return f"a formula is written {{param: {word}, times: 2, plus: 1}}"
        places = (section.entries for section in self.root.entries.values() if isinstance(section, Entries))
        if self.row is not None and any(name in entries for entries in places):
            return f"to name one copy of '{name}' for each row, write its name, {name}_ROW, in a column of the table"
        return choice_of(name, known, "param")

    def _add(self, code: Code, path: Path, mark: Mark, message: str, help_: str = "") -> None:
        self.problems.append(mark.error(code, message, help_, in_names(self.root, path)))


def _name(node: Entries) -> str:
    return str(value_of(child(node, "param")))


def compute(value: float, times: float = 1, plus: float = 0) -> int | float | None:
    """Return a product plus a number, exact before it is rounded (3 times 0.1 is 0.3); None: too large."""
    if isinstance(value, int) and isinstance(times, int) and isinstance(plus, int):
        whole = value * times + plus
        return whole if -INT_LIMIT <= whole < INT_LIMIT else None
    first, second, third = (_EXACT.create_decimal(repr(one)) for one in (value, times, plus))
    number = float(_EXACT.add(_EXACT.multiply(first, second), third))
    if not isfinite(number):
        return None
    return plain(number) if abs(number) < _MAX_EXACT else number
