"""The robots of a rule sheet: who drives them, their kits and devices, and how they talk to each other."""

from __future__ import annotations

from collections.abc import Iterator

from rcj_challenges.devices.ball_receiver import BallReceiverDevice
from rcj_challenges.devices.base import Device
from rcj_challenges.devices.team_emitter import TeamEmitterDevice
from rcj_challenges.devices.team_receiver import TeamReceiverDevice
from rcj_challenges.robots.channels import entrant_of, team_channels
from rcj_challenges.rules.phrasing import heading, listed, metres, metres_alike, plain
from rcj_challenges.scenario.models import robots as models
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.own_devices import devices_of
from rcj_challenges.views.drawing.shapes import point_words
from rcj_challenges.views.sheet.blocks import Block, Heading, Paragraph, Table
from rcj_challenges.views.sheet.nouns import Nouns

_RADIO = (TeamEmitterDevice, TeamReceiverDevice)


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
            phrases = _DevicePhrases(nouns)
            changes = [f"“{device}”: {model.describe(phrases)}" for device, model in robot.devices.items()]
            changes += [f"no “{device}”" for device in robot.without]
            yield Paragraph(f"{plain(name)} differs from its kit: {'; '.join(changes)}.")
    if sum(ball.emits for ball in scenario.balls.values()) > 1 and _any_has(scenario, BallReceiverDevice):
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
    phrases = _DevicePhrases(nouns)
    yield Table(("device", "what it is"), tuple((device, d.describe(phrases)) for device, d in kit.devices.items()))


def _radio_channels(scenario: Scenario, owners: dict[str, str]) -> dict[str, int]:
    """Return the channel of each entrant that drives a robot with a team radio."""
    channels = team_channels(scenario)
    return {
        owners[name]: channels[name]
        for name, robot in scenario.robots.items()
        if name in owners and not robot.idle and has(scenario, name, *_RADIO)
    }


def _any_has(scenario: Scenario, kind: type[Device]) -> bool:
    return any(has(scenario, name, kind) for name, robot in scenario.robots.items() if not robot.idle)


def has(scenario: Scenario, robot: str, *kinds: type[Device]) -> bool:
    """Return whether a robot has a device of one of these kinds, its kit's or its own."""
    return any(isinstance(device, kinds) for device in devices_of(scenario, robot).values())


class _DevicePhrases:
    """What the lines of devices need of a scenario."""

    def __init__(self, nouns: Nouns) -> None:
        self._nouns = nouns

    def balls_with_infrared(self) -> str:
        """Return which balls send infra-red: ``the ball``, ``all balls``; empty: none."""
        balls = self._nouns.scenario.balls
        senders = [self._nouns.thing(name) for name, ball in balls.items() if ball.emits]
        if not senders:
            return ""
        if len(senders) < len(balls):
            return f"{listed(senders, 'and')} only"
        return "the ball" if len(balls) == 1 else "all balls"
