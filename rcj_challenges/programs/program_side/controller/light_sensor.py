"""The light sensor, which looks at the floor."""

from __future__ import annotations

from .device import ReadOnly, Sensor

__all__ = ["LightSensor"]


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
