"""The device ``wheel_sensor``."""

from collections.abc import Iterable, Sequence
from typing import Literal, Self

from rcj_challenges.chassis.base import WHEEL_NAMES, Chassis, WheelName, wheel_words
from rcj_challenges.devices.base import Device, Fitted, Reader, Sensor, SensorContext
from rcj_challenges.devices.poses import RobotPose
from rcj_challenges.rules.fields import OneOrMinusOne, described


class WheelSensorDevice(Device):
    """Measures how far a wheel has turned, in rad."""

    device: Literal["wheel_sensor"]
    wheel: WheelName = described(..., f"the wheel it measures{WHEEL_NAMES}")
    direction: OneOrMinusOne = described(
        1, "1: the value increases while the robot drives along its +x; -1: it decreases"
    )

    CLASS = "position_sensor"
    ACCEPTS = frozenset({"sampling"})
    FREE = frozenset({"wheel", "direction"})
    WIDTH = 1
    RESOLUTION = 1e-4  # a page shows how fast it changes, too
    EXAMPLE = """
robots:
  Y1: {devices: {left wheel sensor: {device: wheel_sensor, wheel: left}}}
"""

    def make_sensor(self, fitted: Fitted, context: SensorContext) -> Sensor:
        return WheelSensor(self, fitted, context)

    def contradictions(self, chassis: Chassis) -> Iterable[tuple[str, str]]:
        return chassis.lacking(self.wheel)

    def describe(self) -> str:
        driving = "forward" if self.direction == 1 else "backward"
        return f"angle of {wheel_words(self.wheel)} in rad, grows while the robot drives {driving}"


class WheelSensor(Sensor):
    """A wheel's angle in rad since the start of the half.

    Attributes:
        joints: refreshed every tick.
        row: its slot, where its angle stands in `Joints.state`, and 1, or -1 to count the other way.
    """

    def __init__(self, device: WheelSensorDevice, fitted: Fitted, context: SensorContext) -> None:
        super().__init__(fitted.spec)
        self.joints = context.joints
        number = fitted.setup.chassis.number_of(device.wheel)
        self.row = (self.slot, context.joints.wheel_angle_at(fitted.robot, number), device.direction)

    @classmethod
    def reader(cls, sensors: Sequence[Self]) -> Reader:
        joints, rows = sensors[0].joints, [sensor.row for sensor in sensors]

        def read(_tick: int, _pose: RobotPose, values: list[float]) -> None:
            state = joints.state
            for slot, at, direction in rows:
                values[slot] = direction * state[at]

        return read
