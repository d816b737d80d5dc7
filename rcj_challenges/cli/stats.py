"""``rcj-challenge stats``: figures of one run or of several together."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from rcj_challenges.cli.app import WATCH, app
from rcj_challenges.cli.options import Json, Runs, RunsFolder
from rcj_challenges.cli.stdio import print_json, print_lines
from rcj_challenges.core.amounts import counted, number_words
from rcj_challenges.core.diagnostics import render_error
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.core.timing import TICK_S

if TYPE_CHECKING:
    from rich.console import Console

    from rcj_challenges.views.stats import Stats

_NOTHING = "-"
_HEADS = {
    "possession": "posses-\nsion %",
    "distance_m": "dis-\ntance m",
    "mean_mps": "aver-\nage m/s",
    "max_mps": "top\nm/s",
    "touches": "touches",
    "shots": "shots",
    "on_goal": "on\ngoal",
    "own_half": "own\nhalf %",
}
"""Narrow enough for a terminal of 80 columns."""
_NAMES = 10
"""Columns of the terminal that names have at least; longer ones take more lines."""


@app.register(WATCH, "rcj-challenge stats --explain")
def stats(
    runs: Runs = None,
    out: RunsFolder = Path("runs"),
    json_: Json = False,
    explain: Annotated[
        bool, typer.Option("--explain", help="Explain below the table how each figure is defined.")
    ] = False,
) -> int:
    """Possession, distance, speeds, shots, faults and referee calls; several runs are added up by team."""
    from rcj_challenges.records.errors import RecordError
    from rcj_challenges.views.console import console_for
    from rcj_challenges.views.replay.browse import find_run
    from rcj_challenges.views.stats import merge_stats, run_stats, stats_as_json

    given = runs or (None,)
    found, errors = [], []
    folders: dict[Path, Path] = {}  # what is given twice counts once
    for run in given:
        try:
            folder = find_run(run, out)
            if folders.setdefault(folder.resolve(), folder) is folder:
                found.append(run_stats(folder))
        except RecordError as error:
            errors.append(error)
    if not found:
        raise errors[0]
    merged = merge_stats(found)
    merged.notes += map(str, errors)
    if same := len(given) - len(found) - len(errors):
        merged.notes.append(f"{same} of the runs are the same as others: counted once")
    if json_:
        print_json(stats_as_json(merged))
        sys.stderr.writelines(f"{render_error(one)}\n" for one in errors)
    else:
        _print(console_for(), merged, explain=explain)
    return 1 if errors else 0


def _print(console: Console, stats: Stats, *, explain: bool) -> None:
    from rcj_challenges.views.stats.figures import DEFINITIONS, figure_keys

    _print_table(console, stats)
    _print_calls(console, stats)
    print_lines(console, *(f"note: {sanitize(note, 500)}" for note in stats.notes))
    if explain:
        print_lines(console, *(f"{DEFINITIONS[key].title}: {DEFINITIONS[key].text}" for key in figure_keys(stats)))
    else:
        print_lines(console, "--explain says how each figure is defined.")


def _print_table(console: Console, stats: Stats) -> None:
    """Print the figures of teams, robots and balls."""
    from rich.box import SIMPLE_HEAD
    from rich.table import Table

    from rcj_challenges.views.sentences import clock
    from rcj_challenges.views.stats.figures import figure_keys, figures

    keys = [key for key in figure_keys(stats) if key not in ("faults", "calls")]
    title = f"{counted(len(stats.runs), 'run')}, {clock(stats.play_ticks * TICK_S)} of play"
    table = Table(
        title=title, box=SIMPLE_HEAD, pad_edge=False, padding=(0, 0, 0, 1), collapse_padding=True,
        title_justify="left"
    )  # fmt: skip
    table.add_column("robot", min_width=_NAMES, overflow="fold")
    for key in keys:
        table.add_column(_HEADS[key], justify="right", overflow="fold")

    def add(name: str, values: Mapping[str, Any], style: str = "") -> None:
        table.add_row(name, *(_cell(key, values.get(key)) for key in keys), style=style)

    for name, team in stats.teams.items():
        add(f"{sanitize(name, 32)}: {number_words(team.points)}", figures(team.total, stats), "bold")
        for label, robot in sorted(team.robots.items()):
            add(f"  {sanitize(label, 40)}", figures(robot, stats))
        table.add_section()
    for name, ball in stats.balls.items():
        of_ball = figures(ball, stats)
        add(sanitize(name, 32), {key: of_ball[key] for key in ("distance_m", "mean_mps", "max_mps")})
    console.print(table)


def _print_calls(console: Console, stats: Stats) -> None:
    """Print referee calls and faults, a line for each robot that has any."""
    for name, team in stats.teams.items():
        for label, robot in sorted(team.robots.items()):
            counts = [f"{event} {count}" for event, count in sorted(robot.calls.items())]
            counts += [f"program fault: {kind} {count}" for kind, count in sorted(robot.faults.items())]
            if counts:
                print_lines(console, f"{sanitize(name, 32)} {sanitize(label, 40)}: {', '.join(counts)}")
    if stats.calls:
        counts = [f"{event} {count}" for event, count in sorted(stats.calls.items())]
        print_lines(console, f"about no robot: {', '.join(counts)}")


def _cell(key: str, value: Any) -> str:
    if value is None:
        return _NOTHING
    return f"{value:.2f}" if key.endswith("_mps") else f"{value:.1f}" if isinstance(value, float) else str(value)
