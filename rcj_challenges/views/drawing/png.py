"""The drawing as PNG, by an optional package: resvg-py, one wheel without system libraries."""

from __future__ import annotations

from rcj_challenges.facts.errors import RcjError

ZOOM = 2.0
"""Pixels for each unit of the drawing: sharp on paper and on dense screens."""


class PngMissingError(RcjError):
    """The package that renders PNG is not installed."""


def png_from_svg(picture: str) -> bytes:
    """Return a drawing as PNG, twice as many pixels each way as its SVG has units.

    Raises:
        PngMissingError: the extra is not installed.
    """
    try:
        import resvg_py  # noqa: PLC0415 - an extra: most people never need it
    except ImportError as error:
        message = 'PNG needs an optional package: pip install "rcj-challenges[png]". SVG needs none: --out field.svg'
        raise PngMissingError(message) from error
    return bytes(resvg_py.svg_to_bytes(svg_string=picture, zoom=ZOOM, background="#ffffff"))
