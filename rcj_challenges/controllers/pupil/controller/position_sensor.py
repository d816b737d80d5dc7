"""``controller.position_sensor`` of R2023a."""

from .sensors import PositionSensor

__all__ = ["PositionSensor"]
