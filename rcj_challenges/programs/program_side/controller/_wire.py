"""The program's end of the protocol: frames over two pipes (``docs/protocol.md``)."""

from __future__ import annotations

import os
from _thread import allocate_lock
from struct import Struct, error

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Collection, Iterable
    from typing import NoReturn

    Motors = Iterable[tuple[int, float, float]]
    """Index, velocity in rad/s, position in rad."""

HELLO, OBSERVATION, REQUEST, FAULT, NOTES = 0x48, 0x4F, 0x52, 0x46, 0x4E
OVER = 1  # flag of an observation
FAULT_KINDS = ("crash", "exit", "memory", "output_flood", "start")

OBSERVATION_HEAD = "<IBIBII"  # length, type, tick, flags, how many values, how many packets; then the values
HEAD_FIELDS = 6
PACKET = Struct("<HI4d")
_LENGTH = Struct("<I")
_REQUEST_HEAD = "<IBIIIQHHHHI"  # length, type, tick, advance, missed, printed, five counts; then the settings
_MISSED_AT, _MISSED = 13, Struct("<I")
_MOTOR = "Hdd"
_SAMPLING = Struct("<HI")
_CHANNEL = Struct("<Hi")
_FREQUENCY = Struct("<Hd")
_EMISSION = Struct("<HiI")
_FAULT = Struct("<IBBI")
_NOTES = Struct("<IBI")

_FORMS = [Struct(_REQUEST_HEAD + count * _MOTOR) for count in range(5)]
"""Of requests that set no motor, one, two …, without what else they ask for."""

_USUAL_READ = 4096
_LARGE_READ = 1 << 16
_WHOLE_WRITE = 512  # POSIX writes that much to a pipe in one piece


class Wire:
    """Reads and writes whole frames. If the parent is gone, the process ends at once."""

    def __init__(self, read_fd: int, write_fd: int) -> None:
        self._read_fd = read_fd
        self._write_fd = write_fd
        self._rest = b""
        self._writing = allocate_lock()

    def receive(self) -> bytes:
        """Wait for the next frame and return it, its length included."""
        try:
            frame = self._rest or os.read(self._read_fd, _USUAL_READ)
        except OSError:
            leave(1)
        if len(frame) >= 4 and _LENGTH.unpack_from(frame)[0] == len(frame) - 4:
            self._rest = b""
            return frame
        return self._receive_in_pieces(frame)

    def send(self, frame: bytes) -> None:
        """Write a whole frame, its length included. Other threads may send theirs meanwhile."""
        with self._writing:
            try:
                sent = os.write(self._write_fd, frame)
                while sent < len(frame):
                    sent += os.write(self._write_fd, frame[sent:])
            except OSError:
                leave(1)

    def exchange(self, frame: bytes) -> bytes:
        """Send a frame, then wait for one and return it."""
        if len(frame) > _WHOLE_WRITE or self._rest:
            self.send(frame)
            return self.receive()
        try:
            os.write(self._write_fd, frame)
            answer = os.read(self._read_fd, _USUAL_READ)
            whole = _LENGTH.unpack_from(answer)[0] == len(answer) - 4
        except error:  # not even a length
            whole = False
        except OSError:
            leave(1)
        return answer if whole else self._receive_in_pieces(answer)

    def _receive_in_pieces(self, held: bytes) -> bytes:
        if not held:
            leave(1)
        while len(held) < 4:
            held += os.read(self._read_fd, _LARGE_READ) or leave(1)
        end = 4 + _LENGTH.unpack_from(held)[0]
        while len(held) < end:
            held += os.read(self._read_fd, _LARGE_READ) or leave(1)
        self._rest = held[end:]
        return held[:end]


def leave(status: int) -> NoReturn:
    """End the process at once, without running anything more of the program."""
    os._exit(status)


Emission = tuple[int, int, bytes]
"""Index of the emitter, channel, payload."""


def request_frame(
    tick: int,
    advance_ticks: int,
    missed_ticks: int,
    printed: int,
    motors: Motors,
    sampling: Collection[tuple[int, int]] = (),
    channels: Collection[tuple[int, int]] = (),
    frequencies: Collection[tuple[int, float]] = (),
    emissions: Collection[Emission] = (),
) -> bytes:
    """Return a request. ``tick`` is the answered observation's."""
    numbers: list[float] = []
    for setting in motors:
        numbers += setting
    count = len(numbers) // 3
    form = _FORMS[count] if count < len(_FORMS) else Struct(_REQUEST_HEAD + count * _MOTOR)
    length = form.size - 4
    if not (sampling or channels or frequencies or emissions):  # as nearly always
        return form.pack(length, REQUEST, tick, advance_ticks, missed_ticks, printed, count, 0, 0, 0, 0, *numbers)
    tail = b"".join([_EMISSION.pack(device, channel, len(data)) + data for device, channel, data in emissions])
    if sampling or channels or frequencies:  # seldom
        settings = [_SAMPLING.pack(*one) for one in sampling] + [_CHANNEL.pack(*one) for one in channels]
        tail = b"".join(settings + [_FREQUENCY.pack(*one) for one in frequencies]) + tail
    counts = count, len(sampling), len(channels), len(frequencies), len(emissions)
    return form.pack(length + len(tail), REQUEST, tick, advance_ticks, missed_ticks, printed, *counts, *numbers) + tail


def with_missed_ticks(request: bytes, missed_ticks: int) -> bytes:
    """Return a request as it would be if so many ticks were missed."""
    return request[:_MISSED_AT] + _MISSED.pack(missed_ticks) + request[_MISSED_AT + _MISSED.size :]


def with_notes(notes: list[tuple[str, str, str, str]], frame: bytes) -> bytes:
    """Return a request or fault that brings notes: code, subject, what is wrong, what to do. Empty: nothing follows."""
    import json  # noqa: PLC0415 - only for a mistake: each import costs every program

    text = json.dumps(notes, ensure_ascii=False).encode("utf-8", "replace")
    body = frame[_LENGTH.size :]
    return _NOTES.pack(_NOTES.size - 4 + len(text) + len(body), NOTES, len(text)) + text + body


def fault_frame(kind: str, detail: str, traceback: str = "") -> bytes:
    """Return the last message of a program that ends: why."""
    text = detail.encode("utf-8", "backslashreplace")[:2_000]
    trace = traceback.encode("utf-8", "backslashreplace")[-20_000:]
    length = _FAULT.size - 4 + len(text) + len(trace)
    return _FAULT.pack(length, FAULT, FAULT_KINDS.index(kind), len(text)) + text + trace
