"""Which devices a robot carries: from kit and overrides to what its program is told before it starts."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from rcj_challenges.devices.channels import ANY_CHANNEL, listening_channels, team_channels
from rcj_challenges.facts.traffic import DeviceSpec, RobotSpec
from rcj_challenges.rules.fields import Strict
from rcj_challenges.scenario.heard import referee_listens
from rcj_challenges.scenario.models import robots as models
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.own_devices import devices_of
from rcj_challenges.scenario.roster import Roster

RADIO_RANGE_M = 10.0
"""How far a receiver of the referee's packets hears. Source: reference, 4.1."""

LIDAR_LOWEST_HZ = 1.0
LIDAR_HIGHEST_HZ = 25.0
"""Bounds of ``setFrequency``, as in the Webots reference (Lidar: minFrequency, maxFrequency)."""


@dataclass(frozen=True)
class Fitted:
    """A device in its place on a robot.

    Attributes:
        robot: index of the robot in the roster.
        robot_name: ``Y1``.
        device: its entry in the scenario.
        spec: what the program is told of it.
    """

    robot: int
    robot_name: str
    device: models.Device
    spec: DeviceSpec


@dataclass(frozen=True)
class _Surroundings:
    """What a device's facts may depend on beside the device."""

    kit: models.Kit
    max_packet_bytes: int
    own_channel: int
    foreign_channels: tuple[int, ...]
    referee_channels: tuple[int, ...]
    open_channels: tuple[int, ...]  # those of the referee's on which it listens


@dataclass(frozen=True)
class _Kind:
    """How one word of the scenario's ``devices`` appears to a program."""

    kind: str
    width: Callable[[Any], int]
    facts: Callable[[Any, _Surroundings], dict[str, Any]]


def _sonar_facts(sonar: models.SonarDevice, _: _Surroundings) -> dict[str, Any]:
    return {"min_value": 0.0, "max_value": 1000.0 * sonar.range_m, "bearing_rad": sonar.bearing_rad}


def _team_receiver_facts(receiver: models.TeamReceiverDevice, around: _Surroundings) -> dict[str, Any]:
    return {
        "channel": around.own_channel,
        "range": receiver.range_m,
        "refused_channels": list(around.foreign_channels),
    }


def _team_emitter_facts(emitter: models.TeamEmitterDevice, around: _Surroundings) -> dict[str, Any]:
    heard_by_referee = {"referee_channels": list(around.open_channels)} if around.open_channels else {}
    return {
        **heard_by_referee,
        "channel": around.own_channel,
        "range": emitter.range_m,
        "baud_rate": emitter.baud,
        "max_packet_bytes": around.max_packet_bytes,
        "refused_channels": sorted(
            {ANY_CHANNEL, *around.foreign_channels, *around.referee_channels} - {*around.open_channels}
        ),
    }


def _supervisor_receiver_facts(receiver: models.SupervisorReceiverDevice, around: _Surroundings) -> dict[str, Any]:
    facts = {"channel": receiver.channel, "range": RADIO_RANGE_M, "refused_channels": list(around.foreign_channels)}
    if around.kit.messages == "2021":  # what is said after a tick is heard in the next one
        facts["silent_ticks"] = around.kit.packet_every_ticks
    return facts


def is_full_turn(lidar: models.LidarDevice) -> bool:
    """Return whether a lidar looks all around; a turn that was rounded is one."""
    return math.isclose(lidar.field_of_view_rad, 2 * math.pi, rel_tol=1e-4)


def lidar_bearings(lidar: models.LidarDevice) -> tuple[float, float]:
    """Return the bearing of cell 0 and the step from cell to cell, in rad, counter-clockwise from the front.

    A full turn begins at the front (reference, 4.2); a part of one spans from its left edge to its right edge. Both
    run clockwise.
    """
    if is_full_turn(lidar):
        return 0.0, -2 * math.pi / lidar.points
    if lidar.points == 1:
        return 0.0, 0.0
    return lidar.field_of_view_rad / 2, -lidar.field_of_view_rad / (lidar.points - 1)


