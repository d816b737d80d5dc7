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

_Said = tuple[bytes, frozenset[int] | None]
"""A packet, and the robots that it is for; None: for all."""

STRENGTH = 1.0
DIRECTION = (0.0, 0.0, 1.0)
"""The referee has no place on the field: its packets come from 1 m above the receiver."""


def flag_bytes(*, waiting: bool) -> bytes:
    """Return the packet of v2.1: ``struct '?'``."""
    return struct.pack("?", waiting)


def flag_json(*, waiting: bool) -> bytes:
    """Return the packet of v2.2: JSON text."""
    return json.dumps({"waiting_for_kickoff": waiting}).encode()


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

    A packet goes out after the referee's output of a tick and is in the air until the next: observation k holds what
    was said after tick k-1. The robots of 2021 never heard of tick 0, for their referee spoke after its first step.
    """

    def __init__(self, kit: Kit, roster: Roster, receivers: list[tuple[Receiver, frozenset[int]]]) -> None:
        """Connect the receivers of the kit's robots, each with the channels on which the referee speaks to it."""
        self._kit = kit
        self._roster = roster
        self._receivers = receivers
        self._robots = frozenset(receiver.robot for receiver, _ in receivers)
        self._listening: list[Receiver] = []
        flag = flag_json if kit.messages == "v2.2" else flag_bytes
        self._flags = {waiting: flag(waiting=waiting) for waiting in (False, True)}
        self._in_the_air: tuple[_Said, ...] = ()
        self._objects: tuple[_Said, ...] = ()
        self._deliveries: dict[_Said, list[tuple[Callable[[Packet], None], Packet]]] = {}

    def retune(self) -> None:
        """Look up the receivers that listen. To be called when a receiver was enabled, disabled or tuned."""
        self._listening = [
            receiver
            for receiver, channels in self._receivers
            if receiver.period_ticks
            and (receiver.channel in channels or (channels and receiver.channel == ANY_CHANNEL))
        ]
        self._deliveries.clear()

    def speak(self, tick: int, output: RefereeOutput, poses: Poses) -> None:
        """Say what holds after the output of ``tick``, if the kit's referee speaks at this tick."""
        if output.broadcast is not None:
            self._objects = tuple(self._objects_of(output.broadcast, output.private_broadcasts or {}))
        if tick % self._kit.packet_every_ticks or (tick == 0 and self._kit.messages == "2021"):
            return
        official = self._official(poses, waiting=output.waiting_for_kickoff)
        self._in_the_air = ((official, None), *self._objects)
        self._objects = ()

    def carry(self) -> None:
        """Bring what was said after the last tick to the receivers that listen."""
        for said in self._in_the_air:
            for receive, packet in self._deliveries.get(said) or self._addressed(said):
                receive(packet)
        self._in_the_air = ()

    def _official(self, poses: Poses, *, waiting: bool) -> bytes:
        if self._kit.messages == "2021":
            return positions_2021(self._kit, self._roster, poses, waiting=waiting)
        return self._flags[waiting]

    def _objects_of(self, to_all: dict[str, Any], to_some: dict[int, dict[str, Any]]) -> Iterator[_Said]:
        """Return the broadcast for each robot; an empty one is not sent."""
        for robot, own in to_some.items():
            yield json.dumps({**to_all, **own}).encode(), frozenset({robot})
        if to_all:
            yield json.dumps(to_all).encode(), self._robots.difference(to_some)

    def _addressed(self, said: _Said) -> list[tuple[Callable[[Packet], None], Packet]]:
        """Return the receivers of a packet, each with its copy; kept, for the same flag is sent for minutes."""
        if len(self._deliveries) >= _REMEMBERED:
            self._deliveries.clear()
        data, robots = said
        hearing = [one for one in self._listening if robots is None or one.robot in robots]
        packets = {one.device: Packet(one.device, data, STRENGTH, DIRECTION) for one in hearing}
        delivery = [(receiver.receive, packets[receiver.device]) for receiver in hearing]
        self._deliveries[said] = delivery
        return delivery


_REMEMBERED = 64
"""Packets kept for reuse."""
