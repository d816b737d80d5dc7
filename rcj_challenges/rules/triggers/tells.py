"""The trigger ``tells``."""

from typing import Annotated, Literal

from rcj_challenges.rules.base import Binder, Phrases, Trigger
from rcj_challenges.rules.fields import Names, described
from rcj_challenges.rules.message import Message
from rcj_challenges.rules.refs import ROBOTS


class Tells(Trigger, Message):
    """Fires when a robot has sent the referee a radio message on the referee's channel.

    One message of each robot in a tick, in the order sent. In messages and sentences ``measured`` is the number in the
    message.
    """

    trigger: Literal["tells"]
    entity: Annotated[Names, ROBOTS] = described("robots", "a robot, a group (any member), or each")

    READS_MESSAGES = True
    MEASURED = "the number told"
    EXAMPLE = """
# Where is the treasure? The closer the position that a robot reports, the more points; each robot may report once.
spots: {treasure: {x_m: 0.4, y_m: -0.2}, guess: {x_m: 0, y_m: 0}}
rules:
  guessed:
    for_each: yellow
    # In a program: emitter.setChannel(1), then emitter.send("0.4 -0.3").
    triggers: [{trigger: tells, entity: each, is_a: position}]
    max_executions: 1
    actions:
      - {action: set_spot, spot: guess, to: {told: each}}
      - {action: score, entrant: each, points: {distance: [guess, treasure], times: -20, plus: 10}}
expect:
  a_tenth_of_a_metre_off_costs_2_points:
    keyframes: [{at_s: 1, tells: {Y1: "0.4 -0.3"}}, {at_s: 2, tells: {Y1: [0.4, -0.2]}}]
    lasts_s: 3
    score: {yellow: 8}
"""

    def bind(self, to: Binder) -> None:
        fits = self.matcher(to.state.draws)
        for robot in to.entities(self.entity):
            to.clock_events.messages.setdefault(to.state.names[robot], []).append((fits, to.binding(robot)))

    def describe(self, phrases: Phrases) -> str:
        return f"the referee receives {self.said(phrases) or 'a message'} from {phrases.any_of(self.entity)}"
