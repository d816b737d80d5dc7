"""The value ``told``."""

from collections.abc import Callable
from typing import Annotated

from rcj_challenges.core.amounts import round_score
from rcj_challenges.core.messages import number_in
from rcj_challenges.rules.base import Firing, Number, Phrases, Reader, Scope
from rcj_challenges.rules.fields import Names, described
from rcj_challenges.rules.refs import ROBOT
from rcj_challenges.rules.values.number import NumberValue


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
# A wager: the goal pays as many points as the robot announced beforehand.
counters: {wager: {}}
rules:
  wagered:
    triggers: [{trigger: tells, entity: Y1, text: [1, 2, 3], is_a: number}]
    actions: [{action: count, counter: wager, to: {told: Y1}}]
    says: "{entity} wagers {measured}."
  goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    actions:
      - {action: score, entrant: yellow, points: {counter: wager, plus: 1}}
      - {action: emit, event: GOAL, payload: {told: {told: Y1}}}
expect:
  three_and_one_are_four_points:
    # A number that is too high is received, but does not match this rule.
    keyframes: [{at_s: 1, tells: {Y1: 3}}, {at_s: 2, tells: {Y1: 100}}, {at_s: 3, place: {ball: [0, 0.8]}}]
    lasts_s: 4
    score: {yellow: 4}
    events: [{event: GOAL, payload: {told: "100"}}]
"""
    SENTENCE = "what Y1 has told the referee last"

    def now(self, to: Scope) -> Callable[[], str | None]:
        messages, robot = to.state.messages, to.members(self.told)[0]
        return lambda: messages.get(robot)

    def measure(self, to: Scope) -> Reader:
        read = self.now(to)

        def read_number(_firing: Firing) -> Number | None:
            found = number_in(read() or "")
            return None if found is None else round_score(found)

        return read_number

    def describe(self, phrases: Phrases) -> str:
        return f"what {phrases.any_of(self.told)} has told the referee last"

    def describe_number(self, phrases: Phrases) -> str:
        return f"the number that {phrases.any_of(self.told)} has told the referee last"
