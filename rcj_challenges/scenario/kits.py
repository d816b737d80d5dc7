"""A robot's kit, chassis and devices (those of its kit and its own), and which robots can send the referee messages."""

from __future__ import annotations

from rcj_challenges.chassis.base import Chassis
from rcj_challenges.devices.base import Device
from rcj_challenges.devices.team_emitter import TeamEmitterDevice
from rcj_challenges.rules.base import Word
from rcj_challenges.scenario.models.robots import Kit
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.tree import Entries, child, entries_of, node_at, value_of
from rcj_challenges.scenario.walk import walk

_KIND = "device"


def kit_of(scenario: Scenario, robot_name: str) -> Kit:
    """Return the kit of a robot."""
    return scenario.kits[scenario.robots[robot_name].kit]


def devices_of(scenario: Scenario, robot_name: str) -> dict[str, Device]:
    """Return the devices of a robot by name: its kit's without those it lacks, then replaced or added ones."""
    robot = scenario.robots[robot_name]
    kit = kit_of(scenario, robot_name)
    devices = {name: device for name, device in kit.devices.items() if name not in robot.without}
    return devices | robot.devices


def chassis_of(scenario: Scenario, robot_name: str) -> Chassis:
    """Return the chassis of a robot's kit."""
    return kit_of(scenario, robot_name).chassis


def fill_in_devices(tree: Entries) -> None:
    """Complete the devices of robots that do not say what they are, from the device of the same name in the kit.

    ``robots: {Y1: {devices: {distancesensor front: {range_m: 0.4}}}}`` so shortens one sonar of one robot. Malformed
    parts are left to the checks that follow.
    """
    for robot in entries_of(tree.entries.get("robots")).values():
        own, kit = entries_of(child(robot, "devices")), str(value_of(child(robot, "kit")))
        for name, device in own.items():
            model = node_at(tree, ("kits", kit, "devices", name))
            if isinstance(device, Entries) and isinstance(model, Entries) and _KIND not in device.entries:
                entries, key_marks = model.entries | device.entries, model.key_marks | device.key_marks
                own[name] = Entries(entries, device.mark, key_marks)


def referee_listens(scenario: Scenario) -> bool:
    """Return whether a rule or the broadcast reads messages of robots.

    If none does, the referee's channels are closed to programs, as in the original.
    """
    words = (word for word, _ in walk((scenario.rules, scenario.broadcast)) if isinstance(word, Word))
    return any(word.READS_MESSAGES for word in words)


def robots_with_emitter(scenario: Scenario) -> list[str]:
    """Return the robots that have a program and an emitter, in the order of the file."""
    driven = {name for entrant in scenario.entrants.values() for name in entrant.robots}
    return [
        name
        for name in scenario.robots
        if name in driven and any(isinstance(one, TeamEmitterDevice) for one in devices_of(scenario, name).values())
    ]
