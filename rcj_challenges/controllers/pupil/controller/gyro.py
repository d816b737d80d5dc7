"""``controller.gyro`` of R2023a."""

from ._absent import Gyro

__all__ = ["Gyro"]
