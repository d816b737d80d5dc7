"""Colours of pictures, as in the replay page's light theme."""

from __future__ import annotations

from PIL import ImageColor

Rgb = tuple[int, int, int]

OUTSIDE: Rgb = (220, 227, 234)
GRASS: tuple[Rgb, Rgb] = ((46, 128, 86), (41, 119, 79))
LINE: Rgb = (232, 240, 236)
GATE: Rgb = (255, 107, 178)
WALL: Rgb = (148, 163, 184)
DARK: Rgb = (22, 28, 36)
WHITE: Rgb = (255, 255, 255)
BAR: Rgb = (17, 24, 39)
MUTED: Rgb = (156, 168, 186)
FAULT: Rgb = (220, 38, 38)
_GREY: Rgb = (134, 142, 150)


def rgb(colour: str) -> Rgb:
    """Return a CSS colour as numbers; grey for a name that Pillow does not know."""
    try:
        found = ImageColor.getrgb(colour)
    except ValueError:
        return _GREY
    return (found[0], found[1], found[2])


def text_on(colour: Rgb) -> Rgb:
    """Return black or white, whichever is readable on a colour (luma of ITU-R BT.601)."""
    return DARK if 0.299 * colour[0] + 0.587 * colour[1] + 0.114 * colour[2] > 140 else WHITE
