"""``rcj-challenge view`` and ``replay``: the pages of records."""

from __future__ import annotations

import sys
from pathlib import Path

from rcj_challenges.cli.stdio import print_lines, shown_path
from rcj_challenges.core.sanitize import sanitize

_NARROW = 70
"""Narrower terminals get lines instead of a table."""


def view_record(run: Path | None, out: Path) -> int:
    """Open a record's page, and print where it is; returns the exit code.

    Raises:
        RecordError: there is no such record, or nothing in it can be shown.
    """
    from rcj_challenges.views.replay.browse import find_run, open_replay

    page, opened = open_replay(find_run(run, out))
    sys.stdout.write(f"{shown_path(page)}\n")
    if not opened:
        sys.stdout.write("no browser could be started here: open this file in one\n")
    return 0


def rebuild_replay(run: Path | None, out: Path) -> int:
    """Write a record's page again and print where it is; returns the exit code.

    Raises:
        RecordError: there is no such record, or nothing in it can be shown.
    """
    from rcj_challenges.records.run_record import read_run
    from rcj_challenges.views.replay import write_replay
    from rcj_challenges.views.replay.browse import find_run

    folder = find_run(run, out)
    sys.stdout.write(f"{shown_path(write_replay(folder))}\n")
    for problem in read_run(folder).problems:
        sys.stderr.write(f"{sanitize(problem, 500)}\n")
    return 0


def list_records(out: Path) -> int:
    """Print the records with date, score and teams, the newest first; returns the exit code.

    Raises:
        RecordError: there is no such folder, or no record in it.
    """
    from rich.table import Column, Table

    from rcj_challenges.views.console import console_for
    from rcj_challenges.views.replay.browse import list_runs
    from rcj_challenges.views.score_lines import score_line

    table = Table(Column("record", no_wrap=True), "started", "scenario", "score")
    rows: list[tuple[str, str, str, str]] = []
    for row in list_runs(out):
        if row.result is None:
            rows.append((sanitize(row.folder.name), "", "", sanitize(row.problem)))
            continue
        names = {team: entrant.name for team, entrant in row.result.entrants.items()}
        swapped = any(seat != team for half in row.result.halves for seat, team in half.sides.items())
        score = score_line(names, row.score, sides_change=swapped) + ("" if row.result.complete else "  (not complete)")
        started = row.result.started[:19].replace("T", " ")
        rows.append((sanitize(row.folder.name), started, row.result.scenario, score))
    console = console_for()
    if console.width < _NARROW:  # a table would cut off its cells
        print_lines(console, *("  ".join(filter(None, cells)) for cells in rows))
        return 0
    for cells in rows:
        table.add_row(*cells)
    console.print(table)
    return 0
