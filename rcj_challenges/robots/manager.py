"""All devices of all robots in one half, as the match loop uses them.

A tick of the match: `apply` what the programs that were due have asked for; physics, referee and placements;
`begin_sensing`; then robot by robot `finish_sensing`, and `observe` if its program is due: the first programs compute
while the later robots are still being read.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache, partial

from rcj_challenges.core.grouping import grouped
from rcj_challenges.core.play import HalfInfo, RefereeOutput
from rcj_challenges.core.traffic import Observation, Request, RobotSpec
from rcj_challenges.devices.base import Fitted, Sensor, SensorContext
from rcj_challenges.devices.motor import Motors
from rcj_challenges.devices.receivers import TRIM_EVERY_TICKS, Queue
from rcj_challenges.robots.cameras import Cameras
from rcj_challenges.robots.fitting import driven_robots, fit, robot_specs
from rcj_challenges.robots.radio_hub import RadioHub
from rcj_challenges.robots.sensors import RobotSensors
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.world.camera_renderer import CameraRenderer
from rcj_challenges.world.poses import Poses
from rcj_challenges.world.rays import WorldRays
from rcj_challenges.world.world import World


class DeviceManager:
    """What programs can read and set, for one half; ``specs`` are by index of the robot, idle ones are absent."""

    def __init__(self, scenario: Scenario, roster: Roster, world: World, half: HalfInfo) -> None:
        """Fit all robots; the world was compiled with the `fixed_rays` of their devices."""
        fitted = fit(scenario, roster)
        robots = driven_robots(scenario, roster)
        self.specs: dict[int, RobotSpec] = robot_specs(scenario, roster, fitted)
        self._poses = Poses(scenario, roster, world)
        self._queues = {robot: Queue() for robot in robots}
        rays = WorldRays(scenario, world)
        make_sight = cache(partial(CameraRenderer, scenario, roster, world))
        sensors = _make_sensors(fitted, SensorContext(half, rays, self._poses, make_sight))
        self._sensors = {
            robot: RobotSensors(sensors.get(robot, {}), self.specs[robot].values, self._poses.robots[robot])
            for robot in robots
        }
        self._radio = RadioHub(scenario, roster, rays, half, fitted, self._queues)
        self._cameras = Cameras(fitted, make_sight, half, self._queues)
        self._motors = {robot: Motors([one for one in fitted if one.robot == robot], world) for robot in robots}
        self._silent: set[int] = set()
        self._tick = 0

    def begin(self, output: RefereeOutput) -> None:
        """Start the half: the world stands as placed at tick 0, and ``output`` is that of tick 0."""
        self._poses.refresh()
        self._radio.transmit(0, output, self._poses)

    def apply(self, robot: int, request: Request) -> None:
        """Carry out a program's request now: it takes effect in the physics that follows."""
        if robot in self._silent:
            return
        _, _, motors, emissions, sampling, channels, frequencies = request
        if channels or sampling or frequencies:  # rare
            for device, channel in channels:
                self._radio.set_channel(robot, device, channel)
            for device, period_ticks in sampling:
                self._set_period(robot, device, period_ticks)
            for device, frequency_hz in frequencies:
                self._sensors[robot].set_frequency(device, frequency_hz)
        wheels = self._motors[robot]
        for command in motors:
            wheels.command(command)
        if emissions and not self._poses.parked[robot]:
            for device, channel, data in emissions:
                self._radio.send(robot, device, channel, data, self._tick)

    def silence(self, robot: int) -> None:
        """End a robot's part: its program is dead. Wheels at velocity 0, nothing sent or received any more."""
        self._silent.add(robot)
        self._motors[robot].stop()
        self._radio.silence(robot)
        self._cameras.silence(robot)
        self._sensors[robot].close(self._tick)

    def messages_to_referee(self, tick: int) -> tuple[tuple[int, str], ...]:
        """Return the messages that have reached the referee by ``tick``, as `Snapshot.messages`."""
        return self._radio.messages_to_referee(tick, self._poses)

    def sense(self, tick: int, output: RefereeOutput) -> None:
        """Sense for all robots: `begin_sensing`, then `finish_sensing` for each."""
        self.begin_sensing(tick, output)
        for robot in self._queues:
            self.finish_sensing(robot)

    def begin_sensing(self, tick: int, output: RefereeOutput) -> None:
        """Begin sensing the world after the placements of ``tick``, for all robots at once; deliver radio packets.

        Ticks count up by one from call to call, beginning at 1. Programs receive the output of a tick at the next.
        """
        self._tick = tick
        poses = self._poses
        poses.refresh()
        if tick % TRIM_EVERY_TICKS == 0:
            for queue in self._queues.values():
                queue.trim()
        self._radio.carry(tick, poses)
        self._radio.transmit(tick, output, poses)
        self._cameras.expose(tick, poses)

    def finish_sensing(self, robot: int) -> None:
        """Read the sensors of one robot, and deliver the balls' infra-red.

        To be called once for each robot after each `begin_sensing`, while the world has not moved.
        """
        self._sensors[robot].read(self._tick)
        self._radio.carry_infrared(robot, self._tick, self._poses)

    def observe(self, robot: int, tick: int, over: bool = False) -> Observation:
        """Return the observation of a program whose step ends at ``tick``; its queue is empty afterwards."""
        return Observation(tick, self._sensors[robot].values.copy(), self._queues[robot].take(), over)

    def _set_period(self, robot: int, device: int, period_ticks: int) -> None:
        if self._radio.set_period(robot, device, period_ticks, self._tick):
            return
        if self._cameras.set_period(robot, device, period_ticks):
            return
        self._sensors[robot].set_period(device, period_ticks, self._tick)


def _make_sensors(fitted: Sequence[Fitted], context: SensorContext) -> dict[int, dict[int, Sensor]]:
    made: dict[int, dict[int, Sensor]] = {}
    for kind, some in grouped((type(one.device), one) for one in fitted).items():
        for one, sensor in zip(some, kind.make_sensors(some, context), strict=True):
            if sensor is not None:
                made.setdefault(one.robot, {})[one.spec.index] = sensor
    return made
