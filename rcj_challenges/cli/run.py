"""``rcj-challenge run``: from options to a played match."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rcj_challenges.facts.errors import RcjError
from rcj_challenges.facts.timing import TICK_S

if TYPE_CHECKING:
    from rich.console import Console

    from rcj_challenges.cli.live import LiveOptions
    from rcj_challenges.controllers.team import Team
    from rcj_challenges.match.match import MatchInterruptedError, PlayedMatch
    from rcj_challenges.scenario.load import Loaded
    from rcj_challenges.scenario.models.scenario import Scenario


class UsageError(RcjError):
    """Options that do not fit the scenario."""


@dataclass(frozen=True)
class RunOptions:
    """The options of ``run``, as given."""

    scenario: str
    teams: list[str]
    team_names: list[str]
    seed: int
    match_id: int
    overrides: list[str]
    out: Path
    json: bool
    quiet: bool
    real_time: bool
    show_output: frozenset[str]
    debug: frozenset[str]
    sandbox: str
    replay: bool
    record_sensors: bool = False
    live: LiveOptions | None = None


def run_scenario(options: RunOptions) -> int:
    """Play it; returns the exit code.

    Raises:
        RcjError: wrong input: the message says where and what is allowed.
    """
    from rcj_challenges.scenario.load import load

    # MuJoCo would load a window system's library, 50 ms, and a match draws nothing.
    os.environ.setdefault("MUJOCO_GL", "disable")
    loaded = load(options.scenario, options.overrides)
    robots = frozenset(robot for entrant in loaded.scenario.entrants.values() for robot in entrant.robots)
    for robot in (*options.show_output, *options.debug):
        _known(robot, robots, "robot")

    # The physics is imported while nobody waits for it yet: opening teams is quick, compiling is not.
    from rcj_challenges.cli import INTERRUPTED
    from rcj_challenges.cli.live import on_air, stay_on_air
    from rcj_challenges.match.match import MatchInterruptedError, MatchPlan, play_match
    from rcj_challenges.match.watching import Together
    from rcj_challenges.views.scoreboard import console_for, watcher_for

    console = console_for(to_stderr=options.json)
    watcher = watcher_for(console, loaded.scenario.title, quiet=options.quiet or options.json)
    plan = MatchPlan(
        loaded=loaded,
        teams=_open_teams(loaded, options),
        team_names=_assignments(options.team_names, loaded.scenario.entrants, "--team-name"),
        seed=options.seed,
        match_id=options.match_id,
        out=options.out,
        sandbox=options.sandbox,
        real_time=options.real_time,
        show_output=options.show_output,
        debug=options.debug,
        record_sensors=options.record_sensors,
    )
    titles = {team: plan.name_of(team) for team in plan.teams}
    try:
        with on_air(options.live, loaded.scenario, titles, plan.logos, plan.seed, console) as show:
            outcome = play_match(plan, watcher if show is None else Together(watcher, show.watcher))
            _tell(options, console, loaded.scenario, outcome)
            if show is not None and options.live is not None:
                show.match_over(outcome.folder)
                stay_on_air(show, options.live, console)
    except MatchInterruptedError as error:
        _tell_of_interruption(console, loaded.scenario, error)
        return INTERRUPTED
    finally:
        for team in plan.teams.values():
            team.close()
    return 0


def _tell(options: RunOptions, console: Console, scenario: Scenario, outcome: PlayedMatch) -> None:
    """Write the replay page, and say how it ended."""
    if options.replay:
        from rcj_challenges.views.replay import write_replay

        write_replay(outcome.folder)
    if options.json:
        sys.stdout.write(json.dumps(outcome.result, ensure_ascii=False, indent=2) + "\n")
        sys.stdout.flush()
    else:
        _summary(console, scenario, outcome, replay=options.replay)


def _tell_of_interruption(console: Console, scenario: Scenario, error: MatchInterruptedError) -> None:
    """Say how far the match came, and where that is."""
    from rcj_challenges.views.scoreboard import score_line
    from rcj_challenges.views.sentences import clock

    result, folder = error.played.result, error.played.folder
    names = {seat: entrant["name"] for seat, entrant in result["entrants"].items()}
    where = "before the first half"
    if result["halves"]:
        half = result["halves"][-1]
        number = f"half {half['half']} of {scenario.match.halves}"
        where = f"after {number}" if half["complete"] else f"in {number} at {clock(half['ticks'] * TICK_S)}"
        where += f": {score_line(names, result['score'])}"
    lines = [f"interrupted {where}", f"record: {folder}"]
    if result["halves"]:
        lines.append(f"watch:  rcj-challenge view {folder}")
    if error.trouble:
        lines.append(f"the record could not be closed: {error.trouble}")
    for line in lines:
        console.print(line, markup=False, highlight=False, soft_wrap=True)


def _open_teams(loaded: Loaded, options: RunOptions) -> dict[str, Team]:
    """Open each seat's team: the one given, else a sample team."""
    from rcj_challenges.controllers.team import open_team

    entrants = loaded.scenario.entrants
    given = _assignments(options.teams, entrants, "--team")
    opened: dict[str, Team] = {}
    try:
        for seat, entrant in entrants.items():
            path = Path(given[seat]) if seat in given else _sample_team(loaded, seat)
            opened[seat] = open_team(path, *(entrants.values() if loaded.scenario.match.swap_sides else (entrant,)))
    except BaseException:
        for team in opened.values():
            team.close()
        raise
    return opened


