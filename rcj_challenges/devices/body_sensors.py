"""What a robot knows of itself: wheel angles, position, heading."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple, cast

from rcj_challenges.devices.fitting import Fitted
from rcj_challenges.devices.ground import Ground
from rcj_challenges.devices.noise import Noise
from rcj_challenges.devices.poses import Poses
from rcj_challenges.devices.sampling import Family
from rcj_challenges.facts.play import HalfInfo
from rcj_challenges.scenario.models.robots import CompassDevice, GpsDevice, WheelSensorDevice


class WheelSensor(NamedTuple):
    """A wheel's angle: where it goes, where it stands in `qpos`, and which way it counts."""

    slot: int
    at: int
    direction: int


class WheelSensors(Family[WheelSensor]):
    """The turning angles of wheels, in rad since the start of the half."""

    def __init__(self, fitted: Sequence[Fitted], ground: Ground) -> None:
        """Find the wheels."""
        sensors = []
        for one in fitted:
            device = cast("WheelSensorDevice", one.device)
            at = int(ground.model.joint(f"{one.robot_name}/{device.wheel}_wheel").qposadr[0])
            sensors.append(WheelSensor(one.spec.slot, at, device.direction))
        super().__init__([one.robot for one in fitted], sensors)

    def read(self, robot: int, tick: int, poses: Poses, own: list[float]) -> None:
        """See `Family`."""
        if not self.due:
            return
        state = poses.state
        for member, (slot, at, direction) in self.of_robot[robot]:
            if self.all_due or member in self.due:
                own[slot] = direction * state[at]


class BodySensor(NamedTuple):
    """A sensor of three numbers: where they go, whether in the frame of 2021, and its errors (None: it has none)."""

    slot: int
    legacy: bool
    noise: Noise | None
    sigma: float


class Gpses(Family[BodySensor]):
    """Positions of cubes' centres in m: [x, y, z], or [y, z, x] in the legacy frame."""

    def __init__(self, fitted: Sequence[Fitted], half: HalfInfo) -> None:
        """Open the streams of noise."""
        sensors = []
        for one in fitted:
            device = cast("GpsDevice", one.device)
            noise = Noise(half, [(one.robot_name, one.spec.name)], 3) if device.noise_m else None
            sensors.append(BodySensor(one.spec.slot, device.frame == "legacy", noise, device.noise_m))
        super().__init__([one.robot for one in fitted], sensors)

    def read(self, robot: int, tick: int, poses: Poses, own: list[float]) -> None:
        """See `Family`."""
        if not self.due:
            return
        pose = poses.robots[robot]
        for member, (slot, legacy, noise, sigma_m) in self.of_robot[robot]:
            if not self.all_due and member not in self.due:
                continue
            x, y, z = pose.x, pose.y, pose.z
            if noise is not None:
                error_x, error_y, error_z = noise.numbers(tick)
                x, y, z = x + sigma_m * error_x, y + sigma_m * error_y, z + sigma_m * error_z
            own[slot : slot + 3] = (y, z, x) if legacy else (x, y, z)


class Compasses(Family[BodySensor]):
    """The world's +y in robots' frames: [sin ψ, cos ψ, 0] when level, or [cos θ, 0, sin θ] in the legacy frame."""

    def __init__(self, fitted: Sequence[Fitted], half: HalfInfo) -> None:
        """Open the streams of noise."""
        sensors = []
        for one in fitted:
            device = cast("CompassDevice", one.device)
            noise = Noise(half, [(one.robot_name, one.spec.name)]) if device.noise_rad else None
            sensors.append(BodySensor(one.spec.slot, device.frame == "legacy", noise, device.noise_rad))
        super().__init__([one.robot for one in fitted], sensors)

    def read(self, robot: int, tick: int, poses: Poses, own: list[float]) -> None:
        """See `Family`."""
        if not self.due:
            return
        for member, (slot, legacy, noise, sigma_rad) in self.of_robot[robot]:
            if not self.all_due and member not in self.due:
                continue
            forward, left, up = poses.robots[robot].north()
            if noise is not None:
                error = sigma_rad * noise.numbers(tick)[0]
                cos, sin = math.cos(error), math.sin(error)
                forward, left = forward * cos + left * sin, left * cos - forward * sin
            own[slot : slot + 3] = (left, up, forward) if legacy else (forward, left, up)
