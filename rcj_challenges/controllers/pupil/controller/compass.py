"""``controller.compass`` of R2023a."""

from .sensors import Compass

__all__ = ["Compass"]
