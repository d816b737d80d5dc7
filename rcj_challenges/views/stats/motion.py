"""Ways and speeds of entities, without the jumps when they were put elsewhere."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from rcj_challenges.records.trajectory import HalfTrack

Array = npt.NDArray[Any]


@dataclass(frozen=True)
class Motion:
    """Positions of a half for counting. ``T`` ticks (row ``i`` is tick ``i + 1``), ``E`` entities, m.

    Attributes:
        places: ``[T, E, 2]``, judged positions.
        steps_m: ``[T, E]``, the way of each tick from where the last verdict left the entity.
        on_field: ``[T, E]``, whether it was on the field.
    """

    places: Array
    steps_m: Array
    on_field: Array


def motion_of(half: HalfTrack) -> Motion:
    """Return the motion of a half; numbers of a damaged record that are none count as no way."""
    with np.errstate(invalid="ignore"):  # what a damaged record holds may be no number even for the processor
        places = half.substeps[:, -1, :, :2].astype(np.float64)
    before = np.empty_like(places)
    before[1:] = places[:-1]
    before[:1] = places[:1] if half.start is None else np.array([pose[:2] for pose in half.start.substeps[-1]])
    on_field = np.ones(places.shape[:2], bool)
    for tick, placements in sorted(half.placements.items()):
        for placement in placements:
            on_field[tick:, placement.entity] = not placement.parked
            if tick < half.ticks:
                before[tick, placement.entity] = placement.x_m, placement.y_m
    with np.errstate(invalid="ignore", over="ignore"):
        steps = np.hypot(*np.moveaxis(places - before, -1, 0))
    return Motion(places, np.where(np.isfinite(steps) & on_field, steps, 0.0), on_field)


def play_mask(ticks: int, phases: Iterable[Sequence[Any]]) -> Array:
    """Return ``[T]``: whether a tick was play: no kick-off was awaited as it began.

    Phases are tick, name and flag of each change, in order; the flag holds for the ticks after it.
    """
    play = np.ones(ticks, bool)
    for tick, _, waiting in phases:
        play[max(0, tick) :] = not waiting
    return play
