"""Takes down what happened in each sub-step: poses and touches."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from rcj_challenges.facts.play import Fault, Pose2, Snapshot
from rcj_challenges.facts.timing import SUBSTEPS_PER_TICK
from rcj_challenges.world.tables import NO_THING, WorldTables

Touches = tuple[tuple[int, int], ...]

_POSE = np.dtype([("x", np.float32), ("y", np.float32), ("yaw", np.float32)])
_FULL_TURN = 2 * math.pi


class Recorder:
    """Collects one tick. Poses come straight from `qpos`, which never lags behind the sub-step."""

    def __init__(self, data: Any, tables: WorldTables, cube_heights_m: tuple[float, ...]) -> None:
        self._data = data
        self._qpos = data.qpos
        entities = len(tables.bodies)
        self._pose_at = tables.pose_at
        self._raw = np.zeros((SUBSTEPS_PER_TICK, entities, 3))
        self._yaws = self._raw[:, :, 2]
        balls = slice(tables.robots, tables.robots + tables.balls)
        self._ball_yaws = self._yaws[:, balls]
        self._balls = balls
        self._exact = np.zeros((SUBSTEPS_PER_TICK, entities, 3), dtype=np.float32)
        self._poses = self._exact.view(_POSE)[:, :, 0]
        self._things = tables.geom_things
        self._walls = int(tables.geom_things.max(initial=0))
        self._heights = list(cube_heights_m)
        self._uprights = [1.0] * entities
        self._touches: list[Touches] = [()] * SUBSTEPS_PER_TICK

    def note(self, substep: int) -> None:
        """Take down a sub-step that has just been made."""
        self._qpos.take(self._pose_at, out=self._raw[substep], mode="clip")
        self._touches[substep] = self._touching()

    def snapshot(self, tick: int, faults: tuple[Fault, ...]) -> Snapshot:
        """Return the tick whose sub-steps have all been noted."""
        return self._as_snapshot(tick, tuple(self._touches), faults)

    def present(self) -> Snapshot:
        """Return the present poses as a snapshot of tick 0, in which nothing touches."""
        for substep in range(SUBSTEPS_PER_TICK):
            self._qpos.take(self._pose_at, out=self._raw[substep], mode="clip")
        return self._as_snapshot(0, ((),) * SUBSTEPS_PER_TICK, ())

    def _as_snapshot(self, tick: int, touches: tuple[Touches, ...], faults: tuple[Fault, ...]) -> Snapshot:
        heights = self._heights.copy()
        heights[self._balls] = self._raw[-1, self._balls, 2].astype(np.float32).tolist()
        # Where a ball has its height, all others have their yaw; balls have none.
        self._ball_yaws[:] = 0.0
        yaws = self._yaws
        yaws -= _FULL_TURN * np.round(yaws / _FULL_TURN)
        self._exact[:] = self._raw
        substeps: list[list[Pose2]] = self._poses.tolist()
        return Snapshot(tick, substeps, heights, self._uprights, touches, faults)

    def _touching(self) -> Touches:
        data = self._data
        if not data.ncon:
            return ()
        pairs = set()
        for one, other in self._things[data.contact.geom].tolist():
            if one != other and one != NO_THING and other != NO_THING:
                pairs.add((one, other) if one < other else (other, one))
        return tuple(sorted(pairs))
