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
_OBSERVATION = "<IBIBII"  # with its length; then the values
_PACKET = Struct("<HI4d")
_PACKET_SIZE = _PACKET.size
_REQUEST = "<IBIIIQHHHHI"  # with its length; then the settings
_MOTOR = "Hdd"
_MOTOR_FORM = Struct("<" + _MOTOR)
_SAMPLING = Struct("<HI")
_CHANNEL = Struct("<Hi")
_FREQUENCY = Struct("<Hd")
_EMISSION = Struct("<HI")
_FAULT = Struct("<IBBI")
_CHUNK = 1 << 16
EMISSION_OVERHEAD = _EMISSION.size

# The common requests, whole: no, one, two … motors set, and nothing else.
_WITH_MOTORS = [Struct(_REQUEST + count * _MOTOR) for count in range(5)]


class Wire:
    """Reads and writes whole frames.

    A parent that is gone ends the process at once: there is nobody left to play for.
    """

    def __init__(self, read_fd: int, write_fd: int) -> None:
        self._read_fd = read_fd
        self._write_fd = write_fd
        self._rest = b""
        self._writing = allocate_lock()
        self._form = Struct(_OBSERVATION)

    def expect_values(self, count: int) -> None:
        """Fix how many numbers each observation holds."""
        self._form = Struct(f"{_OBSERVATION}{count}d")

    def receive(self) -> bytes:
        """Wait for the next frame and return it, its length included."""
        frame = self._rest or self._read()
        if len(frame) >= 4 and _LENGTH.unpack_from(frame)[0] == len(frame) - 4:
            self._rest = b""
            return frame
        return self._receive_in_pieces(frame)

    def _receive_in_pieces(self, held: bytes) -> bytes:
        while len(held) < 4:
            held += self._read()
        end = 4 + _LENGTH.unpack_from(held)[0]
        parts, have = [held], len(held)
        while have < end:
            part = self._read()
            parts.append(part)
            have += len(part)
        held = b"".join(parts)
        self._rest = held[end:]
        return held[:end]

    def send(self, frame: bytes) -> None:
        """Write a whole frame, its length included."""
        with self._writing:
            try:
                sent = os.write(self._write_fd, frame)
                while sent < len(frame):
                    sent += os.write(self._write_fd, frame[sent:])
            except OSError:
                leave(1)

    def observation(self, frame: bytes) -> tuple[int, bool, tuple[float, ...], list[Packet]]:
        """Return tick, whether it is the last one, the values and the packets of an observation."""
        _, kind, tick, flags, _, packet_count, *values = self._form.unpack_from(frame)
        if kind != OBSERVATION:
            raise error(f"expected an observation, got a message of type {kind}")
        packets: list[Packet] = []
        at = self._form.size
        for _ in range(packet_count):
            device, size, strength, x, y, z = _PACKET.unpack_from(frame, at)
            at += _PACKET_SIZE
            packets.append((device, frame[at : at + size], strength, x, y, z))
            at += size
        return tick, flags == OVER, tuple(values), packets

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
    if not (sampling or channels or frequencies or emissions) and len(motors) < len(_WITH_MOTORS):
        whole = _WITH_MOTORS[len(motors)]
        numbers = [number for setting in motors for number in setting]
        return whole.pack(
            whole.size - 4, REQUEST, tick, advance_ticks, missed_ticks, printed, len(motors), 0, 0, 0, 0, *numbers
        )
    parts = [_MOTOR_FORM.pack(*entry) for entry in motors]
    parts += [_SAMPLING.pack(*entry) for entry in sampling]
    parts += [_CHANNEL.pack(*entry) for entry in channels]
    parts += [_FREQUENCY.pack(*entry) for entry in frequencies]
    for device, data in emissions:
        parts += (_EMISSION.pack(device, len(data)), data)
    tail = b"".join(parts)
    head = _WITH_MOTORS[0]
    counts = len(motors), len(sampling), len(channels), len(frequencies), len(emissions)
    length = head.size - 4 + len(tail)
    return head.pack(length, REQUEST, tick, advance_ticks, missed_ticks, printed, *counts) + tail


def fault_frame(kind: str, detail: str, traceback: str = "") -> bytes:
    """Return the last message of a program that ends: why."""
    told = detail.encode("utf-8", "backslashreplace")[:2_000]
    trace = traceback.encode("utf-8", "backslashreplace")[-20_000:]
    length = _FAULT.size - 4 + len(told) + len(trace)
    return _FAULT.pack(length, FAULT, FAULT_KINDS.index(kind), len(told)) + told + trace
