"""``rcj-challenge tournament``: plan, play, follow and decide a tournament that is declared in YAML."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from rcj_challenges.cli.help import ORGANIZE, PLAY, WATCH, Command, Group
from rcj_challenges.cli.stdio import print_json

if TYPE_CHECKING:
    from rcj_challenges.tournament.opened import OpenTournament

tournament_app = typer.Typer(
    name="tournament",
    cls=Group,
    rich_markup_mode=None,
    help="Plan, play and publish a tournament that is declared in YAML.",
    epilog="rcj-challenge tournament plan cup\nrcj-challenge tournament run cup",
    no_args_is_help=True,
    add_completion=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)

File = Annotated[str, typer.Argument(metavar="FILE", help="A tournament file, or the name of a shipped one: cup.")]
Data = Annotated[
    Path | None,
    typer.Option("--data", metavar="DIR", help="Folder of its data; default: NAME_data in the current folder."),
]
_AtOnce = Annotated[
    int | None, typer.Option("--at-once", metavar="N", min=1, help="Matches at a time; default: cores.")
]
_Sandbox = Annotated[
    str, typer.Option("--sandbox", metavar="auto|strict|off", help="How programs are isolated (docs/isolation.md).")
]
_Json = Annotated[bool, typer.Option("--json", help="Print it as JSON and nothing else.")]
_Quiet = Annotated[bool, typer.Option("--quiet", "-q", help="Print only the last lines.")]
_Cascade = Annotated[
    bool, typer.Option("--cascade", help="Play again what depends on a change, also in stages that have begun.")
]


def register(app: typer.Typer) -> None:
    """Add the commands."""
    app.add_typer(tournament_app, rich_help_panel=ORGANIZE)


@contextmanager
def opened(file: str, data: Path | None, *, writing: bool = False) -> Iterator[OpenTournament]:
    """Open a tournament with its store.

    Raises:
        RcjError: the file or the store cannot be used.
    """
    from rcj_challenges.tournament.load import load_tournament
    from rcj_challenges.tournament.opened import OpenTournament, data_folder
    from rcj_challenges.tournament.store.store import Store

    loaded = load_tournament(file)
    with Store(data_folder(loaded, data), writing=writing) as store:
        yield OpenTournament(loaded, store)


@tournament_app.command(cls=Command, rich_help_panel=PLAY, epilog="rcj-challenge tournament plan cup")
def plan(file: File, data: Data = None, json_: _Json = False) -> None:
    """List the known fixtures, the number of matches, and the time and disk space that they need here."""
    from rcj_challenges.cli.tournament_plan import print_plan

    with opened(file, data) as tournament:
        raise typer.Exit(print_plan(tournament, as_json=json_))


@tournament_app.command(cls=Command, rich_help_panel=PLAY, epilog="rcj-challenge tournament run cup")
def run(
    file: File,
    data: Data = None,
    at_once: _AtOnce = None,
    sandbox: _Sandbox = "auto",
    accept: Annotated[
        list[str] | None,
        typer.Option("--accept", metavar="TEAM", help="Let a team play although it fails the check. Repeatable."),
    ] = None,
    cascade: _Cascade = False,
    cluster: Annotated[
        str | None,
        typer.Option("--cluster", metavar="ADDRESS", help="Play on the workers of a Dask cluster: tcp://HOST:8786."),
    ] = None,
    shared: Annotated[
        bool, typer.Option("--shared", help="The workers of the cluster see the data folder under the same path.")
    ] = False,
    redraw: Annotated[
        bool, typer.Option("--redraw", help="Draw again after a change; matches of pairs that still exist are kept.")
    ] = False,
    add: Annotated[
        list[str] | None,
        typer.Option("--add", metavar="TEAM", help="Take a late team into what is not drawn yet, and round robins."),
    ] = None,
    quiet: _Quiet = False,
) -> None:
    """Check all submissions, then play what has not been played yet. After an interruption, run it again to continue.

    Exit status 0: everything is played; 1: a submission fails the check; 2: wrong input, or this computer cannot
    continue; 3: a match could not be played because of a bug in this project.
    """
    from rcj_challenges.cli.tournament_run import RunOptions, run_tournament

    with opened(file, data, writing=True) as tournament:
        options = RunOptions(
            at_once, sandbox, frozenset(accept or ()), cascade, quiet, cluster, shared, redraw, tuple(add or ())
        )
        raise typer.Exit(run_tournament(tournament, options))


@tournament_app.command(cls=Command, rich_help_panel=PLAY, epilog="rcj-challenge tournament status cup")
def status(file: File, data: Data = None, json_: _Json = False) -> None:
    """Show the progress: matches by stage, doubtful ones, and those that could not be played."""
    from rcj_challenges.cli.tournament_results import print_status

    with opened(file, data) as tournament:
        raise typer.Exit(print_status(tournament, as_json=json_))


@tournament_app.command(cls=Command, rich_help_panel=WATCH, epilog="rcj-challenge tournament results cup")
def results(
    file: File,
    data: Data = None,
    json_: _Json = False,
    csv: Annotated[
        Literal["tables", "matches"] | None, typer.Option("--csv", help="Print all tables or all matches as CSV.")
    ] = None,
) -> None:
    """Print tables, brackets and scores."""
    from rcj_challenges.cli.tournament_results import print_results

    with opened(file, data) as tournament:
        raise typer.Exit(print_results(tournament, as_json=json_, as_csv=csv))


@tournament_app.command(cls=Command, rich_help_panel=WATCH, epilog="rcj-challenge tournament publish cup")
def publish(
    file: File,
    data: Data = None,
    premiere: Annotated[
        list[str] | None,
        typer.Option(
            "--premiere", metavar="STAGE", help="The matches of this stage have a premiere when released. Repeatable."
        ),
    ] = None,
    url: Annotated[
        str, typer.Option("--url", metavar="URL", help="Where the site will be, for the feed and the calendar.")
    ] = "",
    out: Annotated[
        Path | None, typer.Option("--out", metavar="DIR", help="Where to write it; default: the data folder.")
    ] = None,
    fewer: Annotated[
        bool, typer.Option("--fewer", help="Replace the site even if it shows more matches than the new one.")
    ] = False,
) -> None:
    """Write the site with all results released so far, and a private folder for each team."""
    from rcj_challenges.cli.publish import publish_tournament
    from rcj_challenges.records.folder import utc_now

    with opened(file, data) as tournament:
        raise typer.Exit(publish_tournament(tournament, utc_now(), premiere or [], url, out, may_shrink=fewer))


@tournament_app.command(
    cls=Command,
    rich_help_panel=ORGANIZE,
    epilog='rcj-challenge tournament decide cup MATCH --replay --reason "a robot broke"',
)
def decide(
    file: File,
    match: Annotated[
        str | None, typer.Argument(metavar="[MATCH]", help="Which match, as plan prints it; none with --withdraw.")
    ] = None,
    reason: Annotated[str, typer.Option("--reason", metavar="TEXT", help="Why; it is published.")] = "",
    forfeit: Annotated[
        list[str] | None,
        typer.Option("--forfeit", metavar="TEAM", help="This team loses the match; given for both, both lose."),
    ] = None,
    replay: Annotated[bool, typer.Option("--replay", help="The match is played again with a different seed.")] = False,
    score: Annotated[
        str | None, typer.Option("--score", metavar="A:B", help="The score is corrected: sides as plan prints them.")
    ] = None,
    withdraw: Annotated[
        str | None, typer.Option("--withdraw", metavar="TEAM", help="This team leaves the tournament.")
    ] = None,
    undo: Annotated[
        bool, typer.Option("--undo", help="Take the last ruling on the match back, or with --withdraw a withdrawal.")
    ] = False,
    cascade: _Cascade = False,
    data: Data = None,
) -> None:
    """Record a referee's ruling on a match, or the withdrawal of a team; it is always shown as a ruling."""
    from rcj_challenges.cli.tournament_decide import record_decision

    with opened(file, data, writing=True) as tournament:
        code = record_decision(
            tournament, match, reason,
            forfeit=forfeit, replay=replay, score=score, withdrawn=withdraw, undo=undo, cascade=cascade,
        )  # fmt: skip
    raise typer.Exit(code)


