"""How the place of something is written where its name stands alone, or behind a key that is none."""

from __future__ import annotations

from rcj_challenges.scenario.catalogue import texts
from rcj_challenges.scenario.tree import Entries, Leaf, Node, Path, child, node_at

_SPOT, _ZONE, _MOVES, _FIXED = "spot", "zone", "what moves", "fixed obstacle"
_SECTIONS = {"spots": _SPOT, "zones": _ZONE, "robots": _MOVES, "balls": _MOVES, "obstacles": _FIXED}
SEEN = frozenset({_SPOT, _MOVES})
"""What one can look at: a fixed obstacle is nothing to look at."""
_KEYS = frozenset({"draw", "entity", "robot", "ball", "obstacle", "zone", "name"})
"""Behind which a name may be meant; another one is a misspelt word of `at`."""


def for_place(path: Path, node: Node | None, root: Node) -> str:
    """Return how the place of what is named is written; empty: the name is none, or nothing can be put there.

    Args:
        path: where the name stands; behind ``towards`` a ball is aimed.
        node: the name, or a mapping in which it stands behind a key that is none, such as ``{draw: target}``.
        root: the whole scenario.
    """
    key = ""
    if isinstance(node, Entries):
        (key, *others) = sorted(_KEYS & node.entries.keys()) or ("",)
        node = None if others else node.entries.get(key)
    if not isinstance(node, Leaf) or not isinstance(node.value, str):
        return ""
    name = node.value
    if _is_drawn(name, root):
        return _written(name, kind_of(name, root), path, "the one drawn")
    kind = kind_of(name, root)
    if kind:
        return _written(name, kind, path, "it")
    members = {kind_of(member, root) for member in texts(node_at(root, ("groups", name)))}
    if members == {_SPOT}:
        return f"; one of these spots by chance is written {{choice: [{name}]}}"
    # Of what is behind its own word, and perhaps misspelt, it is known what is meant.
    if key == "draw":
        return _written(name, _SPOT, path, "the one drawn")
    return _written(name, _ZONE, path, "it") if key == "zone" else ""


def kind_of(name: str, root: Node) -> str:
    """Return what a name stands for; of a draw what it decides among; empty: something else, or nothing."""
    if _is_drawn(name, root):
        drawn = {_kind_alone(value, root) for value in texts(node_at(root, ("draws", name, "values")))}
        return _MOVES if drawn == {_MOVES, _SPOT} else drawn.pop() if len(drawn) == 1 else ""
    return _kind_alone(name, root)


def _is_drawn(name: str, root: Node) -> bool:
    return not _kind_alone(name, root) and node_at(root, ("draws", name)) is not None


def _kind_alone(name: str, root: Node) -> str:
    section = next((one for one in _SECTIONS if child(child(root, one), name) is not None), "")
    movable = child(node_at(root, ("obstacles", name)), "movable")
    return _MOVES if isinstance(movable, Leaf) and movable.value is True else _SECTIONS.get(section, "")


def _written(name: str, kind: str, path: Path, who: str) -> str:
    is_drawn = who != "it"
    if kind == _SPOT:
        return f"; a spot{' that a draw decides' if is_drawn else ''} is written {{spot: {name}}}"
    if kind == _MOVES and path[-1] == "towards":
        return f"; at where {who} is, is written {{relative_to: {name}}}"
    if kind == _MOVES:
        return f"; beside {who} is written {{relative_to: {name}, offset_m: [0.1, 0]}}"
    if is_drawn:
        placed = f"{{action: place, layout: {{draw: {name}}}}}"
        return f"; where a draw decides the place, give it layouts as values: {placed}"
    if kind == _ZONE:
        return f"; a random point of a zone is {{uniform_in: {name}}}"
    return f"; '{name}' is a fixed obstacle: a spot of the same place, or beside it, can stand for it"
