"""Devices that few robots have.

Each file costs every program, so this one is read when a robot has one of them, or a program asks for their classes.
"""

from __future__ import annotations

import math

from ._connection import Connection, complain, number
from .device import Device, ReadOnly, Sensor

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


class TouchSensor(Sensor):
    """Whether the robot touches something."""

    BUMPER, FORCE, FORCE3D = range(3)

    def getValue(self) -> float:
        """Return 1.0 if the robot touched a wall, an obstacle or a robot in the last tick, else 0.0.

        NaN before the first sample.

        Example:
            ``if bumper.getValue() == 1: …``
        """
        return self._rcj_numbers()[0]

    def getValues(self) -> list[float]:
        """Return three zeros: only sensors of another type measure the direction of a force."""
        return [0.0, 0.0, 0.0]

    def getType(self) -> int:
        """Return ``TouchSensor.BUMPER``."""
        return self.BUMPER

    def getLookupTable(self) -> list[float]:
        """Return an empty table: values are given as they are."""
        return []

    value = ReadOnly(getValue)
    values = ReadOnly(getValues)
    type = ReadOnly(getType)
    lookup_table = ReadOnly(getLookupTable)


class LightSensor(Sensor):
    """How bright the floor is under the sensor."""

    def getValue(self) -> float:
        """Return the brightness, from 0 for black to 1000 for the white of lines; NaN before the first sample.

        Example:
            ``on_line = sensor.getValue() > 700``
        """
        return self._rcj_numbers()[0]

    def getLookupTable(self) -> list[float]:
        """Return brightness, reading and noise of both ends of the range; the noise is hidden and given as 0."""
        most = float(self._rcj_facts["max_value"])
        return [0.0, 0.0, 0.0, 1.0, most, 0.0]

    value = ReadOnly(getValue)
    lookup_table = ReadOnly(getLookupTable)


class Gyro(Sensor):
    """How fast the robot turns."""

    def getValues(self) -> list[float]:
        """Return how fast the robot turns about its x, y and z axes in rad/s; NaN before the first sample.

        Example:
            ``turning = gyro.getValues()[2]``, positive counter-clockwise.
        """
        return list(self._rcj_numbers())

    def getLookupTable(self) -> list[float]:
        """Return an empty table: values are given as they are."""
        return []

    values = ReadOnly(getValues)
    value = ReadOnly(getValues)
    lookup_table = ReadOnly(getLookupTable)


class Accelerometer(Sensor):
    """How fast the robot changes its speed."""

    def getValues(self) -> list[float]:
        """Return the acceleration ahead, to the left and up in m/s²; NaN before the first sample.

        At rest it is [0, 0, 9.81]: gravity cannot be told from an acceleration upwards.

        Example:
            ``bumped = abs(accelerometer.getValues()[0]) > 5``
        """
        return list(self._rcj_numbers())

    def getLookupTable(self) -> list[float]:
        """Return an empty table: values are given as they are."""
        return []

    values = ReadOnly(getValues)
    value = ReadOnly(getValues)
    lookup_table = ReadOnly(getLookupTable)


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


class LED(Device):
    """A light that a program switches, for people who watch."""

    def _rcj_set_up(self, connection: Connection, spec: dict[str, Any]) -> None:
        super()._rcj_set_up(connection, spec)
        self._rcj_value = 0

    def set(self, value: int) -> None:
        """Light the first colour with 1, the second with 2, and so on; 0 switches it off.

        Raises:
            TypeError: no number was given.

        Example:
            ``led.set(1)``
        """
        asked = int(number(value, f"{self._rcj_name!r}: set takes the number of a colour, such as 1"))
        most = len(self._rcj_facts["colours"])
        if not 0 <= asked <= most:
            complain(f"Warning: {self._rcj_name!r}: there is no colour {asked}; 0 to {most} are possible.")
            return
        self._rcj_value = asked
        self._rcj_connection.command(self._rcj_index, float(asked), math.inf)

    def get(self) -> int:
        """Return the number of the colour that is lit; 0: none."""
        return self._rcj_value

    value = property(get, set)  # noqa: A003 - the method
