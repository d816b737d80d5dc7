"""The condition ``distance``."""

from collections.abc import Iterable
from typing import Annotated, Literal

from rcj_challenges.rules.base import Binder, Phrases, Test
from rcj_challenges.rules.comparison import Compared, to_mm
from rcj_challenges.rules.conditions.anchors import anchors
from rcj_challenges.rules.fields import Name, Names, Point, described
from rcj_challenges.rules.quantifier import Quantifier, quantified
from rcj_challenges.rules.refs import MEASURED_TO, MOVING, Ref


class Distance(Compared):
    """The distance in m of an entity's centre from another thing, a place or a point; it never holds off the field."""

    condition: Literal["distance"]
    entity: Annotated[
        Names,
        Ref(
            "entity",
            MOVING,
            groups=True,
            each=True,
            instead="name the obstacle in 'to', and in 'entity' the robot or ball that comes near it",
        ),
    ] = described(..., "an entity, each, or a group with `of`")
    to: Annotated[Name | Point, MEASURED_TO] = described(
        ...,
        "an entity, a fixed obstacle (its centre, or a wall's centre line), each, a spot, a gate or zone (its "
        "nearest point; inside a zone the distance is 0), a draw's name, a group (the nearest member), or [x, "
        "y] in m",
    )
    of: Quantifier = described("any", "how many members of a group must satisfy it")

    ABOUT = "entity"
    ASKS_WHERE = True
    EXAMPLE = """
gates: {line: {from_m: [-0.3, 0.3], to_m: [0.3, 0.3]}}
zones: {edge: {shape: rect, x_min_m: -0.5, x_max_m: 0.5, inverted: true}}
rules:
  open_goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    conditions: [{condition: distance, entity: blue, to: ball, at_least: 0.3, of: all}]
    actions: [{action: emit, event: OPEN_GOAL}]
  stopped_near_the_line:
    triggers: [{trigger: holds, condition: {condition: speed, entity: ball, at_most: 0.01}, for_s: 0.5}]
    conditions:
      - {condition: distance, entity: ball, to: line, at_most: 0.2}
      - {condition: distance, entity: ball, to: edge, at_least: 0.1}
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

    def test(self, to: Binder) -> Test:
        state, of = to.state, self.of
        entities, holds = to.entities(self.entity), self.comparison(to, counted=to_mm)
        targets = to.targets(self.to)
        # Nothing is measured from itself.
        others = {
            entity: tuple(target.away_m for target in targets if not target.is_with(entity)) for entity in entities
        }

        def results() -> Iterable[bool]:
            for entity in entities:
                if state.present[entity]:
                    x, y, _ = state.poses[entity]
                    distances = (away_m(x, y) for away_m in others[entity])
                    nearest = min((one for one in distances if one is not None), default=None)
                    if nearest is not None:
                        yield holds(nearest)

        return lambda: quantified(of, results())

    def watched(self, to: Binder) -> tuple[int, ...]:
        return (*super().watched(to), *anchors(to, self.to))

    def distances_m(self) -> tuple[tuple[Name | Point, float], ...]:
        limits = (limit for _, limit in self.limits())
        return tuple((self.to, float(limit)) for limit in limits if isinstance(limit, int | float) and limit > 0)

    def describe(self, phrases: Phrases) -> str:
        subject = phrases.quantified(self.of, self.entity, negate=self.negate)
        point = phrases.point(self.to, self.entity)
        opposite = self.opposite(phrases, " m") if subject.negated else None
        if opposite is None:
            return f"{subject.does('is', 'are')} {self.compared(phrases, ' m', f' from {point}')}"
        # Nothing is measured to what is off the field: then the opposite of it holds.
        off = ", or one of the two is off the field" if phrases.may_be_off() else ""
        return f"{subject.text} is {opposite} from {point}{off}"
