"""``rcj-challenge run``: plays a scenario."""

from __future__ import annotations

import os
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from rcj_challenges.cli import INTERRUPTED, OK, options
from rcj_challenges.cli.app import PLAY, app
from rcj_challenges.cli.codes import BAD_TEAM_NAME, OPTION_GIVEN_TWICE, OPTIONS_CONTRADICT, UNKNOWN_ROBOT
from rcj_challenges.cli.live import RunCommand, live_speed, serve_after_match, shown_live
from rcj_challenges.cli.stdio import print_lines, require_layers, shown_path
from rcj_challenges.cli.team_args import assignments, open_teams, refuse_unknown
from rcj_challenges.core.errors import RcjError, interruption_behind

if TYPE_CHECKING:
    from collections.abc import Sequence

    from rich.console import Console

    from rcj_challenges.scenario.load import Loaded


@app.register(
    PLAY,
    "rcj-challenge run match --duration 1:00 --open",
    "rcj-challenge run match --yellow my_team --blue ball_chaser",
    "rcj-challenge run match --yellow my_team --debug Y1",
    cls=RunCommand,
)
def run(
    scenario: options.ScenarioName,
    team: options.Teams = None,
    blue: options.Blue = None,
    yellow: options.Yellow = None,
    team_name: Annotated[
        list[str] | None, typer.Option("--team-name", metavar="ENTRANT=NAME", help="Overrides team_name.txt.")
    ] = None,
    seed: Annotated[int, typer.Option("--seed", metavar="N", min=0, help="Seed of all random choices.")] = 1,
    duration: options.Duration = None,
    halves: options.Halves = None,
    set_: options.Overrides = None,
    match_id: Annotated[
        int, typer.Option("--match-id", metavar="N", min=0, help="Number of the match in its log.")
    ] = 0,
    out: options.OutFolder = Path("runs"),
    json_: options.Json = False,
    quiet: Annotated[
        bool, typer.Option("--quiet", "-q", help="Print only the last lines, and what --show-output shows.")
    ] = False,
    real_time: Annotated[bool, typer.Option("--real-time", help="Play at the pace of the clock.")] = False,
    show_output: Annotated[
        list[str] | None, typer.Option("--show-output", metavar="ROBOT", help="Show what its program prints.")
    ] = None,
    debug: Annotated[
        list[str] | None,
        typer.Option(
            "--debug",
            metavar="ROBOT",
            help="Stop at breakpoints of its program, without limits: in VS Code with the extra [debug], otherwise "
            "here.",
        ),
    ] = None,
    sandbox: options.Sandbox = "auto",
    replay: Annotated[bool, typer.Option("--replay/--no-replay", help="Write the replay page.")] = True,
    record: Annotated[
        Literal["sensors"] | None,
        typer.Option(
            "--record", metavar="sensors", help="Also record what programs saw, set and printed: up to 15 MB per half."
        ),
    ] = None,
    live: Annotated[
        int | None,
        typer.Option("--live", metavar="[PORT]", min=0, max=65535, help="Show it in the browser while it is played."),
    ] = None,
    speed: Annotated[
        str | None, typer.Option("--speed", metavar="X|max", help="With --live: how many times real time; default: 1.")
    ] = None,
    live_for: Annotated[
        float | None,
        typer.Option(
            "--live-for", metavar="S", min=0, help="With --live: serve the page for this many seconds after the match."
        ),
    ] = None,
    open_: Annotated[
        bool, typer.Option("--open", help="Open the page in the browser: after the match, with --live before it.")
    ] = False,
) -> int:
    """Play a scenario with the teams' programs."""
    teams, overrides = options.all_teams(team, blue, yellow), options.all_overrides(set_, duration, halves)
    factor = live_speed(live, speed, live_for)
    _refuse_contradictions(debug or (), json_=json_, opens_no_page=open_ and live is None and not replay)
    # MuJoCo would load a window system's library, 50 ms, and a match draws nothing.
    os.environ.setdefault("MUJOCO_GL", "disable")
    try:
        from rcj_challenges.cli.output_paths import refuse_devices
        from rcj_challenges.scenario.load import load

        refuse_devices(out=out)
        loaded = load(scenario, overrides)
        if not quiet:
            require_layers(sandbox)
        _refuse_unknown_robots(loaded, *(show_output or ()), *(debug or ()))
        # The physics is imported here, before the match begins: opening teams is quick, compiling is not.
        from rcj_challenges.match.designs import with_designs
        from rcj_challenges.match.runner import MatchInterruptedError, MatchPlan, play_match
        from rcj_challenges.views.console import console_for
        from rcj_challenges.views.scoreboard import create_observer

        console = console_for(to_stderr=json_)
        playing = open_teams(loaded, teams)
        plan = MatchPlan(
            loaded=with_designs(loaded, playing),
            teams=playing,
            team_names=_team_names(loaded, team_name or []),
            seed=seed,
            match_id=match_id,
            out=out,
            sandbox=sandbox,
            real_time=real_time,
            show_output=frozenset(() if json_ else show_output or ()),
            debug=frozenset(debug or ()),
            record_sensors=record == "sensors",
        )
        observer = create_observer(console, loaded.scenario, quiet=quiet or json_, shared=bool(debug))
        if debug and find_spec("debugpy") is None:
            help_ = 'to stop in VS Code too: pip install "rcj-challenges[debug]"'
            print_lines(console, f"debug: breakpoint() stops in this terminal; {help_}")
    except KeyboardInterrupt as error:
        raise KeyboardInterrupt("the match had not begun, and nothing is recorded") from error
    from rcj_challenges.cli.run_report import MatchReport, has_ticks
    from rcj_challenges.match.motionless import MotionlessObserver
    from rcj_challenges.match.observers import ObserverGroup

    report = MatchReport(plan, console, as_json=json_, with_page=replay)
    try:
        with shown_live(live, factor, plan, console, open_=open_) as show:
            motionless = MotionlessObserver(loaded.scenario)
            outcome = play_match(plan, ObserverGroup(observer, motionless, *(() if show is None else (show.observer,))))
            try:
                report.played(outcome, motionless.robots(), getattr(observer, "problem", None))
            except BaseException as error:
                if interruption_behind(error) is None:
                    raise
                raise MatchInterruptedError(outcome, "") from error
            if open_ and live is None and has_ticks(outcome):
                _open_page(outcome.folder, console)
            if show is not None:
                show.match_over(outcome.folder)
                serve_after_match(show, live_for, console)
    except MatchInterruptedError as error:
        report.interrupted(error)
        return INTERRUPTED
    return OK


