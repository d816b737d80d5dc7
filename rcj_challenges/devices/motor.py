"""The device ``motor``."""

import math
from collections.abc import Iterable, Sequence
from functools import partial
from typing import Any, Literal

from rcj_challenges.chassis.base import WHEEL_NAMES, Chassis, WheelName, wheel_words
from rcj_challenges.core.traffic import MotorCommand
from rcj_challenges.devices.base import Device, Fitted, Motion, Movers, RobotSetup
from rcj_challenges.rules.fields import OneOrMinusOne, described

_BY_VELOCITY = math.inf
"""The position target that means velocity control."""


class MotorDevice(Device):
    """The motor of a wheel."""

    device: Literal["motor"]
    wheel: WheelName = described(..., f"the wheel it turns{WHEEL_NAMES}")
    direction: OneOrMinusOne = described(1, "1: positive velocity drives the robot along its +x; -1: along -x")

    CLASS = "motor"
    ACCEPTS = frozenset({"motors"})
    FREE = frozenset({"wheel", "direction"})
    EXAMPLE = """
robots:
  Y1:
    devices:
      left wheel motor: {device: motor, wheel: left, direction: 1}
      right wheel motor: {device: motor, wheel: right, direction: 1}
"""

    def facts(self, setup: RobotSetup) -> dict[str, Any]:
        return {"max_velocity": setup.chassis.max_wheel_radps}

    def contradictions(self, chassis: Chassis) -> Iterable[tuple[str, str]]:
        return chassis.lacking(self.wheel)

    def make_motion(self, fitted: Fitted, movers: Movers) -> Motion:
        chassis = fitted.setup.chassis
        command = partial(movers.set_wheel, fitted.robot, chassis.number_of(self.wheel))
        return Motion(command, self.direction, chassis.max_wheel_radps)

    def describe(self) -> str:
        way = "forward" if self.direction == 1 else "backward"
        return f"motor of {wheel_words(self.wheel)}, positive speeds drive {way}"


class Motors:
    """The motors of one robot. A wheel that was never commanded stays braked, as the world left it."""

    def __init__(self, fitted: Sequence[Fitted], movers: Movers) -> None:
        """Find the motors among the devices of a robot."""
        motions = ((one.spec.index, one.device.make_motion(one, movers)) for one in fitted)
        self._motions = {index: motion for index, motion in motions if motion is not None}

    def command(self, command: MotorCommand) -> None:
        """Set a motor: clamped to its top speed; a command that is not a number is ignored."""
        device, velocity, position = command
        motion = self._motions.get(device)
        if motion is None or velocity != velocity or position != position:  # noqa: PLR0124 - NaN, at every command
            return
        set_motor, direction, limit = motion
        velocity = direction * (velocity if -limit <= velocity <= limit else math.copysign(limit, velocity))
        set_motor(velocity, _BY_VELOCITY if math.isinf(position) else direction * position)

    def stop(self) -> None:
        """Command all motors velocity 0."""
        for motion in self._motions.values():
            motion.command(0.0, _BY_VELOCITY)
