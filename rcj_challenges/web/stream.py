"""Sends the feed of a match on the stage, by the clock of the server: no byte before its time, to all the same."""

from __future__ import annotations

import asyncio
import json
import re
import time
from collections.abc import Awaitable, Callable, Mapping
from functools import lru_cache
from pathlib import Path
from typing import Any, NamedTuple

FEED = re.compile(r"/live/(\d{1,18})/feed")
_START = re.compile(rb"(?:.*&)?from=(\d{1,12})")
RELEASE, DATA = "release.json", "feed"
"""Files of a show: when it begins, in s, and how much may be sent at the end of each step; and what is sent."""

_SPECTATORS = 500
_AT_ONCE_BYTES = 65536
_KEEP_ALIVE = bytes(5)
"""An empty message of the feed; the code of live matches (`views.live.feed`) is not loaded to serve pages."""
_KEEP_ALIVE_S = 5.0
_STALLED_S = 20.0
_HEADERS = [
    (b"content-type", b"application/octet-stream"),
    (b"cache-control", b"no-store"),
    (b"access-control-allow-origin", b"*"),  # the page that reads it has an origin of its own
    (b"content-security-policy", b"default-src 'none'; frame-ancestors 'none'"),
    (b"x-content-type-options", b"nosniff"),
]


class Release(NamedTuple):
    """A feed and its times; they never change.

    Attributes:
        begins_s: when the first step begins, in s since 1970.
        step_s: the length of a step.
        ends: by step, how many bytes may be sent at its end.
        data: the whole feed.
    """

    begins_s: float
    step_s: float
    ends: list[int]
    data: bytes

    def released(self, now_s: float) -> tuple[int, float]:
        """Return how many bytes may be sent at a time, and when the next step ends."""
        steps = min(max(0, int((now_s - self.begins_s) / self.step_s)), len(self.ends))
        return self.ends[steps - 1] if steps else 0, self.begins_s + (steps + 1) * self.step_s


@lru_cache(maxsize=4)
def _read(folder: Path) -> Release:
    return Release(**json.loads((folder / RELEASE).read_text("ascii")), data=(folder / DATA).read_bytes())


class Stream:
    """Answers requests for feeds.

    Args:
        folder: with the shows, by number.
        clock: returns the time, in s since 1970.
    """

    def __init__(self, folder: Path, clock: Callable[[], float] = time.time) -> None:
        self._folder = folder
        self._clock = clock
        self._spectators = 0

    async def __call__(self, show: str, query: bytes, receive: Any, send: Any) -> None:
        """Send a feed from a byte on until its end, or until the show is taken off the stage."""
        start, folder = _START.fullmatch(query), self._folder / show
        if start is None:
            await _refuse(send, 400)
        elif not (folder / RELEASE).is_file():
            await _refuse(send, 409)  # to the page: another match is shown now
        elif self._spectators >= _SPECTATORS:
            await _refuse(send, 503)
        else:
            self._spectators += 1
            gone = asyncio.create_task(_disconnected(receive))
            try:
                await self._send(folder, int(start[1]), gone, send)
            finally:
                self._spectators -= 1
                gone.cancel()

    async def _send(self, folder: Path, at: int, gone: asyncio.Task[None], send: Any) -> None:
        release, sent_s = _read(folder), self._clock()
        await send({"type": "http.response.start", "status": 200, "headers": _HEADERS})
        at = min(at, release.released(self._clock())[0])
        while at < len(release.data) and (folder / RELEASE).exists():
            now_s = self._clock()
            end, next_s = release.released(now_s)
            body = release.data[at : min(end, at + _AT_ONCE_BYTES)]
            at += len(body)
            if body or abs(now_s - sent_s) >= _KEEP_ALIVE_S:
                sent_s = now_s
                message = {"type": "http.response.body", "body": body or _KEEP_ALIVE, "more_body": True}
                async with asyncio.timeout(_STALLED_S):
                    await send(message)
            if at >= end and (await asyncio.wait({gone}, timeout=min(next_s - now_s, _KEEP_ALIVE_S)))[0]:
                return
        await send({"type": "http.response.body", "body": b""})


async def _disconnected(receive: Callable[[], Awaitable[Mapping[str, Any]]]) -> None:
    while (await receive())["type"] != "http.disconnect":
        pass


async def _refuse(send: Any, status: int) -> None:
    headers = [*_HEADERS, (b"content-length", b"0")]
    await send({"type": "http.response.start", "status": status, "headers": headers})
    await send({"type": "http.response.body", "body": b""})
