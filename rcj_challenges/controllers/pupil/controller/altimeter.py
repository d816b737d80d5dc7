"""``controller.altimeter`` of R2023a."""

from ._absent import Altimeter

__all__ = ["Altimeter"]
