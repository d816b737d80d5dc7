"""The drawing as PNG, by an optional package: resvg-py, one wheel without system libraries."""

from __future__ import annotations

from functools import cache
from types import ModuleType

from rcj_challenges.core.codes import MISSING_EXTRA
from rcj_challenges.core.errors import RcjError

ZOOM = 2.0
"""Pixels for each unit of the drawing: sharp on paper and on dense screens."""

FAMILIES = (
    "Segoe UI", "Helvetica Neue", "Helvetica", "Arial", "Liberation Sans", "Noto Sans", "DejaVu Sans", "Ubuntu",
    "Ubuntu Sans", "Cantarell", "Adwaita Sans", "Open Sans", "Roboto", "FreeSans", "Nimbus Sans", "Verdana",
)  # fmt: skip
"""Common fonts, narrow ones first: the renderer does not look up which one ``sans-serif`` is."""

_WORD = '<svg xmlns="http://www.w3.org/2000/svg" width="20" height="20"><text y="18" font-family="{}">M</text></svg>'


def png_from_svg(picture: str) -> bytes:
    """Return a drawing as PNG; where no font is found (`written_with`) it has no words.

    Raises:
        RcjError: the extra is not installed.
    """
    to_bytes, family = _renderer().svg_to_bytes, written_with()
    return bytes(to_bytes(svg_string=picture, zoom=ZOOM, background="#ffffff", sans_serif_family=family))


@cache
def written_with() -> str | None:
    """Return the font of the words in a PNG; None if there is none, and so no words.

    Raises:
        RcjError: the extra is not installed.
    """
    renderer = _renderer()
    nothing = bytes(renderer.svg_to_bytes(svg_string=_WORD.replace("M", "")))
    words = ((family, bytes(renderer.svg_to_bytes(svg_string=_WORD.format(family)))) for family in FAMILIES)
    return next((family for family, word in words if word != nothing), None)


def _renderer() -> ModuleType:
    try:
        import resvg_py  # noqa: PLC0415 - an extra: most people never need it
    except ImportError as error:
        how = 'pip install "rcj-challenges[png]"; SVG needs none: --out field.svg'
        raise RcjError("PNG needs an optional package", how, code=MISSING_EXTRA) from error
    return resvg_py
