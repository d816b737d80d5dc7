"""``controller.accelerometer`` of R2023a."""

from ._absent import Accelerometer

__all__ = ["Accelerometer"]
