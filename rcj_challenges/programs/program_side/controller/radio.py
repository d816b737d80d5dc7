"""Receivers (infra-red and radio) and the team's emitter."""

from __future__ import annotations

import math
import struct

from ._connection import Connection, Packet, complain, format_given, number
from .device import Device, ReadOnly, Sensor

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections import deque
    from collections.abc import Sequence
    from typing import Any
else:
    from _collections import deque


class NoPacketError(RuntimeError, AttributeError):
    """A property of the first packet was read, and there is none.

    ``hasattr`` and ``getattr`` with a default expect an ``AttributeError``: a program that tests for a packet this way
    gets an answer instead of a crash.
    """

    def __init__(self, message: str) -> None:
        super().__init__(message)
        self.name = None  # else Python suggests the getter, which also fails


class _OfPacket(ReadOnly):
    def __get__(self, thing: Any, kind: type | None = None) -> Any:
        try:
            return super().__get__(thing, kind)
        except RuntimeError as error:
            raise NoPacketError(str(error)) from None


class Receiver(Sensor):
    """A queue of packets, oldest first. A packet stays until ``nextPacket``."""

    CHANNEL_BROADCAST = -1

    def _rcj_set_up(self, connection: Connection, spec: dict[str, Any]) -> None:
        super()._rcj_set_up(connection, spec)
        self._rcj_packets: deque[Packet] = _NotListening(self)
        self._rcj_channel = int(self._rcj_facts.get("channel", -1))
        self._rcj_returns_text = connection.spec["getdata_returns"] == "text"
        self._rcj_silent_ticks = int(self._rcj_facts.get("silent_ticks", -1))

    def enable(self, samplingPeriod: float | None = None, *, sampling_period: float | None = None) -> None:
        """Listen, every ``samplingPeriod`` ms (``sampling_period`` in R2023a)."""
        super().enable(samplingPeriod, sampling_period=sampling_period)
        self._rcj_packets = self._rcj_connection.queues[self._rcj_index]

    def getQueueLength(self) -> int:
        """The number of packets that wait.

        Example:
            ``while receiver.getQueueLength(): … receiver.nextPacket()``
        """
        return len(self._rcj_packets)

    def nextPacket(self) -> None:
        """Forget the first packet; without one nothing happens."""
        if packets := self._rcj_packets:
            packets.popleft()

    def getData(self) -> Any:
        """Return the first packet: bytes up to messages v2.1, text from v2.2.

        Raises:
            RuntimeError: the queue is empty.
            UnicodeDecodeError: it is returned as text and is not UTF-8.

        Example:
            ``waiting = struct.unpack("?", receiver.getData())[0]``
        """
        data = self._rcj_first("getData")[0]
        return data.decode() if self._rcj_returns_text else data

    def getBytes(self) -> bytes:
        """Return the first packet as bytes.

        Raises:
            RuntimeError: the queue is empty.
        """
        return self._rcj_first("getBytes")[0]

    def getString(self) -> str:
        """Return the whole first packet as text, zero bytes included, as Webots R2023b does.

        Raises:
            RuntimeError: the queue is empty.
            UnicodeDecodeError: it is not UTF-8.
        """
        return self._rcj_first("getString")[0].decode()

    def getFloats(self) -> list[float]:
        """Return the first packet as a list of doubles.

        Raises:
            RuntimeError: the queue is empty.
            struct.error: its size is not that of whole doubles.
        """
        return self._rcj_unpacked("getFloats", "d", "doubles")

    def getInts(self) -> list[int]:
        """Return the first packet as a list of whole numbers of 4 bytes.

        Raises:
            RuntimeError: the queue is empty.
            struct.error: its size is not that of such numbers.
        """
        return self._rcj_unpacked("getInts", "i", "ints")

    def getBools(self) -> list[bool]:
        """Return the first packet as a list of bools, one of each byte.

        Raises:
            RuntimeError: the queue is empty.
        """
        return self._rcj_unpacked("getBools", "?", "bools")

    def getDataSize(self) -> int:
        """Return the first packet's size in bytes; -1 without one."""
        return len(self._rcj_packets[0][0]) if self._rcj_packets else -1

    def getSignalStrength(self) -> float:
        """Return 1 / r² of the first packet, r the distance to its emitter in m; NaN without one.

        Example:
            ``distance_m = receiver.getSignalStrength() ** -0.5``
        """
        return self._rcj_packets[0][1] if self._rcj_packets else math.nan

    def getEmitterDirection(self) -> list[float]:
        """Return the unit vector to the emitter of the first packet, in the robot's frame: x forward, y left, z up.

        Raises:
            RuntimeError: the queue is empty.

        Example:
            ``angle_rad = math.atan2(direction[1], direction[0])``, 0 straight ahead, positive to the left.
        """
        return list(self._rcj_first("getEmitterDirection")[2:])

    def getChannel(self) -> int:
        """Return the channel it listens to."""
        return self._rcj_channel

    def setChannel(self, channel: int) -> None:
        """Listen to another channel; those of the other team stay silent."""
        self._rcj_channel = _tuned(self._rcj_spec, self._rcj_channel, channel)
        self._rcj_connection.tune(self._rcj_index, self._rcj_channel)

    def _rcj_first(self, method: str) -> Packet:
        packets = self._rcj_packets
        if not packets and self._rcj_connection.tick <= self._rcj_silent_ticks:
            self._rcj_await_the_first(method)
        if not packets:
            raise self._rcj_emptiness(method)
        return packets[0]

    def _rcj_await_the_first(self, method: str) -> None:
        """Let time pass until the referee's first packet of 2021 arrives, which the first step does not bring.

        Programs that read without checking the queue were usual in 2021, and worked.
        """
        connection = self._rcj_connection
        if type(self._rcj_packets) is _NotListening or connection.is_within_step():
            return
        # Up to the second step: robots of 2021 step two ticks, and that often their receivers deliver.
        until = self._rcj_silent_ticks + min(self._rcj_silent_ticks, 2)
        wait_ms = (until - connection.tick) * connection.tick_ms
        complain(
            f"Warning: {self._rcj_name!r}: {method} was called before the first packet was there, and waits for it: "
            f"{wait_ms / 1000:g} s. Ask getQueueLength() first."
        )
        connection.exchange(wait_ms)

    def _rcj_emptiness(self, method: str) -> RuntimeError:
        """Return why there is no packet, after printing it."""
        reason = "with an empty queue; ask getQueueLength() first."
        if type(self._rcj_packets) is _NotListening:
            reason = "but the receiver is not enabled: call enable(32) before the first step."
        text = f"{self._rcj_name!r}: {method} was called {reason}"
        complain(f"Error: {text}", "correct this call")
        return RuntimeError(text)

    def _rcj_unpacked(self, method: str, letter: str, kind: str) -> list[Any]:
        data = self._rcj_first(method)[0]
        size = struct.calcsize(letter)
        if len(data) % size:
            raise struct.error(
                f"{self._rcj_name!r}: {method} reads packets of {kind}, {size} bytes each; this packet has "
                f"{len(data)} bytes. struct.unpack reads others."
            )
        return list(struct.unpack(f"{len(data) // size}{letter}", data))

    queue_length = ReadOnly(getQueueLength)
    data = _OfPacket(getData)
    bytes = _OfPacket(getBytes)
    string = _OfPacket(getString)
    floats = _OfPacket(getFloats)
    ints = _OfPacket(getInts)
    bools = _OfPacket(getBools)
    data_size = ReadOnly(getDataSize)
    signal_strength = ReadOnly(getSignalStrength)
    emitter_direction = _OfPacket(getEmitterDirection)
    channel = property(getChannel, setChannel)


