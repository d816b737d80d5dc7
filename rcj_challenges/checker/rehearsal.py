"""A short match with a team's programs, played by `play_match` as ``run`` plays one; stages read its record."""

from __future__ import annotations

import math
import time
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

from rcj_challenges.checker.advice.hints import read_log
from rcj_challenges.core.play import RefereeOutput, Snapshot
from rcj_challenges.core.timing import ticks_from_s
from rcj_challenges.core.traffic import Note
from rcj_challenges.match.designs import with_designs
from rcj_challenges.match.observers import Observer, ProgramTimes
from rcj_challenges.match.runner import MatchPlan, play_match
from rcj_challenges.match.samples import sample_team
from rcj_challenges.records.folder import LOGS
from rcj_challenges.scenario.halves import in_half, longest_half_s
from rcj_challenges.scenario.load import Loaded, load_resolved
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.submissions.team import Team, TeamError, open_team

SEED = 1
"""Two checks of one file see the same match."""

_LEAST_PATIENCE_STEPS = 2.0
_MAX_OVER = 4.0
_STARTED_TICKS = 48  # output arrives every 16 ticks; by then that of the start has arrived
OWN_TEAM = "your own team"
_STANDING_ROBOTS = "robots that stand still"
_STAND = "from controller import Robot\nrobot = Robot()\nwhile robot.step(32) != -1:\n    pass\n"


@dataclass(frozen=True)
class Rehearsal:
    """What is played, and by which team.

    Attributes:
        loaded: the scenario in its full length.
        team: the team that is checked.
        name: what it is called.
        sandbox: ``auto``, ``strict`` or ``off``.
        out: folder for the records.
    """

    loaded: Loaded
    team: Team
    name: str
    sandbox: str
    out: Path

    @cached_property
    def scenario(self) -> Scenario:
        """The scenario in which all robots are those of the team, as it designed them."""
        designed = with_designs(self.loaded, dict.fromkeys(self.loaded.scenario.entrants, self.team))
        return in_half(designed.scenario, 1)

    def seats(self) -> list[str]:
        """Return the seats that the team can take: all whose programs it has."""
        return [
            seat
            for seat, entrant in self.loaded.scenario.entrants.items()
            if entrant.robots.keys() <= self.team.entries.keys()
        ]


@dataclass
class Activity:
    """What one robot did.

    Attributes:
        path_m: length of its way in m; being put elsewhere does not count.
        turned_rad: how far it turned, both directions added up.
        ball_touches: sub-steps in which it touched a ball.
        printed_bytes: how much its program printed.
        late_bytes: how much of that in the later part of the match, beginning at `late_from_ticks`.
    """

    path_m: float = 0.0
    turned_rad: float = 0.0
    ball_touches: int = 0
    printed_bytes: int = 0
    late_bytes: int = 0


@dataclass(frozen=True)
class Rehearsed:
    """A short match that is over.

    Attributes:
        seats: that the checked team held.
        opponents: name of the team by each other seat.
        folder: its record.
        result: as in ``result.json``.
        faults: of the team's robots, in order, as in the result.
        robots: what the robots of the team did, by name.
        waits: by robot of the team.
        notes: of the programs, by robot.
        simulated_s: what was played in s.
        wall_s: what that took in s.
    """

    seats: tuple[str, ...]
    opponents: dict[str, str]
    folder: Path
    result: dict[str, Any]
    faults: list[dict[str, Any]]
    robots: dict[str, Activity]
    waits: dict[str, ProgramTimes]
    notes: Mapping[str, Sequence[Note]]
    simulated_s: float
    wall_s: float

    def log(self, robot: str) -> str:
        """The output of a program, and lines of the match about it: of much the beginning and the end."""
        return read_log(self.folder / LOGS, robot)


