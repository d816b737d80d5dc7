"""``rcj-challenge stats``: figures of one run or of several together."""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
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
_GAP = 2
"""Between two columns of the table."""


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
    """Print the figures of teams, robots and balls, in parts where the terminal is narrow."""
    from rich.box import SIMPLE_HEAD
    from rich.table import Table

    from rcj_challenges.views.sentences import clock
    from rcj_challenges.views.stats.figures import figure_keys

    keys = [key for key in figure_keys(stats) if key not in ("faults", "calls")]
    blocks = _blocks(stats, keys)
    rows = [cells for block in blocks for _, cells, _ in block]
    widths = [max(map(len, [*_HEADS[key].splitlines(), *(cells[key] for cells in rows)])) for key in keys]
    title = f"{counted(len(stats.runs), 'run')}, {clock(stats.play_ticks * TICK_S)} of play"
    for part in _parts(widths, console.width):
        table = Table(
            title=title, box=SIMPLE_HEAD, pad_edge=False, padding=(0, 0, 0, 1), collapse_padding=True,
            title_justify="left"
        )  # fmt: skip
        table.add_column("robot", min_width=_NAMES, overflow="fold")
        for place in part:
            table.add_column(_HEADS[keys[place]], justify="right", no_wrap=True)
        for block in blocks:
            for name, cells, style in block:
                table.add_row(name, *(cells[keys[place]] for place in part), style=style)
            table.add_section()
        console.print(table)
        title = ""


def _blocks(stats: Stats, keys: Sequence[str]) -> list[list[tuple[str, dict[str, str], str]]]:
    """Rows of each team and those of the balls: name, figures by key, style."""
    from rcj_challenges.views.stats.figures import figures

    blocks = []
    for name, team in stats.teams.items():
        block = [
            (f"{sanitize(name, 32)}: {number_words(team.points)}", _cells(figures(team.total, stats), keys), "bold")
        ]
        for label, robot in sorted(team.robots.items()):
            block.append((f"  {sanitize(label, 40)}", _cells(figures(robot, stats), keys), ""))
        blocks.append(block)
    of_balls = ("distance_m", "mean_mps", "max_mps")
    balls = [
        (sanitize(name, 32), _cells({key: figures(ball, stats)[key] for key in of_balls}, keys), "")
        for name, ball in stats.balls.items()
    ]
    return [*blocks, balls]


def _parts(widths: Sequence[int], room: int) -> list[list[int]]:
    """Columns that stand in one table: as many as have room beside the names, all of them on 80 columns."""
    parts: list[list[int]] = [[]]
    left = room - _NAMES - 1
    for place, width in enumerate(widths):
        if parts[-1] and left < width + _GAP:
            parts.append([])
            left = room - _NAMES - 1
        parts[-1].append(place)
        left -= width + _GAP
    return parts


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


def _cells(values: Mapping[str, Any], keys: Sequence[str]) -> dict[str, str]:
    return {key: _cell(key, values.get(key)) for key in keys}


def _cell(key: str, value: Any) -> str:
    if value is None:
        return _NOTHING
    return f"{value:.2f}" if key.endswith("_mps") else f"{value:.1f}" if isinstance(value, float) else str(value)
