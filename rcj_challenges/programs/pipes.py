"""Exchanging frames with a process over two pipes, without ever waiting longer than asked.

Two ways that behave alike: `PolledPipes` is fast and needs ``poll`` (POSIX); `ThreadedPipes` works everywhere.
"""

from __future__ import annotations

import os
import queue
import select
import sys
import threading
import time
from collections.abc import Sequence
from typing import Protocol

from rcj_challenges.programs.protocol import LENGTH

MOMENT_S = 0.0002
"""How long a side is polled before we sleep until it answers: sleeping and waking take longer than most programs
compute (ADR 10)."""

_SKIPPED_POLLS = 16
"""After a side has not answered within `MOMENT_S`, the next so many waits sleep at once; then it is polled again."""

_CHUNK = 1 << 16
_USUAL = 4096

# Yields to others that have work to do. Systems without this call yield on a sleep of 0 s.
_let_others_run = getattr(os, "sched_yield", lambda: time.sleep(0))


class ChannelClosedError(Exception):
    """The other side is gone."""


class FrameTooLongError(Exception):
    """The other side announced a frame beyond the limit. The size in bytes is the argument."""


class Channel(Protocol):
    """One side of a conversation in frames: a length of four bytes, then that many bytes."""

    def send(self, frame: bytes) -> None:
        """Send a frame, its length included. Never waits; a side that is gone shows at the next `receive`."""

    def receive(self, timeout_s: float) -> bytes | None:
        """Return the next frame without its length, or None if it did not come in time.

        Raises:
            ChannelClosedError: there will be none.
            FrameTooLongError: it would be too long.
        """

    def receive_soon(self) -> bytes | None:
        """Return the next frame if it is here, or comes at once, as this side's frames do; else None.

        It waits for `MOMENT_S` at most, and seldom at all for a side that takes longer.
        """

    def close(self) -> None:
        """Give the pipes back."""


class FrameBuffer:
    """Puts frames together from the pieces in which they arrive and are added to `held`, until they are given out."""

    def __init__(self, limit_bytes: int) -> None:
        self._limit_bytes = limit_bytes
        self.held = bytearray()

    def next(self) -> bytes | None:
        """Return the next whole frame without its length, or None.

        Raises:
            FrameTooLongError: its announced length is beyond the limit.
        """
        if len(self.held) < 4:
            return None
        (length,) = LENGTH.unpack_from(self.held)
        if length > self._limit_bytes:
            raise FrameTooLongError(length)
        end = 4 + length
        if len(self.held) < end:
            return None
        body = bytes(self.held[4:end])
        del self.held[:end]
        return body


class PolledPipes:
    """Non-blocking pipes and ``poll``: three system calls for a question and its answer."""

    def __init__(self, read_fd: int, write_fd: int, limit_bytes: int) -> None:
        os.set_blocking(read_fd, False)
        os.set_blocking(write_fd, False)
        self._read_fd = read_fd
        self._write_fd = write_fd
        self._poll = select.poll()
        self._poll.register(read_fd, select.POLLIN)
        self._buffer = FrameBuffer(limit_bytes)
        self._unsent = b""
        self._broken = False
        self._polls_to_skip = 0

    def send(self, frame: bytes) -> None:
        """See `Channel`. What the pipe does not take at once is sent while receiving."""
        if self._unsent:
            # A side that answers before it has read the last frame does not listen: nothing is kept for it.
            self._broken = True
            return
        try:
            sent = os.write(self._write_fd, frame)
        except OSError:
            sent = -1
        if sent != len(frame):  # rarely
            self._unsent = self._left_of(frame[max(0, sent) :])
            if self._unsent:
                self._poll.register(self._write_fd, select.POLLOUT)

    def receive(self, timeout_s: float) -> bytes | None:
        """See `Channel`."""
        body = self.receive_soon() if timeout_s > 0 else self._receive_now()
        return self._wait(timeout_s) if body is None else body

    def _receive_now(self) -> bytes | None:
        """Return the next frame if it is here already."""
        buffer = self._buffer
        if buffer.held:
            body = buffer.next()
            if body is not None:
                return body
        try:
            # Nearly always exactly one frame arrives, whole and small.
            chunk = os.read(self._read_fd, _CHUNK if buffer.held else _USUAL)
        except BlockingIOError:
            return None
        except OSError:
            raise ChannelClosedError from None
        if not chunk:
            raise ChannelClosedError
        if not buffer.held and len(chunk) >= 4 and LENGTH.unpack_from(chunk)[0] == len(chunk) - 4:
            return chunk[4:]
        buffer.held += chunk
        return buffer.next()

    def receive_soon(self) -> bytes | None:
        """See `Channel`."""
        body = self._receive_now()
        if body is not None or self._unsent:
            return body
        if self._polls_to_skip:
            self._polls_to_skip -= 1
            return None
        give_up = time.perf_counter() + MOMENT_S
        while body is None and time.perf_counter() < give_up:
            _let_others_run()
            body = self._receive_now()
        if body is None:
            self._polls_to_skip = _SKIPPED_POLLS
        return body

    def register(self, poll: select.poll) -> None:
        """Register with a ``poll``: it returns when a frame may be here, or when the pipe takes unsent bytes."""
        poll.register(self._read_fd, select.POLLIN)
        if self._unsent:
            poll.register(self._write_fd, select.POLLOUT)

    def _wait(self, timeout_s: float) -> bytes | None:
        began = time.perf_counter()
        deadline = began + timeout_s
        wait_s = max(0.0, timeout_s)  # poll takes a negative one for eternity
        while True:
            # A side that has stopped listening may have sent the reason: that is here already, or never comes.
            ready = self._poll.poll(0 if self._broken else wait_s * 1000)
            for fd, _ in ready:
                if fd == self._read_fd:
                    body = self._receive_now()
                    if body is not None:
                        if time.perf_counter() - began < MOMENT_S:
                            self._polls_to_skip = 0
                        return body
                else:
                    self._unsent = self._left_of(self._unsent)
                    if not self._unsent:
                        self._poll.unregister(self._write_fd)
            if self._broken and not ready:
                raise ChannelClosedError
            wait_s = deadline - time.perf_counter()
            if wait_s <= 0:
                return None

    def close(self) -> None:
        """See `Channel`."""
        for fd in (self._read_fd, self._write_fd):
            os.close(fd)

    def _left_of(self, data: bytes) -> bytes:
        """Write what the pipe takes at once, and return the rest; return nothing if the other side is gone."""
        try:
            sent = os.write(self._write_fd, data)
        except BlockingIOError:
            return data
        except OSError:
            self._broken = True
            return b""
        return b"" if sent == len(data) else data[sent:]


