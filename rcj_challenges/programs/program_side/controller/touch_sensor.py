"""The bumper."""

from __future__ import annotations

from .device import ReadOnly, Sensor

__all__ = ["TouchSensor"]


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
