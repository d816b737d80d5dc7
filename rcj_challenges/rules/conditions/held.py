"""The condition ``held``."""

from typing import Annotated, Literal

from rcj_challenges.rules.base import Binder, Condition, Phrases, Test
from rcj_challenges.rules.fields import Names, described
from rcj_challenges.rules.quantifier import Quantifier, quantified
from rcj_challenges.rules.refs import ROBOTS


class IsHeld(Condition):
    """Whether a robot is held, by a rule or because the phase holds all robots; also for robots off the field."""

    condition: Literal["held"]
    entity: Annotated[Names, ROBOTS] = described(..., "a robot, each, or a group with `of`")
    of: Quantifier = described("any", "how many members of a group must be held")

    EXAMPLE = """
# A robot that moves during red is held for 3 s. After its release it may be caught again.
phases:
  red: {lasts_s: 10}
first_phase: red
rules:
  moves_at_red:
    for_each: robots
    phases: [red]
    triggers: [{trigger: holds, condition: {condition: speed, entity: each, at_least: 0.05}, for_s: 0.2}]
    conditions: [{condition: held, entity: each, negate: true}]
    actions: [{action: hold, entity: each, for_s: 3}]
  may_drive_again:
    for_each: robots
    phases: any
    triggers: [{trigger: holds, condition: {condition: held, entity: each, negate: true}}]
    actions: [{action: emit, event: MAY_DRIVE, payload: {robot_name: {word: robot_name}}}]
broadcast:
  fields: {Y1_is_held: {held: Y1}}
expect:
  a_moving_robot_is_held_for_three_seconds:
    keyframes: [{at_s: 1}, {at_s: 2, move: {Y1: [0, -0.2]}}]
    lasts_s: 6
    events: [{event: MAY_DRIVE, at_s: 4.3, tolerance_s: 0.1, payload: {robot_name: Y1}}]
    held: {Y1: false}
"""
    SENTENCE = "it is not held"

    def test(self, to: Binder) -> Test:
        held, of = to.state.held, self.of
        robots = to.entities(self.entity)
        return lambda: quantified(of, (held.holds(robot) for robot in robots))

    def describe(self, phrases: Phrases) -> str:
        return f"{phrases.quantified(self.of, self.entity, negate=self.negate).does('is', 'are')} held"
