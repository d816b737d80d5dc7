"""What the referee costs: microseconds per tick of the match, on a random walk of six robots and a ball.

Run it with ``python benchmarks/referee_cost.py [--ticks 18750] [--scenario match] [--json]``. Only `Referee.judge` is
timed, in processor time of its thread, so that a busy machine does not count. Robots drive at up to 0.2 m/s and turn
at random, the ball rolls at up to 0.6 m/s and bounces; the walk obeys the referee's placements. An uneventful tick is
one whose output holds nothing.
"""

from __future__ import annotations

import argparse
import json
import math
import random
import statistics
import sys
import time
from itertools import pairwise
from struct import pack, unpack

from rcj_challenges.core.play import HalfInfo, Placement, Snapshot
from rcj_challenges.core.timing import SUBSTEP_S, SUBSTEPS_PER_TICK
from rcj_challenges.referee.engine import Referee
from rcj_challenges.scenario.load import Loaded, load

# Inner faces of the walls less half a robot: where a centre can be (reference, section 1).
_REACH_X_M, _REACH_Y_M = 0.61, 0.71
_GOAL_HALF_M, _GOAL_END_M = 0.2, 0.84


class RandomWalk:
    """Bodies that wander over the field as a match would have them."""

    def __init__(self, robots: int, entities: int, seed: int) -> None:
        self._rng = random.Random(seed)  # noqa: S311 - a reproducible walk, not a secret
        self._robots = robots
        self.poses = [(0.0, 0.0, 0.0)] * entities
        self._speeds = [self._rng.uniform(0.0, 0.2) for _ in range(entities)]

    def obey(self, placements: tuple[Placement, ...]) -> None:
        """Stand where the referee put things."""
        for placement in placements:
            self.poses[placement.entity] = (placement.x_m, placement.y_m, placement.yaw_rad)

    def snapshot(self, tick: int) -> Snapshot:
        """Move for one tick."""
        for entity in range(len(self.poses)):
            if self._rng.random() < 0.01:
                self._speeds[entity] = self._rng.uniform(0.0, 0.2 if entity < self._robots else 0.6)
                x, y, _ = self.poses[entity]
                self.poses[entity] = (x, y, self._rng.uniform(-math.pi, math.pi))
        substeps = []
        for _ in range(SUBSTEPS_PER_TICK):
            self.poses = [self._moved(entity, pose) for entity, pose in enumerate(self.poses)]
            substeps.append(list(self.poses))
        entities = len(self.poses)
        return Snapshot(tick, substeps, [0.0375] * entities, [1.0] * entities, ((),) * SUBSTEPS_PER_TICK)

    def _moved(self, entity: int, pose: tuple[float, float, float]) -> tuple[float, float, float]:
        x, y, yaw = pose
        x += self._speeds[entity] * SUBSTEP_S * math.cos(yaw)
        y += self._speeds[entity] * SUBSTEP_S * math.sin(yaw)
        end = _GOAL_END_M if abs(x) < _GOAL_HALF_M else _REACH_Y_M
        if abs(x) > _REACH_X_M or abs(y) > end:
            x, y = max(-_REACH_X_M, min(_REACH_X_M, x)), max(-end, min(end, y))
            yaw += math.pi / 2
        return tuple(unpack("<3f", pack("<3f", x, y, yaw)))  # type: ignore[return-value]


def measure(loaded: Loaded, ticks: int, seed: int) -> dict[str, float]:
    """Judge a half and return figures in microseconds per tick."""
    seats = list(loaded.scenario.entrants)
    half = HalfInfo(
        half=1,
        halves=1,
        ticks=ticks,
        match_seed=seed,
        match_id=1,
        team_names={seat: seat for seat in seats},
        teams={seat: seat for seat in seats},
        scores=dict.fromkeys(seats, 0),
    )
    began = time.perf_counter()
    referee = Referee(loaded.scenario, loaded.roster, half)
    compiled_ms = (time.perf_counter() - began) * 1e3
    walk = RandomWalk(loaded.roster.robots, len(loaded.roster.entities), seed)
    walk.obey(referee.start(walk.snapshot(0)).placements)
    clock_ns = _clock_ns()
    quiet: list[int] = []
    eventful: list[int] = []
    for tick in range(1, ticks + 1):
        snapshot = walk.snapshot(tick)
        start = time.thread_time_ns()
        output = referee.judge(snapshot)
        spent = time.thread_time_ns() - start - clock_ns
        walk.obey(output.placements)
        (eventful if output.events or output.firings or output.placements else quiet).append(spent)
    spents = quiet + eventful
    return {
        "ticks": ticks,
        "eventful_ticks": len(eventful),
        "mean_us": statistics.fmean(spents) / 1e3,
        "median_us": statistics.median(spents) / 1e3,
        "p99_us": statistics.quantiles(spents, n=100)[98] / 1e3,
        "uneventful_mean_us": statistics.fmean(quiet) / 1e3,
        "eventful_mean_us": statistics.fmean(eventful) / 1e3 if eventful else 0.0,
        "compile_ms": compiled_ms,
    }


def _clock_ns() -> int:
    """Return what reading the clock itself costs."""
    readings = [time.thread_time_ns() for _ in range(1001)]
    return int(statistics.median(after - before for before, after in pairwise(readings)))


def main() -> int:
    """Measure several times and print the best mean."""
    parser = argparse.ArgumentParser(description="microseconds per tick of the referee")
    parser.add_argument("--scenario", default="match")
    parser.add_argument("--ticks", type=int, default=18_750)
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--json", action="store_true")
    given = parser.parse_args()
    loaded = load(given.scenario)
    runs = [measure(loaded, given.ticks, seed) for seed in range(1, given.repeats + 1)]
    best = min(runs, key=lambda run: run["mean_us"])
    if given.json:
        print(json.dumps(best))
    else:
        for name, value in best.items():
            print(f"{name:20} {value:10.1f}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
