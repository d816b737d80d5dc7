"""Keys in another unit: what they are called here, and the number as it is written in that unit."""

from __future__ import annotations

from collections.abc import Collection
from math import pi

from rcj_challenges.facts.amounts import round_score
from rcj_challenges.facts.measures import number_words
from rcj_challenges.scenario.tree import Leaf, Node

_IN: dict[str, dict[str, float]] = {
    "m": {"cm": 0.01, "mm": 0.001, "dm": 0.1},
    "s": {"min": 60, "minutes": 60, "ms": 0.001, "h": 3600},
    "rad": {"deg": pi / 180, "degrees": pi / 180, "degree": pi / 180},
    "kg": {"g": 0.001},
    "mps": {"cmps": 0.01, "mmps": 0.001, "kmh": 1 / 3.6},
}
"""By the unit of a key, other units, and how much of it one of them is."""
_DECIMALS = 9  # to so many numbers are exact
_ROUNDED_TO = {"rad": 4, "mps": 4}
"""Decimals of what is seldom a number of few digits."""


def for_unit(key: str, node: Node | None, allowed: Collection[str]) -> str:
    """Return what a key is called in the unit that is used here; empty: no key differs from it in its unit alone.

    Args:
        key: the key that is not known.
        node: what stands behind it.
        allowed: the keys that may stand there.
    """
    stem, _, written = key.rpartition("_")
    for unit, others in _IN.items():
        if not stem or written.casefold() not in others or f"{stem}_{unit}" not in allowed:
            continue
        value = node.value if isinstance(node, Leaf) and not node.param else None
        if isinstance(value, bool) or not isinstance(value, int | float):
            return f"; it is called '{stem}_{unit}' here, in {unit}"
        amount = number_words(round_score(value * others[written.casefold()]), _ROUNDED_TO.get(unit, _DECIMALS))
        return f"; it is called '{stem}_{unit}' here, in {unit}: {amount}"
    return ""
