"""``controller.mouse`` of R2023a."""

from .keyboard import Mouse, MouseState

__all__ = ["Mouse", "MouseState"]
