"""Where robots with a touch sensor are touched."""

from __future__ import annotations

import math

import numpy as np

from rcj_challenges.chassis.base import YAW
from rcj_challenges.devices.touch_sensor import TouchSensorDevice
from rcj_challenges.scenario.kits import devices_of
from rcj_challenges.world.effects.base import Effect, Scene
from rcj_challenges.world.tables import NO_THING, one_by_one


class Bumpers(Effect):
    """The contacts of a tick by robot, as bearings in its frame; balls do not count."""

    def __init__(self, scene: Scene) -> None:
        tables, names = scene.tables, scene.roster.entities
        self._contacts, self._qpos = scene.data.contact, one_by_one(scene.data.qpos)
        balls = tables.ball_range
        self._things = [NO_THING if thing in balls else thing for thing in tables.geom_things.tolist()]
        self._robots = {
            robot: tables.qpos_at[robot]
            for robot in range(tables.robots)
            if any(isinstance(one, TouchSensorDevice) for one in devices_of(scene.scenario, names[robot]).values())
        }
        self.bearings: dict[int, list[float]] = {robot: [] for robot in self._robots}
        self.is_needed = bool(self._robots)

    def reset(self) -> None:
        for bearings in self.bearings.values():
            bearings.clear()

    def before_substep(self, substep: int) -> None:
        if substep == 0:
            self.reset()

    def after_substep(self, pattern: bytes) -> None:
        pairs = np.frombuffer(pattern, np.int32).reshape(-1, 2).tolist()
        for number, pair in enumerate(pairs):
            one, other = (self._things[geom] for geom in pair)
            if NO_THING in {one, other}:
                continue
            for robot in (one, other):
                at = self._robots.get(robot)
                if at is None:
                    continue
                x, y, _ = self._contacts.pos[number].tolist()
                bearing = math.atan2(y - self._qpos[at + 1], x - self._qpos[at]) - self._qpos[at + YAW]
                self.bearings[robot].append(bearing)
