"""Merging a scenario into its base, by the shapes of the models.

Mappings merge by key; lists and single values replace. Of keys of which only one can be given (``entity`` or ``per`` of
a sequence) the one written takes the other's place. An entry whose kind changes (another ``shape``, ``device`` …)
replaces the base's whole, since nothing of a circle makes sense in a rectangle. Overridden entries keep the base's
place in the order; new ones follow. A written ``null`` removes a named entry of the base, a robot also from the base's
entrants; a value that is left empty is a mistake, never a removal.
"""

from __future__ import annotations

from collections.abc import Set as AbstractSet
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from rcj_challenges.core.code import Code
from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.scenario.codes import MISSING_VALUE, WRONG_NULL
from rcj_challenges.scenario.errors import choice_of
from rcj_challenges.scenario.shape import (
    Shape,
    bare,
    chosen,
    is_list,
    is_model,
    is_named,
    may_be_scalar,
    step_into,
    tag_of,
    usual_tag,
)
from rcj_challenges.scenario.tree import (
    Entries,
    Leaf,
    Mark,
    Node,
    Path,
    child,
    entries_of,
    in_names,
    items_of,
    node_at,
    value_of,
)

REPEAT_FOR = "repeat_for"
TESTS = "expect"
ALL_INHERITED = "inherited"
"""With ``null``, in place of a test's name: all tests of the base."""


class Repeated(NamedTuple):
    """Where an entry comes from that was written once and repeated.

    Attributes:
        known: what is a param in it besides those of the scenario.
    """

    entry: str
    known: tuple[str, ...]


@dataclass
class Merger:
    """Merges trees and collects what is wrong with them.

    Attributes:
        removed: where each entry was removed, by section and name path.
        repeated: where each entry comes from that is a copy of a repeated one, by section and name.
    """

    problems: list[Diagnostic] = field(default_factory=list)
    removed: dict[Path, Mark] = field(default_factory=dict)
    repeated: dict[tuple[str, str], Repeated] = field(default_factory=dict)

    def merge(self, base: Entries, over: Entries, shape: Shape, path: Path = ()) -> Entries:
        """Merge ``over`` into ``base`` (which changes) and return it."""
        base.mark = over.mark
        if path == (TESTS,) and ALL_INHERITED in over.entries:
            for name in list(base.entries):
                base.drop(name)
        make_way(base, over.entries.keys(), shape)
        for key, node in over.entries.items():
            self.merge_entry(base, key, node, over.key_marks[key], shape, path)
        if not path:
            leave_entrants(base, over)
        return base

    def merge_entry(self, base: Entries, key: str, node: Node, key_mark: Mark, shape: Shape, path: Path) -> None:
        """Merge one entry into the mapping ``base`` whose shape and path are given."""
        here = (*path, key)
        if isinstance(node, Leaf) and node.value is None:
            self._null(base, key, node, key_mark, shape, path)
            return
        before = base.entries.get(key)
        if isinstance(node, Leaf):
            base.put(key, node, key_mark)
            return
        inner = step_into(shape, base, key)
        if inner is None and tag_of(shape, base) is None:
            # The base does not say yet which member of a union this is; the file itself may.
            inner = step_into(shape, Entries({key: node}, key_mark), key)
        if isinstance(before, Entries) and isinstance(node, Entries) and self._same_kind(before, node, inner):
            base.put(key, self.merge(before, node, inner, here), key_mark)
        else:
            base.put(key, self.adopt(node, inner, here), key_mark)

    def adopt(self, node: Node, shape: Shape, path: Path) -> Node:
        """Take over a value that has nothing to merge with."""
        if isinstance(node, Entries):
            fresh = Entries({}, node.mark)
            for key, inner in node.entries.items():
                if isinstance(inner, Leaf) and inner.value is None:
                    self._null(fresh, key, inner, node.key_marks[key], shape, path)
                else:
                    fresh.put(key, self.adopt(inner, step_into(shape, node, key), (*path, key)), node.key_marks[key])
            return fresh
        items = items_of(node)
        for index, item in enumerate(items):
            if isinstance(item, Leaf) and item.value is None:
                message = "an empty list entry" if item.empty else "null has no meaning here"
                self._add(MISSING_VALUE, item.mark, (*path, index), message, "write a value, or leave the entry out")
            else:
                items[index] = self.adopt(item, step_into(shape, node, index), (*path, index))
        return node

    def _same_kind(self, before: Entries, node: Entries, shape: Shape) -> bool:
        if may_be_scalar(shape) and (is_param(before) or is_param(node)):
            return False
        kind = tag_of(shape, node)
        return kind is None or kind == (tag_of(shape, before) or usual_tag(shape))

    def _null(self, base: Entries, key: str, node: Leaf, key_mark: Mark, shape: Shape, path: Path) -> None:
        here = (*path, key)
        if node.empty:
            help_ = (
                "write one, or leave the line out; what begins with # is a comment, unless it is in quotes: '#ff8800'"
            )
            if key in base.entries and is_named(chosen(shape, base)):
                help_ = f"write one, or leave the line out; '{key}: null' takes away what the base has"
            self._add(MISSING_VALUE, key_mark, here, "an empty value", help_)
            base.put(key, node, key_mark)  # it stays, so that it is not called missing too
        elif here == (TESTS, ALL_INHERITED):
            pass  # they are gone already
        elif not is_named(chosen(shape, base)):
            help_ = "leave the line out; a named entry in it is removed by its name"
            if is_list(step_into(shape, base, key)):
                help_ = "a list is replaced as a whole, write [] for none"
            elif here == (TESTS,):
                help_ = f"{{{ALL_INHERITED}: null}} removes all tests of the base"
            self._add(WRONG_NULL, node.mark, here, "null removes named entries of the base only", help_)
            base.put(key, node, key_mark)
        elif key not in base.entries:
            help_ = choice_of(key, base.entries) if base.entries else "leave the line out"
            if path[:1] == ("robots",) and path[2:] == ("devices",):
                help_ = f"a device of the robot's kit is taken away by 'without: [{key}]'"
            if path[-1:] == ("poses",):
                help_ = f"that something is off the field is expected by 'off: [{key}]'"
            help_ = (of_repeated(key, base) if len(path) == 1 else "") or help_
            self._add(WRONG_NULL, node.mark, here, f"nothing to remove: the base has no '{key}'", help_)
        else:
            base.drop(key)
            self.removed[here] = node.mark

    def _add(self, code: Code, mark: Mark, path: Path, message: str, help_: str) -> None:
        self.problems.append(mark.error(code, message, help_, in_names(Entries({}, mark), path)))