_QUEUED_FRAMES = 8
"""A program has one frame under way, and a farewell; one that sends more waits."""


_FLOOD_PAUSE_S = 0.005
_CLOSING_S = 1.0


_arrived = threading.Event()
"""Something has arrived at one of the `ThreadedPipes`."""


class ThreadedPipes:
    """Blocking pipes, each with a thread: works where pipes cannot be polled (Windows)."""

    def __init__(self, read_fd: int, write_fd: int, limit_bytes: int) -> None:
        self._read_fd = read_fd
        self._write_fd = write_fd
        self._buffer = FrameBuffer(limit_bytes)
        self._arrived: queue.SimpleQueue[bytes | Exception] = queue.SimpleQueue()
        self._to_send: queue.SimpleQueue[bytes | None] = queue.SimpleQueue()
        self._end: Exception | None = None
        self._closing = False
        self._threads = [
            threading.Thread(target=work, name=f"rcj-pipe-{work.__name__}", daemon=True)
            for work in (self._read_all, self._write_all)
        ]
        for thread in self._threads:
            thread.start()

    def send(self, frame: bytes) -> None:
        """See `Channel`."""
        self._to_send.put(frame)

    def receive(self, timeout_s: float) -> bytes | None:
        """See `Channel`."""
        if self._end is not None:
            raise self._end
        try:
            arrived = self._arrived.get(timeout=timeout_s) if timeout_s > 0 else self._arrived.get_nowait()
        except queue.Empty:
            return None
        if isinstance(arrived, Exception):
            self._end = arrived
            raise arrived
        return arrived

    def receive_soon(self) -> bytes | None:
        """See `Channel`. Only a thread can report a frame, so this does not wait."""
        return self.receive(0.0)

    def close(self) -> None:
        """See `Channel`. The process must have ended: that is what ends the threads."""
        self._closing = True
        self._to_send.put(None)
        give_up = time.perf_counter() + _CLOSING_S
        while any(thread.is_alive() for thread in self._threads):
            if time.perf_counter() > give_up:
                return  # a process that the program started has escaped and holds the pipes: leave them to it
            for thread in self._threads:
                thread.join(0.001)
        os.close(self._read_fd)
        os.close(self._write_fd)

    def _read_all(self) -> None:
        while True:
            try:
                chunk = os.read(self._read_fd, _CHUNK)
            except OSError:
                chunk = b""
            if not chunk or self._closing:
                self._put(ChannelClosedError())
                return
            self._buffer.held += chunk
            try:
                while (body := self._buffer.next()) is not None:
                    self._put(body)
                    while self._arrived.qsize() > _QUEUED_FRAMES and not self._closing:
                        time.sleep(_FLOOD_PAUSE_S)
            except FrameTooLongError as error:
                self._put(error)
                return

    def _put(self, arrived: bytes | Exception) -> None:
        self._arrived.put(arrived)
        _arrived.set()

    def _write_all(self) -> None:
        while (frame := self._to_send.get()) is not None:
            view = memoryview(frame)
            try:
                while view:
                    view = view[os.write(self._write_fd, view) :]
            except OSError:
                return


def open_channel(read_fd: int, write_fd: int, limit_bytes: int, *, portable: bool | None) -> Channel:
    """Return the best channel for this platform; it owns the file descriptors from now on.

    Frames of more than ``limit_bytes`` are refused. ``portable``: True takes the channel that works everywhere; None
    decides by platform.
    """
    if portable is None:
        portable = sys.platform == "win32" or not hasattr(select, "poll")
    return ThreadedPipes(read_fd, write_fd, limit_bytes) if portable else PolledPipes(read_fd, write_fd, limit_bytes)


def wait_for_any(channels: Sequence[Channel], timeout_s: float) -> None:
    """Wait until a frame may be at one of the channels, at most ``timeout_s``. It may return without one."""
    polled = [channel for channel in channels if isinstance(channel, PolledPipes)]
    if len(polled) < len(channels):
        _arrived.wait(timeout_s)
        _arrived.clear()
        return
    poll = select.poll()
    for channel in polled:
        channel.register(poll)
    poll.poll(timeout_s * 1000)
