"""A small stage for tests of the physics: put things down, drive, watch."""

import math
import random
from functools import cache
from typing import Any

import mujoco
import numpy as np

from rcj_challenges.chassis.base import YAW
from rcj_challenges.core.play import Placement, Pose2, Snapshot
from rcj_challenges.core.timing import ticks_from_s
from rcj_challenges.scenario.load import load
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.world.world import World
from tests.scenario.writing import in_tuples

FULL = 10.0
"""Top wheel speed in rad/s (reference, section 2)."""
BALL_R = 0.021
HALF_CUBE = 0.0375


@cache
def _match() -> dict[str, Any]:
    return load("match").resolved


def scenario_with(**changes: Any) -> Scenario:
    """The match with some sections changed, merged by key; None removes."""
    return Scenario.model_validate(in_tuples(_merged(_match(), changes)))


def _merged(base: dict[str, Any], changes: dict[str, Any]) -> dict[str, Any]:
    out = dict(base)  # what is validated stays as it is, so nothing deeper needs a copy
    for key, value in changes.items():
        out[key] = _merged(out[key], value) if isinstance(value, dict) and isinstance(out.get(key), dict) else value
    return {key: value for key, value in out.items() if value is not None or key not in changes}


class Stage:
    """A world in which everything is parked until it is put somewhere."""

    def __init__(self, **changes: Any) -> None:
        self.scenario = scenario_with(**changes)
        self.roster = Roster.of(self.scenario)
        self.world = World(self.scenario, self.roster)
        self._begin()

    def _begin(self) -> None:
        self.tick = 0
        self.snapshot: Snapshot | None = None
        self.world.place([Placement(entity, 0, 0, 0, parked=True) for entity in range(len(self.roster.entities))])

    def index(self, name: str) -> int:
        return self.roster.index[name]

    def put(self, name: str, x: float, y: float, yaw: float = 0.0) -> None:
        self.world.place([Placement(self.index(name), x, y, yaw)])

    def park(self, name: str) -> None:
        self.world.place([Placement(self.index(name), 0, 0, 0, parked=True)])

    def hold(self, *names: str) -> None:
        """Hold these robots and no others."""
        self.world.hold_robots([self.index(name) for name in names])

    def roll(self, name: str, vx: float, vy: float) -> None:
        """Let a ball roll without sliding."""
        ball, radius = self.index(name), self.scenario.balls[name].radius_m
        self.world.data.qvel[self.world.tables.dofs[ball]] = [vx, vy, 0, -vy / radius, vx / radius, 0]

    def slide(self, name: str, vx: float, vy: float) -> None:
        """Let a ball slide without turning."""
        self.world.data.qvel[self.world.tables.dofs[self.index(name)]] = [vx, vy, 0, 0, 0, 0]

    def drive(self, name: str, left: float, right: float) -> None:
        self.world.set_wheel(self.index(name), 0, left, math.inf)
        self.world.set_wheel(self.index(name), 1, right, math.inf)

    def play(self, seconds: float = 0.032) -> list[Snapshot]:
        """Play at least so long; returns the snapshots."""
        snapshots = []
        for _ in range(ticks_from_s(seconds)):
            self.tick += 1
            self.snapshot = self.world.step(self.tick)
            snapshots.append(self.snapshot)
        return snapshots

    def pose(self, name: str) -> Pose2:
        return self.world.judged().substeps[-1][self.index(name)]

    def velocity(self, name: str) -> tuple[float, float, float]:
        """Speed along x and y in m/s, and about z in rad/s (of a ball: along z in m/s)."""
        dofs = self.world.tables.dofs[self.index(name)][:3]
        x, y, third = self.world.data.qvel[dofs].tolist()
        return x, y, third

    def speed(self, name: str) -> float:
        x, y, _ = self.velocity(name)
        return math.hypot(x, y)

    def wheel_angles(self, name: str) -> list[float]:
        """[left, right] in rad; they grow while it drives along its +x."""
        first = self.world.tables.qpos_at[self.index(name)] + YAW + 1
        return self.world.data.qpos[first : first + 2].tolist()

    def ray(self, origin: tuple[float, float, float], direction: tuple[float, float, float], *groups: int) -> float:
        """Distance to the first geom of the groups, -1 if there is none."""
        chosen = np.array([group in groups for group in range(6)], dtype=np.uint8)
        geom = np.zeros(1, dtype=np.int32)
        model, data = self.world.model, self.world.data
        return mujoco.mj_ray(model, data, np.array(origin), np.array(direction), chosen, 1, -1, geom, None)

    def touching(self, snapshot: Snapshot) -> set[tuple[str, str]]:
        """Names of what touched in any sub-step of a tick."""
        things = self.roster.things
        return {(things[one], things[other]) for pairs in snapshot.touches for one, other in pairs}

    def touched_in(self, seconds: float) -> set[tuple[str, str]]:
        """Play, and return the names of what touched meanwhile."""
        return set().union(*map(self.touching, self.play(seconds)))


_last: dict[str, Stage] = {}


def same_stage(**changes: Any) -> Stage:
    """Return the stage that was asked for last, put back to its beginning, if it is the same: to build one takes long.

    For tests that try the same again and again from other places. What they got before is no longer theirs.
    """
    key = repr(changes)
    if key not in _last:
        _last.clear()
        _last[key] = Stage(**changes)
    stage = _last[key]
    stage.world.reset()
    stage._begin()
    return stage


class Crowd:
    """Robots that all chase the ball, or drive wildly, and so crowd in corners and at walls."""

    def __init__(self, stage: Stage, seed: int, chasers: int) -> None:
        self._stage = stage
        self._random = random.Random(seed)  # noqa: S311 - a reproducible load, not a secret
        self._chasers = chasers

    def command(self) -> None:
        stage = self._stage
        poses = stage.snapshot.substeps[-1] if stage.snapshot else stage.world.judged().substeps[-1]
        ball_x, ball_y, _ = poses[stage.roster.robots]
        for robot, name in enumerate(stage.roster.entities[: stage.roster.robots]):
            if robot >= self._chasers:
                if stage.tick % 8 == 0:
                    stage.drive(name, self._random.choice((-10, -5, 0, 5, 10)), self._random.choice((-10, 0, 10)))
                continue
            x, y, yaw = poses[robot]
            off = math.remainder(math.atan2(ball_y - y, ball_x - x) - yaw, 2 * math.pi)
            turn = max(-FULL, min(FULL, 12 * off))
            ahead = FULL if abs(off) < 0.6 else 0.0
            stage.drive(name, max(-FULL, min(FULL, ahead - turn)), max(-FULL, min(FULL, ahead + turn)))
