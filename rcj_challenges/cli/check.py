"""``rcj-challenge check``: will these submissions play?"""

from __future__ import annotations

import os
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from rcj_challenges.facts.errors import RcjError

if TYPE_CHECKING:
    from rich.console import Console

    from rcj_challenges.checker.check import CheckOptions
    from rcj_challenges.checker.report import CheckReport, FileReport
    from rcj_challenges.scenario.load import Loaded

_ARCHIVES = frozenset({".zip", ".rar", ".7z", ".tar", ".gz", ".tgz", ".bz2", ".xz"})


class CheckUsageError(RcjError):
    """Options that do not fit together, or a path that cannot be opened."""


@dataclass(frozen=True)
class CheckCommand:
    """The options of ``check``, as given."""

    paths: list[Path]
    scenario: str
    overrides: list[str]
    sandbox: str
    jobs: int | None
    fix: Path | None
    html: Path | None
    json: bool
    replays: Path | None
    show_output: bool
    play: bool


def register(app: typer.Typer) -> None:
    """Add the command."""
    app.command("check")(_check)


def _check(
    paths: Annotated[
        list[Path],
        typer.Argument(metavar="FILE|FOLDER...", help="Submissions: ZIPs or folders; or a folder full of ZIPs."),
    ],
    scenario: Annotated[
        str, typer.Option("--scenario", "-s", metavar="S", help="What they are for: a file, or a shipped one's name.")
    ] = "match",
    set_: Annotated[
        list[str] | None,
        typer.Option("--set", metavar="PATH=VALUE", help="Change a param or any value of the scenario. Repeatable."),
    ] = None,
    fix: Annotated[
        Path | None,
        typer.Option("--fix", metavar="OUT.zip", help="Write a repaired archive, and check that one."),
    ] = None,
    html: Annotated[
        Path | None, typer.Option("--html", metavar="OUT", help="Write the report as an HTML page.")
    ] = None,
    json_: Annotated[bool, typer.Option("--json", help="Print the report as JSON and nothing else.")] = False,
    replay: Annotated[
        Path | None, typer.Option("--replay", metavar="DIR", help="Keep the replay pages of the short matches.")
    ] = None,
    show_output: Annotated[bool, typer.Option("--show-output", help="Show what the programs printed.")] = False,
    play: Annotated[bool, typer.Option("--play/--no-play", help="--no-play runs no program.")] = True,
    jobs: Annotated[
        int | None, typer.Option("--jobs", "-j", min=1, help="How many at a time; default: as many as cores.")
    ] = None,
    sandbox: Annotated[
        str, typer.Option("--sandbox", metavar="auto|strict|off", help="How programs are isolated (docs/isolation.md).")
    ] = "auto",
) -> None:
    """Say whether submissions will play in the tournament, and what to do if not: opens, starts and plays them.

    Exit status 0: all will play; 1: some will not; 2: wrong usage, or a path that cannot be opened.
    """
    command = CheckCommand(
        paths=paths,
        scenario=scenario,
        overrides=set_ or [],
        sandbox=sandbox,
        jobs=jobs,
        fix=fix,
        html=html,
        json=json_,
        replays=replay,
        show_output=show_output,
        play=play,
    )
    raise typer.Exit(check_submissions(command))


def check_submissions(command: CheckCommand) -> int:
    """Check them; returns 0 if all will play, else 1.

    Raises:
        RcjError: wrong usage.
    """
    from rcj_challenges.controllers.isolation import active_layers
    from rcj_challenges.scenario.load import load

    loaded = load(command.scenario, command.overrides)
    active_layers(command.sandbox)
    paths = submissions(command.paths)
    if command.fix is not None and len(paths) != 1:
        raise CheckUsageError(f"--fix repairs one submission at a time, not {len(paths)}")

    from rcj_challenges.checker.check import CheckOptions
    from rcj_challenges.checker.report import check_report
    from rcj_challenges.views.scoreboard import console_for

    options = CheckOptions(
        sandbox=command.sandbox, play=command.play, replays=command.replays, show_output=command.show_output
    )
    files = (
        [_check_one(paths[0], loaded, options, command.fix)]
        if len(paths) == 1
        else _check_many(paths, loaded, options, command)
    )
    report = check_report(loaded.scenario.id, loaded.scenario.title, command.sandbox, files)
    _publish(report, command, console_for(to_stderr=command.json))
    return report.exit_code


