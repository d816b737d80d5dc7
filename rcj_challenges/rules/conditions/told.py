"""The condition ``told``."""

from typing import Annotated, Literal

from rcj_challenges.rules.base import Binder, Condition, Phrases, Test
from rcj_challenges.rules.fields import Names, described
from rcj_challenges.rules.message import Message
from rcj_challenges.rules.quantifier import Quantifier, quantified
from rcj_challenges.rules.refs import ROBOTS


class Told(Condition, Message):
    """A robot's last message to the referee in this half; the condition does not hold before the first one.

    Without `text` and `is_a`: whether it has sent any message.
    """

    condition: Literal["told"]
    entity: Annotated[Names, ROBOTS] = described(..., "a robot, each, or a group with `of`")
    of: Quantifier = described("any", "how many members of a group must have sent it")

    READS_MESSAGES = True
    EXAMPLE = """
# A question with a number as its answer: the right one gives 5 points, any other costs one.
draws: {number: {values: [1, 2, 3]}}
rules:
  right:
    for_each: robots
    triggers: [{trigger: tells, entity: each, text: {draw: number}}]
    actions: [{action: score, entrant: each, points: 5}]
  wrong:
    for_each: robots
    triggers: [{trigger: tells, entity: each}]
    conditions: [{condition: told, entity: each, text: {draw: number}, negate: true}]
    actions:
      - {action: score, entrant: each, points: -1}
      - {action: emit, event: WRONG, payload: {robot_name: {word: robot_name}, told: {told: each}}}
expect:
  a_wrong_answer_and_a_right_one:
    draws: {number: 3}
    keyframes: [{at_s: 1, tells: {B1: 2}}, {at_s: 2, tells: {B1: 3}}]
    lasts_s: 3
    score: {blue: 4}
    events: [{event: WRONG, payload: {robot_name: B1, told: "2"}}]
"""
    SENTENCE = "it does not have what was drawn as “number” as its last message to the referee"

    def test(self, to: Binder) -> Test:
        messages, of, fits = to.state.messages, self.of, self.matcher(to.state.draws)
        robots = to.members(self.entity)
        return lambda: quantified(of, (robot in messages and fits(messages[robot]) for robot in robots))

    def describe(self, phrases: Phrases) -> str:
        subject, said = phrases.quantified(self.of, self.entity, negate=self.negate), self.said(phrases)
        if not said:
            return f"{subject.does('was', 'were')} heard by the referee before"
        their = "their" if subject.plural else "its"
        return f"{subject.does('has', 'have')} {said} as {their} last message to the referee"
