"""Small pictures of all kinds, made byte by byte."""

from __future__ import annotations

import struct
import zlib

PNG = b"\x89PNG\r\n\x1a\n"


def chunk(kind: bytes, body: bytes = b"") -> bytes:
    """Return a part of a PNG."""
    return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))


def png(width: int = 8, height: int = 8, *, extra: bytes = b"", pixels: bytes | None = None) -> bytes:
    """Return a grey PNG; ``extra`` chunks come before its pixels."""
    lines = bytes((1 + width) * height) if pixels is None else pixels
    header = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    return PNG + chunk(b"IHDR", header) + extra + chunk(b"IDAT", zlib.compress(lines)) + chunk(b"IEND", b"")


def animated_png() -> bytes:
    return png(extra=chunk(b"acTL", struct.pack(">II", 2, 0)))


def bmp(width: int = 4, height: int = 4) -> bytes:
    line = -(-3 * width // 4) * 4
    pixels = b"\x80" * (line * height)
    header = struct.pack("<LllHHLLllLL", 40, width, height, 1, 24, 0, len(pixels), 2835, 2835, 0, 0)
    return struct.pack("<2sLHHL", b"BM", 54 + len(pixels), 0, 0, 54) + header + pixels


def gif(frame: tuple[int, int] = (1, 1)) -> bytes:
    """Return a GIF of one transparent pixel, whose only frame may claim to be larger."""
    return (
        b"GIF89a\x01\x00\x01\x00\x80\x00\x00\x00\x00\x00\xff\xff\xff!\xf9\x04\x01\x00\x00\x00\x00"
        b",\x00\x00\x00\x00" + struct.pack("<HH", *frame) + b"\x00\x02\x01D\x00;"
    )


def jpeg_head(width: int = 16, height: int = 9) -> bytes:
    """Return a JPEG up to its size; its picture is missing."""
    frame = struct.pack(">HBHHB", 8, 8, height, width, 0)
    return b"\xff\xd8\xff\xe0" + struct.pack(">H", 16) + b"JFIF\0\1\1\0\0\1\0\1\0\0" + b"\xff\xc0" + frame + b"\xff\xd9"


def jpeg(width: int = 16, height: int = 9) -> bytes:
    """Return a whole JPEG; needs pillow."""
    import io

    from PIL import Image

    out = io.BytesIO()
    Image.new("RGB", (width, height), (200, 30, 30)).save(out, "JPEG")
    return out.getvalue()
