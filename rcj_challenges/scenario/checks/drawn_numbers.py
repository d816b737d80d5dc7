"""What is wrong with a value of a draw, where the draw's name stands for a number."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from rcj_challenges.facts.timing import TICK_S
from rcj_challenges.rules.fields import LONGEST_S
from rcj_challenges.rules.kick import MAX_KICK_MPS, DrawnSpeed
from rcj_challenges.rules.values.draw import DrawnDuration, NumberDraw
from rcj_challenges.rules.values.term import term_of
from rcj_challenges.scenario.messages.wording import found_text
from rcj_challenges.scenario.tree import Leaf


def _no_number(value: Leaf) -> str:
    return f"expected a number, found {found_text(value)}" if isinstance(value.value, (str, bool)) else ""


def _no_duration(value: Leaf) -> str:
    if isinstance(value.value, int | float) and not isinstance(value.value, bool):
        if value.value < TICK_S:
            return f"a duration must be at least one tick ({TICK_S} s), found {found_text(value)}"
        if value.value > LONGEST_S:
            return f"must be at most {LONGEST_S}, found {found_text(value)}"
    return _no_number(value)


def _no_speed(value: Leaf) -> str:
    if isinstance(value.value, (str, bool)) or value.value is None:
        return _no_number(value)
    wrong = not 0 < value.value <= MAX_KICK_MPS
    return f"a kick's speed is over 0 and at most {MAX_KICK_MPS} m/s, found {found_text(value)}" if wrong else ""


DRAWN_NUMBERS: dict[Any, Callable[[Leaf], str]] = {
    NumberDraw: _no_number,
    term_of(NumberDraw): _no_number,
    DrawnDuration: _no_duration,
    DrawnSpeed: _no_speed,
}
"""By model: what is wrong with a value; an empty text if nothing is."""
