"""Team radio: no occlusion, no other team's channel."""

from __future__ import annotations

import math

from rcj_challenges.core.traffic import Packet
from rcj_challenges.devices.receivers import ANY_CHANNEL, Receiver
from rcj_challenges.devices.team_emitter import Emitter
from rcj_challenges.world.poses import Poses


class TeamRadio:
    """All emitters to all radio receivers of the same team.

    Receivers of the referee's packets are radios too: one that a program sets to its team's channel receives
    the team's packets.
    """

    def __init__(self, emitters: list[Emitter], receivers: list[Receiver], teams: dict[int, str]) -> None:
        """Connect emitters and receivers, in the order of robots; ``teams`` has the entrant that drives each robot."""
        self._links = [
            (one, [r for r in receivers if r.robot != one.robot and teams[r.robot] == teams[one.robot]])
            for one in emitters
        ]

    def carry(self, tick: int, poses: Poses) -> None:
        """Deliver the packets that arrive at ``tick``: in robot order, those of a robot in the order sent."""
        for emitter, listeners in self._links:
            if not emitter.waiting:
                continue
            if poses.parked[emitter.robot]:
                emitter.clear()
                continue
            if arriving := emitter.arriving(tick):
                _spread(emitter, arriving, listeners, poses)


def _spread(emitter: Emitter, arriving: list[tuple[int, bytes]], listeners: list[Receiver], poses: Poses) -> None:
    source = poses.robots[emitter.robot]
    for receiver in listeners:
        # Every other receiver is the referee's: whether it listens at all is asked before where it is.
        received = [packet for packet in arriving if receiver.channel in (packet[0], ANY_CHANNEL)]
        if not received or not receiver.period_ticks or poses.parked[receiver.robot]:
            continue
        pose = poses.robots[receiver.robot]
        dx, dy, dz = source.x - pose.x, source.y - pose.y, source.z - pose.z
        square = dx * dx + dy * dy + dz * dz
        if square > min(emitter.range_m, receiver.range_m) ** 2 or square == 0.0:
            continue
        inverse = 1 / math.sqrt(square)
        direction = pose.to_frame(dx * inverse, dy * inverse, dz * inverse)
        for _, data in received:
            receiver.receive(Packet(receiver.device, data, 1 / square, direction))
