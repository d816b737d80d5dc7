"""Designs of teams, judged by the guidelines of a scenario: what is wrong with them, and what they cost.

``robot.yaml`` comes from a team and may hold anything. It is read as strictly as a scenario and is much smaller; only
values within the bounds of the models get further.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from pydantic import ValidationError

from rcj_challenges.chassis.base import Chassis
from rcj_challenges.core.code import Code
from rcj_challenges.core.diagnostics import Diagnostic, InFile
from rcj_challenges.devices.base import Device
from rcj_challenges.devices.motor import MotorDevice
from rcj_challenges.geometry.polygons import distance_to_segment_m, side
from rcj_challenges.rules.phrasing import counted, listed, metres
from rcj_challenges.scenario import codes
from rcj_challenges.scenario.errors import ScenarioError, choice_of, listing
from rcj_challenges.scenario.models.designs import Allowance, Design, Guideline, Part, RobotFile
from rcj_challenges.scenario.reading.yaml_strict import parse_bytes
from rcj_challenges.scenario.tree import Entries, Path, in_names, mark_of, plain

ROBOT_FILE = "robot.yaml"
MAX_BYTES = 65_536

_OUTSIDE_M = 0.002
"""So far outside of the body something may sit: the original's sonars are 1 mm in front of it."""


@dataclass(frozen=True)
class Priced:
    """A line of the price table: ``sonar``, how many, points for all of them."""

    what: str
    count: int
    points: int


@dataclass
class Verdict:
    """What comes of the designs of a team: what they cost, and of their file what is wrong or odd.

    Attributes:
        robots: the design of each robot, by its name.
    """

    guideline: Guideline
    designs: Mapping[str, Design] = field(default_factory=dict)
    robots: tuple[str, ...] = ()
    problems: list[Diagnostic] = field(default_factory=list)
    warnings: list[Diagnostic] = field(default_factory=list)

    def costs(self, design: str) -> dict[str, int]:
        """Return the points of each device of a design, but of those that are not allowed."""
        parts, devices = self.guideline.devices, self.designs[design].devices.items()
        return {name: _price(device, parts[device.name()]) for name, device in devices if device.name() in parts}

    def prices(self, design: str) -> list[Priced]:
        """Return the price table of a design: its drive, and its devices by their kind."""
        chassis, devices = self.designs[design].chassis, self.designs[design].devices
        drive = self.guideline.drives.get(chassis.name())
        points = {chassis.name(): [_price(chassis, drive)]} if drive is not None else {}
        for name, cost in self.costs(design).items():
            points.setdefault(devices[name].name(), []).append(cost)
        return [Priced(kind, len(parts), sum(parts)) for kind, parts in points.items()]


def judge_designs(data: bytes, guideline: Guideline, robots: int, ball_m: float, kept: Mapping[str, Device]) -> Verdict:
    """Judge a team's file.

    Args:
        data: its content.
        guideline: of the seat.
        robots: how many a team has.
        ball_m: radius of the largest ball.
        kept: the devices that every robot keeps.
    """
    try:
        tree, file = _read(data)
    except ScenarioError as error:
        unreadable = codes.DESIGN_UNREADABLE
        problems = [Diagnostic(unreadable, one.message, one.help, one.where) for one in error.diagnostics]
        return Verdict(guideline, problems=problems)
    verdict = Verdict(guideline, file.designs, file.robots or tuple(file.designs) * robots)
    found = [*_of_file(file, guideline, robots)]
    for name, design in file.designs.items():
        for code, message, help_, path in (*_judge(design, guideline, ball_m, kept), *_budget(verdict, name)):
            found.append((code, f"{name}: {message}", help_, ("designs", name, *path)))
    for code, message, help_, path in found:
        problem = mark_of(tree, path, at_key=True).error(code, message, help_, in_names(tree, path))
        (verdict.problems if problem.level == "error" else verdict.warnings).append(problem)
    return verdict


def _read(data: bytes) -> tuple[Entries, RobotFile]:
    """Return the tree and the content of a file.

    Raises:
        ScenarioError: all that is wrong with its form.
    """
    if len(data) > MAX_BYTES:
        message = f"{ROBOT_FILE} has {len(data)} bytes; at most {MAX_BYTES} are read"
        raise ScenarioError([Diagnostic(codes.DESIGN_UNREADABLE, message, "", InFile(ROBOT_FILE))])
    tree = parse_bytes(data, ROBOT_FILE)
    if not isinstance(tree, Entries):
        message = "keys and values are expected"
        raise ScenarioError([tree.mark.error(codes.DESIGN_UNREADABLE, message, "design_version: 1 …")])
    try:
        return tree, RobotFile.model_validate(plain(tree, tuple))
    except ValidationError as error:
        from rcj_challenges.scenario.messages.explain import explain  # noqa: PLC0415 - needed for errors only

        problems = explain(error, tree, RobotFile, are_empty_reported=False)
        message = f"not valid: {error.errors(include_input=False)[0]['msg']}"
        raise ScenarioError(problems or [tree.mark.error(codes.DESIGN_UNREADABLE, message)]) from None


