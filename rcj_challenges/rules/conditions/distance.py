"""What is particular to the condition ``distance``."""

from rcj_challenges.rules.base import Phrases
from rcj_challenges.rules.comparison import Compared
from rcj_challenges.rules.fields import Name, Names, Point, is_named
from rcj_challenges.rules.values.distance import DistanceValue


class DistanceIs(Compared, DistanceValue):
    """The distance in m between two things; it never holds while one is off the field."""

    VALUE = DistanceValue
    ASKS_WHERE = True
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
    SENTENCE = "all of the blue robots are at least 0.3 m from the ball"

    def grouped(self) -> Names | None:
        return self.named() or None

    def about(self) -> Names | None:
        """Return the entities whose place it reads."""
        return self.named() or None

    def distances_m(self) -> tuple[tuple[Name | Point, float], ...]:
        limits = () if self.value.is_computed() else (limit for _, limit in self.limits())
        return tuple((self.distance[1], float(one)) for one in limits if isinstance(one, int | float) and one > 0)

    def describe(self, phrases: Phrases) -> str:
        here, there = self.distance
        if self.value.is_computed() or not is_named(here):
            return super().describe(phrases)
        subject = phrases.quantified(self.of or "any", here, negate=self.negate)
        point = phrases.point(there, here)
        opposite = self.opposite(phrases, " m") if subject.negated else None
        if opposite is None:
            return f"{subject.does('is', 'are')} {self.compared(phrases, ' m', f' from {point}')}"
        # Nothing is measured to what is off the field: then the opposite of it holds.
        off = ", or one of the two is off the field" if phrases.may_be_off() else ""
        return f"{subject.text} is {opposite} from {point}{off}"
