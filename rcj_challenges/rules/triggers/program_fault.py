"""The trigger ``program_fault``."""

from typing import Annotated, Literal

from rcj_challenges.rules.base import Trigger
from rcj_challenges.rules.binder import Binder
from rcj_challenges.rules.fields import Names, described
from rcj_challenges.rules.phrases import Phrases
from rcj_challenges.rules.refs import ROBOTS


class ProgramFault(Trigger):
    """Fires when a robot's program has failed."""

    trigger: Literal["program_fault"]
    robot: Annotated[Names, ROBOTS] = described("robots", "a robot, a group (any member), or each")

    EXAMPLE = """
rules:
  crashed:
    for_each: robots
    triggers: [{trigger: program_fault, robot: each}]
    actions: [{action: emit, event: CRASHED, payload: {robot_name: {word: robot_name}}}]
expect:
  the_robot_is_named:
    keyframes: [{at_s: 1, fault: [Y2]}]
    lasts_s: 2
    events: [{event: CRASHED, payload: {robot_name: Y2}}]
"""
    SENTENCE = "its program fails"

    def bind(self, to: Binder) -> None:
        """Bind a rule to the faults of each robot's program."""
        for robot in to.entities(self.robot):
            to.clock_events.faults.setdefault(to.name_of(robot), []).append(to.binding(robot))

    def describe(self, phrases: Phrases) -> str:
        """Return the part of a sentence that follows ``When``."""
        return f"{phrases.owned('program', self.robot)} fails"

    def about(self, _phrases: Phrases) -> Names | None:
        """Return what it can be about."""
        return self.robot
