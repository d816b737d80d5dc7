"""The device ``camera``: pictures of what a robot sees (ADR 17).

Pictures reach a program as packets of its camera: how many colours there are, red, green and blue of each, then a
colour's number for each pixel, row by row. What it recognizes comes in packets of the camera's index and `RECOGNITION`,
one `SEEN` for each thing, and is asked for by that number.
"""

import math
from collections.abc import Iterable, Iterator, Sequence
from struct import Struct
from typing import Any, Literal

from rcj_challenges.chassis.base import Chassis
from rcj_challenges.core.play import HalfInfo
from rcj_challenges.core.timing import TICK_S
from rcj_challenges.devices.base import Device, Eye, Fitted, Rgb, RobotSetup, Seen
from rcj_challenges.devices.noise import sensor_stream
from rcj_challenges.devices.poses import Vector
from rcj_challenges.rules.fields import NotNegative, Positive, described
from rcj_challenges.rules.phrasing import degrees, metres

NEAR_M = 0.01
"""What ``getNear`` returns: nothing nearer is ever seen, because bodies are larger."""

RECOGNITION = 0x8000
"""Added to a camera's index: the number under which its recognition is enabled, and its packets come."""

SEEN = Struct("<2H3B6d4H")
"""A thing: number, model, red, green, blue, position (3) in m, yaw in rad, width and height in m, box in pixels (4)."""
MODELS = ("robot", "ball", "obstacle")

_FULL = 255


class CameraDevice(Device):
    """A camera that looks level. What stands on the field is seen, wheels are not."""

    # Their source: measured with prototypes (ADR 17): a ball is found up to 1.5 m away.

    device: Literal["camera"]
    width: int = described(64, "columns of a picture", ge=8, le=160)
    height: int = described(48, "rows of a picture", ge=6, le=120)
    hz: Positive = described(10.0, "pictures a second, rounded to whole ticks of 32 ms", le=31.25)
    field_of_view_rad: Positive = described(
        1.0472, "angle from the left to the right edge in rad; from 3.1416 on a panorama of equal angles", le=6.2832
    )
    bearing_rad: float = described(0.0, "direction in the robot's frame in rad; 0 front, 1.5708 left (+y)")
    below_horizon: NotNegative = described(0.62, "share of the rows that show what is lower than the camera", le=1)
    ahead_m: NotNegative = described(0.03, "distance from the robot's centre along the bearing in m")
    height_m: Positive = described(0.06, "height above the floor in m", le=1)
    light: tuple[Positive, Positive] = described((1.0, 1.0), "smallest and largest brightness; each half draws its own")

    recognition: bool = described(
        False, "whether it recognizes robots, balls and obstacles by itself, without their pictures"
    )

    CLASS = "camera"
    ACCEPTS = frozenset({"sampling"})
    FREE = frozenset({"bearing_rad", "below_horizon", "ahead_m", "height_m"})
    EXAMPLE = """
robots:
  Y1: {devices: {front camera: {device: camera, light: [0.85, 1.15]}}}
"""

    @property
    def every_ticks(self) -> int:
        """How many ticks pass from picture to picture."""
        return max(1, round(1 / (self.hz * TICK_S)))

    @property
    def eye(self) -> Eye:
        """Where it sits and what it takes in."""
        return Eye(
            self.bearing_rad, self.ahead_m, self.height_m, self.width, self.height, self.field_of_view_rad,
            self.below_horizon,
        )  # fmt: skip

    def place(self) -> Vector:
        return self.ahead_m * math.cos(self.bearing_rad), self.ahead_m * math.sin(self.bearing_rad), self.height_m

    def looks(self) -> tuple[float, float]:
        return self.bearing_rad, self.field_of_view_rad

    def facts(self, _setup: RobotSetup) -> dict[str, Any]:
        return {"width": self.width, "height": self.height, "fov": self.field_of_view_rad, "near": NEAR_M,
                "recognition": self.recognition}  # fmt: skip

    def contradictions(self, _chassis: Chassis) -> Iterator[tuple[str, str]]:
        if self.light[0] > self.light[1]:
            yield "light", "the smallest brightness stands first"

    def describe(self) -> str:
        where = f"bearing {degrees(self.bearing_rad)}, {degrees(self.field_of_view_rad)} wide"
        if self.field_of_view_rad >= math.pi:
            where += " as a panorama"
        rows = f"{self.width} x {self.height} pixels ({100 * self.below_horizon:g} % of the rows below the horizon)"
        every_ms = round(self.every_ticks * TICK_S * 1000)
        text = (
            f"camera, {where}, {rows}, a picture every {every_ms} ms, {metres(self.ahead_m)} off the robot's centre "
            f"and {metres(self.height_m)} above the floor"
        )
        if self.recognition:
            text += "; recognizes robots, balls and obstacles"
        low, high = self.light
        if low == high == 1:
            return text
        return f"{text}; its brightness is drawn for each half, from {low:g} to {high:g}"

    def lit(self, palette: Sequence[Rgb], half: HalfInfo, fitted: Fitted) -> bytes:
        """Return the beginning of its pictures in a half: the colours in the light that is drawn for it."""
        share, high = self.light
        if share != high:
            share += (high - share) * float(sensor_stream(half, fitted.robot_name, fitted.spec.name).random())
        parts = bytes(min(_FULL, int(part * share)) for colour in palette for part in colour)
        return bytes([len(palette)]) + parts


def packed(things: Iterable[Seen]) -> bytes:
    """Return a packet of what a camera recognizes."""
    return b"".join(
        SEEN.pack(
            one.number,
            MODELS.index(one.model),
            *one.rgb,
            *one.position,
            one.yaw_rad,
            one.width_m,
            one.height_m,
            *one.box,
        )
        for one in things
    )
