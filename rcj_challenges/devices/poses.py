"""Where a robot is, in the frame in which its devices measure.

The frame of a robot that stands is level: it turns with the robot about the vertical and nothing else, and heights
are nominal. Programs divide by the small z part of the ball's direction, so a hundredth of a radian of rocking would
turn 0.58 m into 0.90 (reference, section 2). Once it has tipped over, its frame is that of its body (ADR 5); the
robots of the present world cannot (ADR 2), and then nothing of this costs anything.
"""

from __future__ import annotations

import math

TIPPED_FROM_RAD = math.pi / 6
"""From this tilt on a robot counts as tipped over: from there the third part of its compass can reach 0.5, which is
what programs take for "I am lying on my side" (reference, 4.1)."""

NOMINAL_WITHIN_M = 0.005
"""A centre this close to its nominal height is taken to be there: more than contacts give way or a ball hops, less
than anything that is lifted or climbs."""

_COS_TIPPED = math.cos(TIPPED_FROM_RAD)
_ON_ITS_NOSE = 1e-6

Vector = tuple[float, float, float]


class RobotPose:
    """Pose of one robot's cube; refreshed every tick.

    Attributes:
        x, y, z: centre of the cube in m; z is nominal while the robot stands.
        cos, sin: of the yaw.
        tipped: whether the robot lies; then ``rotation`` counts instead of the yaw.
        rotation: body to world, row by row; of robots that move freely.
        parked: whether it has been taken off the field.
    """

    __slots__ = ("_nominal_z", "cos", "parked", "rotation", "sin", "tipped", "x", "y", "z")

    def __init__(self, nominal_z: float) -> None:
        self._nominal_z = nominal_z
        self.x = self.y = 0.0
        self.z = nominal_z
        self.cos, self.sin = 1.0, 0.0
        self.tipped = False
        self.rotation: tuple[float, ...] = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)
        self.parked = False

    def read(self, position: list[float], quaternion: list[float]) -> None:
        """Take over the pose of a robot that moves freely: [x, y, z] in m, and the unit quaternion [w, x, y, z]."""
        self.x, self.y, z = position
        self.rotation = rotation = _matrix(*quaternion)
        # Forward is the body's x axis, laid flat. A robot on its nose has none; it keeps its last yaw.
        length = math.hypot(rotation[0], rotation[3])
        if length > _ON_ITS_NOSE:
            self.cos, self.sin = rotation[0] / length, rotation[3] / length
        self.tipped = rotation[8] <= _COS_TIPPED
        stands = not self.tipped and abs(z - self._nominal_z) < NOMINAL_WITHIN_M
        self.z = self._nominal_z if stands else z

    @property
    def yaw(self) -> float:
        """Yaw in rad, in [-π, π]."""
        return math.atan2(self.sin, self.cos)

    def to_frame(self, dx: float, dy: float, dz: float) -> Vector:
        """Turn a vector of the world into the robot's frame: x forward, y left, z up."""
        if self.tipped:
            r = self.rotation
            return (
                r[0] * dx + r[3] * dy + r[6] * dz,
                r[1] * dx + r[4] * dy + r[7] * dz,
                r[2] * dx + r[5] * dy + r[8] * dz,
            )
        return (self.cos * dx + self.sin * dy, self.cos * dy - self.sin * dx, dz)

    def north(self) -> Vector:
        """Return the world's +y axis in the robot's frame: what a compass shows."""
        if self.tipped:
            return (self.rotation[3], self.rotation[4], self.rotation[5])
        return (self.sin, self.cos, 0.0)


def _matrix(w: float, i: float, j: float, k: float) -> tuple[float, ...]:
    """Return the rotation matrix of a unit quaternion, row by row."""
    return (
        1 - 2 * (j * j + k * k), 2 * (i * j - w * k), 2 * (i * k + w * j),
        2 * (i * j + w * k), 1 - 2 * (i * i + k * k), 2 * (j * k - w * i),
        2 * (i * k - w * j), 2 * (j * k + w * i), 1 - 2 * (i * i + j * j),
    )  # fmt: skip
