"""The value ``draw``: what a draw decided, where anything, a number or a duration is asked for."""

from dataclasses import replace
from math import inf
from typing import Annotated

from rcj_challenges.core.timing import TICK_S
from rcj_challenges.rules.base import Phrases, Reader, Scope
from rcj_challenges.rules.fields import LONGEST_S, Name, Scalar, described
from rcj_challenges.rules.number import NumberValue, as_number
from rcj_challenges.rules.phrasing import listed, quoted_measure, seconds, what_drawn
from rcj_challenges.rules.refs import DRAW

_NUMBERS, _DURATIONS = replace(DRAW, numbers=(-inf, inf)), replace(DRAW, numbers=(TICK_S, LONGEST_S))


class DrawValue(NumberValue):
    """The value of a draw."""

    draw: Annotated[Name, DRAW] = described(..., "a draw")

    KEY = "draw"
    EXAMPLE = """
draws:
  target: {values: [blue_goal, yellow_goal], not_last: true}
  bonus: {values: [5, 10]}
rules:
  hit_blue:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    conditions: [{draw: target, equals: blue_goal}]
    actions:
      - {action: score, entrant: yellow, points: {draw: bonus}}
      - {action: draw, draw: target}
      - {action: emit, event: NEXT_TARGET, payload: {target: {draw: target}}}
expect:
  then_the_other_one_is_drawn:
    draws: {target: blue_goal, bonus: 10}
    keyframes: [{at_s: 1, place: {ball: [0, 0.8]}}]
    lasts_s: 2
    events: [{event: NEXT_TARGET, payload: {target: yellow_goal}}]
    score: {yellow: 10}
"""

    def as_it_is(self, to: Scope) -> Reader:
        draws, name = to.state.draws, self.draw
        return lambda _firing: draws[name]

    def measure(self, to: Scope) -> Reader:
        read = self.as_it_is(to)
        return lambda firing: as_number(read(firing))

    def exactly(self, phrases: Phrases) -> tuple[Scalar, ...]:
        return phrases.draw_values(self.draw)

    def describe(self, _phrases: Phrases) -> str:
        return what_drawn(self.draw)


class NumberDraw(DrawValue):
    """What a draw decided, for a draw whose values are all numbers."""

    draw: Annotated[Name, _NUMBERS] = described(..., "a draw of numbers")


class DrawnDuration(DrawValue):
    """The duration that a draw decided."""

    draw: Annotated[Name, _DURATIONS] = described(..., "a draw whose values are durations in s")

    def describe(self, phrases: Phrases) -> str:
        """Return the value in words: ``5 s or 8 s, as “pause” is drawn``."""
        times_s = sorted({float(value) for value in phrases.draw_values(self.draw)})
        return f"{listed([seconds(time_s) for time_s in times_s], 'or')}, as {quoted_measure(self.draw)} is drawn"
