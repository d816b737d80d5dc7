"""``controller.skin`` of R2023a."""

from ._absent import Skin

__all__ = ["Skin"]
