"""Tables, brackets and scores of a tournament, for the terminal."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from rcj_challenges.core.amounts import number_words
from rcj_challenges.core.sanitize import sanitize

if TYPE_CHECKING:
    from rich.table import Table as RichTable

    from rcj_challenges.tournament.season import Fixture, Outcome, Row, SeasonState, StageState, Table, Team

_UNITS = (("h", 3600.0), ("min", 60.0))


def duration_words(duration_s: float) -> str:
    """``12 min``: a duration in a unit of which there are at least two."""
    unit, unit_s = next((one for one in _UNITS if duration_s >= 2 * one[1]), ("s", 1.0))
    return f"{duration_s / unit_s:.0f} {unit}"


def team_words(teams: Mapping[str, Team], ids: str | Sequence[str]) -> str:
    """Name of a team, or of a super team, given by its ids or by these joined with ``+``."""
    members = ids.split("+") if isinstance(ids, str) else ids
    return " + ".join(teams[one].name if one in teams else one for one in members)


def score_words(fixture: Fixture, outcome: Outcome, teams: Mapping[str, Team]) -> str:
    """``Ada 2 : 1 Bee``, or ``Ada 12`` of what is played alone, and what was decided by a referee."""
    names = [team_words(teams, side.teams) for side in fixture.sides]
    scores = [number_words(score) for score in outcome.scores] or ["-"] * len(names)
    if len(names) == 2:
        score = f"{names[0]} {scores[0]} : {scores[1]} {names[1]}"
    else:
        score = ", ".join(f"{name} {one}" for name, one in zip(names, scores, strict=False))
    return f"{score} ({outcome.ruled.words})" if outcome.ruled.words else score


def stage_tables(state: SeasonState) -> list[RichTable]:
    """Tables and brackets of all stages that have some."""
    found: list[RichTable] = []
    for stage in state.stages:
        found += [_table(stage, table, state.teams) for table in stage.tables if table.rows]
        if stage.ties and any(any(tie.teams) for tie in stage.ties):
            found.append(_bracket(stage, state.teams))
    return found


def _table(stage: StageState, table: Table, teams: Mapping[str, Team]) -> RichTable:
    from rich.table import Table as RichTable
    from rich.text import Text

    title = sanitize(f"{stage.title} {table.name}".strip())
    if table.columns:
        shown = RichTable("", "team", *table.columns, title=Text(title))
        for row in table.rows:
            shown.add_row(_place(row), Text(team_words(teams, row.team)), *map(number_words, row.values))
        return shown
    shown = RichTable("", "team", "played", "won", "drawn", "lost", "goals", "points", title=Text(title))
    for row in table.rows:
        goals = f"{number_words(row.goals)} : {number_words(row.conceded)}"
        counts = map(str, (row.played, row.won, row.drawn, row.lost))
        points = number_words(row.points)
        shown.add_row(_place(row), Text(team_words(teams, row.team)), *counts, goals, points)
    return shown


def _place(row: Row) -> str:
    return f"{row.place}{' =' if row.shared else ''}{' (lot)' if row.by_lot else ''}"


def _bracket(stage: StageState, teams: Mapping[str, Team]) -> RichTable:
    from rich.table import Table as RichTable
    from rich.text import Text

    shown = RichTable("tie", "first", "", "second", "winner", "by", title=Text(sanitize(stage.title)))
    for tie in stage.ties:
        first, second = (
            team_words(teams, team) if team else source for team, source in zip(tie.teams, tie.sources, strict=True)
        )
        score = "" if tie.scores is None else " : ".join(map(number_words, tie.scores))
        winner = team_words(teams, tie.winner) if tie.winner else ""
        by = tie.decided_by.replace("_", " ")
        shown.add_row(*map(Text, (tie.title, first, score, second, winner, by)))
    return shown