_Finding = tuple[Code, str, str, Path]
"""Code, message, help, and the path within the file or the design."""


def _of_file(file: RobotFile, guideline: Guideline, robots: int) -> Iterator[_Finding]:
    if len(file.designs) > guideline.designs:
        message = f"{counted(len(file.designs), 'design')}, {guideline.designs} allowed"
        yield codes.DESIGN_TOO_MANY, message, "", ("designs",)
    for number, name in enumerate(file.robots):
        if name not in file.designs:
            help_ = choice_of(name, file.designs)
            yield codes.DESIGN_UNKNOWN_DESIGN, f"there is no design '{name}'", help_, ("robots", number)
    if len(file.robots) != robots and (file.robots or len(file.designs) > 1):
        message = f"a team has {counted(robots, 'robot')}, and {len(file.robots)} have a design"
        help_ = f"robots: [{', '.join(list(file.designs)[:1] * robots)}]"
        yield codes.DESIGN_ROBOTS, message, help_, ("robots",)


def _judge(design: Design, guideline: Guideline, ball_m: float, kept: Mapping[str, Device]) -> Iterator[_Finding]:
    """Yield what is wrong or odd in a design."""
    chassis, devices = design.chassis, design.devices
    yield from _drive(chassis, guideline)
    yield from _size(chassis, guideline, ball_m)
    for name, device in devices.items():
        if name in kept:
            message = f"every robot has a device '{name}' already"
            yield codes.DESIGN_NAME_TAKEN, message, "take another name", ("devices", name)
        yield from _device(name, device, chassis, guideline)
    for kind, count in Counter(device.name() for device in devices.values()).items():
        part = guideline.devices.get(kind)
        if part is not None and part.at_most is not None and count > part.at_most:
            yield codes.DESIGN_TOO_MANY, f"{count} times {kind}, {part.at_most} allowed", "", ("devices",)
    driven = {device.wheel for device in devices.values() if isinstance(device, MotorDevice)}
    for wheel in chassis.wheel_names():
        if wheel not in driven:
            yield codes.DESIGN_NO_MOTOR, f"wheel {wheel} has no motor and never turns", "", ("devices",)


def _drive(chassis: Chassis, guideline: Guideline) -> Iterator[_Finding]:
    kind = chassis.name()
    for key, message in chassis.contradictions():
        code = codes.DESIGN_CANNOT_DRIVE if key == "wheels_at_rad" else codes.DESIGN_CONTRADICTION
        yield code, message, "", ("chassis", key)
    if kind not in guideline.drives:
        help_ = f"allowed: {listing(guideline.drives)}"
        yield codes.DESIGN_NOT_ALLOWED, f"the drive {kind} is not allowed", help_, ("chassis",)
    else:
        yield from _part(kind, chassis, guideline.drives[kind], ("chassis",))
    if chassis.shape not in guideline.shapes:
        help_ = f"allowed: {listing(guideline.shapes)}"
        yield codes.DESIGN_NOT_ALLOWED, f"the shape {chassis.shape} is not allowed", help_, ("chassis", "shape")


def _device(name: str, device: Device, chassis: Chassis, guideline: Guideline) -> Iterator[_Finding]:
    path: Path = ("devices", name)
    for key, message in device.contradictions(chassis):
        yield codes.DESIGN_CONTRADICTION, f"'{name}': {message}", "", (*path, key)
    part = guideline.devices.get(device.name())
    if part is None:
        help_ = f"allowed: {listing(guideline.devices, 40)}"
        yield codes.DESIGN_NOT_ALLOWED, f"'{name}': {device.name()} is not allowed", help_, path
        return
    yield from _part(name, device, part, path)
    place = device.place()
    if place is not None:
        beyond_m = max(_beyond_m(chassis, *place[:2]), place[2] - chassis.height_m)
        if beyond_m > _OUTSIDE_M:
            yield codes.DESIGN_OUTSIDE, f"'{name}' sits {_metres_up(beyond_m)} outside of the body", "", path


