"""The device ``ball_receiver``."""

import math
from typing import Any, Literal, cast

from rcj_challenges.core.play import HalfInfo
from rcj_challenges.core.traffic import Packet
from rcj_challenges.devices.base import Fitted, RobotSetup
from rcj_challenges.devices.noise import Noise
from rcj_challenges.devices.poses import Vector
from rcj_challenges.devices.receivers import ANY_CHANNEL, Receiver, ReceiverDevice
from rcj_challenges.devices.wording import noise_words, percent_words
from rcj_challenges.rules.fields import NotNegative, Positive, described
from rcj_challenges.rules.phrasing import degrees, metres

PAYLOADS = {"v2.1": b"\x01", "v2.2": b"x", "2021": b"\x01"}
"""What the ball sends, by the kit's messages: ``struct '?'``, or a letter. Source: reference, 4.1. (The robots of 2021
had no infra-red; one fitted to them gets bytes.)"""


class BallReceiverDevice(ReceiverDevice):
    """The infrared receiver for the ball: it reports the strength and direction of each packet."""

    device: Literal["ball_receiver"]
    channel: int = described(4, "channel number that getChannel returns")
    range_m: Positive = described(
        0.6, "greatest 3-D distance between the centres of ball and robot at which it receives, in m"
    )
    strength_noise: NotNegative = described(0.0, "standard deviation of the strength, as a share of its value")
    direction_noise_rad: NotNegative = described(0.0, "standard deviation of the direction's bearing in rad")

    EXAMPLE = """
robots:
  Y1: {devices: {ball receiver: {device: ball_receiver, range_m: 2, direction_noise_rad: 0.05}}}
"""

    def facts(self, _setup: RobotSetup) -> dict[str, Any]:
        return {"channel": self.channel, "range": self.range_m, "refused_channels": []}

    def describe(self) -> str:
        direction = f"{degrees(self.direction_noise_rad)} of the direction" if self.direction_noise_rad else ""
        noise = noise_words(percent_words(self.strength_noise, "the strength"), direction)
        return f"infra-red receiver of balls, up to {metres(self.range_m)}{noise}"


class BallReceiver:
    """A receiver of the balls' infra-red with its range, its noise and its payload."""

    def __init__(self, receiver: Receiver, fitted: Fitted, balls: int, half: HalfInfo) -> None:
        """Join a receiver and its settings; its noise has two draws a tick for each ball."""
        device = cast("BallReceiverDevice", fitted.device)
        is_noisy = device.strength_noise > 0 or device.direction_noise_rad > 0
        self.receiver = receiver
        self.robot = receiver.robot
        self.range_square_m2 = device.range_m**2
        self._payload = PAYLOADS[fitted.setup.messages]
        self._channel = device.channel
        self._strength_noise = device.strength_noise
        self._direction_noise_rad = device.direction_noise_rad
        self._noise = Noise.of(fitted, half, 2 * max(1, balls)) if is_noisy else None

    @property
    def listens(self) -> bool:
        """Whether it is enabled, and tuned to the balls."""
        return self.receiver.period_ticks > 0 and self.receiver.channel in (self._channel, ANY_CHANNEL)

    def receive(self, tick: int, ball: int, square_m2: float, direction: Vector) -> None:
        """Receive the packet of a ball at this squared distance and in this direction of the robot's frame."""
        strength = 1 / square_m2
        if self._noise is not None:
            strength, direction = self._disturbed(self._noise.numbers(tick), ball, strength, direction)
        self.receiver.receive(Packet(self.receiver.device, self._payload, strength, direction))

    def _disturbed(
        self, errors: list[float], ball: int, strength: float, direction: Vector
    ) -> tuple[float, Vector]:  # fmt: skip
        error, turn = errors[2 * ball : 2 * ball + 2]
        cos, sin = math.cos(turn * self._direction_noise_rad), math.sin(turn * self._direction_noise_rad)
        x, y, z = direction
        return max(0.0, strength * (1 + self._strength_noise * error)), (cos * x - sin * y, sin * x + cos * y, z)
