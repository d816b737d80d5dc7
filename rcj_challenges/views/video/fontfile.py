"""Which characters a font file has: its table ``cmap``, read by hand.

Pillow draws a hollow box for a character that a font lacks and does not tell. Source: the OpenType specification,
tables "cmap" (formats 4 and 12) and the font and collection headers.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator
from typing import BinaryIO

_MOST_TABLES = 200
_MOST_CHARACTERS = 400_000


def characters_of(file: BinaryIO) -> frozenset[int]:
    """Return the code points that a font (of a collection: the first one) has an outline for.

    Anything that cannot be read as a font with outlines has none; bitmap fonts come in one size only.
    """
    try:
        return frozenset(_characters(file))
    except (OSError, struct.error, IndexError, ValueError, OverflowError):
        return frozenset()


def _characters(file: BinaryIO) -> Iterator[int]:
    begin = 0
    if file.read(4) == b"ttcf":
        file.seek(12)
        (begin,) = struct.unpack(">I", file.read(4))
    file.seek(begin + 4)
    (count,) = struct.unpack(">H", file.read(2))
    file.seek(begin + 12)
    tables: dict[bytes, tuple[int, int]] = {}
    for _ in range(min(count, _MOST_TABLES)):
        tag, _, offset, length = struct.unpack(">4sIII", file.read(16))
        tables[tag] = (offset, length)
    if not tables.keys() & {b"glyf", b"CFF ", b"CFF2"}:
        return
    offset, length = tables.get(b"cmap", (0, 0))
    file.seek(offset)
    yield from _mapped(file.read(length))


def _mapped(table: bytes) -> Iterator[int]:
    """Yield the code points of the best sub-table for Unicode: all planes before the first one alone."""
    (count,) = struct.unpack_from(">H", table, 2)
    found: dict[int, int] = {}
    for record in range(count):
        platform, encoding, offset = struct.unpack_from(">HHI", table, 4 + 8 * record)
        (kind,) = struct.unpack_from(">H", table, offset)
        if platform == 0 or (platform == 3 and encoding in (1, 10)):
            found.setdefault(kind, offset)
    if 12 in found:
        yield from _format_12(table, found[12])
    elif 4 in found:
        yield from _format_4(table, found[4])


def _format_12(table: bytes, offset: int) -> Iterator[int]:
    (groups,) = struct.unpack_from(">I", table, offset + 12)
    total = 0
    for group in range(groups):
        first, last, _ = struct.unpack_from(">III", table, offset + 16 + 12 * group)
        total += last - first + 1
        if total > _MOST_CHARACTERS or last < first:
            raise ValueError("no font has so many characters")
        yield from range(first, last + 1)


def _format_4(table: bytes, offset: int) -> Iterator[int]:
    (double,) = struct.unpack_from(">H", table, offset + 6)
    segments = double // 2
    shape = f">{segments}H"
    lasts = struct.unpack_from(shape, table, offset + 14)
    firsts = struct.unpack_from(shape, table, offset + 16 + double)
    deltas = struct.unpack_from(shape, table, offset + 16 + 2 * double)
    ranges_at = offset + 16 + 3 * double
    ranges = struct.unpack_from(shape, table, ranges_at)
    for k, (first, last, delta, where) in enumerate(zip(firsts, lasts, deltas, ranges, strict=True)):
        for code in range(first, min(last, 0xFFFE) + 1):
            glyph = code
            if where:
                (glyph,) = struct.unpack_from(">H", table, ranges_at + 2 * k + where + 2 * (code - first))
                if not glyph:
                    continue
            if (glyph + delta) % 0x10000:
                yield code
