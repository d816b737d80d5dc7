"""The devices of a robot: those of its kit and its own, which take from the kit what they leave out."""

from __future__ import annotations

from rcj_challenges.devices.base import Device
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.tree import Entries, Leaf, Node

_KIND = "device"


def devices_of(scenario: Scenario, robot_name: str) -> dict[str, Device]:
    """Return the devices of a robot by name: its kit's without those it lacks, then replaced or added ones."""
    robot = scenario.robots[robot_name]
    devices = {name: device for name, device in scenario.kits[robot.kit].devices.items() if name not in robot.without}
    return devices | robot.devices


def fill_in_devices(tree: Entries) -> None:
    """Complete the devices of robots that do not say what they are, from the device of the same name in the kit.

    ``robots: {Y1: {devices: {distancesensor front: {range_m: 0.4}}}}`` so shortens one sonar of one robot.

    Args:
        tree: a finished tree; malformed parts are left to the checks that follow.
    """
    for robot in _entries(tree, "robots"):
        if not isinstance(robot, Entries):
            continue
        own, kit = robot.entries.get("devices"), robot.entries.get("kit")
        if not isinstance(own, Entries) or not isinstance(kit, Leaf):
            continue
        in_kit = _child(_child(_child(tree, "kits"), str(kit.value)), "devices")
        for name, device in own.entries.items():
            model = _child(in_kit, name)
            if isinstance(device, Entries) and isinstance(model, Entries) and _KIND not in device.entries:
                own.entries[name] = Entries(
                    model.entries | device.entries, device.mark, model.key_marks | device.key_marks
                )


def _child(node: Node | None, key: str) -> Node | None:
    return node.entries.get(key) if isinstance(node, Entries) else None


def _entries(tree: Entries, section: str) -> list[Node]:
    found = tree.entries.get(section)
    return list(found.entries.values()) if isinstance(found, Entries) else []
