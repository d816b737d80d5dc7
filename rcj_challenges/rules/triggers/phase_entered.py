"""The trigger ``phase_entered``."""

from typing import Annotated, Literal

from pydantic import Field

from rcj_challenges.rules.base import Binder, Phrases, Trigger
from rcj_challenges.rules.effects import PhaseStart
from rcj_challenges.rules.fields import Name, described
from rcj_challenges.rules.phrasing import quoted
from rcj_challenges.rules.refs import PHASE


class PhaseEntered(Trigger):
    """Fires when a phase is entered (one tick after ``set_phase``); at the start of a half, use ``half_started``."""

    trigger: Literal["phase_entered"]
    phase: Annotated[Name, PHASE] = described(..., "the phase entered")
    from_: Annotated[Name | None, PHASE] = Field(None, alias="from", description="only if entered from this phase")

    IS_TIME = True
    MOMENT = PhaseStart
    EXAMPLE = """
phases:
  pause: {lasts_s: 2, next: play, waiting_for_kickoff: true}
rules:
  rest:
    triggers: [{trigger: time_reached, at_s: 1}]
    actions: [{action: set_phase, phase: pause}]
  go_on:
    triggers: [{trigger: phase_entered, phase: play, from: pause}]
    actions: [{action: emit, event: KICKOFF}]
expect:
  play_goes_on_after_2_s:
    keyframes: [{at_s: 1}]
    lasts_s: 5
    events: [{event: KICKOFF, at_s: 3.04, tolerance_s: 0.05}]
"""

    def bind(self, to: Binder) -> None:
        """Bind a rule to a phase: it is entered when the one before runs out, or one tick after ``set_phase``."""
        to.clock_events.entered.setdefault(self.phase, []).append((self.from_, to.binding()))

    def describe(self, phrases: Phrases) -> str:
        return f"the phase {quoted(self.phase)} begins" + (f" after {quoted(self.from_)}" if self.from_ else "")
