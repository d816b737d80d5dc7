"""``controller.radar_target`` of R2023a."""

from ._absent import RadarTarget

__all__ = ["RadarTarget"]
