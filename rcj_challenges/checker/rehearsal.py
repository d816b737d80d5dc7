"""A short match with a team's programs, played by the engine of the tournament; stages read its record.

There is no second way to start or to supervise a program: this calls `play_match` as ``run`` does.
"""

from __future__ import annotations

import math
import os
import time
from contextlib import ExitStack, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rcj_challenges.checker.growth import Amounts, FollowedTeam, Growth
from rcj_challenges.controllers.team import Team, TeamError, open_team
from rcj_challenges.core.play import RefereeOutput, Snapshot
from rcj_challenges.match.observers import NullObserver, ProgramTimes
from rcj_challenges.match.runner import MatchPlan, play_match
from rcj_challenges.match.samples import sample_team
from rcj_challenges.records.folder import LOGS
from rcj_challenges.scenario.halves import longest_half_s
from rcj_challenges.scenario.load import Loaded, load_resolved

SEED = 1
"""Two checks of one file see the same match."""

_LEAST_PATIENCE_STEPS = 2.0
_MAX_OVER = 4.0
_MAX_LOG_BYTES = 100_000  # at each end
OWN_TEAM = "your own team"
_NOBODY = "robots that stand still"
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

    def seats(self) -> list[str]:
        """Return the seats that the team can take: all whose programs it has."""
        return [
            seat
            for seat, entrant in self.loaded.scenario.entrants.items()
            if entrant.robots.keys() <= self.team.entries.keys()
        ]


@dataclass
class Motion:
    """How one robot moved.

    Attributes:
        path_m: length of its way in m; being put elsewhere is no part of it.
        turned_rad: how far it turned, both directions added up.
        ball_touches: sub-steps in which it touched a ball.
    """

    path_m: float = 0.0
    turned_rad: float = 0.0
    ball_touches: int = 0


@dataclass(frozen=True)
class Rehearsed:
    """A short match that is over.

    Attributes:
        seats: that the checked team held.
        opponents: name of the team by each other seat.
        folder: its record.
        result: as in ``result.json``.
        faults: of the team's robots, in order, as in the result.
        faults_of_others: of all other robots, in the same form.
        motions: by robot of the team.
        waits: by robot of the team.
        printed: how much the programs of the team printed, by robot.
        written: how much they wrote into their folders, by robot.
        simulated_s: what was played in s.
        wall_s: what that took in s.
    """

    seats: tuple[str, ...]
    opponents: dict[str, str]
    folder: Path
    result: dict[str, Any]
    faults: list[dict[str, Any]]
    faults_of_others: list[dict[str, Any]]
    motions: dict[str, Motion]
    waits: dict[str, ProgramTimes]
    printed: dict[str, Growth]
    written: dict[str, Growth]
    simulated_s: float
    wall_s: float

    def log(self, robot: str) -> str:
        """Return what a program printed, and what the match wrote about it: of much the beginning and the end."""
        try:
            with (self.folder / LOGS / f"{robot}.log").open("rb") as file:
                said = file.read(_MAX_LOG_BYTES)
                left = file.seek(0, os.SEEK_END) - len(said)
                file.seek(max(len(said), len(said) + left - _MAX_LOG_BYTES))
                rest = file.read(_MAX_LOG_BYTES)
        except OSError:
            return ""
        gap = b"\n...\n" if left > len(rest) else b""
        return (said + gap + rest).decode("utf-8", "replace")


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
    followed = FollowedTeam(rehearsal.team)
    with ExitStack() as stack:
        cast = {
            seat: (followed, rehearsal.name) if seat in seats else _other(rehearsal, seat, stack)
            for seat in scenario.entrants
        }
        teams = {seat: team for seat, (team, _) in cast.items()}
        names = {seat: name for seat, (_, name) in cast.items()}
        ours = [robot for seat in seats for robot in scenario.entrants[seat].robots]
        observer = _Observer(short, Amounts(ours, followed, scenario.limits))
        plan = MatchPlan(
            loaded=short,
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
        faults_of_others=[fault for fault in played.result["faults"] if fault["robot"] not in ours],
        motions=observer.motions,
        waits={wait.robot: wait for wait in observer.waits if wait.robot in ours},
        printed=observer.amounts.printed,
        written=observer.amounts.written,
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


def _other(rehearsal: Rehearsal, seat: str, stack: ExitStack) -> tuple[Team, str]:
    """Return who plays in another seat: a sample team, the team against itself, or a stand-in; and its name."""
    scenario = rehearsal.loaded.scenario
    sample = sample_team(scenario, seat)
    if sample is not None:
        with suppress(TeamError):  # no sample team has these programs
            opened = stack.enter_context(open_team(sample, scenario.entrants[seat]))
            return opened, opened.name
    if seat in rehearsal.seats():
        return rehearsal.team, OWN_TEAM
    stand_in = rehearsal.out / "stand_in.py"
    stand_in.write_text(_STAND, encoding="utf-8")
    return stack.enter_context(open_team(stand_in, scenario.entrants[seat])), _NOBODY


class _Observer(NullObserver):
    """Records how robots move, what they touch, and how much time and output their programs used.

    Args:
        loaded: what is played.
        amounts: of the robots that are watched.
    """

    def __init__(self, loaded: Loaded, amounts: Amounts) -> None:
        roster, robots = loaded.roster, list(amounts.printed)
        self.amounts = amounts
        self.motions = {robot: Motion() for robot in robots}
        self.waits: tuple[ProgramTimes, ...] = ()
        self._watched = [(roster.index[robot], self.motions[robot]) for robot in robots]
        self._of_robot = dict(self._watched)
        self._balls = range(roster.robots, roster.robots + roster.balls)
        self._last: list[tuple[float, float, float]] | None = None

    def ticked(self, snapshot: Snapshot, output: RefereeOutput) -> None:
        """Add up what happened in a tick."""
        self.amounts.ticked(snapshot.tick)
        for poses in snapshot.substeps:
            if self._last is not None:
                for index, motion in self._watched:
                    _add(motion, self._last[index], poses[index])
            self._last = poses
        for pairs in snapshot.touches:
            for first, second in pairs:
                if second in self._balls and first in self._of_robot:
                    self._of_robot[first].ball_touches += 1
        if output.placements and self._last is not None:
            self._last = self._last[:]
            for placement in output.placements:
                self._last[placement.entity] = (placement.x_m, placement.y_m, placement.yaw_rad)

    def printed(self, robot: str, text: str) -> None:
        """Record how much a program printed."""
        self.amounts.said(robot, text)

    def half_ended(self, half: object, waits: tuple[ProgramTimes, ...]) -> None:
        """Record how long the match waited for programs."""
        self.waits = waits


def _add(motion: Motion, before: tuple[float, float, float], now: tuple[float, float, float]) -> None:
    motion.path_m += math.hypot(now[0] - before[0], now[1] - before[1])
    turn = abs(now[2] - before[2])
    motion.turned_rad += min(turn, math.tau - turn) if turn <= math.tau else 0.0
