"""The device ``team_emitter``: it has a speed, and sends first what was queued first."""

from collections import deque
from typing import Any, Literal

from rcj_challenges.core.timing import TICK_MS, TICK_S
from rcj_challenges.devices.base import Device, RobotSetup
from rcj_challenges.devices.receivers import ANY_CHANNEL
from rcj_challenges.rules.fields import Positive, described
from rcj_challenges.rules.phrasing import counted, metres

BACKLOG_PACKETS = 16_384
"""Packets that wait to be sent; what a program sends beyond it is lost."""

BACKLOG_BYTES = 4_194_304
"""Payload that waits to be sent. At 460.8 bytes a tick that is five minutes of sending."""

MAX_ARRIVE_A_TICK = 32
"""Packets of one emitter in one tick; what else has come over the air waits for the next. No real program is known that
sends so many, and 460 packets of one byte would cost the match ten times its other work."""

_BITS_PER_BYTE = 8
"""Source: reference, 4.1 (115200 baud are 460.8 bytes a tick: 8 bits a byte)."""

_MS_PER_S = 1000


class TeamEmitterDevice(Device):
    """Sends on the team's radio channel."""

    device: Literal["team_emitter"]
    range_m: Positive = described(10.0, "range in m; the shorter of this and the receiver's range applies")
    baud: int = described(
        115_200, "speed in bits per second, at 8 bits per byte: 460.8 bytes per tick by default", gt=0
    )

    CLASS = "emitter"
    ACCEPTS = frozenset({"emissions"})
    EXAMPLE = """
robots:
  # Y1 sends slowly: 38 bytes per tick.
  Y1: {devices: {team emitter: {device: team_emitter, baud: 9600}}}
"""

    def facts(self, setup: RobotSetup) -> dict[str, Any]:
        open_to_referee = {"referee_channels": list(setup.open_channels)} if setup.open_channels else {}
        return {
            **open_to_referee,
            "channel": setup.own_channel,
            "range": self.range_m,
            "baud_rate": self.baud,
            "max_packet_bytes": setup.max_packet_bytes,
            "refused_channels": sorted(
                {ANY_CHANNEL, *setup.foreign_channels, *setup.referee_channels} - {*setup.open_channels}
            ),
        }

    def describe(self) -> str:
        in_a_tick = f"{counted(self.baud * TICK_S / _BITS_PER_BYTE, 'byte')} in a tick"
        return f"team radio, sends up to {metres(self.range_m)} far, {self.baud} baud ({in_a_tick})"


class Emitter:
    """One emitter of one robot.

    Time on the air is counted in whole thousandths of a bit (bits · ms / s), so that nothing is ever rounded. Packets
    that have not arrived wait with their tick of arrival.
    """

    def __init__(self, robot: int, range_m: float, baud: int, max_packet_bytes: int) -> None:
        self.robot = robot
        self.range_m = range_m
        self._per_tick = baud * TICK_MS
        self._max_packet_bytes = max_packet_bytes
        self._free_from = 0
        self.waiting: deque[tuple[int, int, bytes]] = deque()
        self.to_referee: deque[tuple[int, bytes]] = deque()
        self._bytes = 0
        self._bytes_to_referee = 0

    def send(self, channel: int, data: bytes, now: int) -> None:
        """Queue a packet for a channel at tick ``now``; it is on the air as soon as those before it are out."""
        if self._has_room(data, len(self.waiting), self._bytes):
            self._bytes += len(data)
            self.waiting.append((self._arrival(data, now), channel, data))

    def send_to_referee(self, data: bytes, now: int) -> None:
        """Queue a packet for the referee: it is on the air as any other, and no robot receives it.

        Its backlog is one of its own: the referee receives one message a tick, which must not block the team's radio.
        """
        if self._has_room(data, len(self.to_referee), self._bytes_to_referee):
            self._bytes_to_referee += len(data)
            self.to_referee.append((self._arrival(data, now), data))

    def _has_room(self, data: bytes, packets: int, payload_bytes: int) -> bool:
        if not data or len(data) > self._max_packet_bytes:
            return False
        return not packets or (packets < BACKLOG_PACKETS and payload_bytes + len(data) <= BACKLOG_BYTES)

    def _arrival(self, data: bytes, now: int) -> int:
        begin = max(self._free_from, now * self._per_tick)
        self._free_from = begin + len(data) * _BITS_PER_BYTE * _MS_PER_S
        return -(-self._free_from // self._per_tick)

    def arriving(self, tick: int) -> list[tuple[int, bytes]]:
        """Return (channel, data) of the packets that have arrived by ``tick``, in order, but not too many at once."""
        arrived: list[tuple[int, bytes]] = []
        while self.waiting and self.waiting[0][0] <= tick and len(arrived) < MAX_ARRIVE_A_TICK:
            _, channel, data = self.waiting.popleft()
            self._bytes -= len(data)
            arrived.append((channel, data))
        return arrived

    def messages_to_referee(self, tick: int) -> bytes | None:
        """Return the next packet for the referee that has arrived by ``tick``, None if there is none."""
        if not self.to_referee or self.to_referee[0][0] > tick:
            return None
        _, data = self.to_referee.popleft()
        self._bytes_to_referee -= len(data)
        return data

    def clear(self) -> None:
        """Drop all that has not arrived."""
        self.waiting.clear()
        self.to_referee.clear()
        self._bytes = self._bytes_to_referee = 0
        self._free_from = 0
