"""Finds robots that never moved: an observer for hints."""

from __future__ import annotations

import math

from rcj_challenges.core.play import HalfInfo, Pose2, RefereeOutput, Snapshot
from rcj_challenges.core.timing import ticks_from_s
from rcj_challenges.match.observers import Observer
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster

WATCHED_S = 10
"""From the beginning of each half; later, others have pushed most robots."""
_STANDS_M = 0.02  # the suspension of a braked robot settles by less
_M_PER_RAD = 0.1


class MotionlessObserver(Observer):
    """Adds up how far robots move and turn in the first seconds of each half."""

    def __init__(self, scenario: Scenario) -> None:
        index = Roster.of(scenario).index
        driven = [robot for entrant in scenario.entrants.values() for robot in entrant.robots]
        self._robots = [(robot, index[robot]) for robot in driven if not scenario.robots[robot].idle]
        self._last_tick = ticks_from_s(WATCHED_S)
        self._last: list[Pose2] | None = None
        self._way_m: dict[str, float] = {}
        self._standing: dict[str, bool] = {}

    def half_started(self, half: HalfInfo) -> None:
        self._last = None
        self._way_m = dict.fromkeys((robot for robot, _ in self._robots), 0.0)

    def after_tick(self, snapshot: Snapshot, output: RefereeOutput) -> None:
        if snapshot.tick > self._last_tick:
            return
        poses = list(snapshot.substeps[-1])
        if self._last is not None:
            for robot, index in self._robots:
                (x_m, y_m, yaw_rad), before = poses[index], self._last[index]
                turned_rad = abs(math.remainder(yaw_rad - before[2], math.tau))
                self._way_m[robot] += math.hypot(x_m - before[0], y_m - before[1]) + _M_PER_RAD * turned_rad
        for placement in output.placements:
            poses[placement.entity] = (placement.x_m, placement.y_m, placement.yaw_rad)
        self._last = poses
        if snapshot.tick == self._last_tick:
            for robot, way_m in self._way_m.items():
                self._standing[robot] = self._standing.get(robot, True) and way_m < _STANDS_M

    def robots(self) -> list[str]:
        """Return the robots that did not move in any half that was long enough."""
        return [robot for robot, stands in self._standing.items() if stands]
