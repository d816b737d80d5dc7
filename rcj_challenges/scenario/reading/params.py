"""Params and overrides: ``{param: NAME}`` for any single value, ``--set PATH=VALUE`` from the command line.

What stands beside a param's name, ``times`` and ``plus``, is computed in `param_value`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import get_origin

from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.scenario.errors import ScenarioError, choice_of, cut, listing
from rcj_challenges.scenario.messages.wording import format_node
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.reading.merge import Merger, is_param, make_way, of_repeated
from rcj_challenges.scenario.reading.param_value import KEYS, param_value
from rcj_challenges.scenario.reading.yaml_strict import parse_value
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
from rcj_challenges.scenario.tree import Entries, Items, Leaf, Mark, Node, Path, Step, child, in_names

THIS = "this"
"""What the name of a row is called within a repeated rule."""
_WORD = re.compile(r"[A-Za-z_]\w*", re.ASCII)
_STEPS = re.compile(r"(?:^|\.)([^.\[\]]+)|\[(\d+)\]")


class _RefusedError(Exception):
    """An override that leads nowhere.

    Attributes:
        message, help: as of `Diagnostic`.
    """

    def __init__(self, message: str, help_: str = "") -> None:
        super().__init__(message)
        self.message = message
        self.help = help_


def apply_overrides(root: Entries, overrides: Sequence[str], merger: Merger) -> None:
    """Change the merged tree as the command line asks; what cannot be is added to the merger's problems."""
    for override in overrides:
        shown = f"--set {override if len(override) <= 80 else override[:77] + '...'}"
        path_text, equals, value_text = override.partition("=")
        try:
            if not equals or not path_text.strip() or not value_text.strip():
                raise _RefusedError("expected PATH=VALUE", "PATH is a param's name, or a path such as match.half_s")
            value = parse_value(value_text, shown)
            _point_to_option(value, Mark(shown))
            _set(root, _steps(path_text.strip(), root), value, Mark(shown), merger)
        except _RefusedError as refused:
            merger.problems.append(Mark(shown).error("wrong-override", refused.message, refused.help))
        except ScenarioError as error:
            merger.problems += [Mark(shown).error(one.code, one.message, one.help) for one in error.diagnostics]


def _point_to_option(node: Node, mark: Mark) -> None:
    """Let a value from the command line point to its option, not to a line and column of no file."""
    node.mark = mark
    inner = node.entries.values() if isinstance(node, Entries) else node.items if isinstance(node, Items) else ()
    if isinstance(node, Entries):
        node.key_marks = dict.fromkeys(node.entries, mark)
    for part in inner:
        _point_to_option(part, mark)


def _steps(text: str, root: Entries) -> Path:
    path: list[Step] = []
    end = 0
    for match in _STEPS.finditer(text):
        if match.start() != end:
            break
        end = match.end()
        path.append(int(match[2]) if match[1] is None else match[1])
    if end != len(text) or len(path) > 30:
        help_ = "write names with dots and list entries with [0]: rules.goal.actions[0]"
        raise _RefusedError(f"'{text}' is not a path", help_)
    params = root.entries.get("params")
    if len(path) == 1 and isinstance(params, Entries) and path[0] in params.entries:
        return ("params", path[0])
    if path[0] == "extends":
        message = "what a scenario extends is read before anything is set"
        raise _RefusedError(message, "write a file with extends: and what you change")
    if len(path) == 1 and path[0] not in fields(Scenario):
        names = [*(params.entries if isinstance(params, Entries) else ()), *fields(Scenario)]
        exact = next((dotted for dotted in _dotted() if dotted.rpartition(".")[2] == path[0]), None)
        help_ = f"did you mean '{exact}'?" if exact else choice_of(str(path[0]), names)
        raise _RefusedError(f"unknown param or section '{path[0]}'", help_)
    return tuple(path)


def _dotted() -> Iterator[str]:
    """Yield the paths of single values below the sections that always exist, for a hint."""
    for section, shape in fields(Scenario).items():
        kind = bare(shape).kind
        if is_model(kind):
            yield from (f"{section}.{key}" for key in fields(kind))


def _set(root: Entries, path: Path, value: Node, mark: Mark, merger: Merger) -> None:
    node: Node = root
    shape: Shape = Scenario
    for depth, written in enumerate(path):
        step = int(written) if isinstance(node, Items) and str(written).isdecimal() else written
        here = in_names(root, path[:depth])
        inner = step_into(shape, node, step)
        if depth == len(path) - 1:
            _put(node, step, value, mark, shape, path, here, merger)
            return
        following = child(node, step)
        if following is None:
            following = _opened(node, step, shape, inner, mark, here)
        node, shape = following, inner


def _opened(node: Node, step: Step, shape: Shape, inner: Shape, mark: Mark, here: str) -> Node:
    """Return a new mapping for a section that the file leaves at its defaults; refuse everything else."""
    _check_step(node, step, shape, here)
    if is_named(chosen(shape, node)) or not isinstance(node, Entries) or not isinstance(step, str):
        raise _unknown_name(node, step, here)
    if not any(is_model(bare(member).kind) or is_named(member) for member in members(inner)):
        raise _RefusedError(f"{here + '.' if here else ''}{step} is a single value, nothing is inside it")
    fresh = Entries({}, mark)
    node.put(step, fresh, mark)
    return fresh


