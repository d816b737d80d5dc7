"""``rcj-challenge check``: will these submissions play?"""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from rcj_challenges.cli.app import SUBMIT, app
from rcj_challenges.cli.options import Json, Overrides, Sandbox, complete_scenarios
from rcj_challenges.cli.stdio import print_json, print_lines, print_progress, require_layers
from rcj_challenges.core.codes import BAD_OPTION, CANNOT_OPEN, CANNOT_WRITE
from rcj_challenges.core.errors import RcjError, format_error, room_help
from rcj_challenges.core.sanitize import sanitize

if TYPE_CHECKING:
    from rich.console import Console

    from rcj_challenges.checker.check import CheckOptions
    from rcj_challenges.checker.discovery import Submissions
    from rcj_challenges.checker.report import CheckReport, FileReport
    from rcj_challenges.scenario.load import Loaded


@app.register(SUBMIT, "rcj-challenge check my_team.zip", "rcj-challenge check my_team --fix my_team.zip")
def check(
    paths: Annotated[
        list[Path],
        typer.Argument(metavar="FILE|FOLDER...", help="Submissions: ZIPs or folders; or a folder full of ZIPs."),
    ],
    scenario: Annotated[
        str,
        typer.Option(
            "--scenario",
            "-s",
            metavar="SCENARIO",
            autocompletion=complete_scenarios,
            help="The scenario to check for: a file, or the name of a shipped one.",
        ),
    ] = "match",
    set_: Overrides = None,
    fix: Annotated[
        Path | None, typer.Option("--fix", metavar="OUT.zip", help="Write a repaired archive, and check that one.")
    ] = None,
    html: Annotated[
        Path | None, typer.Option("--html", metavar="OUT", help="Write the report as an HTML page.")
    ] = None,
    json_: Json = False,
    replay: Annotated[
        Path | None, typer.Option("--replay", metavar="DIR", help="Keep the replay pages of the short matches.")
    ] = None,
    show_output: Annotated[bool, typer.Option("--show-output", help="Show what the programs printed.")] = False,
    play: Annotated[bool, typer.Option("--play/--no-play", help="--no-play runs no program.")] = True,
    jobs: Annotated[
        int | None,
        typer.Option("--jobs", "-j", metavar="N", min=1, help="How many at a time; default: as many as cores."),
    ] = None,
    sandbox: Sandbox = "auto",
) -> int:
    """Check whether submissions will play in the tournament, by playing a short match, and explain what to do if not.

    Exit status 0: all will play; 1: some will not; 2: wrong usage, a path that cannot be opened or written, or
    some could not be checked on this computer; 3: some could not be checked because of a bug in this project.
    """
    from rcj_challenges.checker.report_files import ensure_folder, ensure_page
    from rcj_challenges.cli.output_paths import refuse_devices
    from rcj_challenges.cli.team_args import path_or_sample_team
    from rcj_challenges.scenario.load import load

    refuse_devices(html=html, fix=fix, replay=replay)
    loaded = load(scenario, set_ or [])
    require_layers(sandbox)
    given = _submissions([path_or_sample_team(path) for path in paths])
    if fix is not None and len(given.paths) != 1:
        message = f"--fix repairs one submission at a time, not {len(given.paths)}"
        raise RcjError(message, "give one of them", code=BAD_OPTION)
    if fix is not None and str(fix).startswith("-"):
        raise RcjError(f"--fix {fix}: the name of the ZIP to write is missing", "--fix repaired.zip", code=BAD_OPTION)
    # Before anything takes time.
    if html is not None:
        with _or_usage_error(html, "written"):
            ensure_page(html)
    if replay is not None and play:
        with _or_usage_error(replay, "written"):
            ensure_folder(replay)

    from rcj_challenges.checker.check import CheckOptions
    from rcj_challenges.checker.discovery import name_submissions
    from rcj_challenges.checker.report import LeftOut, check_report
    from rcj_challenges.views.console import console_for

    options = CheckOptions(sandbox, play, replays=replay, show_output=show_output)
    done: list[FileReport] = []
    interrupted = False
    try:
        if len(given.paths) == 1:
            done.append(_check_one(given.paths[0], loaded, options, fix))
        else:
            _check_many(given.paths, loaded, options, jobs or os.cpu_count() or 1, done, quiet=json_)
    except KeyboardInterrupt:
        interrupted = True
    order = {one.name: number for number, one in enumerate(name_submissions(given.paths))} if interrupted else {}
    names = {file.file for file in done}
    reason = "the check was interrupted before it was done"
    report = check_report(
        loaded.scenario.id,
        loaded.scenario.title,
        sandbox,
        sorted(done, key=lambda file: order.get(file.file, 0)),
        [*given.left_out, *(LeftOut(file=name, reason=reason) for name in order if name not in names)],
        interrupted=interrupted,
    )
    _publish(report, html, console_for(to_stderr=json_), as_json=json_)
    if interrupted:
        raise KeyboardInterrupt
    return report.exit_code