def _refuse_contradictions(debugged: Sequence[str], *, json_: bool, opens_no_page: bool) -> None:
    """Refuse options that contradict each other.

    Raises:
        RcjError: some do.
    """
    one, code = "give one of them", OPTIONS_CONTRADICT
    if opens_no_page:
        raise RcjError("--open opens the page of the match, and --no-replay leaves it out", one, code=code)
    if debugged and json_:
        message = "--debug gives a program the terminal, and --json prints the result there and nothing else"
        raise RcjError(message, f"{one}; result.json in the record has the same", code=code)
    if len(set(debugged)) > 1:
        robots = ", ".join(sorted(set(debugged)))
        raise RcjError("--debug is given more than once", f"give it for one of {robots}", code=OPTION_GIVEN_TWICE)


def _refuse_unknown_robots(loaded: Loaded, *given: str) -> None:
    robots = frozenset(robot for entrant in loaded.scenario.entrants.values() for robot in entrant.robots)
    for robot in given:
        refuse_unknown(robot, robots, UNKNOWN_ROBOT)


def _team_names(loaded: Loaded, given: list[str]) -> dict[str, str]:
    """Names that override the teams' own, made safe to show as those are.

    Raises:
        RcjError: one names no entrant, or has nothing that can be shown.
    """
    from rcj_challenges.submissions.team_name import safe_name

    assigned = assignments(given, loaded.scenario.entrants, "--team-name")
    names = {seat: safe_name(name) for seat, name in assigned.items()}
    for seat, name in names.items():
        if not name:
            raise RcjError(f"--team-name {seat}=…: nothing of this name can be shown", code=BAD_TEAM_NAME)
    return names


def _open_page(folder: Path, console: Console) -> None:
    from rcj_challenges.views.replay.browse import open_replay

    page, opened = open_replay(folder)
    if not opened:
        print_lines(console, f"no browser could be started here: open {shown_path(page)} in one")
