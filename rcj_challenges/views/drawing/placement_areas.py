"""Where rules and layouts put things, set spots or roll balls to, and where everything is once a half has begun."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product

from rcj_challenges.core.play import Pose2
from rcj_challenges.geometry.polygons import Point
from rcj_challenges.rules.base import PlaceWord
from rcj_challenges.rules.effects import Places, PlacesLayout, Removes, SetsSpot
from rcj_challenges.rules.fields import Names
from rcj_challenges.rules.placement import Mirror
from rcj_challenges.rules.places import place_of
from rcj_challenges.scenario.models.scenario import Rule, Scenario
from rcj_challenges.scenario.roster import EACH, OTHER, Roster, as_tuple
from rcj_challenges.scenario.rule_effects import alternatives, fixed_spots, rules_at_start, written_others
from rcj_challenges.scenario.shapes import point_words, start_noise_m, start_pose

Flip = tuple[bool, bool]
"""Whether x becomes -x, and whether y becomes -y."""
AS_WRITTEN: Flip = (False, False)


@dataclass(frozen=True)
class Area:
    """A place that is neither a spot nor a start.

    Attributes:
        at: the name of a zone, both ends of a line, all points of which are equally likely, or one point.
        noise_m: half width of the noise around it, in x and y.
        flip: how a zone is mirrored. (Points are mirrored themselves.)
        is_aim: whether a ball rolls there from where it is put.
    """

    at: str | tuple[Point, ...]
    noise_m: Point = (0.0, 0.0)
    flip: Flip = AS_WRITTEN
    is_aim: bool = False

    def words(self) -> str:
        """Return its place: ``(0, 0.1)``, ``(-0.3, 0) to (0.3, 0)``, ``in garden``, ``rolls towards (0, 0.1)``."""
        noise = f", ± {self.noise_m[0]:g}, {self.noise_m[1]:g}" if any(self.noise_m) else ""
        if isinstance(self.at, str):
            axes = " and ".join(f"{axis} becomes -{axis}" for axis, turns in zip("xy", self.flip, strict=True) if turns)
            where = f"{'' if self.is_aim else 'in '}{self.at}{f', mirrored ({axes})' if axes else ''}"
        else:
            where = " to ".join(map(point_words, self.at))
        return f"{'rolls towards ' if self.is_aim else ''}{where}{noise}"


def placement_areas(scenario: Scenario, roster: Roster) -> dict[Area, list[str]]:
    """Return the places where rules put things or set spots, with the names of these, as written."""
    found: dict[Area, list[str]] = {}
    for rule in scenario.rules.values():
        for put in _puts(scenario, rule):
            for area, names in _areas(scenario, roster, put):
                everything = found.setdefault(area, [])
                everything.extend(name for name in names if name not in everything)
    return found


def first_poses(scenario: Scenario, roster: Roster) -> dict[str, Pose2 | None]:
    """Return the poses of robots, balls and movable obstacles when a half has begun; None where that is not certain.

    Without rules that place them they are at their starts. They also may be there if one of several rules that may
    fire leaves them there.
    """
    poses: dict[str, Pose2 | None] = {name: start_pose(scenario, name) for name in roster.entities}
    possible: dict[str, list[Pose2 | None]] = {}
    for rule, surely in rules_at_start(scenario):
        placed = _placed(scenario, roster, rule, poses)
        if surely:
            poses |= placed
        else:
            for name, pose in placed.items():
                possible.setdefault(name, []).append(pose)
    return {name: pose if pose in possible.get(name, [pose]) else None for name, pose in poses.items()}


def _placed(scenario: Scenario, roster: Roster, rule: Rule, before: dict[str, Pose2 | None]) -> dict[str, Pose2 | None]:
    """Return the poses in which a rule puts things; None for what it takes off the field or may put elsewhere."""
    placed: dict[str, Pose2 | None] = {}
    for effect in rule.all_effects():
        if isinstance(effect, Removes):
            placed |= dict.fromkeys(roster.expand(_names(effect.names, rule)))
        if not isinstance(effect, Places | PlacesLayout):
            continue
        ends: list[dict[str, Pose2 | None]] = []
        for layout in alternatives(scenario, effect):
            ends.append(dict(placed))
            for one in layout:
                for name in roster.expand(_names(one.names, rule)):
                    ends[-1][name] = _certain_pose(scenario, roster, one, name)
        for name in {name for end in ends for name in end}:
            first, *others = (end.get(name, before[name]) for end in ends)
            placed[name] = first if all(other == first for other in others) else None
    return placed


def flipped(point: Point, flip: Flip) -> Point:
    """Return a point mirrored."""
    # Adding 0 turns -0 into 0.
    return (-point[0] + 0.0 if flip[0] else point[0], -point[1] + 0.0 if flip[1] else point[1])


_Put = tuple[tuple[str, ...], PlaceWord, Point, Flip, bool]
"""What is put where, with noise, mirrored, and whether it only rolls there."""
_EXACTLY: Point = (0.0, 0.0)


def _puts(scenario: Scenario, rule: Rule) -> Iterator[_Put]:
    for effect in rule.all_effects():
        match effect:
            case Removes(names, PlaceWord() as back_at):
                yield _names(names, rule), back_at, _EXACTLY, AS_WRITTEN, False
            case SetsSpot(spot, PlaceWord() as at, mirror):
                yield from (((spot,), at, _EXACTLY, flip, False) for flip in _flips(mirror))
            case Places() | PlacesLayout():
                for put in (one for layout in alternatives(scenario, effect) for one in layout):
                    names = _names(put.names, rule)
                    for flip in _flips(*put.mirrors):
                        yield names, put.at, put.how.noise_m, flip, False
                        if put.how.kick is not None:
                            yield names, place_of(put.how.kick.towards), _EXACTLY, flip, True


def _flips(*mirrors: Mirror | None) -> list[Flip]:
    """Return all ways in which mirrors, one applied after the other, may mirror a place."""
    ways: list[list[Flip]] = []
    for mirror in filter(None, mirrors):
        flip = mirror.axis in ("x", "both"), mirror.axis in ("y", "both")
        ways.append([flip] if mirror.when is None else [AS_WRITTEN, flip])
    return sorted({(sum(x for x, _ in way) % 2 == 1, sum(y for _, y in way) % 2 == 1) for way in product(*ways)})


def _certain_pose(scenario: Scenario, roster: Roster, put: Places, name: str) -> Pose2 | None:
    """Return the only pose that a placement can give; None if chance or the course of the half decides."""
    start, flips = start_pose(scenario, name), _flips(*put.mirrors)
    points = _points(scenario, roster, put.at) if put.at.options() else [start[:2]]
    if put.at.IS_SPREAD or len(points) != 1 or len(flips) != 1:
        return None
    yaw_rad = float(put.how.facing) if isinstance(put.how.facing, int | float) else start[2]
    return (*flipped(points[0], flips[0]), yaw_rad)


def _names(names: Names, rule: Rule) -> tuple[str, ...]:
    """Return names as a row, with what a rule goes over for ``each``, and what it finds touched for ``other``."""
    bound = {EACH: (rule.for_each or "",), OTHER: written_others(rule)}
    return tuple(one for name in as_tuple(names) for one in bound.get(name, (name,)))


def _areas(scenario: Scenario, roster: Roster, put: _Put) -> Iterator[tuple[Area, tuple[str, ...]]]:
    """Yield the places that a placement may choose from, with what is put there.

    Spots and starts are drawn anyway: they are areas only as an aim, mirrored, or with noise.
    """
    names, at, noise_m, flip, is_aim = put
    is_marked = is_aim or flip != AS_WRITTEN or any(noise_m)
    if not at.options():
        for name in (one for one in roster.expand(names) if is_marked and one in roster.things):
            own_m = _EXACTLY if is_aim else start_noise_m(scenario, name)
            both_m = (noise_m[0] + own_m[0], noise_m[1] + own_m[1])
            yield Area((flipped(start_pose(scenario, name)[:2], flip),), both_m, is_aim=is_aim), (name,)
        return
    points = [flipped(point, flip) for point in _points(scenario, roster, at, has_spots=is_marked)]
    if at.IS_SPREAD:
        zones = [name for option in at.options() if isinstance(option, str) for name in roster.expand(option)]
        yield from ((Area(zone, noise_m, flip, is_aim), names) for zone in zones if zone in scenario.zones)
        points_apart = [tuple(points)] if points else []
    else:
        points_apart = [(point,) for point in points]
    yield from ((Area(ends, noise_m, is_aim=is_aim), names) for ends in points_apart)


def _points(scenario: Scenario, roster: Roster, at: PlaceWord, *, has_spots: bool = True) -> list[Point]:
    """Return the points of a place, not mirrored, without spots that rules set and whatever moves."""
    fixed, (dx, dy) = fixed_spots(scenario), getattr(at, "offset_m", (0.0, 0.0))
    points: list[Point] = []
    for option in at.options():
        if not isinstance(option, str):
            points.append(option)
        elif has_spots or dx or dy:
            spots = (fixed[name] for name in roster.may_be(option) if name in fixed)
            points += [(spot.x_m + dx, spot.y_m + dy) for spot in spots]
    return points
