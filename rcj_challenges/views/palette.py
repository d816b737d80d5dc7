"""The colours of pictures of a match: one palette for the replay page, snapshots and videos."""

from __future__ import annotations

from typing import Any

from rcj_challenges.core.colours import hex_colour

Rgb = tuple[int, int, int]

PALETTE: dict[str, Any] = {
    "outside": {"light": "#dbe3eb", "dark": "#0e1217"},
    "grass": ["#2e8054", "#29754d"],
    "line": "#d6e6de",
    "wall": "#b8c4d4",
    "gate": "#ff6bb3",
    "spot": "#050f0d",
    "dark": "#1c2129",
    "mark": "#ffffff",
    "failed": "#737580",
}
"""Colours by what they are for. Lines are white on grass, a little of which shines through."""

_TEAM_COLOURS = {"blue": "#3b82f6", "yellow": "#f2c018"}
"""Brighter than CSS's `blue`, darker than its `yellow`: both must stand out from green, in the light and the dark."""


def css_colour(colour: str) -> str:
    """Return the CSS colour in which a colour of a scenario is shown."""
    return _TEAM_COLOURS.get(colour, colour)


def hex_of(colour: str) -> str:
    """Return the same as ``#rrggbb``; grey for a name that CSS does not know."""
    return hex_colour(css_colour(colour)) or "#868e96"


def rgb(colour: str) -> Rgb:
    """Return the same as numbers from 0 to 255."""
    return _numbers(hex_of(colour))


def text_on(colour: Rgb) -> Rgb:
    """Return the dark colour or white, whichever is readable on a colour (luma of ITU-R BT.601)."""
    luma = 0.299 * colour[0] + 0.587 * colour[1] + 0.114 * colour[2]
    return _numbers(PALETTE["dark"] if luma > 140 else PALETTE["mark"])


def _numbers(digits: str) -> Rgb:
    red, green, blue = bytes.fromhex(digits.removeprefix("#"))
    return red, green, blue
