"""An action that the package does not have."""

from typing import Annotated, Literal

from rcj_challenges.rules.base import Act, Action, Binder, Firing, Phrases
from rcj_challenges.rules.fields import Name, described
from rcj_challenges.rules.refs import WRITTEN_COUNTER


class Double(Action):
    """Double a counter."""

    action: Literal["double"]
    counter: Annotated[Name, WRITTEN_COUNTER] = described(..., "the counter")

    EXAMPLE = """
counters: {stake: {initial: 3}}
rules:
  goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    actions: [{action: double, counter: stake}]
    says: The stake doubles.
expect:
  three_become_six:
    keyframes: [{at_s: 1, place: {ball: [0, 0.8]}}]
    lasts_s: 2
    counters: {stake: 6}
"""

    def compile(self, to: Binder) -> Act:
        """Return what doubles the counter."""
        counters, name = to.state.counters, self.counter

        def act(_firing: Firing) -> None:
            counters[name] = 2 * to.state.counter(name, None)

        return act

    def describe(self, phrases: Phrases) -> str:
        """Return the action as a clause."""
        return f"{phrases.kept('counter', self.counter, None)} is doubled"
