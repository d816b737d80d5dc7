"""Sensors that measure one thing: place, heading, distance, wheel angle."""

from __future__ import annotations

import math

from .device import ReadOnly, Sensor

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


class GPS(Sensor):
    """Where the robot is, in m."""

    LOCAL, WGS84 = 0, 1

    def _rcj_sample(self, ticks: int) -> None:
        super()._rcj_sample(ticks)
        if ticks > 1:
            self._rcj_connection.follow(self._rcj_index)

    def getValues(self) -> list[float]:
        """Return [x, y, z] of the robot's centre in m, in the frame of the field; NaN before the first sample.

        x runs along the short side, y towards the blue goal, z up; the origin is the centre of the field.

        Example:
            ``x, y, _ = gps.getValues()``
        """
        return list(self._rcj_numbers())

    def getSpeedVector(self) -> list[float]:
        """Return the velocity in m/s between the last two samples; NaN before there were two."""
        now, (ticks, numbers) = self._rcj_numbers(), self._rcj_connection.before_sample(self._rcj_index)
        before = numbers[self._rcj_place : self._rcj_end]
        passed_s = ticks * self._rcj_connection.tick_ms / 1000
        return [(new - old) / passed_s if passed_s else math.nan for new, old in zip(now, before, strict=True)]

    def getSpeed(self) -> float:
        """Return the speed in m/s between the last two samples; NaN before there were two."""
        return math.hypot(*self.getSpeedVector())

    def getCoordinateSystem(self) -> int:
        """Return ``GPS.LOCAL``: metres on the field."""
        return self.LOCAL

    @staticmethod
    def convertToDegreesMinutesSeconds(decimalDegree: float) -> str:
        """Return an angle in degrees as text: 12.5 is ``12° 30' 0"``. Here the GPS measures metres."""
        degrees = int(decimalDegree)
        seconds = int(abs(decimalDegree - degrees) * 3600 + 1e-6)
        return f"{degrees}° {seconds // 60}' {seconds % 60}\""

    values = ReadOnly(getValues)
    value = ReadOnly(getValues)
    speed = ReadOnly(getSpeed)
    speed_vector = ReadOnly(getSpeedVector)
    coordinate_system = ReadOnly(getCoordinateSystem)


class Compass(Sensor):
    """Where north is, seen from the robot."""

    def getValues(self) -> list[float]:
        """Return the direction of north (the field's +y axis) in the robot's frame; NaN before the first sample.

        For a heading of ψ rad, counter-clockwise from +x, it is [sin ψ, cos ψ, 0].

        Example:
            ``heading_rad = math.atan2(compass.getValues()[0], compass.getValues()[1])``
        """
        return list(self._rcj_numbers())

    def getLookupTable(self) -> list[float]:
        """Return an empty table: the direction is given as it is."""
        return []

    values = ReadOnly(getValues)
    value = ReadOnly(getValues)
    lookup_table = ReadOnly(getLookupTable)


class DistanceSensor(Sensor):
    """How far the nearest thing is in one direction."""

    GENERIC, INFRA_RED, SONAR, LASER = range(4)

    def getValue(self) -> float:
        """Return the reading: 1000 per m, at most about 1000; NaN before the first sample.

        Example:
            ``front.getValue() < 100`` means: something is nearer than 10 cm.
        """
        if not self._rcj_period_ms and not self._rcj_warned:
            self._rcj_warn()
        reading: float = self._rcj_connection.numbers[self._rcj_place]  # no slice: all four are read every tick
        return reading

    def getMinValue(self) -> float:
        """Return the smallest reading."""
        return float(self._rcj_facts.get("min_value", 0.0))

    def getMaxValue(self) -> float:
        """Return the reading without noise when nothing is near."""
        return float(self._rcj_facts.get("max_value", 1000.0))

    def getAperture(self) -> float:
        """Return 0: a single ray."""
        return 0.0

    def getLookupTable(self) -> list[float]:
        """Return distance in m, reading and noise of both ends of the range; the noise is hidden and given as 0."""
        return [0.0, self.getMinValue(), 0.0, self.getMaxValue() / 1000, self.getMaxValue(), 0.0]

    def getType(self) -> int:
        """Return ``DistanceSensor.SONAR``; of a light barrier ``DistanceSensor.INFRA_RED``."""
        return self.INFRA_RED if self._rcj_facts.get("type") == "infra-red" else self.SONAR

    value = ReadOnly(getValue)
    min_value = ReadOnly(getMinValue)
    max_value = ReadOnly(getMaxValue)
    aperture = ReadOnly(getAperture)
    lookup_table = ReadOnly(getLookupTable)
    type = ReadOnly(getType)


class PositionSensor(Sensor):
    """How far a wheel has turned."""

    ROTATIONAL, LINEAR = 0, 1

    def getValue(self) -> float:
        """Return the wheel's angle in rad since the start; NaN before the first sample.

        Example:
            ``distance_m = sensor.getValue() * 0.02``, the wheel's radius.
        """
        return self._rcj_numbers()[0]

    def getType(self) -> int:
        """Return ``PositionSensor.ROTATIONAL``."""
        return self.ROTATIONAL

    def getMotor(self) -> Any:
        """Return the motor of the same wheel, by its name; None if the robot has none."""
        return self._rcj_sibling("motor", self._rcj_name.replace("sensor", "motor"))

    def getBrake(self) -> None:
        """Return None: there are no brakes."""

    motor = ReadOnly(getMotor)
    brake = ReadOnly(getBrake)

    value = ReadOnly(getValue)
    type = ReadOnly(getType)
