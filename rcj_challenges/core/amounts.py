"""Numbers as people write them: scores, counters and their sums, and names that carry a unit.

Whole numbers have no point, decimal numbers are exact; ``best_s`` is ``best (s)``, and with a value ``best 10.48 s``.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

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


class Noun(NamedTuple):
    """What a part of a match is called, and several of them."""

    one: str
    many: str

    def __str__(self) -> str:
        return self.one

    @property
    def a(self) -> str:
        """Any of them: ``a half``, ``an inning``."""
        return f"{'an' if self.one[0] in 'aeiou' else 'a'} {self.one}"

    def counted(self, number: int) -> str:
        """Format a count of them: ``1 half``, ``2 halves``."""
        return counted(number, *self)


HALF = Noun("half", "halves")


def times(number: int) -> str:
    """Format how often: ``never``, ``once``, ``3 times``."""
    return {0: "never", 1: "once"}.get(number, f"{number} times")


def clamp_to_max(value: float) -> int | float:
    """Clamp a number to `MOST` and its negative; return everything else unchanged."""
    return MOST if value > MOST else max(value, -MOST)


_UNITS = {
    "m": "m", "cm": "cm", "mm": "mm", "s": "s", "ms": "ms", "rad": "rad", "mps": "m/s", "radps": "rad/s", "kg": "kg",
}  # fmt: skip
"""The units with which names of counters, values and fields of payloads end, and how they are written."""


_MAX_DECIMALS = 15  # so many digits of a float are exact


def measure(name: str) -> tuple[str, str]:
    """Split a name into text and unit: ``("best", "s")`` of ``best_s``, ``("laps", "")`` of ``laps``."""
    words, _, last = name.rpartition("_")
    if words and last in _UNITS:
        return words.replace("_", " "), _UNITS[last]
    return name.replace("_", " "), ""


def measure_words(name: str) -> str:
    """Return a name with its unit: ``best (s)``, ``laps``."""
    words, unit = measure(name)
    return f"{words} ({unit})" if unit else words


def measured_words(name: str, value: str) -> str:
    """Return a name with a value and its unit: ``best 10.48 s``, ``laps 3``, ``best none``."""
    words, unit = measure(name)
    return " ".join(part for part in (words, value, unit if value != "none" else "") if part)


def distinct_decimals(measured: float | None, limit: float | None, decimals: int) -> int:
    """Return so many decimals, or more if a measurement would otherwise be rounded to its limit."""
    if measured is not None and limit is not None and measured != limit:
        while decimals < _MAX_DECIMALS and round(measured, decimals) == round(limit, decimals):
            decimals += 1
    return decimals


def number_words(value: float | None, decimals: int = 6) -> str:
    """Format a number without superfluous zeros and without rounding away digits that decide: ``10.48``."""
    if value is None:
        return "none"
    number = f"{value:.{decimals}f}"
    number = number.rstrip("0").rstrip(".") if "." in number else number
    return "0" if number == "-0" else number
