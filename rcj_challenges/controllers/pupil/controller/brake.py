"""``controller.brake`` of R2023a."""

from ._absent import Brake

__all__ = ["Brake"]
