"""The value ``position_of``."""

from typing import Annotated

from rcj_challenges.rules.base import Firing, Phrases, Reader, Scope, ValueWord
from rcj_challenges.rules.fields import Name, described
from rcj_challenges.rules.refs import SEEN

_DIGITS = 6
"""To the micrometre, finer than float32 poses are anyway."""


class PositionValue(ValueWord):
    """Where an entity is when the rule fires: [x, y, yaw] in m and rad; null while it is off the field.

    Placements are carried out after all actions of the tick: for something that this rule places the value is the
    position before. A spot has no yaw: [x, y] in m, its current place if rules set it.
    """

    position_of: Annotated[Name, SEEN] = described(..., "an entity, a fixed obstacle, each, a spot, or a draw's name")

    KEY = "position_of"
    EXAMPLE = """
broadcast:
  every_ticks: 10
  fields: {ball: {position_of: ball}}
expect:
  all_robots_receive_the_position_of_the_ball:
    keyframes: [{at_s: 1, place: {ball: [0, 0.8]}}]
    lasts_s: 2
    told: {robots: {ball: [0, 0.8]}}
"""

    def read(self, to: Scope) -> Reader:
        locate = to.locate(self.position_of)

        def position(_firing: Firing) -> list[float] | None:
            pose = locate()
            return None if pose is None else [round(number, _DIGITS) for number in pose]

        return position

    def exactly(self, _phrases: Phrases) -> str:
        return "[x, y, yaw] in m and rad, of a spot [x, y]; null while it is off the field"

    def describe(self, phrases: Phrases) -> str:
        return f"the position of {phrases.thing(self.position_of)}"
