"""The inertial unit."""

from __future__ import annotations

import math

from .device import ReadOnly, Sensor

__all__ = ["InertialUnit"]


class InertialUnit(Sensor):
    """Which way the robot looks."""

    def getRollPitchYaw(self) -> list[float]:
        """Return roll, pitch and yaw in rad; NaN before the first sample.

        The yaw is 0 along the field's +x axis and grows counter-clockwise, from -π to π.

        Example:
            ``heading = unit.getRollPitchYaw()[2]``
        """
        return list(self._rcj_numbers())

    def getQuaternion(self) -> list[float]:
        """Return the same as a unit quaternion [x, y, z, w]."""
        roll, pitch, yaw = (angle / 2 for angle in self._rcj_numbers())
        (cr, sr), (cp, sp), (cy, sy) = ((math.cos(half), math.sin(half)) for half in (roll, pitch, yaw))
        return [
            sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy,
            cr * cp * sy - sr * sp * cy, cr * cp * cy + sr * sp * sy,
        ]  # fmt: skip

    def getNoise(self) -> float:
        """Return the standard deviation of the yaw in rad."""
        return float(self._rcj_facts["noise"])

    roll_pitch_yaw = ReadOnly(getRollPitchYaw)
    quaternion = ReadOnly(getQuaternion)
    noise = ReadOnly(getNoise)
