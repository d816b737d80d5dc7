"""The value ``told``."""

from typing import Annotated

from rcj_challenges.core.amounts import round_score
from rcj_challenges.core.messages import number_in
from rcj_challenges.rules.base import Firing, Number, Phrases, Reader, Scope
from rcj_challenges.rules.fields import Names, described
from rcj_challenges.rules.number import NumberValue
from rcj_challenges.rules.refs import ROBOT


class ReportedValue(NumberValue):
    """The text of a robot's last message to the referee in this half; none if there is none yet.

    Used as a number it is the number in the message, none if the message is not a number.
    """

    told: Annotated[Names, ROBOT] = described(
        ..., "a robot, or each; in highest, lowest and sum also a group or others"
    )

    KEY = "told"
    OVER = "told"
    READS_MESSAGES = True
    EXAMPLE = """
# A question with a number as its answer: the right one gives 5 points, any other costs as many as it says.
draws: {number: {values: [1, 2, 3]}}
rules:
  right:
    for_each: robots
    triggers: [{trigger: tells, entity: each, text: {draw: number}}]
    actions: [{action: score, entrant: each, points: 5}]
  wrong:
    for_each: robots
    triggers: [{trigger: tells, entity: each}]
    conditions: [{told: each, text: {draw: number}, negate: true}]
    actions:
      - {action: score, entrant: each, points: {told: each, times: -1}}
      - {action: emit, event: WRONG, payload: {robot_name: {word: robot_name}, told: {told: each}}}
expect:
  a_wrong_answer_and_a_right_one:
    draws: {number: 3}
    keyframes: [{at_s: 1, tells: {B1: 2}}, {at_s: 2, tells: {B1: 3}}]
    lasts_s: 3
    score: {blue: 3}
    events: [{event: WRONG, payload: {robot_name: B1, told: "2"}}]
"""

    def as_it_is(self, to: Scope) -> Reader:
        messages, robot = to.state.messages, to.members(self.told)[0]
        return lambda _firing: messages.get(robot)

    def measure(self, to: Scope) -> Reader:
        read = self.as_it_is(to)

        def read_number(firing: Firing) -> Number | None:
            found = number_in(read(firing) or "")
            return None if found is None else round_score(found)

        return read_number

    def describe(self, phrases: Phrases) -> str:
        return f"what {phrases.any_of(self.told)} has told the referee last"

    def describe_number(self, phrases: Phrases) -> str:
        return f"the number that {phrases.any_of(self.told)} has told the referee last"
