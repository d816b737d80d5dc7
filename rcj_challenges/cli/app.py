"""The commands and their options."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from rcj_challenges import __version__
from rcj_challenges.cli import check, judge, run, site, stats, submit, tournament, verify, video
from rcj_challenges.cli.completion import complete_scenarios, complete_teams
from rcj_challenges.cli.help import PLAY, WATCH, WRITE, Command, Group
from rcj_challenges.cli.options import (
    AtOnce,
    Blue,
    Duration,
    Halves,
    Json,
    OutFolder,
    Overrides,
    Quiet,
    Run,
    RunsFolder,
    Sandbox,
    ScenarioName,
    Seeds,
    Teams,
    Yellow,
    all_overrides,
    all_teams,
)

app = typer.Typer(
    name="rcj-challenge",
    cls=Group,
    help="Play robot-soccer matches and challenges that are declared in YAML.",
    epilog="rcj-challenge run match --duration 1:00 --open\nrcj-challenge check my_team.zip",
    no_args_is_help=True,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)


def _show_version(asked: bool) -> None:
    if asked:
        typer.echo(f"rcj-challenge {__version__}")
        raise typer.Exit


@app.callback()
def _root(
    version: Annotated[
        bool, typer.Option("--version", callback=_show_version, is_eager=True, help="Show the version.")
    ] = False,
) -> None:
    """Play robot-soccer matches and challenges that are declared in YAML."""


run.register(app)


@app.command(cls=Command, rich_help_panel=WRITE, epilog="rcj-challenge validate relay_race.yaml")
def validate(
    files: Annotated[
        list[str],
        typer.Argument(
            metavar="FILE...",
            autocompletion=complete_scenarios,
            help="Scenario and tournament files, or names of shipped ones.",
        ),
    ],
    set_: Overrides = None,
    strict: Annotated[bool, typer.Option("--strict", help="Exit with 1 if there is a warning; for CI.")] = False,
    json_: Json = False,
) -> None:
    """Check scenario and tournament files; report mistakes and warnings with file, line and column."""
    from rcj_challenges.cli.validate import validate_files

    raise typer.Exit(validate_files(files, set_ or [], strict=strict, as_json=json_))


@app.command("test", cls=Command, rich_help_panel=WRITE, epilog="rcj-challenge test relay_race.yaml")
def play_tests(
    files: Annotated[
        list[str],
        typer.Argument(
            metavar="FILE...", autocompletion=complete_scenarios, help="Scenario files, or names of shipped ones."
        ),
    ],
    set_: Overrides = None,
    json_: Json = False,
) -> None:
    """Play the tests written in scenario files (expect:), without physics and without programs.

    All files are played, even after one that cannot be used. Exit status 0: all as expected; 1: a test failed;
    2: a file cannot be used, whatever the result of the others.
    """
    from rcj_challenges.cli.expect import run_tests

    raise typer.Exit(run_tests(files, set_ or [], as_json=json_))


@app.command(cls=Command, rich_help_panel=WRITE, epilog="rcj-challenge explain each-never-named")
def explain(
    code: Annotated[
        str | None, typer.Argument(metavar="CODE", help="A code, as in warning[each-never-named]; default: all.")
    ] = None,
) -> None:
    """Explain the code of an error or a warning."""
    from rcj_challenges.cli.explain import explain as explain_code

    raise typer.Exit(explain_code(code))


@app.command(
    cls=Command,
    rich_help_panel=WRITE,
    epilog="rcj-challenge new team my_team\nrcj-challenge new challenge relay_race",
)
def new(
    words: Annotated[
        list[str],
        typer.Argument(
            metavar="[team|challenge] NAME", help="What, and its name or path; one name alone: a challenge."
        ),
    ],
    preset: Annotated[
        str | None,
        typer.Option(
            "--from",
            metavar="PRESET",
            help="Field and robots of a challenge: soccersim_v2 (default), soccersim_2021 or empty_field.",
        ),
    ] = None,
) -> None:
    """Write a new team, or a challenge with a first program for it; nothing is overwritten."""
    from rcj_challenges.cli.new import new_scenario
    from rcj_challenges.cli.new_team import new_team
    from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError

    kind, name = ("challenge", words[0]) if len(words) == 1 else (words[0], words[-1])
    if kind not in ("team", "challenge") or len(words) > 2 or words in (["team"], ["challenge"]):
        asked = "rcj-challenge new team NAME, or rcj-challenge new challenge NAME"
        raise DiagnosticError(Diagnostic("bad-arguments", "new takes one name, and before it what it is", asked))
    if kind == "team" and preset is not None:
        raise DiagnosticError(Diagnostic("option-does-not-fit", "--from is for challenges", "leave it out"))
    raise typer.Exit(new_team(name) if kind == "team" else new_scenario(name, preset or "soccersim_v2"))


@app.command(cls=Command, rich_help_panel=WRITE, epilog="rcj-challenge schema --out scenario.schema.json")
def schema(
    out: Annotated[
        Path | None,
        typer.Option("--out", metavar="FILE", help="Where to write it; default: schemas/scenario.schema.json."),
    ] = None,
    tournament: Annotated[bool, typer.Option("--tournament", help="The schema of tournament files instead.")] = False,
    check: Annotated[bool, typer.Option("--check", help="Write nothing; exit 1 if a shipped one is stale.")] = False,
) -> None:
    """Write the JSON schema of scenario files or of tournament files, for completion in editors."""
    from rcj_challenges.cli.schema import check_schema, write_schema

    raise typer.Exit(check_schema() if check else write_schema(out, of_tournament=tournament))


@app.command(cls=Command, rich_help_panel=WRITE, epilog="rcj-challenge draw relay_race.yaml --out relay_race.svg")
def draw(
    scenario: ScenarioName,
    out: Annotated[
        Path | None,
        typer.Option("--out", "-o", metavar="FILE", help=".svg or .png; default: a file on a terminal, else SVG."),
    ] = None,
    set_: Overrides = None,
) -> None:
    """Draw the field with zones, gates, spots, start poses and placement areas."""
    from rcj_challenges.cli.draw import draw as draw_scenario

    raise typer.Exit(draw_scenario(scenario, out, set_ or []))


@app.command(cls=Command, rich_help_panel=WRITE, epilog="rcj-challenge sheet relay_race.yaml --out relay_race.html")
def sheet(
    scenario: ScenarioName,
    out: Annotated[
        Path | None,
        typer.Option(
            "--out",
            "-o",
            metavar="FILE",
            help=".html, or .md with an .svg beside it; default: an .html on a terminal, else Markdown.",
        ),
    ] = None,
    set_: Overrides = None,
) -> None:
    """Write the rule sheet for the teams."""
    from rcj_challenges.cli.sheet import sheet as write_sheet

    raise typer.Exit(write_sheet(scenario, out, set_ or []))


@app.command(
    cls=Command,
    rich_help_panel=PLAY,
    epilog="rcj-challenge simulate match --seeds 1..20 --yellow my_team --blue ball_chaser",
)
def simulate(
    scenario: ScenarioName,
    seeds: Seeds = "1..10",
    team: Teams = None,
    blue: Blue = None,
    yellow: Yellow = None,
    duration: Duration = None,
    halves: Halves = None,
    set_: Overrides = None,
    out: OutFolder = Path("runs"),
    at_once: AtOnce = None,
    json_: Json = False,
    quiet: Quiet = False,
    sandbox: Sandbox = "auto",
) -> None:
    """Play a challenge with many seeds in parallel and report scores, events and faults."""
    from rcj_challenges.cli import simulate as command

    teams, overrides = all_teams(team, blue, yellow), all_overrides(set_, duration, halves)
    raise typer.Exit(
        command.simulate(
            command.SimulateOptions(scenario, seeds, teams, overrides, out, at_once, json_, quiet, sandbox)
        )
    )


@app.command(cls=Command, rich_help_panel=PLAY, epilog="rcj-challenge compare my_team old_team --against ball_chaser")
def compare(
    new: Annotated[str, typer.Argument(metavar="NEW", help="The changed team.", autocompletion=complete_teams)],
    old: Annotated[str, typer.Argument(metavar="OLD", help="The team before.", autocompletion=complete_teams)],
    against: Annotated[
        str | None, typer.Option("--against", metavar="TEAM", help="The opponent.", autocompletion=complete_teams)
    ] = None,
    scenario: Annotated[
        str, typer.Option("--scenario", metavar="SCENARIO", help="What is played.", autocompletion=complete_scenarios)
    ] = "match",
    seeds: Seeds = "1..20",
    duration: Duration = None,
    halves: Halves = None,
    set_: Overrides = None,
    out: OutFolder = Path("runs"),
    at_once: AtOnce = None,
    json_: Json = False,
    quiet: Quiet = False,
    sandbox: Sandbox = "auto",
) -> None:
    """Compare two versions of a team: same seeds, opponent and seat. Is the difference more than chance?"""
    from rcj_challenges.cli import compare as command
    from rcj_challenges.cli.simulate import SimulateOptions

    overrides = all_overrides(set_, duration, halves)
    options = SimulateOptions(scenario, seeds, [], overrides, out, at_once, json_, quiet, sandbox)
    raise typer.Exit(command.compare(new, old, against, options))


@app.command(cls=Command, rich_help_panel=PLAY, epilog="rcj-challenge teams")
def teams() -> None:
    """List the sample teams, which can be used by name: --blue ball_chaser."""
    from rcj_challenges.cli.teams import list_teams

    raise typer.Exit(list_teams())


@app.command(cls=Command, rich_help_panel=WATCH, epilog="rcj-challenge view\nrcj-challenge view --list")
def view(
    run: Run = None,
    list_: Annotated[
        bool, typer.Option("--list", "-l", help="List the records instead, of DIR or of a folder given as RUN.")
    ] = False,
    out: RunsFolder = Path("runs"),
) -> None:
    """Open the replay page of a record in the browser."""
    from rcj_challenges.cli.view import list_records, view_record

    raise typer.Exit(list_records(run or out) if list_ else view_record(run, out))


@app.command(cls=Command, rich_help_panel=WATCH, epilog="rcj-challenge replay")
def replay(
    run: Run = None,
    out: RunsFolder = Path("runs"),
) -> None:
    """Write the replay page of a record again."""
    from rcj_challenges.cli.view import rebuild_replay

    raise typer.Exit(rebuild_replay(run, out))


check.register(app)
judge.register(app)
stats.register(app)
video.register(app)
tournament.register(app)
site.register(app)
submit.register(app)
verify.register(app)
