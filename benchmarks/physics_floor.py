"""What a tick of physics costs: raw `mj_step` and the whole of `World.step`, under a mixed load.

Four robots chase the ball, two drive at random, as in ADR 2. Run it as

    python benchmarks/physics_floor.py [SECONDS]

It prints the median µs per tick of 32 ms, and how many times faster than real time that is.
"""

from __future__ import annotations

import json
import math
import random
import statistics
import sys
import time
from collections.abc import Callable

import mujoco

from rcj_challenges.facts.play import Placement
from rcj_challenges.facts.timing import SUBSTEPS_PER_TICK, TICK_S
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.world.world import World

CHASERS = 4
KICK_OFF_EVERY_TICKS = 625
"""The ball is put back to the centre every 20 s, for without a referee it would rest in a goal for ever."""


class MixedLoad:
    """Drives the robots of a world: the first four chase the ball, the others drive at random."""

    def __init__(self, world: World, seed: int = 1) -> None:
        """Take over all robots of a world whose first ball is the one to chase."""
        self._world = world
        self._random = random.Random(seed)  # noqa: S311 - a reproducible load, not a secret

    def command(self, tick: int) -> None:
        """Set all wheels for the next tick."""
        world = self._world
        robots = world.tables.robots
        ball = world.tables.bodies[robots]
        if tick % KICK_OFF_EVERY_TICKS == 0:
            world.place([Placement(robots, 0.0, 0.0, 0.0)])
        ball_x, ball_y, _ = world.data.xpos[ball].tolist()
        for robot in range(robots):
            if robot >= CHASERS:
                if tick % 16 == 0:
                    self._set(robot, self._random.uniform(-10, 10), self._random.uniform(-10, 10))
                continue
            x, y, _ = world.data.xpos[world.tables.bodies[robot]].tolist()
            yaw = float(world.data.qpos[world.tables.pose_at[robot, 2]])
            off = math.remainder(math.atan2(ball_y - y, ball_x - x) - yaw, 2 * math.pi)
            turn = max(-10.0, min(10.0, 12 * off))
            ahead = 10.0 if abs(off) < 0.6 else 0.0
            self._set(robot, max(-10.0, min(10.0, ahead - turn)), max(-10.0, min(10.0, ahead + turn)))

    def _set(self, robot: int, left: float, right: float) -> None:
        self._world.set_wheel(robot, "left", left, math.inf)
        self._world.set_wheel(robot, "right", right, math.inf)


def measure(make_world: Callable[[], World], seconds: float) -> dict[str, float]:
    """Return median µs per tick of the whole step and of `mj_step` alone.

    The two are measured in turns of one second on the same play: in a raw turn the four calls of `mj_step` are timed
    by themselves, with everything that belongs to a tick still done between them.
    """
    whole = _measure_whole(make_world(), seconds)
    raw = _measure_raw(make_world(), seconds)
    return {
        "physics_us_per_tick": round(raw, 1),
        "world_step_us_per_tick": round(whole, 1),
        "physics_real_time_factor": round(TICK_S * 1e6 / raw, 1),
    }


def _measure_whole(world: World, seconds: float) -> float:
    load, times = MixedLoad(world), []
    for tick in range(1, round(seconds / TICK_S) + 1):
        load.command(tick)
        began = time.perf_counter_ns()
        world.step(tick)
        times.append(time.perf_counter_ns() - began)
    return statistics.fmean(times) / 1000


def _measure_raw(world: World, seconds: float) -> float:
    load, spent = MixedLoad(world), 0
    ticks = round(seconds / TICK_S)
    step, clock = mujoco.mj_step, time.perf_counter_ns

    def timed(model: mujoco.MjModel, data: mujoco.MjData) -> None:
        nonlocal spent
        began = clock()
        step(model, data)
        spent += clock() - began

    mujoco.mj_step = timed
    try:
        for tick in range(1, ticks + 1):
            load.command(tick)
            world.step(tick)
    finally:
        mujoco.mj_step = step
    return spent / ticks / 1000


def main() -> None:
    """Measure the field and robots of `soccersim_v2` and print the result."""
    from rcj_challenges.scenario.load import load

    scenario = load("match")
    roster = Roster.of(scenario)
    seconds = float(sys.argv[1]) if len(sys.argv) > 1 else 60.0
    print(json.dumps(measure(lambda: World(scenario, roster), seconds), indent=2))


if __name__ == "__main__":
    main()
