"""The trigger ``program_fault``."""

from typing import Annotated, Literal

from rcj_challenges.rules.base import Binder, Phrases, Trigger
from rcj_challenges.rules.fields import Names, described
from rcj_challenges.rules.refs import ROBOTS


class ProgramFault(Trigger):
    """Fires when a robot's program has failed."""

    trigger: Literal["program_fault"]
    robot: Annotated[Names, ROBOTS] = described("robots", "a robot, a group (any member), or each")

    ABOUT = "robot"
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

    def bind(self, to: Binder) -> None:
        for robot in to.entities(self.robot):
            to.clock_events.faults.setdefault(to.state.names[robot], []).append(to.binding(robot))

    def describe(self, phrases: Phrases) -> str:
        return f"{phrases.owned('program', self.robot)} fails"
