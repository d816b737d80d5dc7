"""What to write where something is not wanted, or is gone and still named."""

from __future__ import annotations

from rcj_challenges.scenario.shape import Shape, is_named
from rcj_challenges.scenario.tree import Leaf, Node, Path

_NOTHING = frozenset({"none", "nothing", "no", "null", "nil", "removed", "remove", "delete", "deleted", "off", "away"})
"""What others write for a thing that is not to be there."""


def for_nothing(path: Path, node: Node | None, around: Shape) -> str:
    """Return how something is taken away; empty: it is not what was meant, or null does not take it away.

    Args:
        path: where it stands.
        node: what stands there.
        around: the shape of the mapping in which it stands: null takes away what has a name of the author's own.
    """
    word = node.value if isinstance(node, Leaf) else None
    if not isinstance(word, str) or word.casefold() not in _NOTHING or not is_named(around):
        return ""
    if path[:1] == ("robots",) and path[2:-1] == ("devices",):
        return f"; a device of the robot's kit is taken away by 'without: [{path[-1]}]'"
    return f"; what is not wanted is taken away by null: {path[-1]}: null"


def without(name: str, path: Path) -> str:
    """Return what to do about a place that still names something removed.

    Args:
        name: what was removed.
        path: where it is still named.
    """
    if path[-1] == name and not any(isinstance(part, int) for part in path):
        return f"; write '{name}: null' under {'.'.join(map(str, path[:-1]))} too"
    if len(path) < 3:
        return ""
    # Mappings are merged and lists are not: of a kit only the list in which the name stands need be written.
    named = path[: path.index("packet_lists") + 1] if "packet_lists" in path else path[:2]
    return f"; write {'.'.join(map(str, named))} anew without it"