def submissions(given: list[Path]) -> list[Path]:
    """Return the submissions: of a folder full of archives each of them, everything else as it is.

    Raises:
        CheckUsageError: one cannot be opened.
    """
    found: list[Path] = []
    for path in given:
        try:
            path.stat()
            if path.is_dir():
                found += _archives_in(path) or [path]
            elif path.is_file():
                with path.open("rb"):
                    found.append(path)
            else:
                raise CheckUsageError(f"{_safe(path)}: cannot be opened: it is neither a file nor a folder")
        except (OSError, ValueError) as error:
            reason = getattr(error, "strerror", None) or str(error)
            raise CheckUsageError(f"{_safe(path)}: cannot be opened: {reason}") from error
    return list(dict.fromkeys(found))


def _archives_in(folder: Path) -> list[Path]:
    """Return the archives in a folder; none if it is a team's own, which may have an old ZIP lying about."""
    entries = sorted(folder.iterdir())
    archives = [entry for entry in entries if entry.suffix.lower() in _ARCHIVES and entry.is_file()]
    programs = [entry for entry in entries if entry.suffix == ".py"]
    programs += [inner for entry in entries if archives and entry.is_dir() for inner in entry.glob("*.py")]
    return [] if programs else archives


def _check_one(path: Path, loaded: Loaded, options: CheckOptions, fix: Path | None) -> FileReport:
    from rcj_challenges.checker.check import check_file
    from rcj_challenges.checker.report_text import repaired_lines

    if fix is None:
        return check_file(path, loaded, options)

    from rcj_challenges.checker.repair import repair

    repaired = repair(path, fix, loaded.scenario)
    if repaired.out is None:
        return check_file(path, loaded, options, ["nothing: the submission cannot be read well enough"])
    return check_file(repaired.out, loaded, options, repaired_lines(repaired.done) or ["nothing: there was no need"])


def _check_many(paths: list[Path], loaded: Loaded, options: CheckOptions, command: CheckCommand) -> list[FileReport]:
    from rcj_challenges.checker.many import check_many
    from rcj_challenges.checker.report_text import progress_line
    from rcj_challenges.views.scoreboard import console_for

    console = console_for(to_stderr=True)
    done = 0

    def on_done(file: FileReport) -> None:
        nonlocal done
        done += 1
        if not command.json:
            console.print(progress_line(done, len(paths), file), markup=False, highlight=False, soft_wrap=True)

    return check_many(paths, loaded, options, command.jobs or os.cpu_count() or 1, on_done)


def _publish(report: CheckReport, command: CheckCommand, console: Console) -> None:
    """Print the report, and write the page if one is asked for.

    Raises:
        CheckUsageError: the page cannot be written.
    """
    from rcj_challenges.checker.report import json_text

    if command.json:
        sys.stdout.write(json_text(report))
    else:
        from rcj_challenges.checker.report_text import print_report

        print_report(console, report)
    if command.html is None:
        return

    from rcj_challenges.checker.report_html import html_page

    try:
        command.html.parent.mkdir(parents=True, exist_ok=True)
        command.html.write_text(html_page(report, command.html.parent), encoding="utf-8", newline="\n")
    except OSError as error:
        raise CheckUsageError(f"{_safe(command.html)}: cannot be written: {error.strerror or error}") from error
    if not command.json:
        console.print(f"report: {_safe(command.html)}", markup=False, highlight=False, soft_wrap=True)


def _safe(path: Path) -> str:
    from rcj_challenges.facts.shown import shown

    return shown(path)
