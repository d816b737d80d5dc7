"""Where rules and layouts put things, set spots, or roll balls to: each place once, with what is put there."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product
from typing import NamedTuple

from rcj_challenges.rules.actions.place import Place
from rcj_challenges.rules.actions.remove import Remove
from rcj_challenges.rules.actions.set_spot import SetSpot
from rcj_challenges.rules.fields import Names
from rcj_challenges.rules.mirror import Mirror
from rcj_challenges.rules.places import At
from rcj_challenges.rules.places.choice import Choice
from rcj_challenges.rules.places.furthest_free import FurthestFree
from rcj_challenges.rules.places.nearest_free import NearestFree
from rcj_challenges.rules.places.on_line import OnLine
from rcj_challenges.rules.places.point import AtPoint
from rcj_challenges.rules.places.relative_to import RelativeTo
from rcj_challenges.rules.places.spot import AtSpot
from rcj_challenges.rules.places.start import Start
from rcj_challenges.rules.places.uniform_in import UniformIn
from rcj_challenges.rules.values.draw import DrawValue
from rcj_challenges.rules.values.told import ToldValue
from rcj_challenges.scenario.catalogue import EACH, OTHER
from rcj_challenges.scenario.models.places import Placing
from rcj_challenges.scenario.models.scenario import Rule, Scenario
from rcj_challenges.scenario.other import written_others
from rcj_challenges.scenario.remembered import fixed_spots
from rcj_challenges.scenario.roster import Roster, row_of
from rcj_challenges.views.drawing.shapes import Point, home, point_words

Flip = tuple[bool, bool]
"""Whether x becomes -x, and whether y becomes -y."""
AS_WRITTEN: Flip = (False, False)


class Beside(NamedTuple):
    """A place beside something that moves: it has no place in the drawing, only its numbers in the legend."""

    anchor: str
    offset_m: Point
    turns: bool


@dataclass(frozen=True)
class Area:
    """A place that is neither a spot nor a start.

    Attributes:
        at: the name of a zone or a line, all points of which are equally likely, a point, or a place beside something.
        noise_m: half width of the noise around it, in x and y.
        flip: how a zone is mirrored. (Lines and points are mirrored themselves.)
        aim: whether things are not put there, but roll there from where they are put.
    """

    at: str | OnLine | Point | Beside
    noise_m: Point = (0.0, 0.0)
    flip: Flip = AS_WRITTEN
    aim: bool = False

    def words(self) -> str:
        """Return where it is: ``(0, 0.1)``, ``(-0.3, 0) to (0.3, 0)``, ``in garden``, ``rolls towards (0, 0.1)``."""
        where = self._where() + (f", ± {self.noise_m[0]:g}, {self.noise_m[1]:g}" if any(self.noise_m) else "")
        return f"rolls towards {where.removeprefix('in ')}" if self.aim else where

    def _where(self) -> str:
        if isinstance(self.at, str):
            mirrored = " and ".join(
                f"{axis} becomes -{axis}" for axis, turns in zip("xy", self.flip, strict=True) if turns
            )
            return f"in {self.at}" + (f", mirrored ({mirrored})" if mirrored else "")
        if isinstance(self.at, OnLine):
            return " to ".join(map(point_words, self.at.on_line))
        if isinstance(self.at, Beside):
            turning = ", in its own frame" if self.at.turns else ""
            return f"{point_words(self.at.offset_m)} from {self.at.anchor}{turning}"
        return point_words(self.at)


def placement_areas(scenario: Scenario, roster: Roster) -> dict[Area, list[str]]:
    """Return the places where layouts and rules put things or set spots, with the names of these, as written."""
    found: dict[Area, list[str]] = {}
    for put in _puts(scenario):
        for area, names in _areas(scenario, roster, put):
            everything = found.setdefault(area, [])
            everything.extend(name for name in names if name not in everything)
    return found


def flipped(point: Point, flip: Flip) -> Point:
    """Return a point mirrored."""
    # Adding 0 turns -0 into 0.
    return (-point[0] + 0.0 if flip[0] else point[0], -point[1] + 0.0 if flip[1] else point[1])


def layouts_of(scenario: Scenario, action: Place) -> list[str]:
    """Return the layouts that an action may place."""
    if isinstance(action.layout, DrawValue):
        return [str(value) for value in scenario.draws[action.layout.draw].values]
    return [] if action.layout is None else [action.layout]


class _Put(NamedTuple):
    """What is put where, with noise, mirrored; ``aim``: it only rolls there."""

    names: tuple[str, ...]
    at: At | None
    noise_m: Point = (0.0, 0.0)
    flip: Flip = AS_WRITTEN
    aim: bool = False
    rule: Rule | None = None

    @property
    def is_marked(self) -> bool:
        """Whether spots and starts, which are drawn anyway, have to be marked as places too."""
        return self.aim or self.flip != AS_WRITTEN or any(self.noise_m)


def _puts(scenario: Scenario) -> Iterator[_Put]:
    actions = [(rule, action) for rule in scenario.rules.values() for action in rule.actions]
    for name, layout in scenario.placements.items():
        mirrors = [
            action.mirror for _, action in actions if isinstance(action, Place) and name in layouts_of(scenario, action)
        ]  # empty for a layout that no rule places
        for placing, mirror in product(layout, mirrors):
            for flip in _flips(placing.mirror, mirror):
                yield from _put_and_kick(placing, _names(placing.entity, None), flip, None)
    for rule, action in actions:
        if isinstance(action, Place) and action.entity is not None:
            for flip in _flips(action.mirror):
                yield from _put_and_kick(action, _names(action.entity, rule), flip, rule)
        elif isinstance(action, Remove) and action.for_s is not None:
            yield _Put(_names(action.entity, rule), action.back_at, rule=rule)
        elif isinstance(action, SetSpot) and not isinstance(action.to, str | ToldValue):
            at = AtPoint(point=action.to) if isinstance(action.to, tuple) else action.to
            for flip in _flips(action.mirror):
                yield _Put((action.spot,), at, flip=flip, rule=rule)


def _put_and_kick(placing: Placing | Place, names: tuple[str, ...], flip: Flip, rule: Rule | None) -> Iterator[_Put]:
    yield _Put(names, placing.at, placing.noise_m, flip, rule=rule)
    if placing.kick is not None:
        yield _Put(names, placing.kick.towards, flip=flip, aim=True, rule=rule)


def _flips(*mirrors: Mirror | None) -> list[Flip]:
    """Return all ways in which mirrors, one applied after the other, may mirror a place."""
    ways: list[list[Flip]] = []
    for mirror in mirrors:
        flip = AS_WRITTEN if mirror is None else (mirror.axis in ("x", "both"), mirror.axis in ("y", "both"))
        ways.append([flip] if mirror is None or mirror.when is None else [AS_WRITTEN, flip])
    return sorted({(sum(x for x, _ in way) % 2 == 1, sum(y for _, y in way) % 2 == 1) for way in product(*ways)})


def _names(names: Names, rule: Rule | None) -> tuple[str, ...]:
    """Return names as a row, with what a rule goes over for ``each``, and what it finds touched for ``other``."""
    bound = {} if rule is None else {EACH: (rule.for_each or "",), OTHER: written_others(rule)}
    return tuple(one for name in row_of(names) for one in bound.get(name, (name,)))


def _areas(scenario: Scenario, roster: Roster, put: _Put) -> Iterator[tuple[Area, tuple[str, ...]]]:
    """Yield the places that a placement may choose from, with what is put there."""
    names, at, noise_m, flip, aim, rule = put
    match at:
        case OnLine(on_line=(start, end)):
            yield Area(OnLine(on_line=(flipped(start, flip), flipped(end, flip))), noise_m, aim=aim), names
        case UniformIn():
            zones = (zone for zone in roster.expand(at.uniform_in) if zone in scenario.zones)
            yield from ((Area(zone, noise_m, flip, aim), names) for zone in zones)
        case "start" | Start():
            yield from _starts(scenario, roster, put)
        case RelativeTo(relative_to=anchor) if not all(one in scenario.spots for one in roster.may_be(anchor)):
            if any(at.offset_m) or anchor not in names:
                offset_m = at.offset_m if at.turns else flipped(at.offset_m, flip)
                anchors = " or ".join(_names(anchor, rule))
                yield Area(Beside(anchors, offset_m, at.turns), noise_m, aim=aim), names
        case _:
            yield from (
                (Area(flipped(point, flip), noise_m, aim=aim), names) for point in _points(scenario, roster, put)
            )


def _points(scenario: Scenario, roster: Roster, put: _Put) -> list[Point]:
    """Return the points that a placement may choose from, not yet mirrored; without spots as they are drawn anyway."""
    match put.at:
        case RelativeTo(relative_to=anchor, offset_m=(dx, dy)):
            spots = _spots(scenario, roster, anchor) if put.is_marked or dx or dy else []
            return [(x + dx, y + dy) for x, y in spots]
        case AtPoint(point=point):
            return [point]
        case (
            AtSpot(spot=options)
            | Choice(choice=options)
            | NearestFree(nearest_free=options)
            | FurthestFree(furthest_free=options)
        ):
            pass
        case _:
            return []
    points: list[Point] = []
    for option in options if isinstance(options, tuple) else (options,):
        if not isinstance(option, str):
            points.append(option)
        elif put.is_marked:
            points += _spots(scenario, roster, option)
    return points


def _starts(scenario: Scenario, roster: Roster, put: _Put) -> Iterator[tuple[Area, tuple[str, ...]]]:
    """Yield the start of each thing; noise of the placement adds to the noise of the start itself."""
    for name in roster.expand(put.names) if put.is_marked else ():
        if name in scenario.robots or name in scenario.balls or name in scenario.obstacles:
            own_m = scenario.robots[name].start.noise_m if name in scenario.robots and not put.aim else (0.0, 0.0)
            noise_m = (put.noise_m[0] + own_m[0], put.noise_m[1] + own_m[1])
            yield Area(flipped(home(scenario, name), put.flip), noise_m, aim=put.aim), (name,)


def _spots(scenario: Scenario, roster: Roster, name: str) -> list[Point]:
    """Return the points of a spot, a group, or a draw among spots, without those that rules set."""
    fixed = fixed_spots(scenario)
    return [(fixed[one].x_m, fixed[one].y_m) for one in roster.may_be(name) if one in fixed]
