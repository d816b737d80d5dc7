"""Draws text with Pillow, in fonts of this computer that have its characters."""

from __future__ import annotations

from functools import cache

from PIL import Image, ImageDraw, ImageFont

from rcj_challenges.core.sanitize import sanitize

_FAMILIES = (
    ("NotoSans-Regular.ttf", "NotoSans-Bold.ttf"),
    ("DejaVuSans.ttf", "DejaVuSans-Bold.ttf"),
    ("segoeui.ttf", "segoeuib.ttf"),
    ("arial.ttf", "arialbd.ttf"),
    # Scripts that those above may lack.
    ("NotoSansCJK-Regular.ttc", "NotoSansCJK-Bold.ttc"),
    ("wqy-microhei.ttc", "wqy-microhei.ttc"),
    ("msyh.ttc", "msyhbd.ttc"),
    ("malgun.ttf", "malgunbd.ttf"),
    ("PingFang.ttc", "PingFang.ttc"),
    ("NotoSansArabic-Regular.ttf", "NotoSansArabic-Bold.ttf"),
    ("NotoSansDevanagari-Regular.ttf", "NotoSansDevanagari-Bold.ttf"),
    ("Arial Unicode.ttf", "Arial Unicode.ttf"),
)
"""File names, regular and bold, in order of preference. Pillow looks for them in the folders of the system."""
_ABSENT = "\U0010ffff"
"""No font has this character: it is drawn as the box that stands for missing ones."""

Font = ImageFont.FreeTypeFont | ImageFont.ImageFont


def text_mask(text: str, size_px: int, *, bold: bool = False, max_width_px: float = float("inf")) -> Image.Image:
    """Return one line of text as a mask (``L``), as tall as every line of this size, cut to a width with ``…``."""
    line = sanitize(text, 300)
    font = _font_for(line, size_px, bold)
    if font.getlength(line) > max_width_px:
        while line and font.getlength(line + "…") > max_width_px:
            line = line[:-1]
        line = f"{line.rstrip()}…" if line else ""
    mask = Image.new("L", (max(1, round(font.getlength(line))), line_height_px(size_px)))
    ImageDraw.Draw(mask).text((0, round(size_px * 1.1)), line, fill=255, font=font, anchor="ls")
    return mask


def text_width_px(text: str, size_px: int, *, bold: bool = False) -> float:
    """Return the width of one line of text."""
    line = sanitize(text, 300)
    return float(_font_for(line, size_px, bold).getlength(line))


def line_height_px(size_px: int) -> int:
    """Return the height of a line of text, with what is below the baseline."""
    return round(size_px * 1.4)


def _font_for(text: str, size_px: int, bold: bool) -> Font:
    fonts = _fonts(size_px, bold)
    characters = frozenset(text) - {" "}
    return max(fonts, key=lambda font: sum(_has(font, character) for character in characters))


@cache
def _fonts(size_px: int, bold: bool) -> list[Font]:
    found: list[Font] = []
    for family in _FAMILIES:
        try:
            found.append(ImageFont.truetype(family[bold], size_px))
        except OSError:
            continue
    return found or [ImageFont.load_default(size_px)]


@cache
def _has(font: Font, character: str) -> bool:
    """Return whether a font has a character: it is not drawn as the box for missing ones."""
    return bytes(font.getmask(character)) != bytes(font.getmask(_ABSENT))
