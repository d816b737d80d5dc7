"""Scores, counters and their sums as people write them: whole numbers without a point, decimal numbers exact."""

from __future__ import annotations

from collections.abc import Iterable

_DECIMALS = 9

Score = int | float
"""Points of a team, or what a counter counts: decimal points are allowed."""

MOST = 10**15
"""Scores and counters stay between this and its negative: up to there floats represent every whole number exactly, here
and in a browser."""


def plain(value: float) -> int | float:
    """Return whole numbers as integers: scores and payloads show 3, not 3.0."""
    return int(value) if isinstance(value, float) and value.is_integer() else value


def add_up(values: Iterable[float]) -> int | float:
    """Add from left to right and round after each addition, so that the last bit is the same in every Python.

    From Python 3.12 on, the built-in ``sum`` compensates what it rounds. Code that decides a match does not use it for
    floats (`scripts/check_float_sums.py`).
    """
    total: int | float = 0
    for value in values:
        total += value
    return total


def round_score(value: float) -> int | float:
    """Round a score or counter to what it would be on paper: three times 0.1 is 0.3, not 0.30000000000000004.

    Every score, counter and sum of them comes through here after each change, so that conditions, events, records and
    the ranking see the same number. One that grows beyond `MOST` stays there.
    """
    return plain(round(clamp_to_max(value), _DECIMALS))


def counted(number: int, noun: str, plural: str = "") -> str:
    """Format a count of things in words: ``1 rule``, ``3 rules``; with ``plural`` where that takes more than an s."""
    return f"{number} {noun if number == 1 else plural or f'{noun}s'}"


def times(number: int) -> str:
    """Format how often: ``never``, ``once``, ``3 times``."""
    return {0: "never", 1: "once"}.get(number, f"{number} times")


def clamp_to_max(value: float) -> int | float:
    """Clamp a number to `MOST` and its negative; return everything else unchanged."""
    return MOST if value > MOST else max(value, -MOST)
