"""``controller.touch_sensor`` of R2023a."""

from ._absent import TouchSensor

__all__ = ["TouchSensor"]
