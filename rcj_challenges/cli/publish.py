"""``rcj-challenge tournament publish``: the site for everyone, and the folders for teams and organizer."""

from __future__ import annotations

import re
from collections.abc import Sequence
from datetime import datetime
from pathlib import Path

from rich.progress import Progress

from rcj_challenges.cli import OK
from rcj_challenges.core.amounts import counted
from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError
from rcj_challenges.core.errors import format_error
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.tournament.opened import OpenTournament
from rcj_challenges.tournament.site import SiteSource, publish, site_source
from rcj_challenges.views.console import console_for

_WEB_ADDRESS = re.compile(r"https?://[\w.-]+(:\d+)?(/\S*)?", re.IGNORECASE)
_MIN_SEED_LETTERS = 16
"""A shorter seed can be found by trial: its hash does not hide it."""


def publish_tournament(
    tournament: OpenTournament,
    now: datetime,
    premieres: Sequence[str],
    url: str,
    out: Path | None,
    *,
    may_shrink: bool,
) -> int:
    """Publish, and print where everything is; returns the exit code.

    Raises:
        DiagnosticError: a file cannot be written, the site of before shows more matches, there is no such stage, or
            the address is none.
    """
    if url and not _WEB_ADDRESS.fullmatch(url):
        help_ = "give the address of the site as browsers know it: https://cup.example"
        message = f"--url {sanitize(url)} does not begin with http:// or https://"
        raise DiagnosticError(Diagnostic("bad-url", message, help_))
    source = site_source(tournament, now, premieres, url)
    data = out if out is not None else tournament.store.place.folder
    console = console_for()
    try:
        with Progress(console=console, transient=True, disable=not console.is_terminal) as bars:
            task = bars.add_task("matches", total=None)
            published = publish(
                source, data, lambda done, total: bars.update(task, completed=done, total=total), may_shrink=may_shrink
            )
    except OSError as error:
        message = f"cannot write {sanitize(error.filename or data)}: {format_error(error)}"
        help_ = "make room, give access or choose another folder with --out; the site of before is still there"
        raise DiagnosticError(Diagnostic("site-unwritable", message, help_)) from error
    lines = [
        f"{counted(published.matches, 'match', 'matches')} published, {published.reused} of them as before",
        f"for everyone:  {_index(published.site)}",
        f"for teams:     {published.for_teams} (a folder each; not for others)",
        f"for you:       {published.organizer}",
        *(f"upload at {_local(one.at, source)}: {one.file} to premiere/" for one in published.recordings),
    ]
    if len(source.seed) < _MIN_SEED_LETTERS and not source.is_over:
        lines.append("note: the seed is so short that its published hash can be guessed; next time take a longer one")
    for line in lines:
        console.print(line, markup=False, highlight=False, soft_wrap=True)
    return OK


def _local(at: datetime, source: SiteSource) -> str:
    return f"{at.astimezone(source.time_zone):%Y-%m-%d %H:%M %Z}"


def _index(site: Path) -> Path:
    return site / "index.html"
