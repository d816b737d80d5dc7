"""What is particular to the condition ``counter``."""

from rcj_challenges.rules.base import Phrases
from rcj_challenges.rules.comparison import Compared
from rcj_challenges.rules.kept import asked, kept
from rcj_challenges.rules.phrasing import quoted_measure
from rcj_challenges.rules.values import amount_words
from rcj_challenges.rules.values.counter import CounterValue


class CounterIs(Compared, CounterValue):
    """The value of a counter."""

    VALUE = CounterValue
    EXAMPLE = """
counters: {visits: {per: robots}}
zones: {light: {shape: circle, centre_m: [0, 0], radius_m: 0.2}}
timers: {round: {lasts_s: 5, starts: true}}
rules:
  visit:
    for_each: robots
    triggers: [{trigger: enters, entity: each, zone: light}]
    actions: [{action: count, counter: visits, entity: each}]
  last_is_out:
    for_each: robots
    triggers: [{trigger: timer_expired, timer: round}]
    # Compared with all other robots that are still on the field. If several tie for last, all are out.
    conditions:
      - {counter: visits, entity: each, at_most: {lowest: {counter: visits, entity: others}}}
    actions: [{action: remove, entity: each}, {action: emit, event: OUT, payload: {robot_name: {word: robot_name}}}]
expect:
  the_robot_with_the_fewest_visits_is_out:
    given: {counters: {visits: 1}}
    keyframes:
      - {at_s: 1, place: {B1: [0.1, 0], B2: [0, 0.1], B3: [-0.1, 0], Y1: [0, -0.1], Y3: [0, 0]}}
    lasts_s: 6
    events: [{event: OUT, at_s: 5, tolerance_s: 0.1, payload: {robot_name: Y2}}]
    # Per-entity counters can be listed one by one; `visits: 11` would be the sum. `given` accepts this too.
    counters: {visits: {Y1: 2, Y2: 1}}
"""
    SENTENCE = "its counter “visits” is at most the lowest counter “visits” of all others on the field"

    def describe(self, phrases: Phrases) -> str:
        if self.value.is_computed():
            return super().describe(phrases)
        if isinstance(self.equals, CounterValue):
            return self._equal(phrases, self.equals)
        subject = asked(phrases, self, "counter", self.counter)
        if subject is not None:
            return f"{subject.does('has', 'have')} a counter {quoted_measure(self.counter)} of {self.compared(phrases)}"
        counter = kept(phrases, self, "counter", self.counter)
        if self.negate and (opposite := self.opposite(phrases)):
            return f"{counter} is {opposite}"
        return f"{counter} is {'not ' if self.negate else ''}{self.compared(phrases)}"

    def _equal(self, phrases: Phrases, equals: CounterValue) -> str:
        """Return whether a counter is what another one is."""
        subject, other = asked(phrases, self, "counter", self.counter), amount_words(phrases, equals)
        if subject is not None:
            return f"{subject.does('has', 'have')} a counter {quoted_measure(self.counter)} equal to {other}"
        differs = "differs from" if self.negate else "is equal to"
        return f"{kept(phrases, self, 'counter', self.counter)} {differs} {other}"
