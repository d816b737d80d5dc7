"""The robots of a rule sheet: who drives them, their kits and devices, and how they talk to each other."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from rcj_challenges.devices.channels import entrant_of, team_channels
from rcj_challenges.scenario.models import robots as models
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.own_devices import devices_of
from rcj_challenges.views.sheet.blocks import Block, Heading, Paragraph, Table
from rcj_challenges.views.sheet.nouns import Nouns, listed, plain
from rcj_challenges.views.sheet.phrases import degrees, metres

_RADIO = (models.TeamEmitterDevice, models.TeamReceiverDevice)


def robot_blocks(scenario: Scenario, nouns: Nouns) -> Iterator[Block]:
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
            yield from _kit(kit_name, kit, nouns)
    for name, robot in scenario.robots.items():
        if robot.devices or robot.without:
            changes = [f"“{device}”: {device_words(model, nouns)}" for device, model in robot.devices.items()]
            changes += [f"no “{device}”" for device in robot.without]
            yield Paragraph(f"{plain(name)} differs from its kit: {'; '.join(changes)}.")
    if sum(ball.emits for ball in scenario.balls.values()) > 1 and _any_has(scenario, models.BallReceiverDevice):
        yield Paragraph("A packet of infra-red does not tell which of the balls sent it.")
    channels = _radio_channels(scenario, owners)
    if channels:
        told = ", ".join(f"channel {channel} for {plain(seat)}" for seat, channel in channels.items())
        yield Paragraph(f"Team radio: {told}.")


def _driver(robot: models.Robot, owner: str | None) -> str:
    if robot.idle:
        return "none, it stands braked"
    return "nobody" if owner is None else f"program of {plain(owner)}"


def _kit(name: str, kit: models.Kit, nouns: Nouns) -> Iterator[Block]:
    yield Heading(3, f"Kit {name}")
    chassis = kit.chassis
    top = chassis.wheel_radius_m * chassis.max_wheel_radps
    yield Paragraph(
        f"A cube of {metres(chassis.size_m)} on two wheels; top speed {top:g} m/s "
        f"at {chassis.max_wheel_radps:g} rad/s. Programs take a step every {kit.control_step_ms} ms; "
        f"messages are as in version {kit.messages}."
    )
    yield Table(("device", "what it is"), tuple((device, device_words(d, nouns)) for device, d in kit.devices.items()))


def _radio_channels(scenario: Scenario, owners: dict[str, str]) -> dict[str, int]:
    """Return the channel of each entrant that drives a robot with a team radio."""
    channels = team_channels(scenario)
    return {
        owners[name]: channels[name]
        for name, robot in scenario.robots.items()
        if name in owners and not robot.idle and has(scenario, name, *_RADIO)
    }


def _any_has(scenario: Scenario, kind: type[models.Device]) -> bool:
    return any(has(scenario, name, kind) for name, robot in scenario.robots.items() if not robot.idle)


def has(scenario: Scenario, robot: str, *kinds: type[models.Device]) -> bool:
    """Return whether a robot has a device of one of these kinds, its kit's or its own."""
    return any(isinstance(device, kinds) for device in devices_of(scenario, robot).values())


def device_words(device: models.Device, nouns: Nouns) -> str:
    """Return what a device is, with its range and its noise."""
    if isinstance(device, models.BallReceiverDevice):
        return _ball_receiver(device, nouns)
    return _DEVICES[device.device](device)


def _noise(*parts: str) -> str:
    told = " and ".join(filter(None, parts))
    return f" (noise: standard deviation {told})" if told else ""


def _percent(share: float, of: str) -> str:
    return f"{100 * share:g} % of {of}" if share else ""


def _ball_receiver(d: models.BallReceiverDevice, nouns: Nouns) -> str:
    balls = nouns.scenario.balls
    heard = [nouns.thing(name) for name, ball in balls.items() if ball.emits]
    if not heard:
        return "infra-red receiver; it hears nothing, for no ball sends infra-red"
    direction = f"{degrees(d.direction_noise_rad)} of the direction" if d.direction_noise_rad else ""
    whom = f"{listed(heard, 'and')} only" if len(heard) < len(balls) else "the ball" if len(balls) == 1 else "all balls"
    return (
        f"infra-red receiver of {whom}, up to {metres(d.range_m)}"
        f"{_noise(_percent(d.strength_noise, 'the strength'), direction)}"
    )


def _sonar(d: models.SonarDevice) -> str:
    noise = _noise(_percent(d.noise, "the value from 1 m on, less when nearer"))
    if d.noise and d.range_m < models.SONAR_NOISE_FULL_FROM_M:
        # It never measures as far as where the noise stops growing: the figure that holds is that of its own range.
        full = _percent(d.noise * d.range_m, f"the value at {metres(d.range_m)}")
        noise = _noise(f"{full}, less when nearer: at half the distance half that share")
    return f"distance sensor, bearing {degrees(d.bearing_rad)}, up to {metres(d.range_m)}{noise}"


def _lidar(d: models.LidarDevice) -> str:
    turning = f", turning at {d.frequency_hz:g} Hz" if d.rotating else ""
    noise = _noise(metres(d.noise_m) if d.noise_m else "")
    order = _order(d, ", its points told as [left, up, ahead]")
    return f"lidar, {d.points} points, {metres(d.min_range_m)} to {metres(d.max_range_m)}{turning}{order}{noise}"


def _gps(d: models.GpsDevice) -> str:
    return f"position of the robot{_order(d, ', told as [y, z, x]')}{_noise(metres(d.noise_m) if d.noise_m else '')}"


def _compass(d: models.CompassDevice) -> str:
    noise = _noise(degrees(d.noise_rad) if d.noise_rad else "")
    return f"direction of north{_order(d, ', told as [left, up, ahead]')}{noise}"


def _order(d: models.GpsDevice | models.CompassDevice | models.LidarDevice, legacy: str) -> str:
    """Return in which order numbers are told, where that is not the usual one: a program reads others without it."""
    return f"{legacy} as in the worlds of 2021" if d.frame == "legacy" else ""


_DRIVES_BACK = "; a positive velocity drives against the robot's heading"
_FALLS_AHEAD = "; it falls while the robot drives along its heading"
_DEVICES: dict[str, Callable[[Any], str]] = {
    "motor": lambda d: f"motor of the {d.wheel} wheel{'' if d.direction > 0 else _DRIVES_BACK}",
    "wheel_sensor": lambda d: f"angle of the {d.wheel} wheel{'' if d.direction > 0 else _FALLS_AHEAD}",
    "gps": _gps,
    "compass": _compass,
    "sonar": _sonar,
    "supervisor_receiver": lambda d: f"receiver of the referee's packets, channel {d.channel}",
    "team_receiver": lambda d: f"team radio, receives from up to {metres(d.range_m)}",
    "team_emitter": lambda d: f"team radio, sends up to {metres(d.range_m)} far, {d.baud} baud",
    "lidar": _lidar,
}