@tournament_app.command(cls=Command, rich_help_panel=ORGANIZE, epilog="rcj-challenge tournament verify cup --sample 5")
def verify(
    file: File,
    matches: Annotated[
        list[str] | None, typer.Argument(metavar="[MATCH...]", help="Which matches; default: all.")
    ] = None,
    sample: Annotated[
        int | None, typer.Option("--sample", metavar="N", min=1, help="Only this many, drawn at random.")
    ] = None,
    data: Data = None,
    at_once: _AtOnce = None,
    json_: _Json = False,
) -> None:
    """Play matches again and compare their digests.

    Exit status 0: none differs; 1: one differs; 2: wrong input; 3: one could not be played.
    """
    from rcj_challenges.cli.tournament_verify import verify_tournament

    with opened(file, data, writing=True) as tournament:
        raise typer.Exit(verify_tournament(tournament, matches or [], sample=sample, at_once=at_once, as_json=json_))


@tournament_app.command(cls=Command, rich_help_panel=ORGANIZE, epilog="rcj-challenge tournament rerun cup")
def rerun(
    file: File,
    matches: Annotated[
        list[str] | None,
        typer.Argument(metavar="[MATCH...]", help="Which matches, as plan prints them; default: all."),
    ] = None,
    records: Annotated[
        Literal["full", "replay", "result"], typer.Option("--records", help="What to keep of the records now.")
    ] = "full",
    data: Data = None,
    at_once: _AtOnce = None,
) -> None:
    """Play matches again to recreate parts of their records that were not kept; the results stay the same."""
    from rcj_challenges.cli.tournament_verify import rerun_matches

    with opened(file, data, writing=True) as tournament:
        raise typer.Exit(rerun_matches(tournament, matches or [], records, at_once=at_once))


@tournament_app.command(
    cls=Command, rich_help_panel=ORGANIZE, epilog="rcj-challenge tournament judge cup --set ball_progress_s=15"
)
def judge(
    file: File,
    set_: Annotated[
        list[str] | None,
        typer.Option("--set", metavar="PATH=VALUE", help="Change a value of the rules. Repeatable."),
    ] = None,
    data: Data = None,
    json_: _Json = False,
) -> None:
    """Show how played matches would have ended under changed rules; no program runs."""
    from rcj_challenges.cli.tournament_judge import judge_tournament

    with opened(file, data) as tournament:
        raise typer.Exit(judge_tournament(tournament, set_ or [], as_json=json_))


@tournament_app.command("play-job", hidden=True)
def play_job(job: str, data: Path) -> None:
    """Play one job in this process, for the pool of workers; print its result as JSON."""
    import json
    import os

    # MuJoCo would load a window system's library, 50 ms, and a match draws nothing.
    os.environ.setdefault("MUJOCO_GL", "disable")
    from rcj_challenges.tournament.jobs import MatchJob, Workplace
    from rcj_challenges.tournament.playing import play_job as play

    played = play(MatchJob.from_json(json.loads(job)), Workplace(data))
    print_json({**played.result, "folder": str(played.folder)})
