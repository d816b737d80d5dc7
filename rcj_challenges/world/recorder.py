"""Records poses and touches in each sub-step."""

from __future__ import annotations

import math
import struct
from array import array
from collections.abc import Callable
from typing import Any

import numpy as np

from rcj_challenges.chassis.base import YAW
from rcj_challenges.core.play import Fault, Pose2, Snapshot
from rcj_challenges.core.timing import SUBSTEPS_PER_TICK
from rcj_challenges.world.tables import NO_THING, WorldTables, one_by_one

Touches = tuple[tuple[int, int], ...]
Numbers = tuple[float, ...]

_FULL_TURN_RAD = 2 * math.pi
_POSES, _HEIGHT = struct.Struct("<3f"), struct.Struct("f")
_BYTES = 8
"""Of one number in `qpos`."""
_REMEMBERED = 4096
"""How many patterns of touching geoms are remembered. Most sub-steps repeat the pattern of the one before."""


class Recorder:
    """Collects one tick. Poses come straight from `qpos`, which never lags behind the sub-step.

    ``poses`` of the latest snapshot are packed as little-endian float32 ``[sub-step][entity][3]``.
    """

    def __init__(self, data: Any, tables: WorldTables, heights_m: tuple[float, ...]) -> None:
        self.poses = b""
        self._qpos = one_by_one(data.qpos)
        self._rows = [b""] * SUBSTEPS_PER_TICK
        balls = tables.ball_range
        self._unpack, self._in_float32 = _all_poses(tables, len(data.qpos))
        entities = len(tables.qpos_at)
        self._substeps = [slice(entities * substep, entities * (substep + 1)) for substep in range(SUBSTEPS_PER_TICK)]
        turning = [entity for entity in range(entities) if entity not in balls]
        self._yaws_at = [tables.qpos_at[entity] + YAW for entity in turning]
        # Among the numbers of all sub-steps, in which a ball has two and all else has three.
        in_row = [3 * entity + 2 - sum(ball < entity for ball in balls) for entity in turning]  # integers
        width = 3 * entities - len(balls)
        self._yaws = [width * substep + yaw for substep in range(SUBSTEPS_PER_TICK) for yaw in in_row]
        self._last_yaws = self._yaws[len(self._yaws) - len(in_row) :]
        self._heights_at = [(ball, tables.qpos_at[ball] + 2) for ball in balls]
        self._things = tables.geom_things
        self._heights_m: list[float] = array("f", heights_m).tolist()
        self._uprights = [1.0] * len(tables.bodies)
        self._patterns = [b""] * SUBSTEPS_PER_TICK
        self._known: dict[bytes, Touches] = {b"": ()}

    def note(self, substep: int, pattern: bytes) -> None:
        """Record the sub-step just made; ``pattern`` is the geoms of its contacts in memory."""
        self._rows[substep] = self._qpos.tobytes()
        self._patterns[substep] = pattern

    def snapshot(self, tick: int, faults: tuple[Fault, ...]) -> Snapshot:
        """Return the tick whose sub-steps have all been noted."""
        numbers = self._unpack(b"".join(self._rows))
        for yaw in self._last_yaws:
            if not -math.pi <= numbers[yaw] <= math.pi:
                numbers = self._turned_back(numbers)
                break
        self.poses = self._in_float32(*numbers)
        poses: list[Pose2] = list(_POSES.iter_unpack(self.poses))
        substeps = [poses[of_substep] for of_substep in self._substeps]
        heights = self._heights_m.copy()
        for ball, at in self._heights_at:
            (heights[ball],) = _HEIGHT.unpack(_HEIGHT.pack(self._qpos[at]))
        touches = tuple([self._known.get(pattern) or self._touching(pattern) for pattern in self._patterns])
        return Snapshot(tick, substeps, heights, self._uprights.copy(), touches, faults)

    def present(self) -> Snapshot:
        """Return the present poses as a snapshot of tick 0, in which nothing touches."""
        self._rows = [self._qpos.tobytes()] * SUBSTEPS_PER_TICK
        self._patterns = [b""] * SUBSTEPS_PER_TICK
        return self.snapshot(0, ())

    def _turned_back(self, numbers: Numbers) -> Numbers:
        """Normalize all yaws to half a turn; whole turns do not matter."""
        # In the world as well, so that the next ticks find them in order.
        for at in self._yaws_at:
            self._qpos[at] = _within_half_a_turn(self._qpos[at])
        turned = list(numbers)
        for yaw in self._yaws:
            turned[yaw] = _within_half_a_turn(turned[yaw])
        return tuple(turned)

    def _touching(self, pattern: bytes) -> Touches:
        """Return the things that touch, from the pairs of geoms that do."""
        touches = self._known.get(pattern)
        if touches is None:
            if len(self._known) >= _REMEMBERED:
                self._known = {b"": ()}
            geoms = np.frombuffer(pattern, dtype=np.int32).reshape(-1, 2)
            pairs = {(min(pair), max(pair)) for pair in self._things[geoms].tolist()}
            touches = tuple(sorted(pair for pair in pairs if pair[0] != NO_THING and pair[0] != pair[1]))
            self._known[pattern] = touches
        return touches


def _all_poses(tables: WorldTables, numbers: int) -> tuple[Callable[[bytes], Numbers], Callable[..., bytes]]:
    """Return functions that read all poses from the `qpos` of all sub-steps, and pack them as x, y, yaw.

    Entities stand in `qpos`, which has so many ``numbers``, in their order.
    """
    read, written, end = "", "", 0
    for entity, at in enumerate(tables.qpos_at):
        ball = entity in tables.ball_range
        count = 2 if ball else 3
        read += f"{_BYTES * (at - end)}x{count}d"
        written += "2f4x" if ball else "3f"  # a ball has no yaw: it is 0 for ever
        end = at + count
    read += f"{_BYTES * (numbers - end)}x"
    return struct.Struct(SUBSTEPS_PER_TICK * read).unpack, struct.Struct(f"<{SUBSTEPS_PER_TICK * written}").pack


def _within_half_a_turn(yaw_rad: float) -> float:
    return yaw_rad - _FULL_TURN_RAD * round(yaw_rad / _FULL_TURN_RAD)
