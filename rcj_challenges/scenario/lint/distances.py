"""Lint of distances: limits that nothing on the floor reaches, or that all on it keep; gaps and noise wider than it."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations
from math import dist, inf

from rcj_challenges.scenario.catalogue import EACH
from rcj_challenges.scenario.floor import floor_parts
from rcj_challenges.scenario.floor_shapes import away_m
from rcj_challenges.scenario.lint.logic import without_none
from rcj_challenges.scenario.lint.suspect import Subject, Suspect
from rcj_challenges.scenario.models.actions import Place
from rcj_challenges.scenario.models.base import Strict
from rcj_challenges.scenario.models.conditions import Distance, SpotFree
from rcj_challenges.scenario.models.places import (
    CircleZone,
    FurthestFree,
    HalfPlaneZone,
    NearestFree,
    Placing,
    PolygonZone,
    RectZone,
    Zone,
)
from rcj_challenges.scenario.models.robots import StartPose
from rcj_challenges.scenario.models.scenario import Rule
from rcj_challenges.scenario.models.triggers import Displaced
from rcj_challenges.scenario.polygons import distance_to_segment_m
from rcj_challenges.scenario.remembered import fixed_spots
from rcj_challenges.scenario.roster import row_of
from rcj_challenges.scenario.tree import Path
from rcj_challenges.scenario.visiting import visit

_ROOM_M = 0.05
"""Room for what is pushed into a wall, or lies in the mouth of a goal: far more than walls give."""

Point = tuple[float, float]


def check_distances(subject: Subject) -> Iterator[Suspect]:
    """Limits of distances that the floor is too small for, and such that are less than no distance."""
    parts = floor_parts(subject.scenario.field)
    corners = tuple(dict.fromkeys(corner for part in parts for corner in part))
    for name, rule in subject.scenario.rules.items():
        for model, path in visit(rule, ("rules", name)):
            if isinstance(model, Distance) and _is_of_itself(model, rule, subject):
                holds = "always" if without_none(model).negate else "never"
                reason = f"nothing is measured from '{model.to}' to itself, so that it {holds} holds"
                yield _suspect(path, "to", reason, "name the other thing, or the group of the others")
            elif isinstance(model, Distance):
                yield from _limits(model, path, _furthest_m(model, rule, subject, corners), subject, rule)

    yield from _elsewhere(subject, corners)


def _is_of_itself(model: Distance, rule: Rule, subject: Subject) -> bool:
    if not isinstance(model.to, str) or row_of(model.entity) != (model.to,):
        return False
    # Of a group the nearest other one counts; a group of one has no other.
    return model.to == EACH or subject.members(model.to, rule) == {model.to}


def _limits(model: Distance, path: Path, far_m: float, subject: Subject, rule: Rule) -> Iterator[Suspect]:
    for key in ("at_least", "at_most", "equals"):
        limit = getattr(model, key)
        if not isinstance(limit, int | float):
            continue
        if limit < 0 and key == "at_least":
            yield _suspect(path, key, "every distance keeps to it: none is less than 0", "correct it, or leave it out")
        elif limit < 0:
            to_zone = isinstance(model.to, str) and any(
                name in subject.scenario.zones for name in subject.members(model.to, rule)
            )
            inside = "; inside a zone it is 0" if to_zone else ""
            remedy = "ask for a smaller zone" if to_zone else "correct it"
            yield _suspect(path, key, f"no distance is less than 0{inside}", remedy)
        elif limit > far_m + _ROOM_M:
            what = "every distance keeps to it" if key == "at_most" else "it is never reached"
            place = model.to if isinstance(model.to, str) else f"({model.to[0]:g}, {model.to[1]:g})"
            reason = f"{what}: nothing on the floor is further than {far_m:.2f} m from {_words(place)}"
            yield _suspect(path, key, reason, "correct it; distances are in m")


def _words(place: str) -> str:
    return f"'{place}'" if place.isidentifier() else place


def _suspect(path: Path, key: str, reason: str, remedy: str) -> Suspect:
    return Suspect("distance_never_reached", (*path, key), reason, remedy)


# --- distances in triggers and placements -----------------------------------------------------------------------------


def _elsewhere(subject: Subject, corners: tuple[Point, ...]) -> Iterator[Suspect]:
    """Yield distances of triggers, gaps and noise that are wider than the floor: they are hardly meant in metres."""
    across_m = _across_m(corners)
    for model, path in subject.models:
        if isinstance(model, Displaced):
            yield from _never_displaced(model, path, corners)
        gap = _GAPS.get(type(model))
        if gap is not None and getattr(model, gap) > across_m + _ROOM_M:
            reason = f"no gap on this floor is wider than {across_m:.2f} m: there is never room"
            yield _suspect(path, gap, reason, "correct it; distances are in m")
        if isinstance(model, Place | Placing | StartPose):
            yield from _noise(model.noise_m, path, subject)


_GAPS: dict[type[Strict], str] = {
    Place: "min_clearance_m",
    Placing: "min_clearance_m",
    NearestFree: "clearance_m",
    FurthestFree: "clearance_m",
    SpotFree: "clearance_m",
}
"""What must be free around a place, by the model that says so."""


def _never_displaced(model: Displaced, path: Path, corners: tuple[Point, ...]) -> Iterator[Suspect]:
    is_put = isinstance(model.from_, str)
    far_m = _across_m(corners) if isinstance(model.from_, str) else _from_point_m(model.from_, corners)
    if model.distance_m > far_m + _ROOM_M:
        whence = "where it was put" if is_put else f"({model.from_[0]}, {model.from_[1]})"
        reason = f"it is never reached: nothing on the floor is further than {far_m:.2f} m from {whence}"
        yield _suspect(path, "distance_m", reason, "correct it; distances are in m")


def _noise(noise_m: Point, path: Path, subject: Subject) -> Iterator[Suspect]:
    field = subject.scenario.field
    if noise_m[0] > field.width_m or noise_m[1] > field.length_m:
        yield Suspect(
            "noise_wider_than_the_floor",
            (*path, "noise_m"),
            f"noise of {noise_m[0]:g} m and {noise_m[1]:g} m to either side leads beyond the floor, "
            f"which is {field.width_m:g} m wide and {field.length_m:g} m long",
            "correct it, lengths are in m; to put something anywhere write {uniform_in: ZONE}",
        )


# --- how far anything can be ------------------------------------------------------------------------------------------


def _furthest_m(model: Distance, rule: Rule, subject: Subject, corners: tuple[Point, ...]) -> float:
    """Return more than anything on the floor can be away from what a distance is measured to, in m."""
    if not isinstance(model.to, str):
        return _from_point_m(model.to, corners)
    return max((_from_m(name, subject, corners) for name in subject.members(model.to, rule)), default=inf)


def _from_m(name: str, subject: Subject, corners: tuple[Point, ...]) -> float:
    scenario, across_m = subject.scenario, _across_m(corners)
    fixed = fixed_spots(scenario).get(name)
    if fixed is not None:
        return _from_point_m((fixed.x_m, fixed.y_m), corners)
    if name in scenario.zones:
        return _from_zone_m(scenario.zones[name], corners)
    gate = scenario.gates.get(name)
    if gate is None:
        return across_m  # an entity, or a spot that rules set: they may be anywhere
    if gate.anchor is not None:
        return across_m + distance_to_segment_m(0.0, 0.0, *gate.from_m, *gate.to_m)
    return max(distance_to_segment_m(*corner, *gate.from_m, *gate.to_m) for corner in corners)


def _across_m(corners: tuple[Point, ...]) -> float:
    """Return how far two things on the floor can be apart, in m."""
    return max(dist(one, other) for one, other in combinations(corners, 2))


def _from_point_m(point: Point, corners: tuple[Point, ...]) -> float:
    # The floor lies within the hull of its corners, where nothing is further from a point, or from anything convex.
    return max(dist(point, corner) for corner in corners)


def _from_zone_m(zone: Zone, corners: tuple[Point, ...]) -> float:
    match zone:
        case RectZone(inverted=True):
            return _from_around_m(zone, corners)
        case CircleZone(inverted=True):
            return zone.radius_m
        case PolygonZone(inverted=True):
            return inf
        case PolygonZone():  # which may have bays: each of its corners is surely in it
            return min(_from_point_m(corner, corners) for corner in zone.points_m)
        case HalfPlaneZone(inverted=True):
            x, y = zone.normal
            zone = zone.model_copy(update={"normal": (-x, -y), "inverted": False})
    return max(away_m(zone, corner) for corner in corners)


def _from_around_m(zone: RectZone, corners: tuple[Point, ...]) -> float:
    """Return how deep in a rectangle anything can be: no deeper than it is behind each of its sides."""
    xs, ys = [x for x, _ in corners], [y for _, y in corners]
    deep = [
        (zone.x_min_m, 1.0, xs), (zone.x_max_m, -1.0, xs), (zone.y_min_m, 1.0, ys), (zone.y_max_m, -1.0, ys),
    ]  # fmt: skip
    return min(max(0.0, *(sign * (at - side) for at in ats)) for side, sign, ats in deep if side is not None)
