"""The robots of a rule sheet: who drives them, their kits and devices, and how they talk to each other."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import Any

from rcj_challenges.devices.channels import entrant_of, team_channels
from rcj_challenges.devices.fitting import is_full_turn
from rcj_challenges.facts.timing import TICK_S
from rcj_challenges.rules.phrasing import counted, degrees, heading, listed, metres, metres_alike, plain
from rcj_challenges.scenario.models import robots as models
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.own_devices import devices_of
from rcj_challenges.views.drawing.shapes import point_words
from rcj_challenges.views.sheet.blocks import Block, Heading, Paragraph, Table
from rcj_challenges.views.sheet.nouns import Nouns

_RADIO = (models.TeamEmitterDevice, models.TeamReceiverDevice)


def robot_blocks(scenario: Scenario, nouns: Nouns) -> Iterator[Block]:
    """Return the section about the robots."""
    yield Heading(2, "Robots")
    owners = entrant_of(scenario)
    rows = [
        (plain(name), plain(robot.colour), _driver(robot, owners.get(name)), robot.kit, _start(robot.start))
        for name, robot in scenario.robots.items()
    ]
    yield Table(("robot", "colour", "driven by", "kit", "start (x, y in m)"), tuple(rows), ends_in_words=True)
    if any(any(robot.start.noise_m) for robot in scenario.robots.values()):
        yield Paragraph(
            "Where ± stands, chance shifts a start by up to that much to either side, all shifts equally likely, each "
            "time the robot is put there."
        )
    driven = {robot.kit for robot in scenario.robots.values() if not robot.idle}
    standing = {robot.kit for robot in scenario.robots.values() if robot.idle}
    for kit_name, kit in scenario.kits.items():
        if kit_name in driven | standing:
            yield Heading(3, f"Kit {kit_name}")
            yield Paragraph(_body(kit))
        if kit_name in driven:
            yield from _kit(kit, nouns)
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


def _start(start: models.StartPose) -> str:
    """Return where a robot starts: ``(0.3, 0.3), ± 7.5 cm in x, facing 90° clockwise from +x``."""
    wide = zip("xy", metres_alike(start.noise_m), start.noise_m, strict=True)
    noise = "".join(f", ± {words} in {axis}" for axis, words, wide_m in wide if wide_m)
    return f"{point_words((start.x_m, start.y_m))}{noise}, facing {heading(start.yaw_rad)}"


def _body(kit: models.Kit) -> str:
    """Return what a robot's body is: what drives, weighs and is in the way."""
    chassis = kit.chassis
    top = chassis.wheel_radius_m * chassis.max_wheel_radps
    wheels_m = (chassis.wheel_track_m, chassis.wheel_radius_m, chassis.wheel_width_m)
    apart, radius, width = metres_alike(wheels_m)
    shown = (
        " Pictures show its front at the other end; what is measured and judged, and called forward, left and right "
        "here, goes by the way it faces."
    )
    return (
        f"A cube of {metres(chassis.size_m)} on two wheels; its mass is {chassis.mass_kg:g} kg, and "
        f"{chassis.wheel_mass_kg:g} kg that of each wheel. The wheels have a radius of {radius}, are {width} wide and "
        f"{apart} apart, from centre to centre; top speed {top:g} m/s at {chassis.max_wheel_radps:g} rad/s."
        + (shown if kit.looks_along == "-x" else "")
    )


def _kit(kit: models.Kit, nouns: Nouns) -> Iterator[Block]:
    """Return what programs of a kit have to do with."""
    yield Paragraph(
        f"Programs usually take steps of {kit.control_step_ms} ms; messages are as in version {kit.messages}."
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
    where = f"{metres(d.offset_m)} off the robot's centre and {metres(d.height_m)} above the floor"
    # At a right angle and more a ray meets nothing.
    lost = f", without an echo of what it meets at {degrees(d.lost_from_rad)} or more off the perpendicular"
    return (
        f"distance sensor, bearing {degrees(d.bearing_rad)}, up to {metres(d.range_m)}{noise}, {where}"
        f"{lost if d.lost_from_rad < math.pi / 2 else ''}"
    )


def _lidar(d: models.LidarDevice) -> str:
    turning = f", turning at {d.frequency_hz:g} Hz" if d.rotating else ""
    noise = _noise(metres(d.noise_m) if d.noise_m else "")
    order = _order(d, ", its points told as [left, up, ahead]")
    return (
        f"lidar, {counted(d.points, 'point')}, {metres(d.min_range_m)} to {metres(d.max_range_m)}{turning}{order}"
        f"{noise}, {metres(d.height_m)} above the floor, {_sweep(d)}"
    )


def _sweep(d: models.LidarDevice) -> str:
    """Return where a lidar looks."""
    if d.points == 1:
        return "straight ahead"  # whatever its field of view is
    return "clockwise from the front" if is_full_turn(d) else f"over {degrees(d.field_of_view_rad)} from left to right"


def _gps(d: models.GpsDevice) -> str:
    return f"position of the robot{_order(d, ', told as [y, z, x]')}{_noise(metres(d.noise_m) if d.noise_m else '')}"


def _compass(d: models.CompassDevice) -> str:
    noise = _noise(degrees(d.noise_rad) if d.noise_rad else "")
    return f"direction of north{_order(d, ', told as [left, up, ahead]')}{noise}"


def _order(d: models.GpsDevice | models.CompassDevice | models.LidarDevice, legacy: str) -> str:
    """Return in which order numbers are told, where that is not the usual one: a program reads others without it."""
    return f"{legacy} as in the worlds of 2021" if d.frame == "legacy" else ""


def _emitter(d: models.TeamEmitterDevice) -> str:
    in_a_tick = f"{counted(d.baud * TICK_S / _BITS_OF_A_BYTE, 'byte')} in a tick"
    return f"team radio, sends up to {metres(d.range_m)} far, {d.baud} baud ({in_a_tick})"


def _motor(d: models.MotorDevice) -> str:
    return f"motor of the {d.wheel} wheel, positive speeds drive {'forward' if d.direction == 1 else 'backward'}"


def _wheel_sensor(d: models.WheelSensorDevice) -> str:
    driving = "forward" if d.direction == 1 else "backward"
    return f"angle of the {d.wheel} wheel in rad, grows while the robot drives {driving}"


_BITS_OF_A_BYTE = 8  # on the radio: the description of `baud`

_DEVICES: dict[str, Callable[[Any], str]] = {
    "motor": _motor,
    "wheel_sensor": _wheel_sensor,
    "gps": _gps,
    "compass": _compass,
    "sonar": _sonar,
    "supervisor_receiver": lambda d: f"receiver of the referee's packets, channel {d.channel}",
    "team_receiver": lambda d: f"team radio, receives from up to {metres(d.range_m)}",
    "team_emitter": _emitter,
    "lidar": _lidar,
}
