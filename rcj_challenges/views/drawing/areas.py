"""Where rules put things by chance or at a point, and where they roll balls to: each place once, with all of them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from rcj_challenges.scenario.models.actions import Place, Remove, SetSpot
from rcj_challenges.scenario.models.places import (
    At,
    AtPoint,
    AtSpot,
    Choice,
    FurthestFree,
    NearestFree,
    OnLine,
    Placing,
    RelativeTo,
    Start,
    UniformIn,
)
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.models.state import ToldValue
from rcj_challenges.scenario.remembered import fixed_spots
from rcj_challenges.scenario.roster import Roster, row_of
from rcj_challenges.views.drawing.beside import layouts_of, listed_names, places_beside
from rcj_challenges.views.drawing.flips import AS_WRITTEN, Flip, flipped, flips_of
from rcj_challenges.views.drawing.labels import Point
from rcj_challenges.views.drawing.shapes import home, point_words


@dataclass(frozen=True)
class Area:
    """A place of the field that is no spot and no start.

    Attributes:
        at: the name of a zone or a line, every point of which is equally likely, or a point.
        noise_m: half width of the noise around it, in x and y.
        flip: for a zone, how it is mirrored. (Lines and points are mirrored themselves.)
        aim: whether things are not put there, but roll there from where they are put.
    """

    at: str | OnLine | Point
    noise_m: Point
    flip: Flip = AS_WRITTEN
    aim: bool = False

    def words(self) -> str:
        """Return where it is: ``(0, 0.1)``, ``(-0.3, 0) to (0.3, 0)``, ``in garden``, ``rolls towards (0, 0.1)``."""
        where = self._where()
        return f"rolls towards {where.removeprefix('in ')}" if self.aim else where

    def _where(self) -> str:
        noise = f", ± {self.noise_m[0]:g}, {self.noise_m[1]:g}" if any(self.noise_m) else ""
        if isinstance(self.at, str):
            turned = [f"{axis} becomes -{axis}" for axis, turns in zip("xy", self.flip, strict=True) if turns]
            mirrored = f", mirrored ({' and '.join(turned)})" if turned else ""
            return f"in {self.at}{mirrored}{noise}"
        if isinstance(self.at, OnLine):
            return " to ".join(map(point_words, self.at.on_line)) + noise
        return point_words(self.at) + noise


def placement_areas(scenario: Scenario, roster: Roster) -> dict[Area, list[str]]:
    """Return the places where layouts and rules put things or set spots, with the names of these, as written.

    What a flag mirrors has both places.
    """
    found: dict[Area, list[str]] = {}
    for names, at, noise_m, flip, aim in _placings(scenario):
        marked = aim or flip != AS_WRITTEN or any(noise_m)
        for place, own in _areas(scenario, roster, at, names, marked=marked):
            around_m = noise_m if aim else _with_noise_of_start(scenario, at, own, noise_m)
            who = found.setdefault(_area(place, around_m, flip, aim=aim), [])
            who.extend(name for name in own if name not in who)
    for names, at_m, noise_m, aim in places_beside(scenario, roster):
        who = found.setdefault(Area(at_m, noise_m, aim=aim), [])
        who.extend(name for name in names if name not in who)
    return found


def _with_noise_of_start(scenario: Scenario, at: At | None, names: tuple[str, ...], noise_m: Point) -> Point:
    """Return the noise around a start: that of the placement, and around it that of the start itself."""
    robot = scenario.robots.get(names[0]) if _is_start(at) else None
    own_m = (0.0, 0.0) if robot is None else robot.start.noise_m
    return noise_m[0] + own_m[0], noise_m[1] + own_m[1]


def _is_start(at: At | None) -> bool:
    return at == "start" or isinstance(at, Start)


def _area(place: str | OnLine | Point, noise_m: Point, flip: Flip, *, aim: bool) -> Area:
    if isinstance(place, str):
        return Area(place, noise_m, flip, aim=aim)
    if isinstance(place, OnLine):
        start, end = (flipped(point, flip) for point in place.on_line)
        return Area(OnLine(on_line=(start, end)), noise_m, aim=aim)
    return Area(flipped(place, flip), noise_m, aim=aim)


_Put = tuple[tuple[str, ...], At | None, Point, Flip, bool]
"""What is put where, with what noise, how it is mirrored, and whether it only rolls there."""


def _placings(scenario: Scenario) -> Iterator[_Put]:
    """Yield what is put where by every rule and layout, and where it rolls to from there."""
    places = [(rule, action) for rule in scenario.rules.values() for action in rule.actions]
    for name, layout in scenario.placements.items():
        mirrors = [
            action.mirror for _, action in places if isinstance(action, Place) and name in layouts_of(scenario, action)
        ]
        # What no rule puts is nowhere.
        for placing in layout:
            for flip in flips_of(placing, mirrors):
                yield from _puts(placing, listed_names(placing.entity), flip)
    for rule, action in places:
        if isinstance(action, Place) and action.entity is not None:
            for flip in flips_of(action, [None]):
                yield from _puts(action, listed_names(action.entity, rule), flip)
        elif isinstance(action, Remove) and action.for_s is not None:
            yield listed_names(action.entity, rule), action.back_at, (0.0, 0.0), AS_WRITTEN, False
        elif isinstance(action, SetSpot) and not isinstance(action.to, str | ToldValue):
            # What is set to where something is has no place of its own.
            at = AtPoint(point=action.to) if isinstance(action.to, tuple) else action.to
            for flip in flips_of(action, [None]):
                yield (action.spot,), at, (0.0, 0.0), flip, False


def _puts(placing: Placing | Place, names: tuple[str, ...], flip: Flip) -> Iterator[_Put]:
    yield names, placing.at, placing.noise_m, flip, False
    if placing.kick is not None:
        yield names, placing.kick.towards, (0.0, 0.0), flip, True


def _areas(
    scenario: Scenario, roster: Roster, at: At | None, names: tuple[str, ...], *, marked: bool
) -> Iterator[tuple[str | OnLine | Point, tuple[str, ...]]]:
    """Yield the places that a word of ``at`` stands for, not yet mirrored, with what is put there.

    Args:
        scenario: the scenario.
        roster: its roster.
        at: the word.
        names: what is put there.
        marked: whether spots and starts, which are drawn anyway, are marked too: where mirrored, with noise, as an aim.
    """
    if isinstance(at, OnLine):
        yield at, names
    elif isinstance(at, UniformIn):
        yield from ((zone, names) for zone in roster.expand(at.uniform_in) if zone in scenario.zones)
    elif isinstance(at, AtPoint):
        yield at.point, names
    elif _is_start(at):
        things = {**scenario.robots, **scenario.balls, **scenario.obstacles}
        own = [name for name in roster.expand(names) if name in things] if marked else []
        yield from ((home(scenario, name), (name,)) for name in own)
    elif at is not None:
        yield from ((point, names) for point in _points(scenario, roster, at, marked=marked))


def _points(scenario: Scenario, roster: Roster, at: At, *, marked: bool) -> Iterator[Point]:
    """Yield the points that a word of ``at`` chooses from."""
    if isinstance(at, RelativeTo):
        dx, dy = at.offset_m
        if marked or any(at.offset_m):
            yield from ((x + dx, y + dy) for x, y in _spots(scenario, roster, at.relative_to))
        return
    for option in _options(at):
        if not isinstance(option, str):
            yield option
        elif marked:
            yield from _spots(scenario, roster, option)


def _options(at: At) -> tuple[str | Point, ...]:
    """Return what is chosen from: points, spots, groups of spots, and draws that decide among spots."""
    match at:
        case Choice():
            return at.choice
        case AtSpot():
            return (at.spot,)
        case NearestFree():
            return row_of(at.nearest_free)
        case FurthestFree():
            return row_of(at.furthest_free)
    return ()


def _spots(scenario: Scenario, roster: Roster, name: str) -> list[Point]:
    """Return the points of a spot, of a group of spots, or of all spots that a draw can decide.

    Of an entity, and of a spot that rules set, nobody knows where it is.
    """
    draw = None if name in scenario.spots else scenario.draws.get(name)
    spots = roster.expand(name) if draw is None else tuple(map(str, draw.values))
    fixed = fixed_spots(scenario)
    return [(fixed[one].x_m, fixed[one].y_m) for one in spots if one in fixed]
