"""Logos: what kind of picture a file is, told from its first bytes, and turning it into the one that is asked for.

Nothing here decodes a picture except `as_png`, which needs pillow (the extra ``[images]``), is told the few kinds it
may be, and only gets what is small enough once it is unpacked.
"""

from __future__ import annotations

import io
import struct
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from rcj_challenges.facts.errors import RcjError
from rcj_challenges.records.logos import MOST_LOGO_BYTES, MOST_LOGO_SIDE, PNG_SIGNATURE

if TYPE_CHECKING:
    from PIL import Image

MOST_PIXELS = 12_000_000
"""Pixels that are unpacked at most: 48 MB with four bytes each. The largest logo seen had 6.25 million."""

_JPEG_SIZES = frozenset({*range(0xC0, 0xD0)} - {0xC4, 0xC8, 0xCC})  # markers of frames, which hold the size
_MOST_PARTS = 10_000
_MOTION_WITHIN = 4096  # the marks of animation stand before the first picture
_SMALLER = (1, 2, 4, 8)  # 128 pixels a side are 65 kB, however little they can be packed
_PILLOW_KINDS = ("PNG", "JPEG", "GIF", "BMP", "WEBP")


class PictureError(RcjError):
    """A picture cannot be converted; the message says why."""


@dataclass(frozen=True)
class Picture:
    """What a picture says of itself.

    Attributes:
        kind: ``PNG``, ``JPEG``, ``GIF``, ``BMP`` or ``WebP``.
        width: in pixels; 0 if it does not say.
        height: in pixels; 0 if it does not say.
        animated: whether it moves.
    """

    kind: str
    width: int
    height: int
    animated: bool = False


def look_at(data: bytes) -> Picture | None:
    """Return what kind of picture this is; None if it is none that is known."""
    for magic, kind, size_of, motion in _KINDS:
        if data.startswith(magic) and (kind != "WebP" or data[8:12] == b"WEBP"):
            try:
                width, height = size_of(data)
            except struct.error:
                return None
            return Picture(kind, width, height, bool(motion) and motion in data[:_MOTION_WITHIN])
    return None


def as_png(data: bytes) -> bytes:
    """Return a picture as a PNG that a logo may be: without motion, no larger than allowed.

    Raises:
        PictureError: pillow is not installed, or the picture is damaged, unknown or too large to be unpacked.
    """
    picture = look_at(data)
    if picture is None:
        raise PictureError("it is no picture that is known here")
    if not 0 < picture.width * picture.height <= MOST_PIXELS:
        raise PictureError(f"it is too large to be converted ({picture.width} x {picture.height} pixels)")
    try:
        from PIL import Image  # noqa: PLC0415 - an extra
    except ImportError:
        raise PictureError('converting it needs the extra [images]: pip install "rcj-challenges[images]"') from None
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            warnings.simplefilter("error", Image.DecompressionBombWarning)
            with Image.open(io.BytesIO(data), formats=_PILLOW_KINDS) as opened:
                # The frame of a GIF may be larger than the picture says it is.
                if opened.width * opened.height > MOST_PIXELS:
                    raise PictureError("it is larger than it says")
                first = opened.convert("RGBA")
        return _small_enough(first)
    except PictureError:
        raise
    except Exception as error:  # decoders of damaged pictures raise what they like
        raise PictureError("it is damaged") from error


def _small_enough(picture: Image.Image) -> bytes:
    """Return a picture as a PNG that is neither too wide nor too heavy."""
    for smaller in _SMALLER:
        side = MOST_LOGO_SIDE // smaller
        copy = picture.copy()
        copy.thumbnail((side, side))
        out = io.BytesIO()
        copy.save(out, "PNG")
        if out.tell() <= MOST_LOGO_BYTES:
            break
    return out.getvalue()


def _png_size(data: bytes) -> tuple[int, int]:
    width, height = struct.unpack_from(">LL", data, 16)
    return width, height


def _gif_size(data: bytes) -> tuple[int, int]:
    width, height = struct.unpack_from("<HH", data, 6)
    return width, height


def _jpeg_size(data: bytes) -> tuple[int, int]:
    at = 2
    for _ in range(_MOST_PARTS):
        if at + 9 > len(data) or data[at] != 0xFF:
            return 0, 0
        marker = data[at + 1]
        if marker == 0xFF:
            at += 1
        elif marker in _JPEG_SIZES:
            height, width = struct.unpack_from(">HH", data, at + 5)
            return width, height
        else:
            at += 2 + struct.unpack_from(">H", data, at + 2)[0]
    return 0, 0


def _bmp_size(data: bytes) -> tuple[int, int]:
    if struct.unpack_from("<L", data, 14)[0] == 12:  # the first version of its header
        width, height = struct.unpack_from("<HH", data, 18)
        return width, height
    width, height = struct.unpack_from("<ll", data, 18)
    return abs(width), abs(height)  # upside down if negative


def _webp_size(data: bytes) -> tuple[int, int]:
    kind = data[12:16]
    if kind == b"VP8 ":
        width, height = struct.unpack_from("<HH", data, 26)
        return width & 0x3FFF, height & 0x3FFF
    if kind == b"VP8L":
        bits = struct.unpack_from("<L", data, 21)[0]
        return (bits & 0x3FFF) + 1, (bits >> 14 & 0x3FFF) + 1
    if kind == b"VP8X" and len(data) >= 30:
        return int.from_bytes(data[24:27], "little") + 1, int.from_bytes(data[27:30], "little") + 1
    return 0, 0


_KINDS: tuple[tuple[bytes, str, Callable[[bytes], tuple[int, int]], bytes], ...] = (
    (PNG_SIGNATURE, "PNG", _png_size, b"acTL"),
    (b"\xff\xd8\xff", "JPEG", _jpeg_size, b""),
    (b"GIF87a", "GIF", _gif_size, b""),
    (b"GIF89a", "GIF", _gif_size, b"NETSCAPE2.0"),
    (b"BM", "BMP", _bmp_size, b""),
    (b"RIFF", "WebP", _webp_size, b"ANIM"),
)
"""How each kind begins, where it says its size, and the mark of one that moves."""
