"""How the place of something is written where its name stands alone, or behind a key that is none."""

from __future__ import annotations

from rcj_challenges.scenario.catalogue import texts
from rcj_challenges.scenario.tree import Entries, Leaf, Node, Path, child, node_at

_MOVES = "what moves"
_SECTIONS = {"spots": "spots", "zones": "zones", "robots": _MOVES, "balls": _MOVES, "obstacles": _MOVES}
_KEYS = frozenset({"draw", "entity", "robot", "ball", "obstacle", "zone", "name"})
"""Behind which a name may be meant; another one is a misspelt word of `at`."""


def for_place(path: Path, node: Node | None, root: Node) -> str:
    """Return how the place of what is named is written; empty: the name is none, or nothing can be put there.

    Args:
        path: where the name stands; behind ``towards`` a ball is aimed.
        node: the name, or a mapping in which it stands behind a key that is none, such as ``{draw: target}``.
        root: the whole scenario.
    """
    if isinstance(node, Entries) and len(node.entries) == 1 and _KEYS & node.entries.keys():
        (node,) = node.entries.values()
    if not isinstance(node, Leaf) or not isinstance(node.value, str):
        return ""
    name = node.value
    kind = _kind_of(name, root)
    drawn = {_kind_of(value, root) for value in texts(node_at(root, ("draws", name, "values")))}
    if kind:
        return _written(name, kind, path, "it")
    if len(drawn) == 1:
        (kind,) = drawn
        return _written(name, kind, path, "the one drawn") if kind != "zones" else ""
    members = {_kind_of(member, root) for member in texts(node_at(root, ("groups", name)))}
    return f"; one of these spots by chance is written {{choice: [{name}]}}" if members == {"spots"} else ""


def _kind_of(name: str, root: Node) -> str:
    return next((kind for section, kind in _SECTIONS.items() if child(child(root, section), name) is not None), "")


def _written(name: str, kind: str, path: Path, who: str) -> str:
    if kind == "spots":
        return f"; a spot{'' if who == 'it' else ' that a draw decides'} is written {{spot: {name}}}"
    if kind == "zones":
        return f"; a random point of a zone is {{uniform_in: {name}}}"
    if kind != _MOVES:
        return ""
    if path[-1] == "towards":
        return f"; at where {who} is, is written {{relative_to: {name}}}"
    return f"; beside {who} is written {{relative_to: {name}, offset_m: [0.1, 0]}}"
