"""The condition ``all_of``."""

from typing import Annotated, Literal

from pydantic import Field

from rcj_challenges.rules.base import Binder, Condition, Phrases, Test
from rcj_challenges.rules.conditions.several import all_hold, one_holds, opposites, watched_by
from rcj_challenges.rules.conditions.vocabulary import CONDITIONS


class AllOf(Condition):
    """Whether all of several conditions hold; for use in `holds` and `any_of`."""

    condition: Literal["all_of"]
    conditions: tuple[Annotated[Condition, CONDITIONS.without("all_of")], ...] = Field(
        ...,
        strict=False,
        min_length=1,
        description="the conditions, each as in a rule; any_of may be one of them, but not all_of itself",
    )

    EXAMPLE = """
# Both must hold for 2 s: the robot is in the circle and the ball is near it. In `conditions`, simply list both.
zones: {circle: {shape: circle, centre_m: [0, 0], radius_m: 0.2}}
rules:
  parked:
    triggers:
      - trigger: holds
        for_s: 2
        condition:
          condition: all_of
          conditions:
            - {condition: in_zone, entity: Y3, zone: circle}
            - {condition: distance, entity: ball, to: Y3, at_most: 0.2}
    actions: [{action: emit, event: PARKED}]
expect:
  it_fires_2_s_after_both_hold:
    keyframes: [{at_s: 1, place: {Y3: [0, 0], ball: [0.5, 0]}}, {at_s: 2, place: {ball: [0.1, 0]}}]
    lasts_s: 5
    events: [{event: PARKED, at_s: 4, tolerance_s: 0.1}]
"""
    SENTENCE = "Y3 is in the circle and the ball is at most 0.2 m from Y3"

    def is_several(self) -> bool:
        return len(self.conditions) > 1

    def test(self, to: Binder) -> Test:
        tests = tuple(condition.compile(to) for condition in self.conditions)
        return lambda: all(test() for test in tests)

    def watched(self, to: Binder) -> tuple[int, ...]:
        return watched_by(to, self.conditions)

    def describe(self, phrases: Phrases) -> str:
        # Not all of them hold: of one the opposite does.
        return one_holds(phrases, opposites(self.conditions)) if self.negate else all_hold(phrases, self.conditions)