def _put(node: Node, step: Step, value: Node, mark: Mark, shape: Shape, path: Path, here: str, merger: Merger) -> None:
    _check_step(node, step, shape, here)
    if isinstance(node, Items) and isinstance(step, int):
        if isinstance(value, Leaf) and value.value is None:
            raise _RefusedError("null removes named entries only", f"set the whole list {here}")
        node.items[step] = merger.adopt(value, step_into(shape, node, step), path)
        return
    if not isinstance(node, Entries) or not isinstance(step, str):  # pragma: no cover - _check_step refused it
        return
    # A new name may bring a whole entry; a single value under a new name is a typing mistake.
    if is_named(chosen(shape, node)) and step not in node.entries and isinstance(value, Leaf):
        raise _unknown_name(node, step, here)
    make_way(node, {step}, shape)
    merger.merge_entry(node, step, value, mark, shape, path[:-1])


def _check_step(node: Node, step: Step, shape: Shape, here: str) -> None:
    if isinstance(node, Leaf):
        raise _RefusedError(f"{here} is a single value, nothing is inside it")
    if isinstance(node, Items):
        if not isinstance(step, int) or step >= len(node.items):
            help_ = f"its entries are [0] to [{len(node.items) - 1}]"
            raise _RefusedError(f"{here} is a list and has no '{step}'", help_)
        return
    if not isinstance(step, str):
        raise _RefusedError(f"{here} is not a list", f"it has {listing(node.entries)}")
    kind = bare(chosen(shape, node)).kind
    if is_model(kind) and step not in fields(kind):
        known = fields(kind)
        raise _RefusedError(f"{here or 'a scenario'} has no '{step}'", choice_of(step, known))


def _unknown_name(node: Node, step: Step, here: str) -> _RefusedError:
    names = node.entries if isinstance(node, Entries) else {}
    repeated = of_repeated(str(step), node) if isinstance(node, Entries) and here == "rules" else ""
    return _RefusedError(f"{here} has no '{step}'", repeated or choice_of(str(step), names))


def resolve_params(root: Entries, merger: Merger) -> None:
    """Replace every ``{param: NAME}`` of the tree by the value for which it stands, at the position of its use."""
    resolver = Resolver(root, params_of(root), merger.problems)
    for key, node in root.entries.items():
        if key != "params":
            root.entries[key] = resolver.resolved(node, fields(Scenario).get(key), (key,))


def params_of(root: Entries) -> dict[str, Node]:
    """Return the scenario's params by name."""
    params = root.entries.get("params")
    return params.entries if isinstance(params, Entries) else {}


@dataclass
class Resolver:
    """Resolves params in one part of a tree.

    Attributes:
        root: the whole tree.
        params: the scenario's.
        problems: what is wrong is added to them.
        row: what is known besides within a repeated rule: single values and lists of them; None elsewhere.
    """

    root: Entries
    params: Mapping[str, Node]
    problems: list[Diagnostic]
    row: Mapping[str, Leaf | Items] | None = None

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

    def stood_for(self, node: Entries, path: Path) -> Leaf | Items:
        """Return the value for which a use of a param stands; what is wrong with it is added to the problems."""
        use = node.entries["param"]
        name = _name(node)
        value = (self.row or {}).get(name, self.params.get(name))
        if isinstance(value, Items) and self.row is not None and name in self.row:
            return self._listed(node, name, value, path)
        if not isinstance(value, Leaf) or (self.row is not None and value.value is None):
            # A value that is not a scalar, or that a row lacks, is reported where it is defined.
            if value is None:
                self._add("unknown-param", path, use.mark, f"unknown param '{cut(name)}'", self._hint(name))
            return Leaf(None, use.mark, note="unknown param")
        leaf, refused = param_value(node, name, value)
        for one in refused:
            at = (*path, one.key) if one.key else path
            self._add("wrong-param-use", at, one.mark, one.message, one.help)
        if self.row is not None and name in self.row:
            leaf.param = value.param
        return leaf

    def _listed(self, node: Entries, name: str, value: Items, path: Path) -> Leaf | Items:
        mark = node.entries["param"].mark
        if len(node.entries) > 1:
            message = f"param '{name}' is {format_node(value)}"
            self._add("wrong-param-use", path, mark, message, "nothing can stand beside it")
            return Leaf(None, mark, note="unknown param")
        leaves = (item for item in value.items if isinstance(item, Leaf))
        return Items([Leaf(one.value, mark, note=f"param '{name}'", param=one.param) for one in leaves], mark)

    def _hint(self, name: str) -> str:
        if name == THIS and self.row is None:
            return "'this' can only be used in a rule with repeat_for"
        known = [*(self.row or ()), *self.params]
        if word := next((word for word in _WORD.findall(name) if word in known and word != name), None):
            return f"a formula is written {{param: {word}, times: 2, plus: 1}}"
        return choice_of(name, known, "param")

    def _add(self, code: str, path: Path, mark: Mark, message: str, help_: str = "") -> None:
        self.problems.append(mark.error(code, message, help_, in_names(self.root, path)))


def _name(node: Entries) -> str:
    use = node.entries["param"]
    return str(use.value) if isinstance(use, Leaf) else ""
