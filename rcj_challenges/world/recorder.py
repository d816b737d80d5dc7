"""Takes down what happened in each sub-step: poses and touches."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from rcj_challenges.facts.play import Fault, Pose2, Snapshot
from rcj_challenges.facts.timing import SUBSTEPS_PER_TICK
from rcj_challenges.world.tables import NO_THING, Numbers, WorldTables

Touches = tuple[tuple[int, int], ...]

_FULL_TURN_RAD = 2 * math.pi
_REMEMBERED = 4096
"""How many patterns of touching geoms are remembered. Most sub-steps repeat the pattern of the one before."""


class Recorder:
    """Collects one tick. Poses come straight from `qpos`, which never lags behind the sub-step."""

    def __init__(self, data: Any, tables: WorldTables, heights_m: tuple[float, ...]) -> None:
        self._contact = data.contact
        self._qpos = data.qpos
        self._numbers = len(data.qpos)
        # One number more than qpos has: a ball has no yaw, it is 0 for ever.
        self._rows = np.zeros((SUBSTEPS_PER_TICK, self._numbers + 1))
        self._gathered = np.array([*_pose_addresses(tables, self._numbers), *_ball_height_addresses(tables)])
        self._yaw_at = np.array([at for at in self._gathered[2 : 3 * len(tables.bodies) : 3] if at < self._numbers])
        self._row_of = [row[: self._numbers] for row in self._rows]
        self._wide = np.zeros((SUBSTEPS_PER_TICK, len(self._gathered)))
        self._exact = np.zeros((SUBSTEPS_PER_TICK, len(self._gathered)), dtype=np.float32)
        self._entities = len(tables.bodies)
        self._balls = slice(tables.robots, tables.robots + tables.balls)
        self._things = tables.geom_things
        self._heights_m: list[float] = np.array(heights_m, dtype=np.float32).tolist()
        self._uprights = [1.0] * self._entities
        self._patterns = [b""] * SUBSTEPS_PER_TICK
        self._known: dict[bytes, Touches] = {b"": ()}

    def note(self, substep: int) -> None:
        """Take down a sub-step that has just been made."""
        self._row_of[substep][:] = self._qpos
        self._patterns[substep] = self._contact.geom.tobytes()

    def snapshot(self, tick: int, faults: tuple[Fault, ...]) -> Snapshot:
        """Return the tick whose sub-steps have all been noted."""
        exact, poses = self._exact, 3 * self._entities
        exact[:] = self._rows.take(self._gathered, 1, out=self._wide, mode="clip")
        numbers = exact.tolist()
        yaws = numbers[-1][2:poses:3]
        if max(yaws) > math.pi or min(yaws) < -math.pi:
            exact[:, 2:poses:3] = _within_half_a_turn(self._rows[:, self._gathered[2:poses:3]])
            numbers = exact.tolist()
            # So that the next ticks find all yaws in order: a whole turn more or less changes nothing.
            self._qpos[self._yaw_at] = _within_half_a_turn(self._qpos[self._yaw_at])
        substeps: list[list[Pose2]] = []
        for row in numbers:
            by_three = iter(row)  # the heights at the end may make up triples of their own
            substeps.append(list(zip(by_three, by_three, by_three, strict=False))[: self._entities])
        heights = self._heights_m.copy()
        heights[self._balls] = numbers[-1][poses:]
        touches = tuple([self._known.get(pattern) or self._touching(pattern) for pattern in self._patterns])
        return Snapshot(tick, substeps, heights, self._uprights.copy(), touches, faults)

    def present(self) -> Snapshot:
        """Return the present poses as a snapshot of tick 0, in which nothing touches."""
        self._rows[:, : self._numbers] = self._qpos
        self._patterns = [b""] * SUBSTEPS_PER_TICK
        return self.snapshot(0, ())

    def _touching(self, pattern: bytes) -> Touches:
        """Return which things touch, from the pairs of geoms that do."""
        touches = self._known.get(pattern)
        if touches is None:
            if len(self._known) >= _REMEMBERED:
                self._known = {b"": ()}
            geoms = np.frombuffer(pattern, dtype=np.int32).reshape(-1, 2)
            pairs = {(min(pair), max(pair)) for pair in self._things[geoms].tolist()}
            touches = tuple(sorted(pair for pair in pairs if pair[0] != NO_THING and pair[0] != pair[1]))
            self._known[pattern] = touches
        return touches


def _within_half_a_turn(yaws_rad: Numbers) -> Numbers:
    turned: Numbers = yaws_rad - _FULL_TURN_RAD * np.rint(yaws_rad / _FULL_TURN_RAD)
    return turned


def _pose_addresses(tables: WorldTables, zero_at: int) -> list[int]:
    """Return where x, y and yaw of each entity stand in `qpos`, in one list."""
    balls = tables.ball_range
    return [
        number
        for entity, first in enumerate(tables.qpos_at)
        for number in (first, first + 1, zero_at if entity in balls else first + 2)
    ]


def _ball_height_addresses(tables: WorldTables) -> list[int]:
    return [tables.qpos_at[ball] + 2 for ball in tables.ball_range]