def _part(name: str, word: Chassis | Device, part: Part, path: Path) -> Iterator[_Finding]:
    """Yield what is wrong with the fields of a part."""
    for key, info in type(word).model_fields.items():
        value, allowance = getattr(word, key), part.limits.get(key)
        if allowance is not None:
            amount = _amount(value)
            wrong = _limit(amount, allowance)
            if wrong:
                yield codes.DESIGN_OUT_OF_RANGE, f"'{name}': {key} is {amount:g}; {wrong}", "", (*path, key)
        elif key not in {word.KEY, *word.FREE} and value != info.get_default(call_default_factory=True):
            message = f"'{name}': {key} may not be chosen"
            yield codes.DESIGN_OUT_OF_RANGE, message, "leave it out", (*path, key)


def _size(chassis: Chassis, limits: Guideline, ball_m: float) -> Iterator[_Finding]:
    parts = chassis.solids()
    parts |= {f"wheel {wheel.name}": wheel.corners() for wheel in chassis.wheels()}
    reaches = {name: max(math.hypot(*corner) for corner in outline) for name, outline in parts.items()}
    widest = max(reaches, key=reaches.__getitem__)
    if 2 * reaches[widest] > limits.max_diameter_m + 1e-9:
        message = (
            f"it needs a cylinder of {_metres_up(2 * reaches[widest])}, {metres(limits.max_diameter_m)} are allowed"
            f": {widest.replace('_', ' ')} reaches furthest"
        )
        yield codes.DESIGN_TOO_WIDE, message, "", ("chassis",)
    if chassis.height_m > limits.max_height_m:
        message = f"it is {metres(chassis.height_m)} high, {metres(limits.max_height_m)} are allowed"
        yield codes.DESIGN_TOO_HIGH, message, "the height is that of `size_m`", ("chassis",)
    if chassis.total_mass_kg > limits.max_mass_kg:
        message = f"it weighs {chassis.total_mass_kg:.3g} kg with its wheels, {limits.max_mass_kg:g} kg are allowed"
        yield codes.DESIGN_TOO_HEAVY, message, "", ("chassis",)
    depth_m = chassis.mouth_m(ball_m)
    if depth_m > limits.max_mouth_m:
        message = f"a ball enters the jaws by {metres(depth_m)}, {metres(limits.max_mouth_m)} are allowed"
        yield codes.DESIGN_MOUTH, message, "", ("chassis", "jaws_m")


def _budget(verdict: Verdict, design: str) -> Iterator[_Finding]:
    prices, costs, budget = verdict.prices(design), verdict.costs(design), verdict.guideline.budget
    cost = sum(one.points for one in prices)  # integers
    if cost > budget:
        saving = [name for name, points in costs.items() if points >= cost - budget]
        help_ = f"leaving out '{min(saving, key=costs.__getitem__)}' is enough" if saving else ""
        yield codes.DESIGN_OVER_BUDGET, f"it costs {cost}, {budget} are allowed: {price_words(prices)}", help_, ()


def price_words(prices: Iterable[Priced]) -> str:
    """Return a price table in words, the dearest first: ``4 sonar 200, 1 compass 150``."""
    ranked = sorted((one for one in prices if one.points), key=lambda one: -one.points)
    return listed([f"{one.count} {one.what} {one.points}" for one in ranked], "and")


def _amount(value: Any) -> float:
    if isinstance(value, tuple):
        return len(value)
    return float(value) if isinstance(value, int | float) else 0.0


def _limit(amount: float, allowance: Allowance) -> str:
    most = allowance.most if allowance.most is not None else allowance.prices[-1][0] if allowance.prices else math.inf
    if allowance.least is not None and amount < allowance.least:
        return f"at least {allowance.least:g}"
    return f"at most {most:g}" if amount > most else ""


def _price(word: Chassis | Device, part: Part) -> int:
    """Return the points of a part: its own, and those of its fields."""
    points = part.price
    for key, allowance in part.limits.items():
        amount = _amount(getattr(word, key))
        points += next((price for up_to, price in allowance.prices if amount <= up_to), 0)
    return points


def _metres_up(length_m: float) -> str:
    """A length that is too long, rounded up to 0.1 mm."""
    return metres(math.ceil(length_m * 10_000) / 10_000)


def _beyond_m(chassis: Chassis, ahead_m: float, left_m: float) -> float:
    """The distance from the body to a place outside of it; 0: it is within."""
    body = chassis.body()
    edges = tuple(zip(body, (*body[1:], body[0]), strict=True))
    if all(side(*edge, (ahead_m, left_m)) >= 0 for edge in edges):
        return 0.0
    return min(distance_to_segment_m(ahead_m, left_m, *one, *other) for one, other in edges)
