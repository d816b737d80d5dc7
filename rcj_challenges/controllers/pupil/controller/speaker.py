"""``controller.speaker`` of R2023a."""

from ._absent import Speaker

__all__ = ["Speaker"]
