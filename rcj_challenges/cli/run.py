"""``rcj-challenge run``: its options."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import typer

from rcj_challenges.cli.help import PLAY
from rcj_challenges.cli.live import LiveOptions, RunCommand
from rcj_challenges.cli.options import (
    Blue,
    Duration,
    Halves,
    Json,
    OutFolder,
    Overrides,
    Sandbox,
    ScenarioName,
    Teams,
    Yellow,
    all_overrides,
    all_teams,
)


def register(app: typer.Typer) -> None:
    """Add the command."""
    app.command(
        cls=RunCommand,
        rich_help_panel=PLAY,
        epilog="rcj-challenge run match --duration 1:00 --open\n"
        "rcj-challenge run match --yellow my_team --blue ball_chaser\n"
        "rcj-challenge run match --yellow my_team --debug Y1",
    )(run)


def run(
    scenario: ScenarioName,
    team: Teams = None,
    blue: Blue = None,
    yellow: Yellow = None,
    team_name: Annotated[
        list[str] | None, typer.Option("--team-name", metavar="ENTRANT=NAME", help="Overrides team_name.txt.")
    ] = None,
    seed: Annotated[int, typer.Option("--seed", metavar="N", min=0, help="Seed of all random choices.")] = 1,
    duration: Duration = None,
    halves: Halves = None,
    set_: Overrides = None,
    match_id: Annotated[
        int, typer.Option("--match-id", metavar="N", min=0, help="Number of the match in its log.")
    ] = 0,
    out: OutFolder = Path("runs"),
    json_: Json = False,
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
    sandbox: Sandbox = "auto",
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
) -> None:
    """Play a scenario with the teams' programs."""
    from rcj_challenges.cli.run_match import RunOptions, run_scenario

    raise typer.Exit(
        run_scenario(
            RunOptions(
                scenario=scenario,
                teams=all_teams(team, blue, yellow),
                team_names=team_name or [],
                seed=seed,
                match_id=match_id,
                overrides=all_overrides(set_, duration, halves),
                out=out,
                json=json_,
                quiet=quiet,
                real_time=real_time,
                show_output=frozenset(show_output or ()),
                debug=frozenset(debug or ()),
                sandbox=sandbox,
                replay=replay,
                record_sensors=record == "sensors",
                open=open_,
                live=LiveOptions.of(live, speed, live_for, open_=open_),
            )
        )
    )
