"""The value ``distance``."""

from typing import Annotated, Self

from pydantic import Field

from rcj_challenges.rules.base import Firing, Phrases, Reader, Scope
from rcj_challenges.rules.fields import MM_DIGITS, Name, Names, Point, described, is_named
from rcj_challenges.rules.number import NumberValue
from rcj_challenges.rules.phrasing import Clause
from rcj_challenges.rules.refs import MEASURED_TO

_Several = Annotated[tuple[Name, ...], Field(min_length=1)]


class DistanceValue(NumberValue):
    """The distance in m between the centres of two things, to the millimetre; none while one is off the field."""

    distance: Annotated[tuple[Name | Point | _Several, Name | Point], MEASURED_TO] = described(
        ...,
        "two of the following: an entity, a fixed obstacle, each, a spot, a draw's name, a group (the nearest "
        "member), [x, y] in m; one of them may be a wall, a gate or a zone: then its nearest point counts, and inside "
        "a zone the distance is 0; in highest, lowest and sum the first also a group or others",
    )

    KEY = "distance"
    OVER = "distance"
    DIGITS = MM_DIGITS
    UNIT = "m"
    EXAMPLE = """
gates: {line: {from_m: [-0.3, 0.3], to_m: [0.3, 0.3]}}
zones: {edge: {shape: rect, x_min_m: -0.5, x_max_m: 0.5, inverted: true}}
rules:
  open_goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    conditions: [{distance: [blue, ball], at_least: 0.3, of: all}]
    actions: [{action: emit, event: OPEN_GOAL}]
  stopped_near_the_line:
    triggers: [{trigger: holds, conditions: [{speed: ball, at_most: 0.01}], for_s: 0.5}]
    conditions:
      - {distance: [ball, line], at_most: 0.2}
      - {distance: [ball, edge], at_least: 0.1}
    actions:
      # The nearer to the line, the more points: 10 on it, 8 at 10 cm.
      - {action: score, entrant: yellow, points: {distance: [ball, line], times: -20, plus: 10}}
      - {action: emit, event: STOPPED, payload: {far_m: {distance: [ball, line]}, edge_m: {distance: [ball, edge]}}}
    says: The ball has stopped near the line; {points} points.
expect:
  no_blue_robot_is_near:
    keyframes: [{at_s: 1, place: {ball: [0, 0.8], B1: [0.5, 0], B2: [-0.5, 0], B3: [0, 0]}}]
    lasts_s: 2
    events: [{event: OPEN_GOAL}]
  at_10_cm_it_gives_8_points:
    keyframes: [{at_s: 1, place: {ball: [-0.2, 0.4]}}]
    lasts_s: 2
    score: {yellow: 8}
    events: [{event: STOPPED, payload: {far_m: 0.1, edge_m: 0.3}}]
  too_near_to_the_edge_it_gives_none:
    keyframes: [{at_s: 1, place: {ball: [0.45, 0.3]}}]
    lasts_s: 2
    events: []
"""

    def measure(self, to: Scope) -> Reader:
        here, there = (to.targets(end) for end in self.distance)
        if any(one.place is None for one in here):
            here, there = there, here  # from what is a point to a zone or a gate
        pairs = [
            (one.place, other.away_m)
            for one in here
            for other in there
            if one.place is not None and (other.entity is None or other.entity != one.entity)
        ]

        def read(_firing: Firing) -> float | None:
            starts = ((place(), away_m) for place, away_m in pairs)
            distances = (away_m(start[0], start[1]) for start, away_m in starts if start is not None)
            return min((one for one in distances if one is not None), default=None)

        return read

    def named(self) -> Names:
        """Return its first end, of which it is measured."""
        here = self.distance[0]
        return here if is_named(here) else ()

    def places(self, to: Scope) -> tuple[int, ...]:
        ends = (target.entity for end in self.distance for target in to.targets(end))
        return tuple(dict.fromkeys(entity for entity in ends if entity is not None))

    def of_member(self, member: str) -> Self:
        return self.model_copy(update={"distance": (member, self.distance[1])})

    def describe_each(self, phrases: Phrases) -> str:
        here, there = self.distance
        one = phrases.any_of(here) if is_named(here) else phrases.point(here)
        return f"distance between {one} and {phrases.point(there, here)} in {self.UNIT}"

    def describe(self, phrases: Phrases) -> str:
        here, there = self.distance
        one = phrases.any_of(here) if isinstance(here, tuple) and is_named(here) else phrases.point(here, there)
        other = phrases.point(there, here)
        inside = any(isinstance(end, str) and phrases.may_be_zone(end) for end in self.distance)
        return f"the distance between {one} and {other} in {self.UNIT}" + (" (0 inside)" if inside else "")

    def about(self) -> Names | None:
        return self.named() or None

    def measured_from(self) -> Name | Point:
        return self.distance[1]

    def clause(self, phrases: Phrases) -> Clause | None:
        here, there = self.distance
        if not is_named(here):
            return None
        where, off = f" from {phrases.point(there, here)}", ", or one of the two is off the field"
        return Clause(here, "is", "are", "{}", " m", where, off)
