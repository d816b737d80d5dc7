"""A field on which devices are tried: real world, no programs; things are put where a test wants them."""

from __future__ import annotations

import copy
from functools import cache
from pathlib import Path
from typing import Any

import yaml

import rcj_challenges.scenario
from rcj_challenges.core.play import HalfInfo, Placement, RefereeOutput
from rcj_challenges.core.traffic import MotorCommand, Packet, Request
from rcj_challenges.robots.fitting import fit, fixed_rays
from rcj_challenges.robots.manager import DeviceManager
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.world.world import World
from tests.scenario.writing import in_tuples

PRESETS = Path(rcj_challenges.scenario.__file__).parent / "presets"
BLANK = RefereeOutput()
WAITING = RefereeOutput(waiting_for_kickoff=True)


def merged(base: Any, change: Any) -> Any:
    """Mappings merge by key, everything else replaces; None removes."""
    if not isinstance(base, dict) or not isinstance(change, dict):
        return copy.deepcopy(change)
    out = {key: value for key, value in base.items() if not (key in change and change[key] is None)}
    for key, value in change.items():
        if value is not None:
            out[key] = merged(base.get(key), value)
    return out


def preset_data(preset: str) -> dict[str, Any]:
    """A preset with those that it extends."""
    return copy.deepcopy(_read(preset))


@cache
def _read(preset: str) -> dict[str, Any]:
    """Read it once: that takes longer than most tests on it."""
    data = yaml.safe_load((PRESETS / f"{preset}.yaml").read_text(encoding="utf-8"))
    base = data.pop("extends", None)
    return merged(_read(base), data) if base else data


def scenario_of(preset: str = "soccersim_v2", change: dict[str, Any] | None = None) -> Scenario:
    return Scenario.model_validate(in_tuples(merged(preset_data(preset), change or {})))


def half(number: int = 1, seed: int = 7) -> HalfInfo:
    return HalfInfo(number, 2, 18750, seed, 1, {}, {}, {})


class Bench:
    """Robots far from each other until a test puts them somewhere; programs are played by the test."""

    def __init__(
        self, preset: str = "soccersim_v2", change: dict[str, Any] | None = None, info: HalfInfo | None = None
    ) -> None:
        self.scenario = scenario_of(preset, change)
        self.roster = Roster.of(self.scenario)
        self.world = World(self.scenario, self.roster, fixed_rays(fit(self.scenario, self.roster)))
        self.devices = DeviceManager(self.scenario, self.roster, self.world, info or half())
        self.tick = 0
        for name in self.roster.entities:
            self.park(name)

    def place(self, name: str, x: float, y: float, yaw: float = 0.0) -> None:
        """Put something down: before the first tick as part of tick 0, later in the tick that follows."""
        self._put(Placement(self.roster.index[name], x, y, yaw))

    def park(self, name: str) -> None:
        self._put(Placement(self.roster.index[name], 0, 0, 0, parked=True))

    def _put(self, placement: Placement) -> None:
        self.world.place([placement])
        if self.tick == 0:
            self.devices.begin(BLANK)

    def device(self, robot: str, name: str) -> int:
        return next(d.index for d in self.devices.specs[self.roster.index[robot]].devices if d.name == name)

    def ask(self, robot: str, **request: Any) -> None:
        self.devices.apply(self.roster.index[robot], Request(1, **request))

    def enable(self, robot: str, *devices: str, period: int = 1) -> None:
        self.ask(robot, sampling=tuple((self.device(robot, name), period) for name in devices))

    def send(self, robot: str, *payloads: bytes, channel: int | None = None) -> None:
        """Send packets; without a channel, on that of the robot's team."""
        emitter = self.device(robot, "team emitter")
        if channel is None:
            channel = self.devices.specs[self.roster.index[robot]].devices[emitter].facts["channel"]
        self.ask(robot, emissions=tuple((emitter, channel, data) for data in payloads))

    def tune(self, robot: str, device: str, channel: int) -> None:
        self.ask(robot, channels=((self.device(robot, device), channel),))

    def drive(self, robot: str, left: float, right: float, position: float = float("inf")) -> None:
        motors = (("left wheel motor", left), ("right wheel motor", right))
        self.ask(robot, motors=tuple(MotorCommand(self.device(robot, name), v, position) for name, v in motors))

    def sense(self, output: RefereeOutput = BLANK, *, ticks: int = 1) -> None:
        """Let time pass in which nothing moves."""
        for _ in range(ticks):
            self.tick += 1
            self.devices.sense(self.tick, output)

    def play(self, ticks: int) -> None:
        """Let time pass with physics."""
        for _ in range(ticks):
            self.tick += 1
            self.world.step(self.tick)
            self.devices.sense(self.tick, BLANK)

    def read(self, robot: str, device: str) -> list[float]:
        spec = next(d for d in self.devices.specs[self.roster.index[robot]].devices if d.name == device)
        values = self.devices.observe(self.roster.index[robot], self.tick).values
        return values[spec.slot : spec.slot + spec.width]

    def heard(self, robot: str, device: str) -> list[Packet]:
        """Return what a receiver delivered since this robot was last asked; the other receivers' packets are lost."""
        index = self.device(robot, device)
        packets = self.devices.observe(self.roster.index[robot], self.tick).packets
        return [packet for packet in packets if packet.device == index]
