"""The referee's radio: its packet, and the scenario's broadcast after it."""

from __future__ import annotations

import json
import struct
from collections.abc import Callable, Iterator
from typing import Any

from rcj_challenges.core.play import RefereeOutput
from rcj_challenges.core.traffic import Packet
from rcj_challenges.devices.receivers import ANY_CHANNEL, Receiver
from rcj_challenges.scenario.models.robots import Kit
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.world.poses import Poses

_Addressed = tuple[bytes, frozenset[int] | None]
"""A packet, and the robots that it is for; None: for all."""

STRENGTH = 1.0
DIRECTION = (0.0, 0.0, 1.0)
"""The referee has no place on the field: its packets come from 1 m above the receiver."""


def positions_2021(kit: Kit, roster: Roster, poses: Poses, *, waiting: bool) -> bytes:
    """Return the packet of 2021: per listed robot X, Z and orientation, per ball X and Z, then the flag.

    X is our y and Z is our x; the orientation is the yaw (reference, 4.2). Native byte order, as programs unpack it.
    """
    numbers: list[float] = []
    for name in kit.packet_lists:
        pose = poses.robots[roster.index[name]]
        numbers += (pose.y, pose.x, pose.yaw)
    for x, y, _ in poses.balls:
        numbers += (y, x)
    if kit.packet_has_flag:
        return struct.pack(f"{len(numbers)}d?", *numbers, waiting)
    return struct.pack(f"{len(numbers)}d", *numbers)


class RefereeRadio:
    """The referee's transmitter for all robots of one kit.

    A packet goes out after the referee's output of a tick and arrives in the next: observation k holds the packet of
    tick k-1. The robots of 2021 received none of tick 0, for their referee sent after its first step.
    """

    def __init__(self, kit: Kit, roster: Roster, receivers: list[tuple[Receiver, frozenset[int]]]) -> None:
        """Connect the receivers of the kit's robots, each with the channels on which the referee sends to it."""
        self._kit = kit
        self._roster = roster
        self._receivers = receivers
        self._robots = frozenset(receiver.robot for receiver, _ in receivers)
        self._listening: list[Receiver] = []
        self._flags = {waiting: struct.pack("?", waiting) for waiting in (False, True)}
        if kit.messages == "v2.2":
            self._flags = {waiting: json.dumps({"waiting_for_kickoff": waiting}).encode() for waiting in (False, True)}
        self._sent: tuple[_Addressed, ...] = ()
        self._objects: tuple[_Addressed, ...] = ()
        self._deliveries: dict[_Addressed, list[tuple[Callable[[Packet], None], Packet]]] = {}

    def retune(self) -> None:
        """Look up the receivers that listen. To be called when a receiver was enabled, disabled or tuned."""
        self._listening = [
            receiver
            for receiver, channels in self._receivers
            if receiver.period_ticks
            and (receiver.channel in channels or (channels and receiver.channel == ANY_CHANNEL))
        ]
        self._deliveries.clear()

    def transmit(self, tick: int, output: RefereeOutput, poses: Poses) -> None:
        """Send the packets after the output of ``tick``, if the kit's referee sends at this tick."""
        if output.broadcast is not None:
            self._objects = tuple(self._objects_of(output.broadcast, output.private_broadcasts or {}))
        if tick % self._kit.packet_every_ticks or (tick == 0 and self._kit.messages == "2021"):
            return
        waiting = output.waiting_for_kickoff
        is_2021 = self._kit.messages == "2021"
        official = positions_2021(self._kit, self._roster, poses, waiting=waiting) if is_2021 else self._flags[waiting]
        self._sent = ((official, None), *self._objects)
        self._objects = ()

    def carry(self) -> None:
        """Bring the packets of the last tick to the receivers that listen."""
        for sent in self._sent:
            for receive, packet in self._deliveries.get(sent) or self._addressed(sent):
                receive(packet)
        self._sent = ()

    def _objects_of(self, to_all: dict[str, Any], to_some: dict[int, dict[str, Any]]) -> Iterator[_Addressed]:
        """Return the broadcast for each robot; an empty one is not sent."""
        for robot, own in to_some.items():
            yield json.dumps({**to_all, **own}).encode(), frozenset({robot})
        if to_all:
            yield json.dumps(to_all).encode(), self._robots.difference(to_some)

    def _addressed(self, sent: _Addressed) -> list[tuple[Callable[[Packet], None], Packet]]:
        """Return the receivers of a packet, each with its copy; kept, for the same flag is sent for minutes."""
        if len(self._deliveries) >= _REMEMBERED:
            self._deliveries.clear()
        data, robots = sent
        receivers = [one for one in self._listening if robots is None or one.robot in robots]
        packets = {one.device: Packet(one.device, data, STRENGTH, DIRECTION) for one in receivers}
        self._deliveries[sent] = [(one.receive, packets[one.device]) for one in receivers]
        return self._deliveries[sent]


_REMEMBERED = 64
"""Packets kept for reuse."""
