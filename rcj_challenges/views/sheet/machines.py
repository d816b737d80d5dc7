"""The robots of a rule sheet: who drives them, their kits and devices, and how they talk to each other."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from rcj_challenges.devices.channels import entrant_of, team_channels
from rcj_challenges.scenario.models import robots as models
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.views.sheet.blocks import Block, Heading, Paragraph, Table
from rcj_challenges.views.sheet.nouns import Nouns, plain
from rcj_challenges.views.sheet.phrases import degrees, metres

_RADIO = (models.TeamEmitterDevice, models.TeamReceiverDevice)


def robot_blocks(scenario: Scenario, _nouns: Nouns) -> Iterator[Block]:
    """Return the section about the robots."""
    yield Heading(2, "Robots")
    owners = entrant_of(scenario)
    rows = [
        (plain(name), plain(robot.colour), _driver(robot, owners.get(name)), robot.kit)
        for name, robot in scenario.robots.items()
    ]
    yield Table(("robot", "colour", "driven by", "kit"), tuple(rows))
    used = {robot.kit for robot in scenario.robots.values() if not robot.idle}
    for kit_name, kit in scenario.kits.items():
        if kit_name in used:
            yield from _kit(kit_name, kit)
    for name, robot in scenario.robots.items():
        if robot.devices or robot.without:
            changes = [f"“{device}”: {device_words(model)}" for device, model in robot.devices.items()]
            changes += [f"no “{device}”" for device in robot.without]
            yield Paragraph(f"{plain(name)} differs from its kit: {'; '.join(changes)}.")
    channels = _radio_channels(scenario, owners)
    if channels:
        told = ", ".join(f"channel {channel} for {plain(seat)}" for seat, channel in channels.items())
        yield Paragraph(f"Team radio: {told}.")


def _driver(robot: models.Robot, owner: str | None) -> str:
    if robot.idle:
        return "none, it stands braked"
    return "nobody" if owner is None else f"program of {plain(owner)}"


def _kit(name: str, kit: models.Kit) -> Iterator[Block]:
    yield Heading(3, f"Kit {name}")
    chassis = kit.chassis
    top = chassis.wheel_radius_m * chassis.max_wheel_radps
    yield Paragraph(
        f"A cube of {metres(chassis.size_m)} on two wheels; top speed {top:g} m/s "
        f"at {chassis.max_wheel_radps:g} rad/s. Programs take a step every {kit.control_step_ms} ms; "
        f"messages are as in version {kit.messages}."
    )
    yield Table(("device", "what it is"), tuple((device, device_words(d)) for device, d in kit.devices.items()))


def _radio_channels(scenario: Scenario, owners: dict[str, str]) -> dict[str, int]:
    """Return the channel of each entrant that drives a robot with a team radio."""
    channels = team_channels(scenario)
    return {
        owners[name]: channels[name]
        for name, robot in scenario.robots.items()
        if name in owners and not robot.idle and _has_radio(scenario, robot)
    }


def _has_radio(scenario: Scenario, robot: models.Robot) -> bool:
    devices = {**scenario.kits[robot.kit].devices, **robot.devices}
    return any(isinstance(device, _RADIO) for name, device in devices.items() if name not in robot.without)


def device_words(device: models.Device) -> str:
    """Return what a device is, with its range and its noise."""
    return _DEVICES[device.device](device)


def _noise(*parts: str) -> str:
    told = " and ".join(filter(None, parts))
    return f" (noise: standard deviation {told})" if told else ""


def _percent(share: float, of: str) -> str:
    return f"{100 * share:g} % of {of}" if share else ""


def _ball_receiver(d: models.BallReceiverDevice) -> str:
    direction = f"{degrees(d.direction_noise_rad)} of the direction" if d.direction_noise_rad else ""
    return (
        f"infra-red receiver of the ball, up to {metres(d.range_m)}"
        f"{_noise(_percent(d.strength_noise, 'the strength'), direction)}"
    )


def _sonar(d: models.SonarDevice) -> str:
    noise = _noise(_percent(d.noise, "the value from 1 m on, less when nearer"))
    return f"distance sensor, bearing {round(d.bearing_rad * 57.29578)}°, up to {metres(d.range_m)}{noise}"


def _lidar(d: models.LidarDevice) -> str:
    turning = f", turning at {d.frequency_hz:g} Hz" if d.rotating else ""
    noise = _noise(metres(d.noise_m) if d.noise_m else "")
    return f"lidar, {d.points} points, {metres(d.min_range_m)} to {metres(d.max_range_m)}{turning}{noise}"


_DEVICES: dict[str, Callable[[Any], str]] = {
    "motor": lambda d: f"motor of the {d.wheel} wheel",
    "wheel_sensor": lambda d: f"angle of the {d.wheel} wheel",
    "gps": lambda d: f"position of the robot{_noise(metres(d.noise_m) if d.noise_m else '')}",
    "compass": lambda d: f"direction of north{_noise(degrees(d.noise_rad) if d.noise_rad else '')}",
    "sonar": _sonar,
    "ball_receiver": _ball_receiver,
    "supervisor_receiver": lambda d: f"receiver of the referee's packets, channel {d.channel}",
    "team_receiver": lambda d: f"team radio, receives from up to {metres(d.range_m)}",
    "team_emitter": lambda d: f"team radio, sends up to {metres(d.range_m)} far, {d.baud} baud",
    "lidar": _lidar,
}
