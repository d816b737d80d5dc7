"""Append-only files of chunks: trajectories and sensor recordings.

A file begins with a line of JSON. Each chunk that follows is ``CHNK``, the length of the rest (little-endian uint32),
and a zlib stream of a line of JSON and any bytes. Nothing that is written is changed later: what a kill cuts off is cut
off at a whole chunk, and the checksum of zlib finds damage.
"""

from __future__ import annotations

import struct
import zlib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.folder import RECORD_VERSION, check_version, read_file, write_all
from rcj_challenges.records.lines import json_line, parsed

MAX_FILE_BYTES = 512_000_000
"""Of a file that is read, packed and unpacked: seventy times a half of ten minutes."""

DAMAGE = (ArithmeticError, AttributeError, LookupError, TypeError, ValueError, MemoryError)
"""Exceptions of json, numpy and arithmetic on what an invalid file holds."""

_MAGIC = b"CHNK"
_HEAD = struct.Struct("<4sI")


class ChunkWriter:
    """Writes a file of chunks; ``size_bytes`` is that of all that was appended."""

    def __init__(self, path: Path, header: Mapping[str, Any], level: int) -> None:
        """Create the file; the header is JSON-able, level 0 of zlib's compression packs nothing.

        Raises:
            OSError: it exists, or cannot be written.
        """
        self._level = level
        self._pending = bytearray(json_line({"record": RECORD_VERSION, **header}))
        self.size_bytes = len(self._pending)
        self._file = path.open("xb", buffering=0)
        write_all(self._file, self._pending)

    def append(self, chunk: bytes) -> None:
        """Append a chunk that was made by `pack`."""
        self.size_bytes += len(chunk)
        self._pending += chunk
        write_all(self._file, self._pending)

    def pack(self, head: Mapping[str, Any], body: bytes = b"") -> bytes:
        """Return a chunk of a JSON-able head and any bytes."""
        packed = zlib.compress(json_line(head) + body, self._level)
        return _HEAD.pack(_MAGIC, len(packed)) + packed

    def close(self) -> None:
        """Write what is left, and close the file. Can be called again."""
        if not self._file.closed:
            write_all(self._file, self._pending)
            self._file.close()


@dataclass(frozen=True)
class Chunks:
    """The readable part of a file of chunks, each with its head and bytes.

    A kill cuts the last chunk off; it is damaged if something else is wrong behind the last of them.
    """

    header: dict[str, Any]
    chunks: tuple[tuple[dict[str, Any], bytes], ...]
    is_cut_off: bool = False
    is_damaged: bool = False


def read_chunks(path: Path) -> Chunks:
    """Read a file of chunks, as far as possible.

    Raises:
        RecordError: it cannot be read, is too large, of another version, or not a file of chunks.
    """
    data = read_file(path, MAX_FILE_BYTES)
    end = data.find(b"\n") + 1
    try:
        header = parsed(data[:end])
        version = header["record"]
        if type(version) is not int:
            raise TypeError("no version")
    except (KeyError, TypeError, ValueError) as error:
        what = f"{path.parent.name}: {path.name} is not a file of this package, or damaged"
        raise RecordError.damaged(what) from error
    check_version(version, path.parent.name)
    chunks: list[tuple[dict[str, Any], bytes]] = []
    left_bytes = MAX_FILE_BYTES
    while end < len(data):
        magic, size = _HEAD.unpack_from(data, end) if len(data) - end >= _HEAD.size else (_MAGIC, len(data))
        begin, end = end + _HEAD.size, end + _HEAD.size + size
        is_cut_off = magic == _MAGIC and end > len(data)
        is_whole = magic == _MAGIC and not is_cut_off
        chunk = _unpacked(memoryview(data)[begin:end], left_bytes) if is_whole else None
        if chunk is None:
            return Chunks(header, tuple(chunks), is_cut_off, is_damaged=not is_cut_off)
        chunks.append(chunk)
        left_bytes = max(1, left_bytes - len(chunk[1]))  # 0 would be no limit
    return Chunks(header, tuple(chunks))


def _unpacked(data: memoryview, max_bytes: int) -> tuple[dict[str, Any], bytes] | None:
    """Return head and bytes of a chunk; None if it is damaged, or larger than it may be."""
    unpacker = zlib.decompressobj()
    try:
        text = unpacker.decompress(data, max_bytes)
        line = text.find(b"\n") + 1
        head = parsed(text[:line])
    except (ValueError, zlib.error):
        return None
    return (head, text[line:]) if unpacker.eof and isinstance(head, dict) else None
