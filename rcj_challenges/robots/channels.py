"""The radio channel of each robot."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import chain

from rcj_challenges.devices.base import Device
from rcj_challenges.devices.supervisor_receiver import SupervisorReceiverDevice
from rcj_challenges.scenario.models.scenario import Scenario


def entrant_of(scenario: Scenario) -> dict[str, str]:
    """Return the entrant that drives each robot, by the robot's name. A robot named twice belongs to the first."""
    owners: dict[str, str] = {}
    for entrant, entry in scenario.entrants.items():
        for robot in entry.robots:
            owners.setdefault(robot, entrant)
    return owners


def team_channels(scenario: Scenario) -> dict[str, int]:
    """Return the team radio channel of each driven robot, by its name.

    A team is an entrant: all its robots share its ``radio_channel``, whatever their colour. In a match that is blue
    2 and yellow 3; in a challenge with one entrant that drives both colours they are one team, and all receive
    each other's packets. Two entrants never share a channel, nor does one have the referee's: an entrant that names a
    channel already taken gets the next free one.
    """
    owners = entrant_of(scenario)
    referee = referee_channels(scenario)
    by_entrant: dict[str, int] = {}
    for name, entrant in scenario.entrants.items():
        channel = entrant.radio_channel
        while channel in by_entrant.values() or channel in referee:
            channel += 1
        by_entrant[name] = channel
    return {robot: by_entrant[entrant] for robot, entrant in owners.items()}


def listening_channels(scenario: Scenario, devices: Iterable[Device]) -> tuple[int, ...]:
    """Return the channels on which the referee receives from a robot with these devices, if it receives at all.

    They are those on which it sends to that robot, or to any, if this one has no receiver for it.
    """
    own = tuple(device.channel for device in devices if isinstance(device, SupervisorReceiverDevice))
    return own or tuple(sorted(referee_channels(scenario)))


def referee_channels(scenario: Scenario) -> set[int]:
    """Return all channels on which a referee sends to some robot."""
    kits = (device for kit in scenario.kits.values() for device in kit.devices.values())
    robots = (device for robot in scenario.robots.values() for device in robot.devices.values())
    return {device.channel for device in chain(kits, robots) if isinstance(device, SupervisorReceiverDevice)}
