"""``controller.radar`` of R2023a."""

from ._absent import Radar

__all__ = ["Radar"]