def _submissions(given: list[Path]) -> Submissions:
    """The submissions: of a folder full of archives each of them, everything else as it is.

    Raises:
        RcjError: one cannot be opened.
    """
    from rcj_challenges.checker.discovery import find_submissions

    for path in given:
        with _or_usage_error(path, "opened"):
            path.stat()
            if path.is_file():
                path.open("rb").close()
            elif not path.is_dir():
                message = f"{sanitize(path)}: cannot be opened: it is neither a file nor a folder"
                raise RcjError(message, code=CANNOT_OPEN)
            else:
                find_submissions([path])
    return find_submissions(given)


@contextmanager
def _or_usage_error(path: Path, done: str) -> Iterator[None]:
    """Make an error of the system one that says which path cannot be opened or written, and why."""
    try:
        yield
    except (OSError, ValueError) as error:
        code = CANNOT_OPEN if done == "opened" else CANNOT_WRITE
        message = f"{sanitize(path)}: cannot be {done}: {format_error(error)}"
        raise RcjError(message, room_help(error), code=code) from error


def _check_one(path: Path, loaded: Loaded, options: CheckOptions, fix: Path | None) -> FileReport:
    from rcj_challenges.checker.check import check_file

    if fix is None:
        return check_file(path, loaded, options)

    from rcj_challenges.checker.repair import repair

    repaired = repair(path, fix, loaded.scenario)
    if repaired.out is None:
        return check_file(path, loaded, options, ["nothing: the submission cannot be read well enough"])
    why_nothing = "the following must be repaired by hand" if repaired.left else "there was no need"
    return check_file(repaired.out, loaded, options, [*map(sanitize, repaired.done)] or [f"nothing: {why_nothing}"])


def _check_many(
    paths: list[Path], loaded: Loaded, options: CheckOptions, jobs: int, done: list[FileReport], *, quiet: bool
) -> None:
    """Check several, and print a line for each when it is done.

    ``done`` takes the reports: as they come, so that they survive an interruption, at the end in order.
    """
    from rcj_challenges.checker.many import check_many
    from rcj_challenges.checker.report_text import progress_line
    from rcj_challenges.views.console import console_for

    console = console_for(to_stderr=True)

    def on_done(file: FileReport) -> None:
        done.append(file)
        if not quiet:
            print_progress(console, progress_line(len(done), len(paths), file))

    done[:] = check_many(paths, loaded, options, jobs, on_done)


def _publish(report: CheckReport, html: Path | None, console: Console, *, as_json: bool) -> None:
    """Print the report, and write the page if one is asked for: also if the report cannot be printed.

    Raises:
        RcjError: the page cannot be written.
    """
    try:
        if as_json:
            print_json(report.model_dump(mode="json"))
        else:
            from rcj_challenges.checker.report_text import print_report

            print_report(console, report)
    finally:
        if html is not None:
            from rcj_challenges.checker.report_files import write_page
            from rcj_challenges.checker.report_html import html_page

            page = html_page(report, html.parent)
            with _or_usage_error(html, "written"):
                write_page(html, page)
    if html is not None and not as_json:
        print_lines(console, f"report: {sanitize(html)}")
