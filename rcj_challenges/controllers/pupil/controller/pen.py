"""``controller.pen`` of R2023a."""

from ._absent import Pen

__all__ = ["Pen"]