def of_repeated(name: str, section: Entries) -> str:
    """Return the help for a change or removal of a copy of a repeated entry; empty if there is no such entry."""
    for entry, node in section.entries.items():
        if REPEAT_FOR in entries_of(node) and name.startswith(f"{entry}_"):
            return f"copies of '{entry}' are changed there, or in the table for which it is repeated"
    return ""


def make_way(base: Entries, written: AbstractSet[str], shape: Shape) -> None:
    """Take out of a mapping in whose place something is written: of some keys only one can be given."""
    kind: Any = None if shape is None else bare(shape).kind
    either = set(kind.either) if is_model(kind) else set()
    if either & written:
        for key in base.entries.keys() & either - written:
            base.drop(key)


def leave_entrants(base: Entries, written: Entries) -> None:
    """Take robots that a file removes out of the entrants of its base, and entrants that have none left."""
    gone = entries_of(written.entries.get("robots")).keys() - entries_of(base.entries.get("robots")).keys()
    entrants = base.entries.get("entrants")
    for seat, entrant in list(entries_of(entrants).items()) if gone else ():
        driven, own = entries_of(child(entrant, "robots")), node_at(written, ("entrants", seat))
        for name in gone & driven.keys() - entries_of(child(own, "robots")).keys():
            del driven[name]
        if not driven and own is None:
            entries_of(entrants).pop(seat)


def is_param(node: Node) -> bool:
    """Return whether a mapping reads ``{param: NAME}``, whatever stands beside."""
    return isinstance(node, Entries) and isinstance(value_of(node.entries.get("param")), str)
