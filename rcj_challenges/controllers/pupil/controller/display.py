"""``controller.display`` of R2023a."""

from ._absent import Display, ImageRef

__all__ = ["Display", "ImageRef"]
