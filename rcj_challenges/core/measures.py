"""Names that carry a unit, as people write them: ``best_s`` is ``best (s)``, and with a value ``best 10.48 s``."""

from __future__ import annotations

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
    """Return a name with a value and its unit: ``best 10.48 s``, ``laps 3``."""
    words, unit = measure(name)
    return " ".join(part for part in (words, value, unit) if part)


def distinct_decimals(measured: float | None, limit: float | None, decimals: int) -> int:
    """Return so many decimals, or more if a measurement would otherwise be rounded to its limit."""
    if measured is not None and limit is not None and measured != limit:
        while decimals < _MAX_DECIMALS and round(measured, decimals) == round(limit, decimals):
            decimals += 1
    return decimals


def number_words(value: float, decimals: int = 6) -> str:
    """Format a number without superfluous zeros and without rounding away digits that decide: ``10.48``."""
    number = f"{value:.{decimals}f}"
    number = number.rstrip("0").rstrip(".") if "." in number else number
    return "0" if number == "-0" else number
