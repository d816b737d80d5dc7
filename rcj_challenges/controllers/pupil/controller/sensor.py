"""``controller.sensor`` of R2023a."""

from .device import Sensor

__all__ = ["Sensor"]
