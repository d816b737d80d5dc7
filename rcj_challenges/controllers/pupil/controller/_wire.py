"""The program's end of the protocol: frames over two pipes (``docs/protocol.md``)."""

from __future__ import annotations

import os
from _thread import allocate_lock
from struct import Struct, error
from typing import NoReturn

Packet = tuple[int, bytes, float, float, float, float]
"""Index of the receiver, payload, strength, and the direction's x, y, z in the robot's frame."""

HELLO, OBSERVATION, REQUEST, FAULT = 0x48, 0x4F, 0x52, 0x46
OVER = 1
FAULT_KINDS = ("crash", "exit", "memory", "output_flood", "start")

_LENGTH = Struct("<I")
_OBSERVATION = Struct("<BIBII")
_PACKET = Struct("<HI4d")
_REQUEST = Struct("<IBIIIQHHHHI")
_MOTOR = Struct("<Hdd")
_SAMPLING = Struct("<HI")
_CHANNEL = Struct("<Hi")
_FREQUENCY = Struct("<Hd")
_EMISSION = Struct("<HI")
_FAULT = Struct("<IBBI")
_CHUNK = 1 << 16
EMISSION_OVERHEAD = _EMISSION.size


class Wire:
    """Reads and writes whole frames.

    A parent that is gone ends the process at once: there is nobody left to play for.
    """

    def __init__(self, read_fd: int, write_fd: int) -> None:
        self._read_fd = read_fd
        self._write_fd = write_fd
        self._rest = b""
        self._writing = allocate_lock()
        self._values = Struct("<0d")

    def expect_values(self, count: int) -> None:
        """Fix how many numbers each observation holds."""
        self._values = Struct(f"<{count}d")

    def receive(self) -> bytes:
        """Wait for the next frame and return it without its length."""
        held = self._rest or self._read()
        while len(held) < 4:
            held += self._read()
        (length,) = _LENGTH.unpack_from(held)
        end = 4 + length
        if len(held) < end:
            parts, have = [held], len(held)
            while have < end:
                part = self._read()
                parts.append(part)
                have += len(part)
            held = b"".join(parts)
        self._rest = held[end:]
        return held[4:end]

    def send(self, frame: bytes) -> None:
        """Write a whole frame, its length included."""
        with self._writing:
            try:
                sent = os.write(self._write_fd, frame)
                while sent < len(frame):
                    sent += os.write(self._write_fd, frame[sent:])
            except OSError:
                leave(1)

    def observation(self, body: bytes) -> tuple[int, bool, tuple[float, ...], list[Packet]]:
        """Return tick, whether it is the last one, the values and the packets of an observation's body."""
        kind, tick, flags, _, packet_count = _OBSERVATION.unpack_from(body)
        if kind != OBSERVATION:
            raise error(f"expected an observation, got a message of type {kind}")
        values = self._values.unpack_from(body, _OBSERVATION.size)
        packets: list[Packet] = []
        at = _OBSERVATION.size + self._values.size
        for _ in range(packet_count):
            device, size, strength, x, y, z = _PACKET.unpack_from(body, at)
            at += _PACKET.size
            packets.append((device, body[at : at + size], strength, x, y, z))
            at += size
        return tick, bool(flags & OVER), values, packets

    def _read(self) -> bytes:
        try:
            chunk = os.read(self._read_fd, _CHUNK)
        except OSError:
            chunk = b""
        return chunk or leave(1)


def leave(status: int) -> NoReturn:
    """End the process at once, without running anything more of the program."""
    os._exit(status)


def request_frame(
    tick: int,
    advance_ticks: int,
    missed_ticks: int,
    printed: int,
    motors: list[tuple[int, float, float]],
    sampling: list[tuple[int, int]],
    channels: list[tuple[int, int]],
    frequencies: list[tuple[int, float]],
    emissions: list[tuple[int, bytes]],
) -> bytes:
    """Return a request as a frame. ``tick`` is that of the observation it answers."""
    parts = [b""]
    parts += [_MOTOR.pack(*entry) for entry in motors]
    parts += [_SAMPLING.pack(*entry) for entry in sampling]
    parts += [_CHANNEL.pack(*entry) for entry in channels]
    parts += [_FREQUENCY.pack(*entry) for entry in frequencies]
    for device, data in emissions:
        parts += (_EMISSION.pack(device, len(data)), data)
    tail = b"".join(parts)
    return (
        _REQUEST.pack(
            _REQUEST.size - 4 + len(tail),
            REQUEST,
            tick,
            advance_ticks,
            missed_ticks,
            printed,
            len(motors),
            len(sampling),
            len(channels),
            len(frequencies),
            len(emissions),
        )
        + tail
    )


def fault_frame(kind: str, detail: str, traceback: str = "") -> bytes:
    """Return the last message of a program that ends: why."""
    told = detail.encode("utf-8", "backslashreplace")[:2_000]
    trace = traceback.encode("utf-8", "backslashreplace")[-20_000:]
    length = _FAULT.size - 4 + len(told) + len(trace)
    return _FAULT.pack(length, FAULT, FAULT_KINDS.index(kind), len(told)) + told + trace
