"""``controller.led`` of R2023a."""

from ._absent import LED

__all__ = ["LED"]
