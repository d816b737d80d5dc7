"""``controller.joystick`` of R2023a."""

from .keyboard import Joystick

__all__ = ["Joystick"]
