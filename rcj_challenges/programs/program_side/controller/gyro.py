"""The gyro."""

from __future__ import annotations

from .device import ReadOnly, Sensor

__all__ = ["Gyro"]


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
