"""Sensors that measure one thing: place, heading, distance, wheel angle."""

from __future__ import annotations

import math

from .device import Sensor


class GPS(Sensor):
    """Where the robot is, in m."""

    LOCAL, WGS84 = 0, 1

    def getValues(self) -> list[float]:
        """Return [x, y, z] of the robot's centre in m; NaN before the first sample."""
        return list(self._numbers())

    def getSpeedVector(self) -> list[float]:
        """Return the velocity in m/s between the last two observations; NaN before there were two."""
        now, before = self._numbers(), self._hub.previous[self._place : self._end]
        passed_s = (self._hub.tick - self._hub.previous_tick) * self._hub.tick_ms / 1000
        return [(new - old) / passed_s if passed_s else math.nan for new, old in zip(now, before, strict=True)]

    def getSpeed(self) -> float:
        """Return the speed in m/s between the last two observations; NaN before there were two."""
        return math.hypot(*self.getSpeedVector())

    def getCoordinateSystem(self) -> int:
        """Return ``GPS.LOCAL``: metres on the field."""
        return self.LOCAL

    values = property(getValues)
    value = property(getValues)
    speed = property(getSpeed)
    speed_vector = property(getSpeedVector)
    coordinate_system = property(getCoordinateSystem)


class Compass(Sensor):
    """Where north is, seen from the robot."""

    def getValues(self) -> list[float]:
        """Return the direction of north (the world's +y axis) in the robot's frame; NaN before the first sample."""
        return list(self._numbers())

    values = property(getValues)
    value = property(getValues)


class DistanceSensor(Sensor):
    """How far the nearest thing is in one direction."""

    GENERIC, INFRA_RED, SONAR, LASER = range(4)

    def getValue(self) -> float:
        """Return the reading: 1000 per metre; NaN before the first sample."""
        return self._numbers()[0]

    def getMinValue(self) -> float:
        """Return the smallest reading."""
        return float(self._facts.get("min_value", 0.0))

    def getMaxValue(self) -> float:
        """Return the reading without noise when nothing is near."""
        return float(self._facts.get("max_value", 1000.0))

    def getAperture(self) -> float:
        """Return 0: a single ray."""
        return 0.0

    def getType(self) -> int:
        """Return ``DistanceSensor.SONAR``."""
        return self.SONAR

    value = property(getValue)
    min_value = property(getMinValue)
    max_value = property(getMaxValue)
    aperture = property(getAperture)
    type = property(getType)


class PositionSensor(Sensor):
    """How far a wheel has turned."""

    ROTATIONAL, LINEAR = 0, 1

    def getValue(self) -> float:
        """Return the wheel's angle in rad; NaN before the first sample."""
        return self._numbers()[0]

    def getType(self) -> int:
        """Return ``PositionSensor.ROTATIONAL``."""
        return self.ROTATIONAL

    value = property(getValue)
    type = property(getType)
