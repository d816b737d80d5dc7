"""The value ``distance``."""

from collections.abc import Callable
from typing import Annotated, Self

from pydantic import Field

from rcj_challenges.rules.base import Phrases, Reader, Scope
from rcj_challenges.rules.fields import MM_DIGITS, Name, Names, Point, described, is_named
from rcj_challenges.rules.refs import MEASURED_TO
from rcj_challenges.rules.values.number import NumberValue

_Several = Annotated[tuple[Name, ...], Field(strict=False, min_length=1)]


class DistanceValue(NumberValue):
    """The distance in m between the centres of two things, to the millimetre; none while one is off the field."""

    distance: Annotated[tuple[Name | Point | _Several, Name | Point], Field(strict=False), MEASURED_TO] = described(
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
rules:
  brought:
    triggers: [{trigger: time_reached, at_s: 3}]
    # 25 points, less 10 for each metre from the centre.
    actions:
      - {action: score, entrant: yellow, points: {distance: [ball, centre], times: -10, plus: 25}}
      - {action: emit, event: BROUGHT, payload: {distance_m: {distance: [ball, centre]}}}
    says: The ball has been delivered; {points} points.
expect:
  at_10_cm_it_gives_24_points:
    keyframes: [{at_s: 2, place: {ball: [0.1, 0]}}]
    lasts_s: 4
    score: {yellow: 24}
    events: [{event: BROUGHT, payload: {distance_m: 0.1}}]
"""
    SENTENCE = "the distance between the ball and the spot “centre” in m"

    def now(self, to: Scope) -> Callable[[], float | None]:
        read = self._measure(to)
        return lambda: None if (metres := read()) is None else round(metres, MM_DIGITS)

    def unrounded(self, to: Scope) -> Reader:
        read = self._measure(to)
        return lambda _firing: read()

    def _measure(self, to: Scope) -> Callable[[], float | None]:
        """Return a function that measures the distance; None if one of the two is off the field."""
        here, there = (to.targets(end) for end in self.distance)
        if any(one.place is None for one in here):
            here, there = there, here  # from what is a point to a zone or a gate
        pairs = [
            (one.place, other.away_m)
            for one in here
            for other in there
            if one.place is not None and not other.is_with(one.entity)
        ]

        def read() -> float | None:
            starts = ((place(), away_m) for place, away_m in pairs)
            distances = (away_m(*start) for start, away_m in starts if start is not None)
            return min((one for one in distances if one is not None), default=None)

        return read

    def names(self, _to: Scope) -> Names:
        return self.named()

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
