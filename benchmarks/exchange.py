"""What exchanging observations and requests with six trivial programs costs per tick.

    python benchmarks/exchange.py [--ticks 3000] [--rounds 5] [--json]

Rows: the exchange as matches do it; its portable twin; and as a floor, in the same run, the same bytes over bare pipes
with ``poll``, answered by six children that do nothing else. Medians and minima over the rounds, in µs a tick.
"""

from __future__ import annotations

import argparse
import json
import os
import select
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

from rcj_challenges.core.play import Fault
from rcj_challenges.core.traffic import DeviceSpec, Observation, Packet, RobotSpec
from rcj_challenges.programs.pool import PoolPlan, ProgramPool
from rcj_challenges.scenario.models.limits import Limits
from rcj_challenges.submissions.team import open_team

ROBOTS = ("B1", "B2", "B3", "Y1", "Y2", "Y3")
DEVICES = (
    ("left wheel motor", "motor", 0), ("right wheel motor", "motor", 0), ("gps", "gps", 3),
    ("supervisor receiver", "receiver", 0), ("compass", "compass", 3),
    *((f"{side} wheel sensor", "position_sensor", 1) for side in ("left", "right")),
    *((f"distancesensor {side}", "distance_sensor", 1) for side in ("left", "right", "front", "back")),
)  # fmt: skip
"""Name, kind and how many numbers each has."""
VALUES = sum(width for _, _, width in DEVICES)
RECEIVER = [name for name, _, _ in DEVICES].index("supervisor receiver")
PROGRAM = """
from controller import Robot
robot = Robot()
wheels = [robot.getDevice(side + " wheel motor") for side in ("left", "right")]
gps = robot.getDevice("gps")
supervisor = robot.getDevice("supervisor receiver")
for wheel in wheels:
    wheel.setPosition(float("inf"))
gps.enable(32)
supervisor.enable(32)
while robot.step(32) != -1:
    while supervisor.getQueueLength():
        supervisor.getData()
        supervisor.nextPacket()
    x, y, z = gps.getValues()
    wheels[0].setVelocity(5 if x % 2 else -5)
    wheels[1].setVelocity(5)
"""
NUMPY_PROGRAM = "import numpy\n" + PROGRAM
ECHO = "import os\nwhile d := os.read(0, 65536): os.write(1, d[:48])"


def spec(name: str) -> RobotSpec:
    """Return a robot with these devices."""
    devices, slot = [], 0
    for index, (device, kind, width) in enumerate(DEVICES):
        devices.append(DeviceSpec(device, kind, index, slot if width else -1, width))
        slot += width
    return RobotSpec(name, tuple(devices), VALUES, "bytes")


def crew_rounds(folder: Path, source: str, ticks: int, rounds: int, *, portable: bool) -> tuple[float, list[float]]:
    """Return the seconds from launch to the first requests of all six, and µs a tick of each round."""
    (folder / "robot.py").write_text(source, encoding="utf-8")
    costs = []
    team = open_team(folder / "robot.py")
    with ProgramPool(PoolPlan(Limits(), 1, 1, folder / "logs", portable=portable)) as pool:
        began = time.perf_counter()
        programs = [pool.add(spec(name), team, team.single) for name in ROBOTS]
        pool.launch()
        for program in programs:
            program.collect()
        start_s = time.perf_counter() - began
        tick = 0
        for _ in range(rounds):
            began = time.perf_counter()
            for _ in range(ticks):
                tick += 1
                observation = Observation(tick, [float(tick)] * VALUES, [Packet(RECEIVER, b"\0", 1.0, (1.0, 0.0, 0.0))])
                for program in programs:
                    program.release(observation)
                for program in programs:
                    answer = program.collect()
                    if isinstance(answer, Fault):
                        raise SystemExit(f"a program failed: {answer}")
            costs.append((time.perf_counter() - began) / ticks * 1e6)
    return start_s, costs


def floor_rounds(ticks: int, rounds: int) -> list[float]:
    """Return µs a tick of bare pipes."""
    children = [
        subprocess.Popen([sys.executable, "-S", "-c", ECHO], stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0)
        for _ in ROBOTS
    ]
    ends = [(c.stdin.fileno(), c.stdout.fileno()) for c in children if c.stdin and c.stdout]
    polls = [select.poll() for _ in ends]
    for poll, (_, read_fd) in zip(polls, ends, strict=True):
        poll.register(read_fd, select.POLLIN)
    message = bytes(18 + VALUES * 8 + 39)
    costs = []
    for number in range(rounds + 1):
        began = time.perf_counter()
        for _ in range(ticks if number else 10):
            for write_fd, _ in ends:
                os.write(write_fd, message)
            for poll, (_, read_fd) in zip(polls, ends, strict=True):
                poll.poll(5000)
                os.read(read_fd, 65536)
        costs.append((time.perf_counter() - began) / ticks * 1e6)
    for child in children:
        child.kill()
        child.communicate()
    return costs[1:]


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ticks", type=int, default=3000)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args()
    rows: dict[str, dict[str, float]] = {}

    def row(name: str, measure: Callable[[Path], tuple[float, list[float]]]) -> None:
        with tempfile.TemporaryDirectory() as folder:
            start_s, costs = measure(Path(folder))
        rows[name] = {"median_us": statistics.median(costs), "min_us": min(costs), "start_s": start_s}

    if hasattr(select, "poll"):
        row("bare pipes", lambda _: (0.0, floor_rounds(options.ticks, options.rounds)))
    for name, portable, source in (
        ("exchange", False, PROGRAM),
        ("portable twin", True, PROGRAM),
        ("exchange, numpy imported", False, NUMPY_PROGRAM),
    ):
        if portable or hasattr(select, "poll"):
            row(
                name,
                lambda folder, p=portable, s=source: crew_rounds(folder, s, options.ticks, options.rounds, portable=p),
            )
    if options.json:
        print(json.dumps(rows, indent=2))
        return
    print(f"{'six programs':26}{'median µs':>12}{'min µs':>10}{'start s':>10}")
    for name, row_ in rows.items():
        print(f"{name:26}{row_['median_us']:12.0f}{row_['min_us']:10.0f}{row_['start_s']:10.2f}")


if __name__ == "__main__":
    main()
