"""The action ``set_phase``."""

from typing import Annotated, Literal

from rcj_challenges.rules.base import Act, Action, Binder, Phrases
from rcj_challenges.rules.effects import SetsPhase
from rcj_challenges.rules.fields import Name, described
from rcj_challenges.rules.phrasing import quoted
from rcj_challenges.rules.refs import PHASE


class SetPhase(Action):
    """Enter a phase when the round of this rule ends; if it is the current one, it begins again."""

    action: Literal["set_phase"]
    phase: Annotated[Name, PHASE] = described(..., "the phase")

    NOTES = ("A rule that begins the phase that is already on restarts it, with all of its time.",)
    EFFECT = SetsPhase
    EXAMPLE = """
phases:
  second_task: {}
rules:
  first_done:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    actions: [{action: score, entrant: yellow}, {action: set_phase, phase: second_task}]
  second_done:
    phases: [second_task]
    triggers: [{trigger: enters, entity: ball, zone: yellow_goal}]
    actions: [{action: score, entrant: yellow, points: 2}, {action: set_phase, phase: play}]
expect:
  one_after_the_other:
    keyframes:
      - {at_s: 1, place: {ball: [0, -0.8]}}
      - {at_s: 2, place: {ball: [0, 0.8]}}
      - {at_s: 3, place: {ball: [0, -0.8]}}
    lasts_s: 4
    score: {yellow: 3}
    phase: play
"""

    def compile(self, to: Binder) -> Act:
        phase = self.phase
        return lambda _firing: to.enter_phase(phase)

    def describe(self, phrases: Phrases) -> str:
        return f"the phase {quoted(self.phase)} begins"
