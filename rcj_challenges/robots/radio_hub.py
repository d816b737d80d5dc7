"""The radio hub: builds all receivers and emitters of the robots, and carries what is sent in each tick."""

from __future__ import annotations

from collections.abc import Sequence

from rcj_challenges.core.grouping import grouped
from rcj_challenges.core.messages import message_text
from rcj_challenges.core.play import HalfInfo, RefereeOutput
from rcj_challenges.devices.ball_receiver import BallReceiver, BallReceiverDevice
from rcj_challenges.devices.base import Fitted, Rays
from rcj_challenges.devices.receivers import TRIM_EVERY_TICKS, Queue, Receiver, ReceiverDevice
from rcj_challenges.devices.supervisor_receiver import SupervisorReceiverDevice
from rcj_challenges.devices.team_emitter import Emitter, TeamEmitterDevice
from rcj_challenges.robots.channels import entrant_of
from rcj_challenges.robots.infrared import Infrared
from rcj_challenges.robots.referee_radio import RefereeRadio
from rcj_challenges.robots.team_radio import TeamRadio
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.world.poses import Poses


class RadioHub:
    """Infra-red, team radio and the referee's packets."""

    def __init__(
        self,
        scenario: Scenario,
        roster: Roster,
        rays: Rays,
        half: HalfInfo,
        fitted: Sequence[Fitted],
        queues: dict[int, Queue],
    ) -> None:
        self._receivers: dict[tuple[int, int], Receiver] = {}
        self._slow: dict[int, list[Receiver]] = {}  # by robot; robots without one are absent
        self._emitters: dict[tuple[int, int], Emitter] = {}
        self._refused: dict[tuple[int, int], frozenset[int]] = {}
        self._referees: dict[tuple[int, int], frozenset[int]] = {}
        radios: list[tuple[Fitted, Receiver]] = []
        ball_receivers: list[BallReceiver] = []
        for one in fitted:
            key = (one.robot, one.spec.index)
            facts = one.spec.facts
            if isinstance(one.device, ReceiverDevice):
                receiver = Receiver(*key, facts["channel"], facts["range"], queues[one.robot])
                self._receivers[key] = receiver
                if isinstance(one.device, BallReceiverDevice):
                    ball_receivers.append(BallReceiver(receiver, one, roster.balls, half))
                else:
                    radios.append((one, receiver))
            elif isinstance(one.device, TeamEmitterDevice):
                self._emitters[key] = Emitter(one.robot, facts["range"], facts["baud_rate"], facts["max_packet_bytes"])
            if "refused_channels" in facts:
                self._refused[key] = frozenset(facts["refused_channels"])
            if "referee_channels" in facts:
                self._referees[key] = frozenset(facts["referee_channels"])
        owners = entrant_of(scenario)
        teams = {one.robot: owners[one.robot_name] for one in fitted}
        self._infrared = Infrared(scenario, roster, rays, ball_receivers)
        self._team = TeamRadio(list(self._emitters.values()), [receiver for _, receiver in radios], teams)
        self._referee = _referee_radios(scenario, roster, radios)

    def set_period(self, robot: int, device: int, period_ticks: int, now: int) -> bool:
        """Set the sampling period of a receiver; False if the device is none."""
        receiver = self._receivers.get((robot, device))
        if receiver is None:
            return False
        receiver.set_period(period_ticks, now)
        self._retune()
        return True

    def set_channel(self, robot: int, device: int, channel: int) -> None:
        """Tune a receiver; another team's channel is refused: it stays where it was."""
        key = (robot, device)
        if key in self._receivers and channel not in self._refused.get(key, ()):
            self._receivers[key].channel = channel
            self._retune()

    def send(self, robot: int, device: int, channel: int, data: bytes, now: int) -> None:
        """Queue a packet; it is lost on another team's channel, or on that of a referee that does not listen."""
        key = (robot, device)
        emitter = self._emitters.get(key)
        if emitter is None or channel in self._refused[key]:
            return
        if channel in self._referees.get(key, ()):
            emitter.send_to_referee(data, now)
        else:
            emitter.send(channel, data, now)

    def messages_to_referee(self, tick: int, poses: Poses) -> tuple[tuple[int, str], ...]:
        """Return the messages to the referee at ``tick``: of each robot on the field its next one that has arrived."""
        if not self._referees:  # as in all matches
            return ()
        received: dict[int, str] = {}
        for robot, device in self._referees:
            emitter = self._emitters[robot, device]
            if poses.parked[robot]:
                emitter.clear()
            elif robot not in received and (data := emitter.messages_to_referee(tick)) is not None:
                received[robot] = message_text(data)
        return tuple(received.items())

    def silence(self, robot: int) -> None:
        """Drop all unsent packets of a robot's emitters, and switch off its receivers."""
        for emitter in self._emitters.values():
            if emitter.robot == robot:
                emitter.clear()
        for receiver in self._receivers.values():
            if receiver.robot == robot:
                receiver.set_period(0, 0)
        self._retune()

    def _retune(self) -> None:
        self._slow = grouped((one.robot, one) for one in self._receivers.values() if one.slow)
        self._infrared.retune()
        for referee in self._referee:
            referee.retune()

    def transmit(self, tick: int, output: RefereeOutput, poses: Poses) -> None:
        """Send the referee's packets after its output of ``tick``."""
        for referee in self._referee:
            referee.transmit(tick, output, poses)

    def carry(self, tick: int, poses: Poses) -> None:
        """Deliver the referee's and the teams' packets that arrive at ``tick``."""
        for referee in self._referee:
            referee.carry()
        self._team.carry(tick, poses)

    def carry_infrared(self, robot: int, tick: int, poses: Poses) -> None:
        """Bring the balls' packets of ``tick`` to a robot; then its slow receivers deliver what they have received."""
        self._infrared.send(robot, tick, poses)
        if self._slow:
            for receiver in self._slow.get(robot, ()):
                receiver.deliver(tick)
                if tick % TRIM_EVERY_TICKS == 0:
                    receiver.trim()


def _referee_radios(
    scenario: Scenario, roster: Roster, radios: list[tuple[Fitted, Receiver]]
) -> list[RefereeRadio]:  # fmt: skip
    """Return one transmitter for each kit in use. It sends on the channels of its robots' supervisor receivers."""
    channels: dict[int, set[int]] = {}
    for one, _ in radios:
        if isinstance(one.device, SupervisorReceiverDevice):
            channels.setdefault(one.robot, set()).add(one.device.channel)
    by_kit = grouped(
        (scenario.robots[one.robot_name].kit, (receiver, frozenset(channels.get(one.robot, ()))))
        for one, receiver in radios
    )
    return [RefereeRadio(scenario.kits[kit], roster, receivers) for kit, receivers in by_kit.items()]
