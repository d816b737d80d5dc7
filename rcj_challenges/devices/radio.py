"""Team radio: emitters with a speed, first in first out, no occlusion, nobody else's channel."""

from __future__ import annotations

import math
from collections import deque

from rcj_challenges.devices.channels import ANY_CHANNEL
from rcj_challenges.devices.poses import Poses
from rcj_challenges.devices.receivers import Receiver
from rcj_challenges.facts.timing import TICK_MS
from rcj_challenges.facts.traffic import Packet

BACKLOG_PACKETS = 16_384
"""Packets that wait to be sent; what a program sends beyond it is lost."""

BACKLOG_BYTES = 4_194_304
"""Payload that waits to be sent. At 460.8 bytes a tick that is five minutes of sending."""

MOST_ARRIVE_A_TICK = 32
"""Packets of one emitter in one tick; what else has come over the air waits for the next. No real program is known that
sends so many, and 460 packets of one byte would cost the match ten times its other work."""

_BITS_PER_BYTE = 8
"""Source: reference, 4.1 (115200 baud are 460.8 bytes a tick: 8 bits a byte)."""

_MS_PER_S = 1000


class Emitter:
    """One emitter of one robot.

    Time on the air is counted in whole thousandths of a bit (bits · ms / s), so that nothing is ever rounded.

    Attributes:
        robot: index of the robot.
        range_m: how far it is heard, in m.
        waiting: (tick of arrival, channel, data) of what has not arrived.
        to_referee: (tick of arrival, data) of what the referee has not heard.
    """

    def __init__(self, robot: int, range_m: float, baud: int, max_packet_bytes: int) -> None:
        """Build an emitter that has nothing to send."""
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

    def tell_referee(self, data: bytes, now: int) -> None:
        """Queue a packet for the referee: it is on the air as any other, and no robot hears it.

        Its backlog is one of its own: the referee hears one message a tick, which must not silence the team's radio.
        """
        if self._has_room(data, len(self.to_referee), self._bytes_to_referee):
            self._bytes_to_referee += len(data)
            self.to_referee.append((self._arrival(data, now), data))

    def _has_room(self, data: bytes, packets: int, payload_bytes: int) -> bool:
        """Return whether a packet can wait behind so many others; else it is lost."""
        if not data or len(data) > self._max_packet_bytes:
            return False
        return not packets or (packets < BACKLOG_PACKETS and payload_bytes + len(data) <= BACKLOG_BYTES)

    def _arrival(self, data: bytes, now: int) -> int:
        """Return the tick at which a packet arrives that is sent at tick ``now``."""
        begin = max(self._free_from, now * self._per_tick)
        self._free_from = begin + len(data) * _BITS_PER_BYTE * _MS_PER_S
        return -(-self._free_from // self._per_tick)

    def arriving(self, tick: int) -> list[tuple[int, bytes]]:
        """Return (channel, data) of the packets that have arrived by ``tick``, in order, but not too many at once."""
        arrived: list[tuple[int, bytes]] = []
        while self.waiting and self.waiting[0][0] <= tick and len(arrived) < MOST_ARRIVE_A_TICK:
            _, channel, data = self.waiting.popleft()
            self._bytes -= len(data)
            arrived.append((channel, data))
        return arrived

    def told_referee(self, tick: int) -> bytes | None:
        """Return the next packet for the referee that has arrived by ``tick``, None if there is none."""
        if not self.to_referee or self.to_referee[0][0] > tick:
            return None
        _, data = self.to_referee.popleft()
        self._bytes_to_referee -= len(data)
        return data

    def fall_silent(self) -> None:
        """Drop all that has not arrived."""
        self.waiting.clear()
        self.to_referee.clear()
        self._bytes = self._bytes_to_referee = 0
        self._free_from = 0


class TeamRadio:
    """All emitters to all radio receivers of the same team.

    Receivers of the referee's packets are radios too: one that a program sets to its team's channel hears the team.
    """

    def __init__(self, emitters: list[Emitter], receivers: list[Receiver], teams: dict[int, str]) -> None:
        """Connect them.

        Args:
            emitters: in the order of robots.
            receivers: in the order of robots.
            teams: the entrant that drives each robot, by its index.
        """
        self._links = [
            (
                emitter,
                [r for r in receivers if r.robot != emitter.robot and teams[r.robot] == teams[emitter.robot]],
            )
            for emitter in emitters
        ]

    def carry(self, tick: int, poses: Poses) -> None:
        """Bring what arrives at ``tick`` to those who hear it: in robot order, each robot's in the order sent."""
        for emitter, listeners in self._links:
            if not emitter.waiting:
                continue
            if poses.robots[emitter.robot].parked:
                emitter.fall_silent()
                continue
            arriving = emitter.arriving(tick)
            if arriving:
                _spread(emitter, arriving, listeners, poses)


def _spread(emitter: Emitter, arriving: list[tuple[int, bytes]], listeners: list[Receiver], poses: Poses) -> None:
    source = poses.robots[emitter.robot]
    for receiver in listeners:
        # Every other receiver is the referee's: whether it listens at all is asked before where it is.
        if receiver.channel == ANY_CHANNEL:
            heard = arriving
        else:
            heard = [packet for packet in arriving if packet[0] == receiver.channel]
        pose = poses.robots[receiver.robot]
        if not heard or not receiver.period_ticks or pose.parked:
            continue
        dx, dy, dz = source.x - pose.x, source.y - pose.y, source.z - pose.z
        square = dx * dx + dy * dy + dz * dz
        if square > min(emitter.range_m, receiver.range_m) ** 2 or square == 0.0:
            continue
        inverse = 1 / math.sqrt(square)
        direction = pose.to_frame(dx * inverse, dy * inverse, dz * inverse)
        for _, data in heard:
            receiver.hear(Packet(receiver.device, data, 1 / square, direction))
