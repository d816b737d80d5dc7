"""The rack: all devices of all robots in one half, as the match loop uses them.

A tick of the match: `DeviceRack.apply` what the programs that were due have asked for; physics, verdict and
placements; `DeviceRack.begin_sensing`; then robot by robot `DeviceRack.finish_sensing`, and `DeviceRack.observe` if
its program is due: the first programs think while the later robots still look around.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from rcj_challenges.devices.body_sensors import Compasses, Gpses, WheelSensors
from rcj_challenges.devices.drive import Drive
from rcj_challenges.devices.fitting import Fitted, driven_robots, fit, robot_specs
from rcj_challenges.devices.ground import Ground
from rcj_challenges.devices.lidar import NOT_YET_SWEPT, Lidars
from rcj_challenges.devices.poses import Poses
from rcj_challenges.devices.radio_room import RadioRoom
from rcj_challenges.devices.receivers import TRIM_EVERY_TICKS, Queue
from rcj_challenges.devices.sampling import Family
from rcj_challenges.devices.sonar import Sonars
from rcj_challenges.facts.play import HalfInfo, Verdict
from rcj_challenges.facts.traffic import Observation, Request, RobotSpec
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster

Values = dict[int, list[float]]
"""By robot: the numbers of all its devices, by slot."""

Reader = Callable[[int, int, Poses, list[float]], None]
"""The `Family.read` of some family."""


class DeviceRack:
    """What programs can read and set, for one half.

    Attributes:
        specs: what each program is told when it starts, by index of its robot; idle robots are absent.
    """

    def __init__(self, scenario: Scenario, roster: Roster, world: Ground, half: HalfInfo) -> None:
        """Fit all robots.

        Args:
            scenario: kits, robots, entrants.
            roster: order of robots, balls, obstacles.
            world: compiled with `device_sites` as an extension of its model.
            half: number and seed, for the noise of sensors.
        """
        fitted = fit(scenario, roster)
        robots = driven_robots(scenario, roster)
        self.specs: dict[int, RobotSpec] = robot_specs(scenario, roster, fitted)
        self._ground = world
        self._poses = Poses(scenario, roster, world)
        self._queues = {robot: Queue() for robot in robots}
        self._values: Values = {robot: [math.nan] * self.specs[robot].values for robot in robots}
        self._radio = RadioRoom(scenario, roster, world, half, fitted, self._queues)
        self._drives = {robot: Drive(scenario, robot, fitted, world) for robot in robots}
        self._members: dict[tuple[int, int], tuple[Family[Any], int, Fitted]] = {}
        self._lidars: Lidars | None = None
        self._readers: dict[int, list[Reader]] = {robot: [] for robot in robots}
        self._families = self._build_families(scenario, roster, half, fitted)
        self._silent: set[int] = set()
        self._tick = 0

    def _build_families(
        self, scenario: Scenario, roster: Roster, half: HalfInfo, fitted: list[Fitted]
    ) -> list[Family[Any]]:  # fmt: skip
        """Build the families of which there are members; a kind that no robot has costs nothing."""
        of_kind: dict[str, list[Fitted]] = {}
        for one in fitted:
            of_kind.setdefault(one.spec.kind, []).append(one)
        families: list[Family[Any]] = []
        for kind, members in of_kind.items():
            family: Family[Any]
            if kind == "position_sensor":
                family = WheelSensors(members, self._ground)
            elif kind == "gps":
                family = Gpses(members, half)
            elif kind == "compass":
                family = Compasses(members, half)
            elif kind == "distance_sensor":
                family = Sonars(members, scenario, self._ground, half)
            elif kind == "lidar":
                family = self._lidars = Lidars(members, scenario, self._ground, half)
            else:  # motors and radio are no sensors
                continue
            families.append(family)
            for number, one in enumerate(members):
                self._members[one.robot, one.spec.index] = (family, number, one)
                self._blank(one)
            for robot in family.of_robot:
                self._readers[robot].append(family.read)
        return families

    def begin(self, verdict: Verdict) -> None:
        """Start the half: the world stands as placed at tick 0, and ``verdict`` is that of tick 0."""
        self._tick = 0
        self._poses.refresh()
        self._radio.speak(0, verdict, self._poses)

    def apply(self, robot: int, request: Request) -> None:
        """Carry out what a program asked for, now: it takes effect in the physics that follows."""
        if robot in self._silent:
            return
        for device, channel in request.channels:
            self._radio.set_channel(robot, device, channel)
        for device, period_ticks in request.sampling:
            self._set_period(robot, device, period_ticks)
        for device, frequency_hz in request.frequencies:
            self._set_frequency(robot, device, frequency_hz)
        drive = self._drives[robot]
        for command in request.motors:
            drive.command(command)
        if not self._poses.robots[robot].parked:
            for device, data in request.emissions:
                self._radio.send(robot, device, data, self._tick)

    def silence(self, robot: int) -> None:
        """End a robot's part: its program is dead. Wheels at velocity 0, nothing sent or heard any more."""
        self._silent.add(robot)
        self._drives[robot].stop()
        self._radio.fall_silent(robot)
        for (owner, _), (family, number, _fitted) in self._members.items():
            if owner == robot:
                family.schedule.set(number, 0, self._tick)

    def sense(self, tick: int, verdict_now: Verdict) -> None:
        """Sense for all robots: `begin_sensing`, then `finish_sensing` for each."""
        self.begin_sensing(tick, verdict_now)
        for robot in self._queues:
            self.finish_sensing(robot)

    def begin_sensing(self, tick: int, verdict_now: Verdict) -> None:
        """Begin to look at the world as it stands after the placements of ``tick``; bring the radio's packets.

        This is what has to be done for all robots at once: `finish_sensing` does the rest, robot by robot.

        Args:
            tick: counts up by one from call to call, beginning at 1.
            verdict_now: the verdict of this tick; programs hear of it at the next.
        """
        self._tick = tick
        poses = self._poses
        poses.refresh()
        if tick % TRIM_EVERY_TICKS == 0:
            for queue in self._queues.values():
                queue.trim()
        for family in self._families:
            family.begin(tick)
        self._radio.carry(tick, poses)
        self._radio.speak(tick, verdict_now, poses)

    def finish_sensing(self, robot: int) -> None:
        """Let one robot read its sensors, and hear the balls' infra-red.

        To be called once for each robot after each `begin_sensing`, while the world has not moved.
        """
        tick, poses, own = self._tick, self._poses, self._values[robot]
        for read in self._readers[robot]:
            read(robot, tick, poses, own)
        self._radio.carry_infrared(robot, tick, poses)

    def observe(self, robot: int, tick: int, over: bool = False) -> Observation:
        """Return what a program is told when its step ends at ``tick``; its queue is empty afterwards."""
        return Observation(tick, self._values[robot].copy(), self._queues[robot].take(), over)

    def _set_period(self, robot: int, device: int, period_ticks: int) -> None:
        if self._radio.set_period(robot, device, period_ticks, self._tick):
            return
        member = self._members.get((robot, device))
        if member is None:
            return
        family, number, fitted = member
        family.schedule.set(number, period_ticks, self._tick)
        if not period_ticks:
            self._blank(fitted)
            if self._lidars is not None and family is self._lidars:
                self._lidars.lidars[number].clear()

    def _set_frequency(self, robot: int, device: int, frequency_hz: float) -> None:
        member = self._members.get((robot, device))
        if member is not None and self._lidars is not None and member[0] is self._lidars:
            self._lidars.lidars[member[1]].set_frequency(frequency_hz)

    def _blank(self, fitted: Fitted) -> None:
        """Make a device's numbers those of one that has not been sampled."""
        blank = NOT_YET_SWEPT if fitted.spec.kind == "lidar" else math.nan
        slot, width = fitted.spec.slot, fitted.spec.width
        self._values[fitted.robot][slot : slot + width] = [blank] * width
