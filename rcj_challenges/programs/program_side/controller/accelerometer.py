"""The accelerometer."""

from __future__ import annotations

from .device import ReadOnly, Sensor

__all__ = ["Accelerometer"]


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
