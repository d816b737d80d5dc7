"""The names of a scenario: what each one names, what a group stands for, and the order in which things are numbered.

The order of members decides random streams, so it is part of what a match is: groups keep the order in which they are
written, nested ones are put in their place, and each member counts once.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TypeVar

from rcj_challenges.rules.effects import Touch
from rcj_challenges.rules.fields import Names, Scalar
from rcj_challenges.scenario.models.scenario import MAX_GROUPS, MAX_MEMBERS, Rule, Scenario
from rcj_challenges.scenario.tree import Entries, Items, Leaf, Node, child, entries_of, node_at, value_of

_T = TypeVar("_T")

WALLS = "walls"
ENTRANTS = "entrants"
ALWAYS = ("robots", "balls", "obstacles", WALLS, ENTRANTS)
"""Groups that always exist; each colour of a robot is one too."""

EACH = "each"
OTHER = "other"
OTHERS = "others"
BOUND = (EACH, OTHER)
"""Names that a rule has for the entities which its firing is about."""

_KIND_OF_SECTION = {"robots": "robot", "balls": "ball", "zones": "zone", "gates": "gate", "spots": "spot"}
_NOUN_OF_SECTION = {
    "entrants": "entrant", "draws": "draw", "roles": "role", "counters": "counter", "flags": "flag", "timers": "timer",
    "sequences": "sequence", "placements": "layout", "phases": "phase", "kits": "kit", "params": "param",
    "guidelines": "guideline",
}  # fmt: skip


def as_tuple(written: _T | tuple[_T, ...]) -> tuple[_T, ...]:
    """Return names or values as a tuple: where several may be written, a single one need not stand in a list."""
    return written if isinstance(written, tuple) else (written,)


def with_each(names: Names, each: str | None) -> tuple[str, ...]:
    """Return names of a rule as a tuple, with one member, or the whole group, for ``each``; None: that stays."""
    return tuple(each if name == EACH and each is not None else name for name in as_tuple(names))


@dataclass(frozen=True)
class Roster:
    """The names of one scenario.

    Attributes:
        entities: robots, balls, movable obstacles; each kind in the order of the file.
        things: the entities, then the fixed obstacles, then ``walls``.
        index: name to index in ``things``.
        groups: group to the names of its members, nested groups resolved; the groups that always exist included.
        drawn: draw to the names among which it decides; none for a draw that has the name of something on the
            field, which takes precedence.
        kinds: what each name on the field is: ``robot``, ``ball``, ``obstacle`` (movable), ``fixed obstacle``,
            ``walls``, ``zone``, ``gate`` or ``spot``.
        sections: section to the names that it defines.
        teams: entrant to its robots, which it stands for where things are asked for; so does the group ``entrants``.
        roles: role to its members.
    """

    entities: tuple[str, ...]
    robots: int
    balls: int
    things: tuple[str, ...]
    index: dict[str, int]
    groups: dict[str, tuple[str, ...]]
    drawn: dict[str, tuple[str, ...]]
    kinds: dict[str, str]
    sections: dict[str, tuple[str, ...]]
    teams: dict[str, tuple[str, ...]]
    roles: dict[str, tuple[str, ...]]

    @classmethod
    def of(cls, scenario: Scenario) -> Roster:
        """Return the roster of a scenario whose references have been checked."""
        return _roster(
            {name: tuple(value) for name, value in scenario if isinstance(value, dict)},
            colours={name: robot.colour for name, robot in scenario.robots.items()},
            movable={name for name, one in scenario.obstacles.items() if getattr(one, "movable", False)},
            parts=scenario.groups,
            values={name: draw.values for name, draw in scenario.draws.items()},
            teams={name: tuple(entrant.robots) for name, entrant in scenario.entrants.items()},
            roles={name: as_tuple(role.of) for name, role in scenario.roles.items()},
            walls=scenario.field.walls,
        )

    @classmethod
    def of_tree(cls, root: Entries) -> Roster:
        """Return the roster of a scenario in which anything may be wrong; what is malformed counts as absent.

        Unknown names stay in groups; a group that leads back to itself ends there.
        """
        sections = {key: tuple(entries_of(node)) for key, node in root.entries.items()}
        groups = entries_of(root.entries.get("groups"))
        if len(groups) > MAX_GROUPS:
            groups = {}  # refused as too many; nothing more is said about them

        def each(section: str, key: str) -> dict[str, Node | None]:
            return {name: child(node, key) for name, node in entries_of(root.entries.get(section)).items()}

        return _roster(
            sections,
            colours={name: texts(colour)[0] for name, colour in each("robots", "colour").items() if texts(colour)},
            movable={name for name, one in each("obstacles", "movable").items() if value_of(one) is True},
            parts={name: texts(node)[:MAX_MEMBERS] for name, node in groups.items()},
            values={name: texts(values) for name, values in each("draws", "values").items()},
            teams={name: tuple(entries_of(robots)) for name, robots in each(ENTRANTS, "robots").items()},
            roles={name: texts(of) for name, of in each("roles", "of").items()},
            walls=value_of(node_at(root, ("field", WALLS))) is not False,
        )

    def names(self, section: str) -> tuple[str, ...]:
        """Return the names that a section defines."""
        return self.sections.get(section, ())

    def kind_of(self, name: str) -> str:
        """Return the kind of a name, wherever it is defined: ``robot``, ``group``, ``draw``; else an empty text."""
        if name in self.kinds:
            return self.kinds[name]
        defined = (noun for section, noun in _NOUN_OF_SECTION.items() if name in self.names(section))
        return next(defined, "group" if name in self.groups else "")

    # --- what names stand for -----------------------------------------------------------------------------------------

    def expand(self, names: Names, each: str | None = None) -> tuple[str, ...]:
        """Return the members that names stand for, without repeats, in order; without ``each`` that stays."""
        return _each_once(with_each(names, each), self.groups)

    def keepers(self, group: str) -> tuple[str, ...]:
        """Return those of a group that a rule is for, or that keep something: of ``entrants`` these themselves."""
        return tuple(self.teams) if group == ENTRANTS else self.expand(group)

    def keeps(self, group: str | None, per: str) -> bool:
        """Return whether each member of a group has its own of what is kept ``per`` another."""
        if group is None or (group == ENTRANTS) != (per == ENTRANTS):
            return False
        return set(self.expand(group)) <= set(self.expand(per))

    def of_rule(self, name: str, group: str | None, each: str | None) -> tuple[str, ...]:
        """Return the members of a rule's group for which ``each`` and ``others`` stand; none for another name.

        Without ``each`` they stand for the whole group.
        """
        if name == EACH and each is not None:
            return (each,)
        if group is None or (name != EACH and not self.is_others(name)):
            return ()
        return tuple(one for one in self.keepers(group) if one != each)

    def named(self, names: Names, group: str | None, each: str | None) -> tuple[str, ...]:
        """Return the things that names stand for in a rule for one member of a group; of entrants their robots."""
        found: list[str] = []
        for name in as_tuple(names):
            members = self.of_rule(name, group, each)
            found += [robot for one in members for robot in self.teams[one]] if group == ENTRANTS else members
            found += () if members else (name,)
        return self.expand(tuple(found))

    def may_be(self, names: Names, rule: Rule | None = None) -> tuple[str, ...]:
        """Return all that names may ever stand for: of a draw all among which it decides, in a rule also ``each``."""
        found: list[str] = []
        named = tuple(EACH if self.is_others(name) else name for name in as_tuple(names))
        for name in self.expand(named, rule.for_each if rule is not None else None):
            if rule is not None and name == OTHER and has_other(rule):
                found += self.others(rule, rule.for_each)
            else:
                found += self.roles.get(name) or self.drawn.get(name, (name,))
        return tuple(dict.fromkeys(found))

    def is_others(self, name: str) -> bool:
        """Return whether a name stands for the rest of a rule's group: nothing on the field is called so."""
        return name == OTHERS and name not in self.groups and name not in self.kinds

    def others(self, rule: Rule, each: str | None) -> tuple[str, ...]:
        """Return the names that ``other`` may stand for in a rule of touches, in the order of ``things``.

        Nothing touches itself; without ``each`` that may be any member of the rule's group.
        """
        found: set[str] = set()
        for touch in rule.moments(Touch):
            named = (self.named(names, rule.for_each, each) for names in (touch.entity, touch.other))
            found |= touched(*map(self.may_be, named))
        return tuple(sorted(found, key=self.index.__getitem__))


