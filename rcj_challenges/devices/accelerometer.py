"""The device ``accelerometer``."""

from typing import Literal

from rcj_challenges.chassis.base import GRAVITY_MPS2
from rcj_challenges.core.timing import TICK_S
from rcj_challenges.devices.base import Device, Fitted, Sensor, SensorContext
from rcj_challenges.devices.noise import Noise
from rcj_challenges.devices.poses import RobotPose
from rcj_challenges.devices.wording import noise_words
from rcj_challenges.rules.fields import NotNegative, described


class AccelerometerDevice(Device):
    """The acceleration of the robot in its frame, with what holds it against gravity: [0, 0, 9.81] at rest."""

    device: Literal["accelerometer"]
    noise_mps2: NotNegative = described(0.0, "standard deviation of each part in m/s²", le=100)

    CLASS = "accelerometer"
    ACCEPTS = frozenset({"sampling"})
    WIDTH = 3
    EXAMPLE = """
robots:
  Y1: {devices: {accelerometer: {device: accelerometer, noise_mps2: 0.1}}}
"""

    def make_sensor(self, fitted: Fitted, context: SensorContext) -> Sensor:
        return AccelerometerSensor(self, fitted, context)

    def describe(self) -> str:
        noise = noise_words(f"{self.noise_mps2:g} m/s²" if self.noise_mps2 else "")
        return f"acceleration ahead, to the left and up in m/s², at rest 0, 0, 9.81{noise}"


class AccelerometerSensor(Sensor):
    """The mean acceleration of the last tick; a robot that is put somewhere comes to rest there."""

    def __init__(self, device: AccelerometerDevice, fitted: Fitted, context: SensorContext) -> None:
        super().__init__(fitted.spec)
        self.advances = True
        self._robot, self._joints = fitted.robot, context.joints
        self._noise_mps2 = device.noise_mps2
        self._noise = Noise.of(fitted, context.half, draws_per_tick=3)
        self._speeds = self._gained = (0.0, 0.0)

    def advance(self, _tick: int, _pose: RobotPose) -> None:
        vx, vy, _ = self._joints.velocity(self._robot)
        before_x, before_y = self._speeds
        self._speeds, self._gained = (vx, vy), (vx - before_x, vy - before_y)

    def read(self, tick: int, pose: RobotPose, values: list[float]) -> None:
        x, y = self._gained
        measured = pose.to_frame(x / TICK_S, y / TICK_S, GRAVITY_MPS2)
        noise = self._noise.numbers(tick) if self._noise_mps2 else (0.0, 0.0, 0.0)
        for axis, (part, error) in enumerate(zip(measured, noise, strict=True)):
            values[self.slot + axis] = part + self._noise_mps2 * error
