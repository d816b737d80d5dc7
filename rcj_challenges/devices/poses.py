"""Where a robot is, in the frame in which its devices measure.

The frame of a robot is level: it turns with the robot about the vertical and nothing else, and heights are nominal
(ADR 5). Programs divide by the small z part of the ball's direction, so a hundredth of a radian of rocking would turn
0.58 m into 0.90 (reference, section 2).
"""

from __future__ import annotations

import math

NOMINAL_WITHIN_M = 0.005
"""A centre this close to its nominal height is taken to be there: more than contacts give way or a ball hops, less
than anything that is lifted or climbs."""

Vector = tuple[float, float, float]


class RobotPose:
    """Pose of one robot; refreshed every tick.

    Attributes:
        x, y: centre of its body in m.
        z: nominal height of that in m.
        cos, sin: of the yaw.
    """

    __slots__ = ("cos", "sin", "x", "y", "z")

    def __init__(self, nominal_z: float) -> None:
        self.x = self.y = 0.0
        self.z = nominal_z
        self.cos, self.sin = 1.0, 0.0

    @property
    def yaw(self) -> float:
        """Yaw in rad, in [-π, π]."""
        return math.atan2(self.sin, self.cos)

    def to_frame(self, dx: float, dy: float, dz: float) -> Vector:
        """Turn a vector of the world into the robot's frame: x forward, y left, z up."""
        return (self.cos * dx + self.sin * dy, self.cos * dy - self.sin * dx, dz)
