"""``controller.receiver`` of R2023a."""

from .radio import Receiver

__all__ = ["Receiver"]