def late_from_ticks(simulated_s: float) -> int:
    """Return from which tick of a short match on what programs print counts as what they print all the time."""
    return max(ticks_from_s(simulated_s) // 2, _STARTED_TICKS)


def rehearse(rehearsal: Rehearsal, seats: tuple[str, ...], seconds: float) -> Rehearsed:
    """Play for some simulated seconds.

    Args:
        rehearsal: what is played.
        seats: those that the team takes; a sample team takes each of the others, or the team itself where there is
            none that fits; if that does not fit either, the robots there stand still.
        seconds: simulated time, at most a half.

    Raises:
        RcjError: the sandbox cannot be had, or the physics became unstable.
    """
    scenario = rehearsal.loaded.scenario
    short = shortened(rehearsal.loaded, seconds)
    began = time.perf_counter()
    cast = {
        seat: (rehearsal.team, rehearsal.name) if seat in seats else _opponent(rehearsal, seat)
        for seat in scenario.entrants
    }
    teams = {seat: team for seat, (team, _) in cast.items()}
    names = {seat: name for seat, (_, name) in cast.items()}
    ours = [robot for seat in seats for robot in scenario.entrants[seat].robots]
    observer = _Observer(short, ours)
    plan = MatchPlan(
        loaded=with_designs(short, teams),
        teams=teams,
        team_names=names,
        seed=SEED,
        out=rehearsal.out,
        sandbox=rehearsal.sandbox,
        show_output=frozenset(ours),
    )
    played = play_match(plan, observer)
    return Rehearsed(
        seats=seats,
        opponents={seat: name for seat, name in names.items() if seat not in seats},
        folder=played.folder,
        result=played.result,
        faults=[fault for fault in played.result["faults"] if fault["robot"] in ours],
        robots=observer.robots,
        waits={wait.robot: wait for wait in observer.waits if wait.robot in ours},
        notes=played.notes,
        simulated_s=played.result["simulated_s"],
        wall_s=time.perf_counter() - began,
    )


def shortened(loaded: Loaded, seconds: float) -> Loaded:
    """Return a scenario of one short half.

    The time limit of a half shrinks too, but not in proportion: only a program that would go far beyond the limit of a
    whole half is stopped here, so that its check ends.
    """
    match, limits = loaded.scenario.match, loaded.scenario.limits
    longest_s = longest_half_s(match)
    half_s = min(longest_s, seconds)
    share = _MAX_OVER * limits.half_s * half_s / longest_s
    patience_s = min(limits.half_s, max(_LEAST_PATIENCE_STEPS * limits.step_s, share))
    resolved = {
        **loaded.resolved,
        "match": {**loaded.resolved["match"], "halves": 1, "half_s": half_s},
        "limits": {**loaded.resolved["limits"], "half_s": patience_s},
        "expect": {},
    }
    return load_resolved(resolved, loaded.name)


def _opponent(rehearsal: Rehearsal, seat: str) -> tuple[Team, str]:
    """Return the opponent in another seat (a sample team, the team itself or a stand-in) and its name."""
    scenario = rehearsal.loaded.scenario
    sample = sample_team(scenario, seat)
    if sample is not None:
        with suppress(TeamError):  # no sample team has these programs
            opened = open_team(sample, scenario.entrants[seat])
            return opened, opened.name
    if seat in rehearsal.seats():
        return rehearsal.team, OWN_TEAM
    stand_in = rehearsal.out / "stand_in.py"
    stand_in.write_text(_STAND, encoding="utf-8")
    return open_team(stand_in, scenario.entrants[seat]), _STANDING_ROBOTS


class _Observer(Observer):
    """Records how robots move, what they touch and print, and how much time their programs take."""

    def __init__(self, loaded: Loaded, robots: Sequence[str]) -> None:
        roster = loaded.roster
        self.robots = {robot: Activity() for robot in robots}
        self.waits: tuple[ProgramTimes, ...] = ()
        self._by_index = {roster.index[robot]: self.robots[robot] for robot in robots}
        self._balls = range(roster.robots, roster.robots + roster.balls)
        self._last: list[tuple[float, float, float]] | None = None
        self._is_late = False
        self._late_from_ticks = late_from_ticks(longest_half_s(loaded.scenario.match))

    def after_tick(self, snapshot: Snapshot, output: RefereeOutput) -> None:
        """Add up what happened in a tick."""
        self._is_late = snapshot.tick > self._late_from_ticks
        for poses in snapshot.substeps:
            if self._last is not None:
                for index, activity in self._by_index.items():
                    _add(activity, self._last[index], poses[index])
            self._last = poses
        for pairs in snapshot.touches:
            for first, second in pairs:
                if second in self._balls and first in self._by_index:
                    self._by_index[first].ball_touches += 1
        if output.placements and self._last is not None:
            self._last = self._last[:]
            for placement in output.placements:
                self._last[placement.entity] = (placement.x_m, placement.y_m, placement.yaw_rad)

    def printed(self, robot: str, text: str) -> None:
        """Record how much a program printed."""
        if robot in self.robots:
            size_bytes = len(text.encode("utf-8", "replace"))
            self.robots[robot].printed_bytes += size_bytes
            self.robots[robot].late_bytes += size_bytes * self._is_late

    def half_ended(self, half: object, waits: tuple[ProgramTimes, ...]) -> None:
        """Record how long the match waited for programs."""
        self.waits = waits


def _add(activity: Activity, before: tuple[float, float, float], now: tuple[float, float, float]) -> None:
    activity.path_m += math.hypot(now[0] - before[0], now[1] - before[1])
    turn = abs(now[2] - before[2])
    activity.turned_rad += min(turn, math.tau - turn) if turn <= math.tau else 0.0
