"""Builds the devices of a robot from kit and overrides, and the data that its program gets at its start."""

from __future__ import annotations

from collections.abc import Sequence

from rcj_challenges.core.traffic import DeviceSpec, RobotSpec
from rcj_challenges.devices.base import Fitted, FixedRay, RobotSetup
from rcj_challenges.devices.supervisor_receiver import SupervisorReceiverDevice
from rcj_challenges.robots.channels import listening_channels, team_channels
from rcj_challenges.scenario.kits import devices_of, kit_of, referee_listens
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster


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
        kit = kit_of(scenario, name)
        setup = RobotSetup(
            chassis=kit.chassis,
            messages=kit.messages,
            packet_every_ticks=kit.packet_every_ticks,
            max_packet_bytes=int(scenario.limits.message_kb * 1000),
            own_channel=channels[name],
            foreign_channels=tuple(sorted(set(channels.values()) - {channels[name]})),
            referee_channels=tuple(d.channel for d in devices.values() if isinstance(d, SupervisorReceiverDevice)),
            open_channels=listening_channels(scenario, devices.values()) if listens else (),
        )
        slot = 0
        for index, (device_name, device) in enumerate(devices.items()):
            spec = DeviceSpec(
                name=device_name,
                kind=device.CLASS,
                index=index,
                slot=slot if device.numbers else -1,
                width=device.numbers,
                facts=device.facts(setup),
            )
            slot += device.numbers
            fitted.append(Fitted(robot, name, device, spec, setup))
    return fitted


def fixed_rays(fitted: Sequence[Fitted]) -> list[FixedRay]:
    """Return the rays that the world carries along for devices, in their order."""
    rays = (one.device.fixed_ray(one.robot_name, one.spec.name, one.setup) for one in fitted)
    return [ray for ray in rays if ray is not None]


def robot_specs(scenario: Scenario, roster: Roster, fitted: Sequence[Fitted]) -> dict[int, RobotSpec]:
    """Return the data of each driven robot's program at its start, by index of the robot."""
    specs = {}
    for robot in driven_robots(scenario, roster):
        name = roster.entities[robot]
        kit = kit_of(scenario, name)
        devices = tuple(one.spec for one in fitted if one.robot == robot)
        specs[robot] = RobotSpec(
            name=name,
            devices=devices,
            values=sum(device.width for device in devices),  # integers
            getdata_returns="text" if kit.messages == "v2.2" else "bytes",
            max_velocity_radps=kit.chassis.max_wheel_radps,
        )
    return specs
