"""What a robot knows of itself: wheel angles, position, heading."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import cast

from rcj_challenges.devices.fitting import Fitted
from rcj_challenges.devices.ground import Ground
from rcj_challenges.devices.noise import Noise
from rcj_challenges.devices.poses import Poses
from rcj_challenges.devices.sampling import Schedule
from rcj_challenges.facts.play import HalfInfo
from rcj_challenges.scenario.models.robots import CompassDevice, GpsDevice, WheelSensorDevice

Values = dict[int, list[float]]
"""By robot: the numbers of all its devices, by slot."""


class WheelSensors:
    """The turning angles of wheels, in rad since the start of the half."""

    def __init__(self, fitted: Sequence[Fitted], ground: Ground) -> None:
        self.schedule = Schedule()
        self._sensors = []
        for one in fitted:
            device = cast("WheelSensorDevice", one.device)
            at = int(ground.model.joint(f"{one.robot_name}/{device.wheel}_wheel").qposadr[0])
            self._sensors.append((one.robot, one.spec.slot, at, device.direction))

    def sample(self, tick: int, poses: Poses, values: Values) -> None:
        """Read the sensors that are due at ``tick``."""
        state = poses.state
        for member in self.schedule.due(tick):
            robot, slot, at, direction = self._sensors[member]
            values[robot][slot] = direction * state[at]


class Gpses:
    """Positions of cubes' centres in m: [x, y, z], or [y, z, x] in the legacy frame."""

    def __init__(self, fitted: Sequence[Fitted], half: HalfInfo) -> None:
        self.schedule = Schedule()
        self._sensors = []
        for one in fitted:
            device = cast("GpsDevice", one.device)
            noise = Noise(half, [(one.robot_name, one.spec.name)], 3) if device.noise_m else None
            self._sensors.append((one.robot, one.spec.slot, device.frame == "legacy", noise, device.noise_m))

    def sample(self, tick: int, poses: Poses, values: Values) -> None:
        """Read the sensors that are due at ``tick``."""
        for member in self.schedule.due(tick):
            robot, slot, legacy, noise, sigma_m = self._sensors[member]
            pose = poses.robots[robot]
            x, y, z = pose.x, pose.y, pose.z
            if noise is not None:
                error_x, error_y, error_z = noise.row(tick).tolist()
                x, y, z = x + sigma_m * error_x, y + sigma_m * error_y, z + sigma_m * error_z
            values[robot][slot : slot + 3] = (y, z, x) if legacy else (x, y, z)


class Compasses:
    """The world's +y in robots' frames: [sin ψ, cos ψ, 0] when level, or [cos θ, 0, sin θ] in the legacy frame."""

    def __init__(self, fitted: Sequence[Fitted], half: HalfInfo) -> None:
        self.schedule = Schedule()
        self._sensors = []
        for one in fitted:
            device = cast("CompassDevice", one.device)
            noise = Noise(half, [(one.robot_name, one.spec.name)]) if device.noise_rad else None
            self._sensors.append((one.robot, one.spec.slot, device.frame == "legacy", noise, device.noise_rad))

    def sample(self, tick: int, poses: Poses, values: Values) -> None:
        """Read the sensors that are due at ``tick``."""
        for member in self.schedule.due(tick):
            robot, slot, legacy, noise, sigma_rad = self._sensors[member]
            forward, left, up = poses.robots[robot].north()
            if noise is not None:
                error = sigma_rad * noise.row(tick).item()
                cos, sin = math.cos(error), math.sin(error)
                forward, left = forward * cos + left * sin, left * cos - forward * sin
            values[robot][slot : slot + 3] = (left, up, forward) if legacy else (forward, left, up)
