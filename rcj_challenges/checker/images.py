"""Logos: which kind of picture a file is, and converting it to the PNG that is asked for.

Only `as_png` decodes a picture: it needs Pillow (the extra ``[images]``), which may open a few kinds and no more than
`MAX_PIXELS`.
"""

from __future__ import annotations

import io
import warnings
from dataclasses import dataclass

from rcj_challenges.core.codes import UNUSABLE_PICTURE
from rcj_challenges.core.errors import RcjError
from rcj_challenges.records.logos import MAX_LOGO_BYTES, MAX_LOGO_SIDE, PNG_SIGNATURE

MAX_PIXELS = 12_000_000
"""Decoded at most: 48 MB with four bytes each. The largest logo seen had 6.25 million."""

_KINDS = {PNG_SIGNATURE: "PNG", b"\xff\xd8\xff": "JPEG", b"GIF8": "GIF", b"BM": "BMP", b"RIFF": "WebP"}
_ANIMATION_WITHIN_BYTES = 4096  # the mark stands before the first picture
_SIDES = (MAX_LOGO_SIDE, 512, 256, 128)  # 128 pixels a side are 65 kB, however badly they compress


class PictureError(RcjError):
    """A picture cannot be converted; the message says why."""

    CODE = UNUSABLE_PICTURE


@dataclass(frozen=True)
class Picture:
    """The facts in the first bytes of a picture.

    Attributes:
        kind: ``PNG``, ``JPEG``, ``GIF``, ``BMP`` or ``WebP``.
        width: of a PNG in pixels; else 0.
        height: of a PNG in pixels; else 0.
        animated: whether it is a PNG that moves.
    """

    kind: str
    width: int = 0
    height: int = 0
    animated: bool = False


def identify(data: bytes) -> Picture | None:
    """The kind of picture; None if it is not a known one."""
    kind = next((kind for signature, kind in _KINDS.items() if data.startswith(signature)), None)
    if kind is None or (kind == "WebP" and data[8:12] != b"WEBP") or len(data) < 24:
        return None
    if kind != "PNG":
        return Picture(kind)
    width, height = int.from_bytes(data[16:20], "big"), int.from_bytes(data[20:24], "big")
    return Picture(kind, width, height, b"acTL" in data[:_ANIMATION_WITHIN_BYTES])


def as_png(data: bytes) -> bytes:
    """Return a picture as a PNG that a logo may be: not animated, not larger than allowed.

    Raises:
        PictureError: Pillow is not installed, or the picture is damaged, unknown or too large to be decoded.
    """
    if identify(data) is None:
        raise PictureError("it is not a known kind of picture")
    try:
        from PIL import Image  # noqa: PLC0415 - an extra
    except ImportError:
        raise PictureError('converting it needs the extra [images]: pip install "rcj-challenges[images]"') from None
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            warnings.simplefilter("error", Image.DecompressionBombWarning)
            with Image.open(io.BytesIO(data), formats=("PNG", "JPEG", "GIF", "BMP", "WEBP")) as opened:
                if opened.width * opened.height > MAX_PIXELS:
                    raise Image.DecompressionBombError
                picture = opened.convert("RGBA")
        for side in _SIDES:
            picture.thumbnail((side, side))
            out = io.BytesIO()
            picture.save(out, "PNG")
            if out.tell() <= MAX_LOGO_BYTES:
                break
        return out.getvalue()
    except (Image.DecompressionBombError, Image.DecompressionBombWarning):
        raise PictureError("it is too large to be converted") from None
    except Exception as error:  # decoders of damaged pictures raise anything
        raise PictureError("it is damaged") from error
