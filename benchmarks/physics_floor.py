"""What a tick of physics costs: raw `mj_step` and the whole of `World.step`, under a mixed load.

Four robots chase the ball, two drive at random, as in ADR 2. Run it as

    python benchmarks/physics_floor.py [SECONDS]

It prints the mean µs per tick of 32 ms, and how many times faster than real time that is.
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

from rcj_challenges.core.play import Placement
from rcj_challenges.core.timing import TICK_S
from rcj_challenges.scenario.load import load
from rcj_challenges.world.world import World

CHASERS = 4
KICK_OFF_EVERY_TICKS = 625
"""The ball is put back to the centre every 20 s, for without a referee it would rest in a goal for ever."""


class MixedLoad:
    """Drives the robots of a world: the first four chase the ball, the others drive at random."""

    def __init__(self, world: World) -> None:
        """Take over all robots of a world whose first ball is the one to chase."""
        self._world = world
        self._random = random.Random(1)  # noqa: S311 - a reproducible load, not a secret

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
            yaw = float(world.data.qpos[world.tables.qpos_at[robot] + 2])
            off = math.remainder(math.atan2(ball_y - y, ball_x - x) - yaw, 2 * math.pi)
            turn = max(-10.0, min(10.0, 12 * off))
            ahead = 10.0 if abs(off) < 0.6 else 0.0
            self._set(robot, max(-10.0, min(10.0, ahead - turn)), max(-10.0, min(10.0, ahead + turn)))

    def _set(self, robot: int, left: float, right: float) -> None:
        self._world.set_wheel(robot, 0, left, math.inf)
        self._world.set_wheel(robot, 1, right, math.inf)


def measure(make_world: Callable[[], World], seconds: float) -> dict[str, float]:
    """Return what a tick costs, in µs: the four calls of `mj_step` by themselves, and the whole of `World.step`.

    Both are means over the ticks, as the time of a half is the sum of its own: a crowd costs more than the usual tick,
    and so does a noisy moment of the machine. They are of two runs of the same play, because taking the time of each
    `mj_step` costs time itself.
    """
    whole_us = statistics.fmean(_whole_ticks_us(make_world(), seconds))
    physics_us = statistics.fmean(_physics_us(make_world(), seconds))
    return {
        "physics_us_per_tick": round(physics_us, 1),
        "world_step_us_per_tick": round(whole_us, 1),
        "physics_real_time_factor": round(TICK_S * 1e6 / physics_us, 1),
    }


def _whole_ticks_us(world: World, seconds: float) -> list[float]:
    load, times = MixedLoad(world), []
    for tick in range(1, round(seconds / TICK_S) + 1):
        load.command(tick)
        began = time.perf_counter_ns()
        world.step(tick)
        times.append((time.perf_counter_ns() - began) / 1000)
    return times


def _physics_us(world: World, seconds: float) -> list[float]:
    """Time `mj_step` where `World.step` calls it."""
    load, times, spent_ns = MixedLoad(world), [], 0
    step, clock = mujoco.mj_step, time.perf_counter_ns

    def timed(model: mujoco.MjModel, data: mujoco.MjData) -> None:
        nonlocal spent_ns
        began = clock()
        step(model, data)
        spent_ns += clock() - began

    mujoco.mj_step = timed
    try:
        for tick in range(1, round(seconds / TICK_S) + 1):
            load.command(tick)
            spent_ns = 0
            world.step(tick)
            times.append(spent_ns / 1000)
    finally:
        mujoco.mj_step = step
    return times


def main() -> None:
    """Measure the field and robots of the match and print the result."""
    loaded = load("match")
    seconds = float(sys.argv[1]) if len(sys.argv) > 1 else 60.0
    print(json.dumps(measure(lambda: World(loaded.scenario, loaded.roster), seconds), indent=2))


if __name__ == "__main__":
    main()