def _sample_team(loaded: Loaded, seat: str) -> Path:
    """Return the sample team for a seat; see `rcj_challenges.match.samples.sample_team`.

    Raises:
        UsageError: there is none; says what to give.
    """
    from rcj_challenges.match.samples import sample_team
    from rcj_challenges.scenario.load import load

    scenario = loaded.scenario
    bases = [load(path).scenario for path in loaded.bases]
    found = sample_team(scenario, seat, bases)
    if found is not None:
        return found
    raise UsageError(
        f"who plays for {seat!r}? {_why_no_sample_team(scenario, seat, bases)}: "
        f"give --team {seat}=PATH, a team with {_programs_of(scenario, seat)}"
    )


def _why_no_sample_team(scenario: Scenario, seat: str, bases: Sequence[Scenario]) -> str:
    from rcj_challenges.match.samples import has_sample_team, other_kits

    for base in bases:
        if has_sample_team(base) and (kits := other_kits(scenario, base, seat)):
            told = ", ".join(f"{robot}: {kit}" for robot, kit in kits.items())
            return f"The sample team of {base.id} was written for other kits or packets ({told})"
    return "There is no sample team for it"


def _programs_of(scenario: Scenario, seat: str) -> str:
    """Return what a team must bring: each program, whom it drives, and of which kit those are."""
    driven: dict[str, list[str]] = {}
    for robot, entry in scenario.entrants[seat].robots.items():
        driven.setdefault(entry if isinstance(entry, str) else entry[0], []).append(robot)
    return " and ".join(
        f"{program} for {', '.join(f'{robot} (kit {scenario.robots[robot].kit})' for robot in robots)}"
        for program, robots in driven.items()
    )


def _assignments(given: list[str], seats: Mapping[str, Any], option: str) -> dict[str, str]:
    """Return ``ENTRANT=VALUE`` options by entrant."""
    found: dict[str, str] = {}
    for entry in given:
        seat, equals, value = entry.partition("=")
        if not equals or not value:
            raise UsageError(f"{option} {entry}: expected ENTRANT=VALUE, such as {next(iter(seats))}=…")
        _known(seat, seats, "entrant")
        if seat in found:
            raise UsageError(f"{option}: {seat!r} is given twice")
        found[seat] = value
    return found


def _known(name: str, names: Mapping[str, Any] | frozenset[str], kind: str) -> None:
    if name not in names:
        nearest = get_close_matches(name, names, 1)
        hint = f"; did you mean {nearest[0]!r}?" if nearest else ""
        raise UsageError(f"unknown {kind} {name!r}: this scenario has {', '.join(sorted(names))}{hint}")


def _summary(console: Console, scenario: Scenario, outcome: PlayedMatch, *, replay: bool) -> None:
    """Say how it ended, by what, and where the record is."""
    from rcj_challenges.views.scoreboard import ranking_lines, score_line
    from rcj_challenges.views.sentences import plain

    result, folder = outcome.result, outcome.folder
    names = {seat: entrant["name"] for seat, entrant in result["entrants"].items()}
    lines = [score_line(names, result["score"])]
    lines += ranking_lines(scenario.result.rank, names, result["ranking"])
    lines += [
        f"program fault: {fault['robot']} {fault['kind']} at tick {fault['tick']}: {plain(fault['detail'])} "
        f"(logs/{fault['robot']}.log)"
        for fault in result["faults"]
    ]
    lines.append(
        f"{result['simulated_s']:.0f} s played in {result['wall_s']:.1f} s "
        f"({result['real_time_factor']:.0f} x real time)"
    )
    lines.append(f"record: {folder}")
    if replay:
        lines.append(f"watch:  {folder / 'replay.html'}")
    for line in lines:
        console.print(line, markup=False, highlight=False, soft_wrap=True)
