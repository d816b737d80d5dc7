"""The poses of a half as a block of text for the page: int16, differences of differences, zlib, base64.

The page undoes it in ``viewer/embedded.js``. Rounding is to 0.1 mm and 0.0055°, so a page's poses equal the trajectory
within 0.05 mm (0.2 mm on the largest field that a scenario may have) and 0.003°.
"""

from __future__ import annotations

import base64
import math
import zlib
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from rcj_challenges.core.play import Placement
from rcj_challenges.records.trajectory import HalfTrack

FINEST_M = 1e-4
"""A tenth of a millimetre: half of it is far below the 0.2 mm that a page may be off."""
HEIGHT_M = 2e-4
TURN_RAD = 2 * math.pi / 65_536
"""A full turn is the range of int16, so sums of differences wrap round as angles do."""
TILT_RAD = math.radians(0.1)

PARKED_BEYOND_M = 100.0
"""What is farther out was taken off the field: a field is at most 10 m long, the parking place begins at 1000 m."""

_LARGEST = 32_767
"""As x it means off the field, also in ``recording.js``."""
_ZLIB_LEVEL = 6

Array = npt.NDArray[Any]


Jumps = Sequence[Sequence[int]]
"""By entity, the ticks after which it was put elsewhere."""


class Frames(NamedTuple):
    """Judged poses of a half for the page: by channel (``x y yaw z tilt``) int16 ``[T + 1, E]``, first the start."""

    columns: Mapping[str, Array]
    jumps: Jumps


def length_unit(*halves: HalfTrack) -> float:
    """Return the unit of x and y in m with which the furthest position on the field fits into int16."""
    furthest = max((_furthest(half.substeps[:, -1, :, :2]) for half in halves), default=0.0)
    return max(FINEST_M, math.ceil(furthest / (_LARGEST - 1) * 1e9) / 1e9)


def frames_of(half: HalfTrack, unit_m: float) -> Frames:
    """Return the frames of a half; ``unit_m`` is the unit of x and y."""
    poses = half.substeps[:, -1]
    start, heights, uprights = _start(half)
    with np.errstate(invalid="ignore"):  # what a damaged file holds may be no number even for the processor
        judged = np.concatenate([start[None], poses])
        all_heights = np.concatenate([heights[None], half.heights])
        all_uprights = np.concatenate([uprights[None], half.uprights])
    columns = rounded_poses(judged, all_heights, all_uprights, unit_m)
    jumps: list[list[int]] = [[] for _ in range(poses.shape[1])]
    for tick, placements in sorted(half.placements.items()):
        for entity in {placement.entity for placement in placements} if tick else ():
            jumps[entity].append(tick)
    return Frames(columns, tuple(map(tuple, jumps)))


def rounded_poses(judged: Array, heights: Array, uprights: Array, unit_m: float) -> dict[str, Array]:
    """Return the channels of ticks, int16 ``[T, E]`` each, in the order in which they are sent and stored.

    Args:
        judged: ``[T, E, 3]``: x and y in m, yaw in rad.
        heights: ``[T, E]``: z in m.
        uprights: ``[T, E]``: cosine of the tilt.
        unit_m: of x and y.
    """
    with np.errstate(invalid="ignore"):  # a damaged file may hold infinities; they are shown at the edge
        poses = judged.astype(np.float64)
        return {
            "x": _rounded(poses[:, :, 0] / unit_m),
            "y": _rounded(poses[:, :, 1] / unit_m),
            # The remainder first: a yaw may have any number of turns, int16 has one.
            "yaw": _rounded(np.remainder(poses[:, :, 2] + math.pi, 2 * math.pi) / TURN_RAD - _LARGEST - 1),
            "z": _rounded(heights.astype(np.float64) / HEIGHT_M),
            "tilt": _rounded(np.arccos(np.clip(uprights.astype(np.float64), -1.0, 1.0)) / TILT_RAD),
        }


def place_at_start(poses: Array, placements: Iterable[Placement]) -> None:
    """Move what was placed at tick 0 to where frame 0 shows it: beyond the edge if it was taken off."""
    for placement in placements:
        off = (math.inf, 0.0, 0.0)
        poses[placement.entity] = off if placement.parked else (placement.x_m, placement.y_m, placement.yaw_rad)


def units(unit_m: float) -> dict[str, float]:
    """Return the unit of each channel, in m and rad; ``unit_m``: of x and y."""
    return {"x": unit_m, "y": unit_m, "yaw": TURN_RAD, "z": HEIGHT_M, "tilt": TILT_RAD}


def packed(frames: Frames) -> str:
    """Return the frames as text: by channel and entity the low, then the high bytes of second differences."""
    blocks = []
    for numbers in frames.columns.values():
        columns = np.ascontiguousarray(numbers.T)
        # Two differences, each in wrapping int16; the first number of a column is its own difference from 0.
        for _ in range(2):
            columns = np.diff(columns, axis=1, prepend=np.zeros((len(columns), 1), np.int16))
        planes = columns.astype("<i2").view(np.uint8).reshape(*columns.shape, 2).transpose(0, 2, 1)
        blocks.append(planes.tobytes())
    return base64.b64encode(zlib.compress(b"".join(blocks), _ZLIB_LEVEL)).decode("ascii")


def unpacked(text: str, channels: int, entities: int) -> Array:
    """Return packed frames, int16 ``[T + 1, channel, entity]``."""
    planes = np.frombuffer(zlib.decompress(base64.b64decode(text)), np.uint8).reshape(channels, entities, 2, -1)
    columns = np.ascontiguousarray(planes.transpose(0, 1, 3, 2)).view("<i2")[..., 0]
    for _ in range(2):
        columns = np.cumsum(columns, axis=2, dtype=np.int16)
    return columns.transpose(2, 0, 1)


def _furthest(positions: Array) -> float:
    away = np.abs(positions)
    near = away[away < PARKED_BEYOND_M]  # no comparison holds for NaN
    return float(near.max()) if near.size else 0.0


def _rounded(numbers: Array) -> Array:
    """Round to int16: NaN becomes 0, what does not fit the largest number."""
    whole: Array = np.rint(np.nan_to_num(numbers, nan=0.0, posinf=_LARGEST, neginf=-_LARGEST))
    fitting: Array = np.clip(whole, -_LARGEST - 1, _LARGEST).astype(np.int16)
    return fitting


def _start(half: HalfTrack) -> tuple[Array, Array, Array]:
    """Return poses, heights and uprights of frame 0: the start, after what was placed at tick 0."""
    entities = half.substeps.shape[2]
    first = half.start or next(half.snapshots(), None)
    if first is None:
        return np.zeros((entities, 3)), np.zeros(entities), np.ones(entities)
    poses = np.array(first.substeps[-1], dtype=np.float64)
    place_at_start(poses, half.placements.get(0, ()))
    return poses, np.array(first.heights), np.array(first.uprights)
