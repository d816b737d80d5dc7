"""The data exchanged between the devices of a robot and the program that drives it.

`devices` makes `Observation`s and consumes `Request`s; `programs` carries both over pipes. Neither
imports the other: this file is all they share.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, NamedTuple


@dataclass(frozen=True, slots=True)
class DeviceSpec:
    """One device of one robot, as its program sees it.

    Attributes:
        name: as the program asks for it, ``distancesensor left``.
        kind: the class of the object that ``getDevice`` returns, in snake_case: ``position_sensor``.
        index: position in the robot's list of devices; messages name a device by it.
        slot: offset of its first number in ``Observation.values`` (-1: it has none).
        width: how many numbers it has there.
        facts: what the program can ask without stepping (max_velocity, min_value, max_value, channel, range, fov,
            resolution, …), JSON-able.
    """

    name: str
    kind: str
    index: int
    slot: int
    width: int
    facts: dict[str, Any] = field(default_factory=dict)


class Note(NamedTuple):
    """What the module ``controller`` refused or ignored of a program's calls.

    Attributes:
        code: ``no-device``, ``ignored-call``, or empty.
        subject: the device or call that the code is about, as the program wrote it; not safe to show.
        message: what is wrong, in one line.
        help: what to do about it; empty with ``no-device``.
    """

    code: str
    subject: str
    message: str
    help: str


@dataclass(frozen=True, slots=True)
class RobotSpec:
    """Everything that a program's process receives at its start.

    Attributes:
        name: ``B1``.
        devices: in the order of their index.
        values: length of ``Observation.values``.
        getdata_returns: ``bytes`` (v2.1, 2021) or ``text`` (v2.2): what ``Receiver.getData`` gives.
        basic_step_ms: what ``getBasicTimeStep`` returns (32, in the 2021 worlds 32 too: robots step 64).
        max_velocity_radps: of the wheels.
    """

    name: str
    devices: tuple[DeviceSpec, ...]
    values: int
    getdata_returns: str
    basic_step_ms: int = 32
    max_velocity_radps: float = 10.0


class Packet(NamedTuple):
    """A radio packet as a receiver sees it; a tuple, for a dozen are made every tick.

    Attributes:
        device: index of the receiving device.
        data: the bytes sent.
        strength: 1 / r² with the 3-D distance r in m.
        direction: unit vector to the emitter in the robot's frame (x forward, y left, z up).
    """

    device: int
    data: bytes
    strength: float
    direction: tuple[float, float, float]


class Observation(NamedTuple):
    """What one program receives when its ``step`` returns.

    Attributes:
        tick: tick of the half; simulated time is ``tick * 0.032`` s.
        values: all numbers of all devices (NaN before the first sample), by slot. Lidar ranges stand here too.
        packets: those that arrived since the last observation, in order.
        over: True in the last one: ``step`` returns -1.
    """

    tick: int
    values: list[float]
    packets: list[Packet]
    over: bool = False


class MotorCommand(NamedTuple):
    """One motor's setting: velocity in rad/s, and the position target in rad (``inf``: velocity control)."""

    device: int
    velocity_radps: float
    position_rad: float


class Request(NamedTuple):
    """A program's request when it calls ``step``. Trusted in form (decoded and range-checked), not in content.

    Attributes:
        advance_ticks: ``step(ms)`` in ticks, >= 1.
        missed_ticks: whole ticks that the program slept or busy-waited away since its last observation; its commands
            take effect that many ticks later, and its step ends ``missed_ticks + advance_ticks`` ticks from now.
        motors: settings that changed since the last request, in order.
        emissions: (device index, channel, payload) in the order sent.
        sampling: (device index, period in ticks; 0 = disable) changed since the last request, in order.
        channels: (device index, channel) set by ``setChannel`` of a receiver.
        frequencies: (device index, Hz) set by ``setFrequency`` of a rotating lidar.
    """

    advance_ticks: int
    missed_ticks: int = 0
    motors: tuple[MotorCommand, ...] = ()
    emissions: tuple[tuple[int, int, bytes], ...] = ()
    sampling: tuple[tuple[int, int], ...] = ()
    channels: tuple[tuple[int, int], ...] = ()
    frequencies: tuple[tuple[int, float], ...] = ()
