"""Receivers (infra-red and radio) and the team's emitter."""

from __future__ import annotations

import math
import struct
from collections.abc import Sequence
from typing import Any

from ._hub import Hub, Packet, complain
from .device import Device, ReadOnly, Sensor


class Receiver(Sensor):
    """A queue of packets, oldest first. A packet stays until ``nextPacket``."""

    CHANNEL_BROADCAST = -1

    def __init__(self, hub: Hub, spec: dict[str, Any], siblings: dict[str, Device]) -> None:
        super().__init__(hub, spec, siblings)
        self._queue = hub.queues[self._index]
        self._channel = int(self._facts.get("channel", -1))
        self._returns_text = hub.spec["getdata_returns"] == "text"

    def getQueueLength(self) -> int:
        """Return how many packets wait."""
        return len(self._queue.packets)

    def nextPacket(self) -> None:
        """Forget the first packet; without one nothing happens."""
        if self._queue.packets:
            self._queue.drop()

    def getData(self) -> Any:
        """Return the first packet: bytes up to v2.1, text from v2.2.

        Raises:
            RuntimeError: the queue is empty.
        """
        return self.getString() if self._returns_text else self._first("getData")[0]

    def getBytes(self) -> bytes:
        """Return the first packet as bytes.

        Raises:
            RuntimeError: the queue is empty.
        """
        return self._first("getBytes")[0]

    def getString(self) -> str:
        """Return the first packet as text, up to its first zero byte.

        Raises:
            RuntimeError: the queue is empty.
            UnicodeDecodeError: it is not UTF-8.
        """
        return self._first("getString")[0].split(b"\0", 1)[0].decode()

    def getFloats(self) -> list[float]:
        """Return the first packet as a list of doubles.

        Raises:
            RuntimeError: the queue is empty.
            struct.error: its size is not that of whole doubles.
        """
        data = self._first("getFloats")[0]
        return list(struct.unpack(f"{len(data) / 8:g}d", data))

    def getDataSize(self) -> int:
        """Return the first packet's size in bytes; -1 without one."""
        return len(self._queue.packets[0][0]) if self._queue.packets else -1

    def getSignalStrength(self) -> float:
        """Return 1 / r² of the first packet, r in m; NaN without one."""
        return self._queue.packets[0][1] if self._queue.packets else math.nan

    def getEmitterDirection(self) -> list[float]:
        """Return the unit vector to the emitter of the first packet: x forward, y left, z up.

        Raises:
            RuntimeError: the queue is empty.
        """
        return list(self._first("getEmitterDirection")[2:])

    def getChannel(self) -> int:
        """Return the channel it listens to."""
        return self._channel

    def setChannel(self, channel: int) -> None:
        """Listen to another channel; those of the other team stay silent."""
        self._channel = _tuned(self._hub, self._spec, self._channel, int(channel))

    def _first(self, method: str) -> Packet:
        if not self._queue.packets:
            text = f"{self.getName()!r}: {method} was called with an empty queue; ask getQueueLength() first."
            complain(f"Error: {text}")
            raise RuntimeError(text)
        return self._queue.packets[0]

    queue_length = ReadOnly(getQueueLength)
    data = ReadOnly(getData)
    bytes = ReadOnly(getBytes)
    string = ReadOnly(getString)
    floats = ReadOnly(getFloats)
    data_size = ReadOnly(getDataSize)
    signal_strength = ReadOnly(getSignalStrength)
    emitter_direction = ReadOnly(getEmitterDirection)
    channel = property(getChannel, setChannel)


class Emitter(Device):
    """Sends packets to the robots of the own team."""

    CHANNEL_BROADCAST = -1

    def __init__(self, hub: Hub, spec: dict[str, Any], siblings: dict[str, Device]) -> None:
        super().__init__(hub, spec, siblings)
        self._channel = int(self._facts.get("channel", -1))
        self._range = self.getMaxRange()
        self._warned = False

    def send(self, message: str | bytes | bytearray | memoryview | Sequence[float], size: int | None = None) -> int:
        """Send bytes, text (as UTF-8) or a list of floats (as doubles). Returns 1, or 0 if it is too large.

        Raises:
            TypeError: it is none of these.
        """
        data = _packed(message, self._spec["name"])
        if self._hub.emit(self._index, data if size is None else data[:size]):
            return 1
        if not self._warned:
            self._warned = True
            complain(f"Warning: {self.getName()!r}: the packet is dropped: too much is sent in one step.")
        return 0

    def getChannel(self) -> int:
        """Return the channel it sends on."""
        return self._channel

    def setChannel(self, channel: int) -> None:
        """Send on another channel; those of the other team carry nothing."""
        self._channel = _tuned(self._hub, self._spec, self._channel, int(channel))

    def getRange(self) -> float:
        """Return how far it sends, in m."""
        return self._range

    def setRange(self, range: float) -> None:
        """Remember a smaller range in m. It is not simulated: the packets are heard as far as before."""
        self._range = min(float(range), self.getMaxRange())

    def getMaxRange(self) -> float:
        """Return the largest range in m."""
        return float(self._facts.get("range", 10.0))

    def getBufferSize(self) -> int:
        """Return -1: unlimited."""
        return -1

    channel = property(getChannel, setChannel)
    range = property(getRange, setRange)
    max_range = ReadOnly(getMaxRange)
    buffer_size = ReadOnly(getBufferSize)


def _packed(message: Any, emitter: str) -> bytes:
    """Return the bytes of a packet.

    Raises:
        TypeError: nothing that can be sent; the text names the emitter and what was found.
    """
    if isinstance(message, str):
        return message.encode()
    if isinstance(message, (bytes, bytearray, memoryview)):
        return bytes(message)
    found = f"{type(message).__name__} was given"
    if hasattr(message, "__len__") and not isinstance(message, (dict, set, frozenset)):
        try:
            return struct.pack(f"{len(message)}d", *message)
        except (TypeError, struct.error):
            found += ", and not all in it are numbers"
    raise TypeError(
        f"{emitter!r}: send takes bytes, a str or a list of numbers; {found}. "
        "json.dumps makes a str of other data, struct.pack bytes."
    )


def _tuned(hub: Hub, spec: dict[str, Any], current: int, asked: int) -> int:
    """Ask for another channel; return the one that the device is on now."""
    if asked in spec["facts"].get("refused_channels", ()):
        complain(f"Error: {spec['name']!r}: channel {asked} is not for this team; it stays on {current}.")
        return current
    asked = min(max(asked, -(2**31)), 2**31 - 1)
    hub.tune(spec["index"], asked)
    return asked
