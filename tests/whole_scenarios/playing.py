"""Whole matches without processes: the real loop, physics, devices and record, and programs that are objects here."""

from __future__ import annotations

import random
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from rcj_challenges.core.play import Fault
from rcj_challenges.core.traffic import MotorCommand, Observation, Request, RobotSpec
from rcj_challenges.expect.scripted_match import ScriptedMatch
from rcj_challenges.match.observers import Observer
from rcj_challenges.match.runner import MatchPlan, _MatchRunner
from rcj_challenges.scenario.load import Loaded

_TELLS = (b"Hello", b"7", b"0.1 0.2", b"yes", b"-1e400 0", b"\xff\xfe", b"", b"nan", b"x" * 200, b" no  ")


@dataclass
class Puppet:
    """Drives a robot at random; stands where a program does."""

    spec: RobotSpec
    chance: random.Random
    requests: int = 0
    started_s: float = 0.0
    fault: Fault | None = None
    budget: Any = None
    fails_at: int = 10**9
    notes: tuple[()] = ()

    @property
    def name(self) -> str:
        """Whose it is."""
        return self.spec.name

    def collect(self) -> Request | Fault:
        """Return what it asks for next."""
        self.requests += 1
        if self.requests > self.fails_at:
            self.fault = Fault(self.name, "crash", self.requests, 1, "made up")
            return self.fault
        motors, emissions = [], []
        for device in self.spec.devices:
            if device.kind == "motor":
                motors.append(MotorCommand(device.index, self.chance.uniform(-10, 10), float("inf")))
            elif device.kind == "emitter" and self.chance.random() < 0.3:
                emissions.append((device.index, self.chance.choice((1, 2, 10)), self.chance.choice(_TELLS)))
        sampling = tuple((one.index, 1) for one in self.spec.devices if one.kind not in ("motor", "emitter"))
        return Request(
            self.chance.choice((1, 1, 1, 3)), motors=tuple(motors), emissions=tuple(emissions),
            sampling=sampling if self.requests == 1 else (),
        )  # fmt: skip

    def collect_soon(self) -> Request | Fault | None:
        """Return the same at once."""
        return self.collect()

    def release(self, observation: Observation) -> None:
        """Hear what its devices say; there must be a packet or a number for each."""
        assert len(observation.values) == self.spec.values

    def limit_fault(self, tick: int) -> Fault | None:
        """Say that it takes no more than it may."""
        return None

    def keep_output(self) -> int:
        """Return the size of its log, into which it never prints."""
        return 0


@dataclass(frozen=True)
class _Team:
    name: str
    digest: str = ""
    files: dict[Any, bytes] = field(default_factory=dict)


class _PuppetRunner(_MatchRunner):
    """A match of which the programs are puppets: no processes, all else is real."""

    def _launch(self, pool: Any, specs: Any, half: Any) -> Any:
        drivers = {}
        for entrant in self._scenario.entrants.values():
            for name in entrant.robots:
                robot = self._roster.index[name]
                if robot in specs:
                    chance = random.Random(f"{half.half} {name}")  # noqa: S311 - nothing secret
                    fails_at = chance.choice((10**9, 10**9, 0, 20))
                    drivers[robot] = Puppet(specs[robot], chance, budget=_BUDGET, fails_at=fails_at)
        pool.finish = _nobody_is_told
        return {robot: drivers[robot] for robot in sorted(drivers)}


def _nobody_is_told(_last: object) -> None:
    """Stand in for telling programs that the half is over."""


@dataclass(frozen=True)
class _Budget:
    charged_s: float = 0.0
    slowest_s: float = 0.0
    started_s: float = 0.0


_BUDGET = _Budget()


def played(loaded: Loaded, out: Path, seed: int) -> tuple[Path, dict[str, Any]]:
    """Play a match with programs that do something at random; returns its folder and result."""
    teams: Any = {seat: _Team(f"Team {seat}") for seat in loaded.scenario.entrants}
    outcome = _PuppetRunner(MatchPlan(loaded, teams, {}, seed=seed, out=out, sandbox="off"), Observer()).play()
    return outcome.folder, outcome.result


def puppet_show(loaded: Loaded, seed: int, ticks: int) -> tuple[list[str], ScriptedMatch]:
    """Judge random poses, touches, tilts, faults and messages; return all that the referee said, and the play."""
    chance = random.Random(seed)  # noqa: S311 - nothing secret
    play = ScriptedMatch(loaded.scenario, loaded.roster)
    roster = loaded.roster
    robots, entities = roster.entities[: roster.robots], roster.entities
    reported = []
    while play.tick < ticks and play.output.ended is None and not play.referee.time_is_up:
        for _ in range(chance.choice((0, 0, 1, 3))):
            _do_something(play, chance, robots, entities)
        play.play(chance.choice((1, 1, 1, 10)))
        reported.append(f"{play.tick} {play.output.broadcast} {play.output.private_broadcasts}")
    play.finish()
    return [*map(repr, play.events), *map(repr, play.firings), *map(repr, play.placements), *reported], play


def _do_something(play: ScriptedMatch, chance: random.Random, robots: Any, entities: Any) -> None:
    x, y = chance.uniform(-0.9, 0.9), chance.uniform(-0.9, 0.9)
    entity = chance.choice(entities)
    match chance.randrange(7):
        case 0 | 1:
            play.place(entity, x, y, chance.choice((None, 0.3, -3.14)))
        case 2 | 3:
            play.glide(entity, (x, y), chance.choice((1, 5, 40)))
        case 4:
            other = chance.choice(play.roster.things)
            if other != entity:
                play.touch(entity, other, chance.choice((1, 3)))
        case 5 if robots:
            chance.choice((play.tip, play.fail))(chance.choice(robots))
        case 6 if robots:
            play.tell(
                chance.choice(robots), chance.choice(("Hello", "7", "0.1 0.2", "yes", "-1e400 0", "nan nan", "11 11"))
            )
        case _:
            pass
