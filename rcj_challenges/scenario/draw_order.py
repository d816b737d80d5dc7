"""Which values a draw can bring next, for the referee, and for checks of the values that tests decide."""

from __future__ import annotations

from collections.abc import Sequence

from rcj_challenges.geometry.polygons import Point
from rcj_challenges.rules.fields import Scalar
from rcj_challenges.scenario.models.state import Draw

Series = Scalar | tuple[Scalar, ...]
"""What a test decides of a draw: its first value, or its first values in order."""


def drawable(draw: Draw, left: Sequence[Scalar], last: Sequence[Scalar]) -> tuple[Sequence[Scalar], Sequence[Scalar]]:
    """Return the values that may be drawn now, and what is left of the round in which they are drawn.

    Args:
        draw: the draw.
        left: of a draw with ``not_again`` what has not been drawn in this round, else all its values.
        last: the value that it has, or nothing if it has none yet.
    """
    values = _others(draw, left, last)
    if values:
        return values, left
    # The round is over, or what is left of it is what may not come twice running.
    return _others(draw, draw.values, last) or draw.values, draw.values


def _others(draw: Draw, values: Sequence[Scalar], last: Sequence[Scalar]) -> Sequence[Scalar]:
    return tuple(value for value in values if value not in last) if draw.not_last and last else values


def never_drawn(draw: Draw, series: Sequence[Scalar]) -> int | None:
    """Return the index of the first value that cannot follow those before it, or None if all can be drawn."""
    left: Sequence[Scalar] = draw.values
    last: tuple[Scalar, ...] = ()
    for index, value in enumerate(series):
        values, left = drawable(draw, left, last)
        if value not in values:
            return index
        if draw.not_again is not None:
            remaining = list(left)
            remaining.remove(value)
            left = remaining
        last = (value,)
    return None


def places_of(decided: Point | tuple[Point, ...]) -> tuple[Point, ...]:
    """Return the places that a test decides for a spot, in order: one, or several."""
    return decided if isinstance(decided[0], tuple) else (decided,)
