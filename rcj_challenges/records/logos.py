"""Logos of teams: found among their files, kept in the record, and checked before one is shown.

Logos, and whole records, are untrusted. A page therefore contains only the parts of the picture that a viewer needs,
after each of them has been checked.
"""

from __future__ import annotations

import struct
import zlib
from collections.abc import Iterator, Mapping
from pathlib import Path, PurePosixPath

from rcj_challenges.core.codes import UNUSABLE_PICTURE
from rcj_challenges.core.errors import RcjError

MAX_LOGO_BYTES = 1_000_000
"""Size limit in a record, because the logo is on every page of the run."""
MAX_LOGO_SIDE = 1024
"""Pixels. Teams have handed in 2500 (reference, section 7): such a picture unpacks to 25 MB in every browser."""

PNG_SIGNATURE = b"\x89PNG\r\n\x1a\n"
"""The bytes with which every PNG begins."""

_FILE = "logo.png"
_CHUNK_HEAD = struct.Struct(">I4s")
_IHDR = struct.Struct(">IIBBBBB")
_KEPT = (b"IHDR", b"PLTE", b"tRNS", b"IDAT", b"IEND")
_CHANNELS = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}
_DEPTHS = {0: (1, 2, 4, 8, 16), 2: (8, 16), 3: (1, 2, 4, 8), 4: (8, 16), 6: (8, 16)}
_ADAM7 = ((0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4), (1, 0, 2, 2), (0, 1, 1, 2))
_OTHER_KINDS = ((b"\xff\xd8\xff", "a JPEG"), (b"GIF8", "a GIF"), (b"BM", "a BMP"), (b"RIFF", "a WebP"))


class LogoError(RcjError):
    """A logo that cannot be shown; the message says why."""

    CODE = UNUSABLE_PICTURE


def logo_of(files: Mapping[PurePosixPath, bytes]) -> bytes | None:
    """Return a team's ``logo.png`` as it is, the nearest to the top; None without one or if it is too large."""
    found = sorted((path for path in files if path.name.casefold() == _FILE), key=lambda path: len(path.parts))
    return files[found[0]] if found and len(files[found[0]]) <= MAX_LOGO_BYTES else None


def logo_path(folder: Path, team: str) -> Path:
    """Return the path of a team's logo in a record; ``team`` is the seat of its first half."""
    return folder / f"logo-{team}.png"


def checked_png(data: bytes) -> bytes:
    """Return a PNG with the same pixels, made only of what showing it needs.

    Checked are signature, checksums, order and sizes of its parts, and that its pixels unpack to exactly what its
    header says. Animation, text, colour profiles and anything behind its end are left out.

    Raises:
        LogoError: it is no PNG, is damaged, or is too large.
    """
    if not data.startswith(PNG_SIGNATURE):
        kind = next((kind for magic, kind in _OTHER_KINDS if data.startswith(magic)), "no PNG")
        raise LogoError(f"it is {kind}")
    if len(data) > MAX_LOGO_BYTES:
        raise LogoError(f"it has {len(data) / 1e6:.1f} MB, more than {MAX_LOGO_BYTES / 1e6:g}")
    chunks = [(kind, body) for kind, body in _chunks(data) if kind in _KEPT]
    kinds = [kind for kind, _ in chunks]
    order = sorted(kinds, key=_KEPT.index)
    if kinds != order or any(kinds.count(kind) != 1 for kind in (b"IHDR", b"IEND")) or kinds.count(b"PLTE") > 1:
        raise LogoError("it is damaged: its parts are out of order")
    header = chunks[0][1]
    _check_pixels(header, b"".join(body for kind, body in chunks if kind == b"IDAT"), palette=b"PLTE" in kinds)
    return PNG_SIGNATURE + b"".join(_written(kind, body) for kind, body in chunks)


def _chunks(data: bytes) -> Iterator[tuple[bytes, bytes]]:
    at = len(PNG_SIGNATURE)
    while True:
        if at + _CHUNK_HEAD.size + 4 > len(data):
            raise LogoError("it is damaged: it ends too early")
        size, kind = _CHUNK_HEAD.unpack_from(data, at)
        at += _CHUNK_HEAD.size
        body, check = data[at : at + size], data[at + size : at + size + 4]
        if len(check) < 4 or int.from_bytes(check, "big") != zlib.crc32(kind + body):
            raise LogoError("it is damaged: a checksum does not fit")
        yield kind, body
        if kind == b"IEND":
            return
        at += size + 4


def _check_pixels(header: bytes, packed: bytes, *, palette: bool) -> None:
    if len(header) != _IHDR.size:
        raise LogoError("it is damaged: its header has a wrong size")
    width, height, depth, colour, compression, filtering, interlace = _IHDR.unpack(header)
    if depth not in _DEPTHS.get(colour, ()) or compression or filtering or interlace > 1 or (colour == 3) > palette:
        raise LogoError("it is damaged: its header says what no PNG has")
    if not (0 < width <= MAX_LOGO_SIDE and 0 < height <= MAX_LOGO_SIDE):
        raise LogoError(f"it has {width} x {height} pixels, more than {MAX_LOGO_SIDE} on a side")
    expected = _unpacked_bytes(width, height, depth * _CHANNELS[colour], interlaced=bool(interlace))
    unpacker = zlib.decompressobj()
    try:
        pixels = unpacker.decompress(packed, expected + 1)
    except zlib.error as error:
        raise LogoError("it is damaged: its pixels cannot be unpacked") from error
    if len(pixels) != expected or not unpacker.eof:
        raise LogoError("it is damaged: it has other pixels than its header says")


def _unpacked_bytes(width: int, height: int, bits: int, *, interlaced: bool) -> int:
    """Return the size of the pixels: each line has a byte for its filter and is rounded up to whole bytes."""
    passes = _ADAM7 if interlaced else ((0, 0, 1, 1),)
    total = 0
    for x, y, dx, dy in passes:
        columns, lines = -(-(width - x) // dx), -(-(height - y) // dy)
        if columns > 0 and lines > 0:
            total += lines * (1 + (columns * bits + 7) // 8)
    return total


def _written(kind: bytes, body: bytes) -> bytes:
    return _CHUNK_HEAD.pack(len(body), kind) + body + zlib.crc32(kind + body).to_bytes(4, "big")