class _NotListening(deque[Packet]):
    """Stands for the queue of a receiver until it is enabled: empty; the first look at it prints a hint."""

    def __init__(self, receiver: Receiver) -> None:
        super().__init__()
        self._receiver = receiver

    def __len__(self) -> int:
        if not self._receiver._rcj_warned:  # noqa: SLF001 - a part of it
            self._receiver._rcj_warn()  # noqa: SLF001
        return 0


class Emitter(Device):
    """Sends packets to the robots of its own team."""

    CHANNEL_BROADCAST = -1

    def _rcj_set_up(self, connection: Connection, spec: dict[str, Any]) -> None:
        super()._rcj_set_up(connection, spec)
        self._rcj_channel = int(self._rcj_facts.get("channel", -1))
        self._rcj_range = self.getMaxRange()
        self._rcj_warned_about: set[str] = set()

    def send(self, message: str | bytes | bytearray | memoryview | Sequence[float], size: int | None = None) -> int:
        """Send bytes, text (as UTF-8) or a list of floats (as doubles) to the robots of its own team.

        Example:
            ``emitter.send(json.dumps({"ball": True}))``

        Returns:
            1, or 0 if it is empty or too large, which is reported once.

        Raises:
            TypeError: it is none of these, or the size is no whole number.
        """
        data = _packed(message, self._rcj_name)
        if size is not None:
            data = _cut(data, size, self._rcj_name)
        if data and self._rcj_connection.emit(self._rcj_index, self._rcj_channel, data):
            return 1
        self._rcj_warn_why_not(len(data))
        return 0

    def _rcj_warn_why_not(self, size: int) -> None:
        """Say why a packet of so many bytes is not sent: each reason once."""
        most = self._rcj_connection.message_bytes
        reason, text, help_ = "step", "too much is sent in one step.", "send less in one packet and in one step"
        if not size:
            reason, text, help_ = "empty", "it is empty.", "send nothing where there is nothing to say"
        elif size > most:
            reason, text = "large", f"it has {size} bytes, and at most {most} are allowed."
        if reason not in self._rcj_warned_about:
            self._rcj_warned_about.add(reason)
            complain(f"Warning: {self._rcj_name!r}: the packet is dropped: {text}", help_)

    def getChannel(self) -> int:
        """Return the channel it sends on."""
        return self._rcj_channel

    def setChannel(self, channel: int) -> None:
        """Send on another channel from now on; those of the other team carry nothing."""
        self._rcj_channel = _tuned(self._rcj_spec, self._rcj_channel, channel)

    def getRange(self) -> float:
        """Its range in m."""
        return self._rcj_range

    def setRange(self, range: float) -> None:
        """Remember a smaller range in m. It is not simulated: packets reach as far as before."""
        self._rcj_range = min(float(range), self.getMaxRange())

    def getMaxRange(self) -> float:
        """Return the largest range in m."""
        return float(self._rcj_facts.get("range", 10.0))

    def getBufferSize(self) -> int:
        """Return -1: unlimited."""
        return -1

    channel = property(getChannel, setChannel)
    range = property(getRange, setRange)
    max_range = ReadOnly(getMaxRange)
    buffer_size = ReadOnly(getBufferSize)


def _packed(message: Any, emitter: str) -> bytes:
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


def _cut(data: bytes, size: Any, emitter: str) -> bytes:
    try:
        return data[:size]
    except TypeError:
        text = "send takes one message, and then how many of its bytes to send"
        raise TypeError(f"{emitter!r}: {text}; {format_given(size)} was given as this number.") from None


def _tuned(spec: dict[str, Any], current: int, given: float) -> int:
    """Return the channel of a device after a request; a refusal is reported."""
    asked = int(number(given, f"{spec['name']!r}: setChannel takes the number of a channel, such as 1"))
    help_ = "correct this call"
    if asked in spec["facts"].get("refused_channels", ()):
        complain(f"Error: {spec['name']!r}: channel {asked} is not for this team; it stays on {current}.", help_)
        return current
    if asked < Receiver.CHANNEL_BROADCAST:
        complain(
            f"Error: {spec['name']!r}: channel {asked} does not exist (the lowest is -1); it stays on {current}.", help_
        )
        return current
    return min(asked, 2**31 - 1)