def has_other(rule: Rule) -> bool:
    """Return whether a rule may name ``other``: each of its triggers is a touch."""
    return len(rule.moments(Touch)) == len(rule.triggers)


def touched(entities: tuple[str, ...], others: tuple[str, ...]) -> set[str]:
    """Return those of the others that one of the entities may touch."""
    return {other for other in others if any(entity != other for entity in entities)}


def texts(node: Node | None) -> tuple[str, ...]:
    """Return the texts of a value or of a list, lists inside it included."""
    if isinstance(node, Leaf):
        return (node.value,) if isinstance(node.value, str) else ()
    if isinstance(node, Items):
        return tuple(text for item in node.items for text in texts(item))
    return ()


def _roster(
    sections: dict[str, tuple[str, ...]],
    *,
    colours: Mapping[str, str],
    movable: set[str],
    parts: Mapping[str, tuple[str, ...]],
    values: Mapping[str, tuple[Scalar, ...]],
    teams: dict[str, tuple[str, ...]],
    roles: Mapping[str, tuple[str, ...]],
    walls: bool,
) -> Roster:
    robots, balls, obstacles = (sections.get(section, ()) for section in ("robots", "balls", "obstacles"))
    entities = (*robots, *balls, *(name for name in obstacles if name in movable))
    things = (*entities, *(name for name in obstacles if name not in movable), WALLS)
    kinds: dict[str, str] = {}
    for section, kind in _KIND_OF_SECTION.items():
        for name in sections.get(section, ()):
            kinds.setdefault(name, kind)  # a name that is given twice is an error; the first one counts
    for name in obstacles:
        kinds.setdefault(name, "obstacle" if name in movable else "fixed obstacle")
    groups: dict[str, tuple[str, ...]] = {"robots": robots, "balls": balls, "obstacles": obstacles}
    if walls:
        kinds[WALLS], groups[WALLS] = WALLS, (WALLS,)
    groups[ENTRANTS] = tuple(dict.fromkeys(robot for team in teams.values() for robot in team))
    for name, colour in colours.items():
        if colour not in kinds:  # which is an error
            groups[colour] = (*groups.get(colour, ()), name)
    known = {name: members for name, members in groups.items() if name not in parts}
    groups |= {name: _members(name, parts, known) for name in parts}
    on_field = {*things, *groups, *kinds}
    return Roster(
        entities=entities,
        robots=len(robots),
        balls=len(balls),
        things=things,
        index={name: index for index, name in enumerate(things)},
        groups=groups,
        drawn={
            name: tuple(dict.fromkeys(value for value in decided if isinstance(value, str)))
            for name, decided in values.items()
            if name not in on_field
        },
        kinds=kinds,
        sections=sections,
        teams=teams,
        roles={role: _each_once(names, {**groups, ENTRANTS: tuple(teams)}) for role, names in roles.items()},
    )


def _each_once(names: Iterable[str], groups: Mapping[str, tuple[str, ...]]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(one for name in names for one in groups.get(name, (name,))))


def _members(
    group: str, parts: Mapping[str, tuple[str, ...]], known: dict[str, tuple[str, ...]], above: tuple[str, ...] = ()
) -> tuple[str, ...]:
    """Return the members of a group; a group that leads back to itself, which the checks report, ends there."""
    if group in above:
        return ()
    if group in parts and group not in known:
        inner = {part: _members(part, parts, known, (*above, group)) for part in parts[group]}
        known[group] = _each_once(parts[group], inner)
    return known.get(group, (group,))
