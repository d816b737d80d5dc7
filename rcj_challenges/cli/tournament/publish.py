"""``rcj-challenge tournament publish``: the site for everyone, and the folders for teams and organizer."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Annotated

import typer

from rcj_challenges.cli.app import WATCH
from rcj_challenges.cli.codes import BAD_URL
from rcj_challenges.cli.stdio import print_lines
from rcj_challenges.cli.tournament.group import Data, File, opened, tournament_app
from rcj_challenges.core.amounts import counted
from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError
from rcj_challenges.core.errors import format_error
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.tournament.codes import SITE_UNWRITABLE

_WEB_ADDRESS = re.compile(r"https?://[\w.-]+(:\d+)?(/\S*)?", re.IGNORECASE)
_MIN_SEED_LENGTH = 16
"""A shorter seed can be found by trial: its hash does not hide it."""


@tournament_app.register(WATCH, "rcj-challenge tournament publish cup")
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
    from rich.progress import Progress

    from rcj_challenges.records.folder import utc_now
    from rcj_challenges.tournament.site import publish as write_site
    from rcj_challenges.tournament.site import site_source
    from rcj_challenges.views.console import console_for

    if url and not _WEB_ADDRESS.fullmatch(url):
        help_ = "give the address of the site as browsers know it: https://cup.example"
        message = f"--url {sanitize(url)} does not begin with http:// or https://"
        raise DiagnosticError(Diagnostic(BAD_URL, message, help_))
    with opened(file, data) as tournament:
        source = site_source(tournament, utc_now(), premiere or [], url)
        target = out if out is not None else tournament.store.place.folder
        console = console_for()
        try:
            with Progress(console=console, transient=True, disable=not console.is_terminal) as bars:
                task = bars.add_task("matches", total=None)
                published = write_site(
                    source, target, lambda done, total: bars.update(task, completed=done, total=total), may_shrink=fewer
                )
        except OSError as error:
            message = f"cannot write {sanitize(error.filename or target)}: {format_error(error)}"
            help_ = "make room, give access or choose another folder with --out; the site of before is still there"
            raise DiagnosticError(Diagnostic(SITE_UNWRITABLE, message, help_)) from error
    lines = [
        f"{counted(published.matches, 'match', 'matches')} published, {published.reused} of them as before",
        f"for everyone:  {published.site / 'index.html'}",
        f"for teams:     {published.for_teams} (a folder each; not for others)",
        f"for you:       {published.organizer}",
        *(
            f"upload at {one.at.astimezone(source.time_zone):%Y-%m-%d %H:%M %Z}: {one.file} to premiere/"
            for one in published.recordings
        ),
    ]
    if len(source.seed) < _MIN_SEED_LENGTH and not source.is_over:
        lines.append("note: the seed is so short that its published hash can be guessed; next time take a longer one")
    print_lines(console, *lines)
