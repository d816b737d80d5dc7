"""All names of a scenario, read from its tree: which there are, what each names, what a group stands for.

Read from the tree and not from the models, so that unknown names are reported together with everything else that is
wrong. Malformed parts count as absent here; what is wrong with them is reported elsewhere.
"""

from __future__ import annotations

from rcj_challenges.scenario.models.scenario import MAX_GROUPS, MAX_MEMBERS
from rcj_challenges.scenario.tree import Entries, Items, Leaf, Node, child, node_at

ALWAYS = ("robots", "balls", "obstacles", "walls")
"""Groups that always exist; each colour of a robot is one too."""

EACH = "each"
OTHER = "other"
BOUND = (EACH, OTHER)
"""Names that a rule has for those whom a firing is about."""

KIND_OF_SECTION = {"robots": "robot", "balls": "ball", "zones": "zone", "gates": "gate", "spots": "spot"}
_NOUNS = {
    "entrants": "entrant",
    "draws": "draw",
    "counters": "counter",
    "flags": "flag",
    "timers": "timer",
    "sequences": "sequence",
    "placements": "layout",
    "phases": "phase",
    "kits": "kit",
    "params": "param",
}
FAMILIES = {"robot": "thing", "ball": "thing", "obstacle": "thing", "fixed obstacle": "thing", "walls": "thing"}
"""Kinds that may share a group; the others keep to themselves."""


class Catalogue:
    """The names of one scenario.

    Attributes:
        root: the tree.
        kinds: what each name on the field is: ``robot``, ``ball``, ``obstacle`` (movable), ``fixed obstacle``,
            ``walls``, ``zone``, ``gate`` or ``spot``.
        groups: the members of each group, nested groups resolved, unknown names left in.
        broken: sections that are there and are no mappings.
    """

    def __init__(self, root: Entries) -> None:
        self.root = root
        self.broken = {name for name, node in root.entries.items() if not isinstance(node, Entries)}
        self.kinds: dict[str, str] = {}
        for section, kind in KIND_OF_SECTION.items():
            for name in self.names(section):
                self.kinds.setdefault(name, kind)  # a name given twice is reported; the first one counts
        for name in self.names("obstacles"):
            movable = self.leaf("obstacles", name, "movable") is True
            self.kinds.setdefault(name, "obstacle" if movable else "fixed obstacle")
        self.kinds["walls"] = "walls"
        self.groups: dict[str, tuple[str, ...]] = {
            "robots": self.names("robots"),
            "balls": self.names("balls"),
            "obstacles": self.names("obstacles"),
            "walls": ("walls",),
        }
        for robot in self.names("robots"):
            colour = self.leaf("robots", robot, "colour")
            if isinstance(colour, str):
                self.groups[colour] = (*self.groups.get(colour, ()), robot)
        self.colours = tuple(name for name in self.groups if name not in ALWAYS)
        if len(self.names("groups")) > MAX_GROUPS:
            self.broken.add("groups")  # refused as too many; nothing more is said about them
        else:
            known: dict[str, tuple[str, ...]] = {}
            for group in self.names("groups"):
                self.groups[group] = self._members(group, (), known)

    def section(self, name: str) -> Entries | None:
        """Return a section that is a mapping."""
        found = self.root.entries.get(name)
        return found if isinstance(found, Entries) else None

    def names(self, section: str) -> tuple[str, ...]:
        """Return the names that a section defines."""
        found = self.section(section)
        return tuple(found.entries) if found is not None else ()

    def known_as(self, name: str) -> str:
        """Return what a name names, wherever that is defined, as ``robot``, ``group``, ``draw``; else an empty text."""
        if name in self.kinds:
            return self.kinds[name]
        defined = (noun for section, noun in _NOUNS.items() if name in self.names(section))
        return next(defined, "group" if name in self.groups else "")

    def leaf(self, *path: str) -> object:
        """Return a single value, or None."""
        found = node_at(self.root, path)
        return found.value if isinstance(found, Leaf) else None

    def has_centre(self, zone: str) -> bool:
        """Return whether a zone has one point that is its centre: see `measured.centre_of`, which asks a whole one."""
        shape, sides = self.leaf("zones", zone, "shape"), ("x_min_m", "x_max_m", "y_min_m", "y_max_m")
        is_bounded = shape == "rect" and all(self.leaf("zones", zone, side) is not None for side in sides)
        return (shape == "circle" or is_bounded) and self.leaf("zones", zone, "inverted") is not True

    def parts(self, group: str) -> tuple[str, ...]:
        """Return what is written in a group."""
        section = self.section("groups")
        return texts(child(section, group))[:MAX_MEMBERS] if section is not None else ()

    def _members(self, group: str, above: tuple[str, ...], known: dict[str, tuple[str, ...]]) -> tuple[str, ...]:
        if group in above:
            return ()  # a cycle, reported by the checks
        if group not in known:
            members: list[str] = []
            for part in self.parts(group):
                if part in self.names("groups"):
                    members += self._members(part, (*above, group), known)
                else:
                    members += self.groups.get(part, (part,))
            known[group] = tuple(dict.fromkeys(members))
        return known[group]

    def expand(self, name: str) -> tuple[str, ...]:
        """Return what a name stands for: a group's members, or itself."""
        return self.groups.get(name, (name,)) if name not in self.kinds or name == "walls" else (name,)

    def of_kind(self, kinds: frozenset[str]) -> list[str]:
        """Return the names on the field that are of one of these kinds."""
        return [name for name, kind in self.kinds.items() if kind in kinds]


def texts(node: Node | None) -> tuple[str, ...]:
    """Return the texts of a value or of a list, lists inside it included."""
    if isinstance(node, Leaf):
        return (node.value,) if isinstance(node.value, str) else ()
    if isinstance(node, Items):
        return tuple(text for item in node.items for text in texts(item))
    return ()
