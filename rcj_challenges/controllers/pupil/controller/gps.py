"""``controller.gps`` of R2023a."""

from .sensors import GPS

__all__ = ["GPS"]
