"""``controller.emitter`` of R2023a."""

from .radio import Emitter

__all__ = ["Emitter"]
