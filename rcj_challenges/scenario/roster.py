"""Names to indices, once: which entities and things there are, in which order, and what a group stands for."""

from __future__ import annotations

from dataclasses import dataclass

from rcj_challenges.rules.fields import Names, Strict
from rcj_challenges.scenario.catalogue import EACH
from rcj_challenges.scenario.models.scenario import Scenario

WALLS = "walls"


def row_of(names: Names) -> tuple[str, ...]:
    """Return names as a row: where several may be written, one need not be in a list."""
    return (names,) if isinstance(names, str) else names


def written_for(names: Names, each: str | None) -> tuple[str, ...]:
    """Return names of a rule as a row, with another name for ``each``.

    Args:
        names: as they are written.
        each: for whom the rule is: one, or the whole group of its ``for_each``; None: ``each`` stays.
    """
    return tuple(each if name == EACH and each is not None else name for name in row_of(names))


@dataclass(frozen=True)
class Roster:
    """The order in which entities and things are numbered everywhere.

    Attributes:
        entities: robots, balls, movable obstacles; each kind in the order of the file.
        robots, balls: how many of the entities are robots; how many are balls.
        things: the entities, then the fixed obstacles, then ``walls``.
        index: name to index in ``things``.
        groups: group to the names of its members, nested groups resolved; the groups that always exist included.
        drawn: draw to the names among which it decides; of a draw that is called like something on the field that is
            meant, and not the draw.
    """

    entities: tuple[str, ...]
    robots: int
    balls: int
    things: tuple[str, ...]
    index: dict[str, int]
    groups: dict[str, tuple[str, ...]]
    drawn: dict[str, tuple[str, ...]]

    @classmethod
    def of(cls, scenario: Scenario) -> Roster:
        """Return the roster of a scenario whose references have been checked."""
        robots = tuple(scenario.robots)
        balls = tuple(scenario.balls)
        movable = tuple(name for name, obstacle in scenario.obstacles.items() if _movable(obstacle))
        fixed = tuple(name for name in scenario.obstacles if name not in movable)
        entities = robots + balls + movable
        things = (*entities, *fixed, WALLS)
        groups: dict[str, tuple[str, ...]] = {
            "robots": robots,
            "balls": balls,
            "obstacles": tuple(scenario.obstacles),
            WALLS: (WALLS,),
        }
        for name, robot in scenario.robots.items():
            groups[robot.colour] = (*groups.get(robot.colour, ()), name)
        for name in scenario.groups:
            groups[name] = _members(scenario, groups, name, ())
        on_field = {*things, *groups, *scenario.zones, *scenario.gates, *scenario.spots}
        return cls(
            drawn={
                name: tuple(dict.fromkeys(value for value in draw.values if isinstance(value, str)))
                for name, draw in scenario.draws.items()
                if name not in on_field
            },
            entities=entities,
            robots=len(robots),
            balls=len(balls),
            things=things,
            index={name: index for index, name in enumerate(things)},
            groups=groups,
        )

    def expand(self, names: Names) -> tuple[str, ...]:
        """Return the members that a name, a group or a list of both stands for, without repeats, in order."""
        return tuple(dict.fromkeys(member for name in row_of(names) for member in self.groups.get(name, (name,))))

    def may_be(self, names: Names) -> tuple[str, ...]:
        """Return the same, and for a draw's name all among which it decides: what the names may ever stand for."""
        expanded = self.expand(names)
        return tuple(dict.fromkeys(one for name in expanded for one in self.drawn.get(name, (name,))))


def _movable(obstacle: Strict) -> bool:
    return bool(getattr(obstacle, "movable", False))


def _members(
    scenario: Scenario, known: dict[str, tuple[str, ...]], name: str, above: tuple[str, ...]
) -> tuple[str, ...]:
    if name in known:
        return known[name]
    if name in above:  # a cycle; the checks report it, here it must only end
        return ()
    if name not in scenario.groups:
        return (name,)
    members = (m for part in scenario.groups[name] for m in _members(scenario, known, part, (*above, name)))
    known[name] = tuple(dict.fromkeys(members))
    return known[name]