def _lidar_facts(lidar: models.LidarDevice, _: _Surroundings) -> dict[str, Any]:
    first_rad, step_rad = lidar_bearings(lidar)
    return {
        "horizontal_resolution": lidar.points,
        "number_of_layers": 1,
        "number_of_points": lidar.points,
        "fov": lidar.field_of_view_rad,
        "vertical_fov": 0.0,
        "min_range": lidar.min_range_m,
        "max_range": lidar.max_range_m,
        "frequency": lidar.frequency_hz,
        "min_frequency": min(LIDAR_LOWEST_HZ, lidar.frequency_hz),
        "max_frequency": max(LIDAR_HIGHEST_HZ, lidar.frequency_hz),
        "rotating": lidar.rotating,
        "first_bearing_rad": first_rad,
        "bearing_step_rad": step_rad,
        **({"frame": lidar.frame} if lidar.frame != "field" else {}),
    }


def _motor_facts(_: models.MotorDevice, around: _Surroundings) -> dict[str, Any]:
    return {"max_velocity": around.kit.chassis.max_wheel_radps}


def _nothing(*_: Any) -> dict[str, Any]:
    return {}


def _numbers(count: int) -> Callable[[Any], int]:
    return lambda _: count


DEVICE_KINDS: dict[type[Strict], _Kind] = {
    models.MotorDevice: _Kind("motor", _numbers(0), _motor_facts),
    models.WheelSensorDevice: _Kind("position_sensor", _numbers(1), _nothing),
    models.GpsDevice: _Kind("gps", _numbers(3), _nothing),
    models.CompassDevice: _Kind("compass", _numbers(3), _nothing),
    models.SonarDevice: _Kind("distance_sensor", _numbers(1), _sonar_facts),
    models.BallReceiverDevice: _Kind(
        "receiver",
        _numbers(0),
        lambda device, _: {"channel": device.channel, "range": device.range_m, "refused_channels": []},
    ),
    models.SupervisorReceiverDevice: _Kind("receiver", _numbers(0), _supervisor_receiver_facts),
    models.TeamReceiverDevice: _Kind("receiver", _numbers(0), _team_receiver_facts),
    models.TeamEmitterDevice: _Kind("emitter", _numbers(0), _team_emitter_facts),
    models.LidarDevice: _Kind("lidar", lambda device: device.points, _lidar_facts),
}
"""What a program finds behind each word of the scenario."""


def driven_robots(scenario: Scenario, roster: Roster) -> tuple[int, ...]:
    """Return the indices of the robots that have a program: not idle, and named by an entrant."""
    named = {name for entrant in scenario.entrants.values() for name in entrant.robots}
    robots = roster.entities[: roster.robots]
    return tuple(i for i, name in enumerate(robots) if name in named and not scenario.robots[name].idle)


def fit(scenario: Scenario, roster: Roster) -> list[Fitted]:
    """Return all devices of all driven robots, by robot, then by device."""
    channels = team_channels(scenario)
    listens = referee_listens(scenario)
    fitted = []
    for robot in driven_robots(scenario, roster):
        name = roster.entities[robot]
        devices = devices_of(scenario, name)
        around = _Surroundings(
            kit=scenario.kits[scenario.robots[name].kit],
            max_packet_bytes=int(scenario.limits.message_kb * 1000),
            own_channel=channels[name],
            foreign_channels=tuple(sorted(set(channels.values()) - {channels[name]})),
            referee_channels=tuple(
                d.channel for d in devices.values() if isinstance(d, models.SupervisorReceiverDevice)
            ),
            open_channels=listening_channels(scenario, devices.values()) if listens else (),
        )
        slot = 0
        for index, (device_name, device) in enumerate(devices.items()):
            kind = DEVICE_KINDS[type(device)]
            width = kind.width(device)
            spec = DeviceSpec(
                name=device_name,
                kind=kind.kind,
                index=index,
                slot=slot if width else -1,
                width=width,
                facts=kind.facts(device, around),
            )
            slot += width
            fitted.append(Fitted(robot, name, device, spec))
    return fitted


def robot_specs(scenario: Scenario, roster: Roster, fitted: list[Fitted]) -> dict[int, RobotSpec]:
    """Return what each driven robot's program is told when it starts, by index of the robot."""
    specs = {}
    for robot in driven_robots(scenario, roster):
        name = roster.entities[robot]
        kit = scenario.kits[scenario.robots[name].kit]
        devices = tuple(one.spec for one in fitted if one.robot == robot)
        specs[robot] = RobotSpec(
            name=name,
            devices=devices,
            values=sum(device.width for device in devices),
            getdata_returns="text" if kit.messages == "v2.2" else "bytes",
            max_velocity_radps=kit.chassis.max_wheel_radps,
        )
    return specs
