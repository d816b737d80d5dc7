"""A scenario as it was written: values with the place of each in its file.

The tree is what loading, merging, params and overrides work on; only the finished tree becomes plain data and then a
`Scenario`. Every key and value keeps its own mark, so that a mistake in a base file is reported in the base file.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from rcj_challenges.core.code import Code
from rcj_challenges.core.diagnostics import Diagnostic, InFile
from rcj_challenges.rules.conditions import CONDITIONS
from rcj_challenges.scenario.codes import SCENARIO_TOO_LARGE
from rcj_challenges.scenario.errors import ScenarioError, cut

RESOLVED = "resolved scenario"
"""In place of a file: the scenario of a record."""

Step = str | int
Path = tuple[Step, ...]
"""From the root to a value: keys and list indices."""


@dataclass(frozen=True, slots=True)
class Mark:
    """A place in a file; line and column are 1-based, 0 where there are none."""

    file: str
    line: int = 0
    column: int = 0

    def error(self, code: Code, message: str, help_: str = "", path: str = "") -> Diagnostic:
        """Return a mistake at this place; arguments as of `Diagnostic` and `InFile`."""
        return Diagnostic(code, message, help_, self.place(path))

    def place(self, path: str = "") -> InFile:
        """Return it as the place of a diagnostic."""
        return InFile(self.file, self.line or None, self.column or None, path)


@dataclass(slots=True)
class Leaf:
    """A scalar.

    Attributes:
        value: text, number, true or false; None for a written ``null`` and for an empty value.
        empty: True if nothing was written at all.
        note: where the value came from if not from here: ``param 'push_m' times 2``.
        written: the characters of a plain value in its file, such as ``007``.
    """

    value: str | int | float | bool | None
    mark: Mark
    empty: bool = False
    note: str = ""
    param: str = ""
    written: str = field(default="", compare=False)


@dataclass(slots=True)
class Items:
    """A list."""

    items: list[Node]
    mark: Mark


@dataclass(slots=True)
class Entries:
    """A mapping, in the order of the file."""

    entries: dict[str, Node]
    mark: Mark
    key_marks: dict[str, Mark] = field(default_factory=dict)

    def put(self, key: str, node: Node, key_mark: Mark) -> None:
        """Set an entry; one that exists keeps its place in the order."""
        self.entries[key] = node
        self.key_marks[key] = key_mark

    def drop(self, key: str) -> None:
        """Remove an entry."""
        del self.entries[key]
        self.key_marks.pop(key, None)


Node = Leaf | Items | Entries


MAX_KEYS = 256
"""Entries of one mapping; the sections of the shipped scenarios have up to 30."""
MAX_ITEMS = 512
"""Entries of one list."""
MAX_VALUES = 10_000
"""Values in one file, lists and mappings among them; the largest shipped scenario has 1400."""
MAX_MERGED_VALUES = 20_000
"""Values of a scenario with its bases, or of one in a record, which has all defaults written out."""


def check_amount(node: Items | Entries) -> None:
    """Refuse a list or mapping with more entries than any scenario needs.

    Raises:
        ScenarioError: it has more.
    """
    if isinstance(node, Entries) and len(node.entries) > MAX_KEYS:
        raise too_large(node.mark, f"a mapping with more than {MAX_KEYS} entries")
    if isinstance(node, Items) and len(node.items) > MAX_ITEMS:
        raise too_large(node.mark, f"a list with more than {MAX_ITEMS} entries")


def check_size(root: Node) -> None:
    """Refuse a finished tree that is larger than any scenario needs: checks and lint would take minutes.

    Raises:
        ScenarioError: it is larger.
    """
    for count, node in enumerate(nodes_in(root), 1):
        if count > MAX_MERGED_VALUES:
            raise too_large(root.mark, f"more than {MAX_MERGED_VALUES} values, with those of its bases")
        if not isinstance(node, Leaf):
            check_amount(node)


def too_large(mark: Mark, what: str) -> ScenarioError:
    """Return the error about a file, list or mapping that is too large."""
    help_ = "leave out what the challenge does not need; repeat_for and groups say the same of several things at once"
    return ScenarioError([mark.error(SCENARIO_TOO_LARGE, what, help_)])


def nodes_in(node: Node) -> Iterator[Node]:
    """Yield a value and all that is in it."""
    yield node
    for inner in () if isinstance(node, Leaf) else node.entries.values() if isinstance(node, Entries) else node.items:
        yield from nodes_in(inner)


def plain(node: Node, listed: type[list[Any] | tuple[Any, ...]] = list) -> Any:
    """Return the tree as plain dicts, lists and scalars; for models, which have tuples, with these as lists."""
    if isinstance(node, Entries):
        return {key: plain(child, listed) for key, child in node.entries.items()}
    if isinstance(node, Items):
        return listed([plain(child, listed) for child in node.items])
    return node.value


def copied(node: Node) -> Node:
    """Return a tree of its own with the same values at the same places."""
    if isinstance(node, Entries):
        inner = {key: copied(child) for key, child in node.entries.items()}
        return Entries(inner, node.mark, dict(node.key_marks))
    if isinstance(node, Items):
        return Items([copied(child) for child in node.items], node.mark)
    return replace(node)


def child(node: Node | None, step: Step) -> Node | None:
    """Return the value one step further, or None if there is none."""
    if isinstance(node, Entries) and isinstance(step, str):
        return node.entries.get(step)
    if isinstance(node, Items) and isinstance(step, int) and 0 <= step < len(node.items):
        return node.items[step]
    return None


def entries_of(node: Node | None) -> dict[str, Node]:
    """Return the entries of a mapping; of anything else none."""
    return node.entries if isinstance(node, Entries) else {}


def items_of(node: Node | None) -> list[Node]:
    """Return the entries of a list; of anything else none."""
    return node.items if isinstance(node, Items) else []


def value_of(node: Node | None) -> str | int | float | bool | None:
    """Return a single value; None of anything else."""
    return node.value if isinstance(node, Leaf) else None


def deepest(root: Node, path: Sequence[Step]) -> tuple[Node, int]:
    """Return the last value on a path that exists, and how many steps lead to it."""
    node = root
    for count, step in enumerate(path):
        following = child(node, step)
        if following is None:
            return node, count
        node = following
    return node, len(path)


def node_at(root: Node, path: Sequence[Step]) -> Node | None:
    """Return the value at the end of a path, or None if it does not exist."""
    node, count = deepest(root, path)
    return node if count == len(path) else None


def mark_of(root: Node, path: Sequence[Step], *, at_key: bool = False) -> Mark:
    """Return the mark of a value, or of its key; what was not written has that of its surroundings."""
    node, count = deepest(root, path)
    whole = count == len(path)
    if not count or (whole and not at_key and not isinstance(node, Entries)):
        return node.mark
    # A mapping, and anything left out of one, is best found by its key.
    parent, _ = deepest(root, path[: count - 1])
    key = path[count - 1]
    if isinstance(parent, Entries) and isinstance(key, str):
        return parent.key_marks.get(key, node.mark)
    return node.mark


def note_at(root: Node, path: Sequence[Step]) -> str:
    """Return the addition to a message on the origin of a value: `` (param 'push_m')``; empty if from the file."""
    node = node_at(root, path)
    return f" ({node.note})" if isinstance(node, Leaf) and node.note else ""


_KINDS = {"triggers": "trigger", "actions": "action"}
_LISTS = (*_KINDS, "conditions", "any_of")


def in_names(root: Node, path: Sequence[Step]) -> str:
    """Return a path as authors read it: ``rules.goal.triggers[0] (enters).zone``."""
    text = ""
    for depth, step in enumerate(path):
        if isinstance(step, str):
            text += f".{cut(step)}" if text else cut(step)
            continue
        text += f"[{step}]"
        word = _word_at(deepest(root, path[: depth + 1])[0], str(path[depth - 1]) if depth else "")
        text += f" ({cut(word)})" if word else ""
    return text


def _word_at(node: Node, listed: str) -> str:
    """Return the word of an entry of a list of triggers, conditions or actions; empty: it has none."""
    if listed in ("conditions", "any_of"):
        return CONDITIONS.tag_of(plain(node)) or ""
    kind = child(node, _KINDS.get(listed, ""))
    return kind.value if isinstance(kind, Leaf) and isinstance(kind.value, str) else ""


def format_path(root: Node, path: Path) -> str:
    """Return a path in names that ends, within a rule, at the trigger, condition or action."""
    words = [i for i in range(1, len(path)) if isinstance(path[i], int) and path[i - 1] in _LISTS]
    return in_names(root, path[: words[-1] + 1] if words and path[0] == "rules" else path)
