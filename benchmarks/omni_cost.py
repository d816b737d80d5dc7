"""What omni wheels cost: `mj_step` of six robots on omni wheels as a share of six on two wheels, in one process.

    python -m benchmarks.omni_cost [--pairs 40] [--ticks 125] [--json]

Both worlds have the same load: four robots chase the ball and two drive at random, or all drive at random. They take
turns, and which is first changes from pair to pair, so that a busy computer slows both. The time is that of the
processor. What counts is all of it, because a crowd costs more than the usual tick and comes at other times in each
world; the quartiles of the pairs show how far that goes.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import random
import statistics
import time

import mujoco

from rcj_challenges.chassis import USUAL_CHASSIS
from rcj_challenges.chassis.base import Chassis
from rcj_challenges.chassis.omni import OmniChassis
from rcj_challenges.core.play import Placement
from rcj_challenges.scenario.load import load
from rcj_challenges.world.world import World

BAR = 1.25
CHASERS = (4, 0)
KICK_OFF_EVERY_TICKS = 625
COLUMNS = ("all", "quartile_1", "median", "quartile_3")
BODIES: dict[str, Chassis] = {
    "round": OmniChassis(drive="omni"),
    "flat front, jaws": OmniChassis(drive="omni", shape="flat_front", jaws_m=(0.006, 0.05)),
    "three wheels": OmniChassis(drive="omni", wheels_at_rad=(1.0472, 3.1416, 5.236)),
}


class Play:
    """A world whose robots have a load that is the same for every chassis."""

    def __init__(self, chassis: Chassis, chasers: int) -> None:
        """Build the match's world with this chassis; the first robots chase the ball."""
        loaded = load("match")
        kit = loaded.scenario.kits["v2"].model_copy(update={"chassis": chassis, "devices": {}})
        scenario = loaded.scenario.model_copy(update={"kits": {"v2": kit}})
        self._world, self._chassis, self._chasers = World(scenario, loaded.roster), chassis, chasers
        self._random = random.Random(1)  # noqa: S311 - a reproducible load, not a secret
        self._tick = 0

    def cost_us(self, ticks: int) -> float:
        """Play on, and return the time of `mj_step` in µs per tick."""
        spent_ns, step, clock = 0, mujoco.mj_step, time.thread_time_ns

        def timed(model: mujoco.MjModel, data: mujoco.MjData) -> None:
            nonlocal spent_ns
            began = clock()
            step(model, data)
            spent_ns += clock() - began

        mujoco.mj_step = timed
        try:
            for _ in range(ticks):
                self._tick += 1
                self._command()
                self._world.step(self._tick)
        finally:
            mujoco.mj_step = step
        return spent_ns / 1000 / ticks

    def _command(self) -> None:
        world = self._world
        robots = world.tables.robots
        if self._tick % KICK_OFF_EVERY_TICKS == 0:
            world.place([Placement(robots, 0.0, 0.0, 0.0)])
        ball_x, ball_y, _ = world.data.xpos[world.tables.bodies[robots]].tolist()
        for robot in range(robots):
            if robot >= self._chasers:
                if self._tick % 16 == 0:
                    self._drive(robot, self._random.uniform(-0.2, 0.2), self._random.uniform(-4, 4))
                continue
            x, y, _ = world.data.xpos[world.tables.bodies[robot]].tolist()
            yaw = float(world.data.qpos[world.tables.qpos_at[robot] + 2])
            off = math.remainder(math.atan2(ball_y - y, ball_x - x) - yaw, 2 * math.pi)
            self._drive(robot, 0.2 if abs(off) < 0.6 else 0.0, max(-4.0, min(4.0, 5 * off)))

    def _drive(self, robot: int, ahead_mps: float, spin_radps: float) -> None:
        """Turn the wheels as a motion demands; faster commands than motors allow are clamped."""
        fastest = self._chassis.max_wheel_radps
        for number, wheel in enumerate(self._chassis.wheels()):
            cos, sin = math.cos(wheel.yaw_rad), math.sin(wheel.yaw_rad)
            rim_mps = ahead_mps * cos + spin_radps * (wheel.x_m * sin - wheel.y_m * cos)
            radps = max(-fastest, min(fastest, rim_mps / wheel.radius_m))
            self._world.set_wheel(robot, number, radps, math.inf)


def measure(chassis: Chassis, chasers: int, pairs: int, ticks: int) -> dict[str, float]:
    """Return the cost of a chassis as a share of the usual one's: of all ticks, and the quartiles of the pairs."""
    usual, other = Play(USUAL_CHASSIS, chasers), Play(chassis, chasers)
    costs: list[tuple[float, float]] = []
    for pair in range(pairs + 1):
        first, second = (usual, other) if pair % 2 else (other, usual)
        now = {id(play): play.cost_us(ticks) for play in (first, second)}
        if pair:  # the first warms up
            costs.append((now[id(usual)], now[id(other)]))
    low, middle, high = statistics.quantiles([theirs / ours for ours, theirs in costs], n=4)
    all_of_it = math.fsum(theirs for _, theirs in costs) / math.fsum(ours for ours, _ in costs)
    return {name: round(value, 3) for name, value in zip(COLUMNS, (all_of_it, low, middle, high), strict=True)}


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description="cost of omni wheels as a share of two wheels")
    parser.add_argument("--pairs", type=int, default=40)
    parser.add_argument("--ticks", type=int, default=125)
    parser.add_argument("--json", action="store_true")
    given = parser.parse_args()
    found = {
        f"{name}, {chasers} chase": measure(chassis, chasers, given.pairs, given.ticks)
        for name, chassis in BODIES.items()
        for chasers in CHASERS
    }
    load_now = round(os.getloadavg()[0], 1)
    if given.json:
        print(json.dumps({"bar": BAR, "load": load_now, **found}, indent=2))
        return
    for name, one in found.items():
        total, low, middle, high = one.values()
        verdict = "ok" if total <= BAR else "OVER"
        print(f"{name:26} {total:.2f}  pairs {middle:.2f} ({low:.2f} to {high:.2f})  bar {BAR}  {verdict}")
    print(f"load {load_now} on {os.cpu_count()} cores")


if __name__ == "__main__":
    main()
