"""The feed: everything that is sent to spectators, as one growing sequence of bytes.

A spectator reads from any place of it, at its own speed; written bytes never change. Messages are framed as ``kind``
(uint8), ``length`` (uint32), then so many bytes, little-endian; a message is appended whole.

| kind | content |
|---|---|
| 0 | empty, keeps the connection alive; sent in between, not part of the sequence |
| 1 | one JSON object; its key ``say`` names it: ``half``, ``sensors``, ``news``, ``printed``, ``pace``, ``over`` |
| 2 | poses: half (uint16), tick of the first row (uint32), then rows of int16 ``[channel][entity]`` |
| 3 | readings of a robot: half (uint16), its place in ``sensors`` (uint16), rows (uint32), int32 ``[row][column]`` |
"""

from __future__ import annotations

import json
import struct
import threading
from typing import Any

KEEP_ALIVE = struct.pack("<BI", 0, 0)

_JSON, _POSES, _READINGS = 1, 2, 3
_MAX_AT_ONCE = 1 << 16


def json_message(message: dict[str, Any]) -> bytes:
    """Return a JSON message, framed."""
    body = json.dumps(message, ensure_ascii=True, allow_nan=False, separators=(",", ":")).encode("ascii")
    return struct.pack("<BI", _JSON, len(body)) + body


def news_message(half: int, news: dict[str, Any]) -> bytes:
    """Return what happened in some ticks of a half, framed; nothing if nothing did.

    ``news`` are lists of which those of the half go on: its changes (`timeline.CHANGES`), faults, events, and jumps,
    ticks by entity.
    """
    happened = {name: rows for name, rows in news.items() if rows}
    return json_message({"say": "news", "half": half, **happened}) if happened else b""


def pose_message(half: int, first_tick: int, rows: bytes) -> bytes:
    """Return poses of ticks that follow each other, framed; ``rows`` is int16 ``[tick][channel][entity]``."""
    return struct.pack("<BIHI", _POSES, 6 + len(rows), half, first_tick) + rows


def reading_message(half: int, robot: int, count: int, rows: bytes) -> bytes:
    """Return readings and commands of a robot's program, framed; ``rows`` is int32 ``[row][column]``."""
    return struct.pack("<BIHHI", _READINGS, 8 + len(rows), half, robot, count) + rows


class Feed:
    """A sequence of bytes that only grows: one thread writes, any number of threads read."""

    def __init__(self) -> None:
        self._data = bytearray()
        self._news = threading.Condition()
        self._closed = False

    @property
    def size_bytes(self) -> int:
        """The length so far."""
        return len(self._data)

    def append(self, chunk: bytes) -> None:
        """Add whole messages and wake all readers that wait."""
        if chunk:
            with self._news:
                self._data += chunk
                self._news.notify_all()

    def close(self) -> None:
        """End the feed and wake all readers that wait."""
        with self._news:
            self._closed = True
            self._news.notify_all()

    def read(self, start: int, wait_s: float) -> bytes | None:
        """Return the bytes from a place on, at most 64 KB, after waiting for them if there are none yet.

        They are empty if none came within ``wait_s``, None at the end of the feed.
        """
        with self._news:
            if start >= self.size_bytes and not self._closed:
                self._news.wait(wait_s)
            data = bytes(self._data[start : start + _MAX_AT_ONCE])
            return None if self._closed and not data else data
