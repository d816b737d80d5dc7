"""Keyboard, mouse and joystick, which are never used in a match.

Programs that use them for manual tests run without input. Few do, so this file is read only on use.
"""

from __future__ import annotations

import math

from ._connection import number
from .device import ReadOnly


class _Input:
    """What all of them have in common."""

    def __init__(self) -> None:
        self._period_ms = 0

    def enable(self, samplingPeriod: float | None = None, *, sampling_period: float | None = None) -> None:
        """Remember a period in ms."""
        given = samplingPeriod if sampling_period is None else sampling_period
        period_ms = number(given, f"{type(self).__name__}: enable takes a number of ms, such as 32")
        self._period_ms = int(period_ms) if period_ms > 0 else 0

    def disable(self) -> None:
        """Forget the period."""
        self._period_ms = 0

    def getSamplingPeriod(self) -> int:
        """Return the period in ms that was asked for; 0 if it is disabled."""
        return self._period_ms

    sampling_period = property(getSamplingPeriod, enable)


class Keyboard(_Input):
    """A keyboard on which no key is pressed."""

    END, HOME, LEFT, UP, RIGHT, DOWN = range(312, 318)
    PAGEUP, PAGEDOWN = 366, 367
    NUMPAD_HOME, NUMPAD_LEFT, NUMPAD_UP, NUMPAD_RIGHT, NUMPAD_DOWN = range(375, 380)
    NUMPAD_END = 382
    KEY, SHIFT, CONTROL, ALT = 0xFFFF, 0x10000, 0x20000, 0x40000

    def getKey(self) -> int:
        """Return -1: no key is pressed."""
        return -1

    key = ReadOnly(getKey)


class MouseState:
    """A mouse that is not over the field: no button is pressed, and all positions are NaN."""

    left = middle = right = False
    u = v = x = y = z = math.nan


class Mouse(_Input):
    """A mouse that never moves."""

    def __init__(self) -> None:
        super().__init__()
        self._has_place = False

    def enable3dPosition(self) -> None:
        """Accepted without effect."""
        self._has_place = True

    def disable3dPosition(self) -> None:
        """Accepted without effect."""
        self._has_place = False

    def is3dPositionEnabled(self) -> bool:
        """Return what was set."""
        return self._has_place

    def getState(self) -> MouseState:
        """Return that nothing is pressed."""
        return MouseState()

    state = ReadOnly(getState)


class Joystick(_Input):
    """A joystick that is not plugged in."""

    def isConnected(self) -> bool:
        """Return False."""
        return False

    def getModel(self) -> str:
        """Return no name."""
        return ""

    def getNumberOfAxes(self) -> int:
        """Return 0."""
        return 0

    def getAxisValue(self, axis: int) -> int:
        """Return 0: in the middle."""
        return 0

    def getNumberOfPovs(self) -> int:
        """Return 0."""
        return 0

    def getPovValue(self, pov: int) -> int:
        """Return 0: not pressed."""
        return 0

    def getPressedButton(self) -> int:
        """Return -1: no button is pressed."""
        return -1

    connected = ReadOnly(isConnected)
    model = ReadOnly(getModel)
    number_of_axes = ReadOnly(getNumberOfAxes)
    number_of_povs = ReadOnly(getNumberOfPovs)
    pressed_button = ReadOnly(getPressedButton)
