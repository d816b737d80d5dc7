"""``rcj-challenge view``: opens the page of a record, or lists records."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

import typer

from rcj_challenges.cli.app import WATCH, app
from rcj_challenges.cli.options import Run, RunsFolder
from rcj_challenges.cli.stdio import print_lines, shown_path
from rcj_challenges.core.sanitize import sanitize


@app.register(WATCH, "rcj-challenge view", "rcj-challenge view --list")
def view(
    run: Run = None,
    list_: Annotated[
        bool, typer.Option("--list", "-l", help="List the records instead, of DIR or of a folder given as RUN.")
    ] = False,
    out: RunsFolder = Path("runs"),
) -> None:
    """Open the replay page of a record in the browser."""
    from rcj_challenges.views.replay.browse import find_run, open_replay

    if list_:
        _list_records(run or out)
        return
    page, opened = open_replay(find_run(run, out))
    sys.stdout.write(f"{shown_path(page)}\n")
    if not opened:
        sys.stdout.write("no browser could be started here: open this file in one\n")


def _list_records(out: Path) -> None:
    """Print the records with date, score and teams, the newest first.

    Raises:
        RecordError: there is no such folder, or no record in it.
    """
    from rcj_challenges.views.console import console_for
    from rcj_challenges.views.naming import score_line, shown_names
    from rcj_challenges.views.replay.browse import list_runs

    console = console_for()
    for row in list_runs(out):
        if row.result is None:
            print_lines(console, f"{sanitize(row.folder.name)}  {sanitize(row.problem)}")
            continue
        names = {team: entrant.name for team, entrant in row.result.entrants.items()}
        swapped = any(seat != team for half in row.result.halves for seat, team in half.sides.items())
        score = score_line(shown_names(names, sides_change=swapped), row.score) + (
            "" if row.result.complete else "  (not complete)"
        )
        started = row.result.started[:19].replace("T", " ")
        print_lines(console, f"{sanitize(row.folder.name)}  {started}  {row.result.scenario}  {score}")
