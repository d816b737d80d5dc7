"""Takes down what happened in each sub-step: poses and touches."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from rcj_challenges.facts.play import Fault, Pose2, Snapshot
from rcj_challenges.facts.timing import SUBSTEPS_PER_TICK
from rcj_challenges.world.tables import NO_THING, WorldTables

Touches = tuple[tuple[int, int], ...]

_FULL_TURN_RAD = np.float32(2 * math.pi)
_REMEMBERED = 4096
"""How many patterns of touching geoms are remembered. Most sub-steps repeat the pattern of the one before."""


class Recorder:
    """Collects one tick. Poses come straight from `qpos`, which never lags behind the sub-step."""

    def __init__(self, data: Any, tables: WorldTables, heights_m: tuple[float, ...]) -> None:
        entities = len(tables.bodies)
        self._data = data
        self._qpos = data.qpos
        self._rows = np.zeros((SUBSTEPS_PER_TICK, len(data.qpos)))
        exact = np.zeros((SUBSTEPS_PER_TICK, entities, 3), dtype=np.float32)
        self._exact = exact.reshape(SUBSTEPS_PER_TICK, -1)
        self._yaws = exact[:, :, 2]
        robots, balls, obstacles = tables.by_kind(self._rows)
        first_ball, first_obstacle = tables.robots, tables.robots + tables.balls
        # A ball has no yaw: it is 0 for ever.
        self._copies = [
            (target, source)
            for target, source in (
                (exact[:, :first_ball], robots[..., :3]),
                (exact[:, first_ball:first_obstacle, :2], balls[..., :2]),
                (exact[:, first_obstacle:], obstacles),
            )
            if target.size
        ]
        self._ball_heights_m = balls[-1, :, 2]
        self._ball_entities = slice(first_ball, first_obstacle)
        self._things = tables.geom_things
        self._heights_m: list[float] = np.array(heights_m, dtype=np.float32).tolist()
        self._uprights = [1.0] * entities
        self._touches: list[Touches] = [()] * SUBSTEPS_PER_TICK
        self._known: dict[bytes, Touches] = {}

    def note(self, substep: int) -> None:
        """Take down a sub-step that has just been made."""
        self._rows[substep] = self._qpos
        self._touches[substep] = self._touching() if self._data.ncon else ()

    def snapshot(self, tick: int, faults: tuple[Fault, ...]) -> Snapshot:
        """Return the tick whose sub-steps have all been noted."""
        for target, source in self._copies:
            target[:] = source
        substeps = self._as_poses()
        for _, _, yaw in substeps[-1]:
            if yaw > math.pi or yaw < -math.pi:
                self._yaws -= _FULL_TURN_RAD * np.round(self._yaws / _FULL_TURN_RAD)
                substeps = self._as_poses()
                break
        heights = self._heights_m.copy()
        heights[self._ball_entities] = self._ball_heights_m.astype(np.float32).tolist()
        return Snapshot(tick, substeps, heights, self._uprights.copy(), tuple(self._touches), faults)

    def present(self) -> Snapshot:
        """Return the present poses as a snapshot of tick 0, in which nothing touches."""
        self._rows[:] = self._qpos
        self._touches = [()] * SUBSTEPS_PER_TICK
        return self.snapshot(0, ())

    def _as_poses(self) -> list[list[Pose2]]:
        poses = []
        for numbers in self._exact.tolist():
            one_by_one = iter(numbers)
            poses.append(list(zip(one_by_one, one_by_one, one_by_one, strict=True)))
        return poses

    def _touching(self) -> Touches:
        geoms = self._data.contact.geom
        pattern = geoms.tobytes()
        touches = self._known.get(pattern)
        if touches is None:
            if len(self._known) >= _REMEMBERED:
                self._known.clear()
            pairs = {(min(pair), max(pair)) for pair in self._things[geoms].tolist()}
            touches = tuple(sorted(pair for pair in pairs if pair[0] != NO_THING and pair[0] != pair[1]))
            self._known[pattern] = touches
        return touches
