"""``controller.light_sensor`` of R2023a."""

from ._absent import LightSensor

__all__ = ["LightSensor"]
