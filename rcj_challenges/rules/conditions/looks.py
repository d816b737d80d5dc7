"""The condition ``looks``."""

from math import atan2, cos, pi, sin
from typing import Annotated, Literal

from rcj_challenges.rules.base import Binder, Condition, Phrases, Test
from rcj_challenges.rules.conditions.anchors import anchors
from rcj_challenges.rules.fields import Name, Names, Point, described
from rcj_challenges.rules.phrasing import degrees, heading
from rcj_challenges.rules.quantifier import Quantifier, quantified
from rcj_challenges.rules.refs import ROBOTS, SEEN


class Looks(Condition):
    """Whether a robot faces something, or a direction; both must be on the field."""

    condition: Literal["looks"]
    entity: Annotated[Names, ROBOTS] = described(..., "a robot, each, or a group with `of`")
    towards: Annotated[Name | Point | None, SEEN] = described(
        None, "an entity, a fixed obstacle, each, a spot, a draw's name, or [x, y] in m"
    )
    heading_rad: float | None = described(
        None, "instead of towards: a direction in rad, counter-clockwise from +x of the field"
    )
    within_rad: float = described(0.2, "how far off its front may point, to either side, in rad", gt=0, le=pi)
    of: Quantifier = described("any", "how many members of a group must do so")

    either = ("towards", "heading_rad")
    ABOUT = "entity"
    EXAMPLE = """
rules:
  goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    # For a fixed direction, write heading_rad: 1.57 instead of towards.
    conditions: [{condition: looks, entity: Y1, towards: ball, within_rad: 0.3}]
    actions: [{action: score, entrant: yellow}]
expect:
  it_counts_if_y1_watches_it:
    keyframes:
      - {at_s: 1, place: {Y1: [0, 0.2, 1.57], ball: [0, 0.8]}}
      - {at_s: 2, place: {Y1: [0, 0.2, 0], ball: [0, 0]}}
      - {at_s: 3, place: {ball: [0, 0.8]}}
    lasts_s: 4
    score: {yellow: 1}
"""
    SENTENCE = "Y1 looks towards the ball (to within 17.2°)"

    def test(self, to: Binder) -> Test:
        state, of, within, heading_rad = to.state, self.of, self.within_rad, self.heading_rad
        is_drawn = self.towards in to.drawn
        itself = () if self.towards is None or is_drawn else anchors(to, self.towards)
        entities = tuple(entity for entity in to.entities(self.entity) if entity not in itself)
        target = (lambda: None) if self.towards is None else to.locate(self.towards)

        def looks_there(entity: int) -> bool:
            x, y, yaw = state.poses[entity]
            wanted = heading_rad
            if wanted is None:
                at = target()
                if at is None or at == (x, y):  # nothing looks at itself, also if it is the one drawn
                    return False
                wanted = atan2(at[1] - y, at[0] - x)
            off = wanted - yaw
            return abs(atan2(sin(off), cos(off))) <= within

        return lambda: quantified(of, (looks_there(entity) for entity in entities if state.present[entity]))

    def watched(self, to: Binder) -> tuple[int, ...]:
        return (*super().watched(to), *(() if self.towards is None else anchors(to, self.towards)))

    def describe(self, phrases: Phrases) -> str:
        subject = phrases.quantified(self.of, self.entity, negate=self.negate).does("looks", "look")
        way = heading(self.heading_rad or 0.0) if self.towards is None else f"towards {phrases.point(self.towards)}"
        return f"{subject} {way} (to within {degrees(self.within_rad)})"
