"""What sensing costs: microseconds per tick for all robots of a scenario, every sensor sampled, packets fetched.

python -m benchmarks.sensing_cost [--scenario match] [--ticks 4000]
"""

from __future__ import annotations

import argparse
import json
import statistics
import time

from benchmarks.physics_floor import MixedLoad
from rcj_challenges.core.play import HalfInfo, RefereeOutput
from rcj_challenges.core.traffic import Request
from rcj_challenges.robots.fitting import fit, fixed_rays
from rcj_challenges.robots.manager import DeviceManager
from rcj_challenges.scenario.load import Loaded, load
from rcj_challenges.world.world import World


def measure(loaded: Loaded, ticks: int) -> dict[str, float]:
    """Return median and mean of `DeviceManager.sense` plus `observe` for all robots, in µs per tick."""
    scenario, roster = loaded.scenario, loaded.roster
    seats = list(scenario.entrants)
    half = HalfInfo(1, 1, ticks, 1, 0, {s: s for s in seats}, {s: s for s in seats}, dict.fromkeys(seats, 0))
    world = World(scenario, roster, fixed_rays(fit(scenario, roster)))
    devices = DeviceManager(scenario, roster, world, half)
    devices.begin(RefereeOutput())
    for robot, spec in devices.specs.items():
        sampled = tuple((device.index, 1) for device in spec.devices if device.kind not in ("motor", "emitter"))
        devices.apply(robot, Request(1, sampling=sampled))
    traffic, output, times = MixedLoad(world), RefereeOutput(), []
    for tick in range(1, ticks + 1):
        traffic.command(tick)
        world.step(tick)
        began = time.perf_counter_ns()
        devices.sense(tick, output)
        for robot in devices.specs:
            devices.observe(robot, tick)
        times.append((time.perf_counter_ns() - began) / 1000)
    return {"median_us": statistics.median(times), "mean_us": statistics.fmean(times)}


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description="microseconds per tick of sensing")
    parser.add_argument("--scenario", default="match")
    parser.add_argument("--ticks", type=int, default=4000)
    given = parser.parse_args()
    print(json.dumps(measure(load(given.scenario), given.ticks), indent=2))


if __name__ == "__main__":
    main()
