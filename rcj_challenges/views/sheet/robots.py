"""The robots of a rule sheet: their programs, kits, devices and radio channels."""

from __future__ import annotations

from collections.abc import Iterator

from rcj_challenges.core.grouping import grouped
from rcj_challenges.devices.base import Device
from rcj_challenges.devices.team_emitter import TeamEmitterDevice
from rcj_challenges.devices.team_receiver import TeamReceiverDevice
from rcj_challenges.robots.channels import entrant_of, team_channels
from rcj_challenges.rules.phrasing import heading, metres_alike, plain
from rcj_challenges.scenario.halves import in_half
from rcj_challenges.scenario.kits import devices_of
from rcj_challenges.scenario.models import robots as models
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.shapes import point_words
from rcj_challenges.views.sheet.document import Block, Table

_RADIO = (TeamEmitterDevice, TeamReceiverDevice)


def robot_blocks(scenario: Scenario) -> Iterator[Block]:
    """Yield the facts of the robots, in the first half if teams take theirs along."""
    if scenario.match.swap_sides and any(entrant.kits for entrant in scenario.entrants.values()):
        first = f"the first {scenario.match.period}"
        yield f"Teams take their robots along when they change sides; these are those of {first}."
    scenario = in_half(scenario, 1)
    owners = entrant_of(scenario)
    starts = [
        (plain(name), plain(robot.colour), _driver(robot, owners.get(name)), robot.kit, _start(robot.start))
        for name, robot in scenario.robots.items()
    ]
    yield Table(("robot", "colour", "program", "kit", "start (x, y in m)"), tuple(starts))
    if any(any(robot.start.noise_m) for robot in scenario.robots.values()):
        yield (
            "Each time a robot is put at its start, chance shifts it by up to ±, all shifts in this range being "
            "equally likely."
        )
    for kit_name, kit in scenario.kits.items():
        members = [name for name, robot in scenario.robots.items() if robot.kit == kit_name]
        if members:
            yield f"Kit {kit_name}: {_body(kit)}"
        if driven := [name for name in members if not scenario.robots[name].idle]:
            steps = f"Programs for the kit {kit_name} usually take steps of {kit.control_step_ms} ms"
            yield f"{steps}; messages are as in version {kit.messages}."
            rows = _device_rows(scenario, driven)
            yield Table((f"device of {kit_name}", "robots", "what it is"), tuple(rows))
    yield from dict.fromkeys(
        f"Team radio: channel {team_channels(scenario)[name]} for {plain(owners[name])}."
        for name in scenario.robots
        if name in owners and has(scenario, name, *_RADIO)
    )


def has(scenario: Scenario, robot: str, *kinds: type[Device]) -> bool:
    """Return whether a robot that a program drives has a device of one of these kinds."""
    is_idle = scenario.robots[robot].idle
    return not is_idle and any(isinstance(device, kinds) for device in devices_of(scenario, robot).values())


def _device_rows(scenario: Scenario, robots: list[str]) -> Iterator[tuple[str, str, str]]:
    carriers = grouped(
        ((name, device.describe()), robot) for robot in robots for name, device in devices_of(scenario, robot).items()
    )
    for (name, words), those in carriers.items():
        yield name, "all" if those == robots else ", ".join(map(plain, those)), words


def _driver(robot: models.Robot, owner: str | None) -> str:
    if robot.idle:
        return "none, it stands braked"
    return "none" if owner is None else f"of {plain(owner)}"


def _start(start: models.StartPose) -> str:
    """Return the start of a robot: ``(0.3, 0.3), ± 7.5 cm in x, facing 90° clockwise from +x``."""
    wide = zip("xy", metres_alike(start.noise_m), start.noise_m, strict=True)
    noise = "".join(f", ± {words} in {axis}" for axis, words, wide_m in wide if wide_m)
    return f"{point_words((start.x_m, start.y_m))}{noise}, facing {heading(start.yaw_rad)}"


def _body(kit: models.Kit) -> str:
    shown = " Pictures show its front at the other end." if kit.looks_along == "-x" else ""
    return f"{kit.chassis.describe()}.{shown}"
