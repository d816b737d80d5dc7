"""Motors: what a program commands, and what reaches the wheels."""

from __future__ import annotations

import math
from collections.abc import Sequence

from rcj_challenges.devices.fitting import Fitted
from rcj_challenges.devices.ground import Ground
from rcj_challenges.facts.traffic import MotorCommand
from rcj_challenges.scenario.models.robots import MotorDevice
from rcj_challenges.scenario.models.scenario import Scenario

_BY_VELOCITY = math.inf
"""The position target that means velocity control."""


class Drive:
    """The motors of one robot. A wheel that was never commanded stays braked, as the world left it."""

    def __init__(self, scenario: Scenario, robot: int, fitted: Sequence[Fitted], ground: Ground) -> None:
        """Find the robot's motors among its devices."""
        self._robot = robot
        self._ground = ground
        self._motors = {
            one.spec.index: (one.device.wheel, one.device.direction)
            for one in fitted
            if one.robot == robot and isinstance(one.device, MotorDevice)
        }
        name = list(scenario.robots)[robot]
        self._max_radps = scenario.kits[scenario.robots[name].kit].chassis.max_wheel_radps

    def command(self, command: MotorCommand) -> None:
        """Set a motor: clamped to its top speed; a command that is no number is ignored."""
        device, velocity, position = command
        motor = self._motors.get(device)
        if motor is None or velocity != velocity or position != position:  # noqa: PLR0124 - NaN, at every command
            return
        wheel, direction = motor
        limit = self._max_radps
        velocity = direction * (velocity if -limit <= velocity <= limit else math.copysign(limit, velocity))
        target = _BY_VELOCITY if math.isinf(position) else direction * position
        self._ground.set_wheel(self._robot, wheel, velocity, target)

    def stop(self) -> None:
        """Command all wheels velocity 0."""
        for wheel, _ in self._motors.values():
            self._ground.set_wheel(self._robot, wheel, 0.0, _BY_VELOCITY)
