"""``controller.motion`` of R2023a."""

from ._absent import Motion

__all__ = ["Motion"]
