"""``controller.distance_sensor`` of R2023a."""

from .sensors import DistanceSensor

__all__ = ["DistanceSensor"]
