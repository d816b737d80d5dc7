"""``rcj-challenge tournament results``: what came out."""

from __future__ import annotations

import sys
from dataclasses import asdict
from typing import TYPE_CHECKING, Annotated, Any, Literal

import typer

from rcj_challenges.cli.app import WATCH
from rcj_challenges.cli.options import Json
from rcj_challenges.cli.stdio import print_json, print_safely
from rcj_challenges.cli.tournament.group import Data, File, opened, tournament_app
from rcj_challenges.cli.tournament.tables import score_words, stage_tables, team_words

if TYPE_CHECKING:
    from rcj_challenges.tournament.opened import OpenTournament
    from rcj_challenges.tournament.season import SeasonState


@tournament_app.register(WATCH, "rcj-challenge tournament results cup")
def results(
    file: File,
    data: Data = None,
    json_: Json = False,
    csv: Annotated[
        Literal["tables", "matches"] | None, typer.Option("--csv", help="Print all tables or all matches as CSV.")
    ] = None,
) -> None:
    """Print tables, brackets and scores."""
    with opened(file, data) as tournament:
        state = tournament.state()
        if json_:
            print_json(_as_json(tournament, state))
            return
    if csv is not None:
        from rcj_challenges.tournament.csv_text import csv_text

        sys.stdout.write(csv_text(_tables(state) if csv == "tables" else _matches(state)))
        return
    from rcj_challenges.views.console import console_for

    played = (fixture for fixture in state.fixtures if fixture.id in state.outcomes)
    print_safely("\n".join(f"{one.id}  {score_words(one, state.outcomes[one.id], state.teams)}" for one in played))
    console = console_for()
    for table in stage_tables(state):
        console.print(table)


def _as_json(tournament: OpenTournament, state: SeasonState) -> dict[str, Any]:
    """The state as JSON-able data, with digests and rulings."""
    summaries = tournament.store.summaries()
    rulings = [
        {"kind": row.kind, "match": row.fixture, "team": row.team, "scores": row.scores, "reason": row.reason,
         "at": row.at.isoformat()}
        for row in tournament.rulings
    ]  # fmt: skip
    return {
        "title": tournament.loaded.tournament.title,
        "teams": {team.id: asdict(team) for team in state.teams.values()},
        "stages": [asdict(stage) for stage in state.stages],
        "outcomes": {
            fixture: {**asdict(outcome), "digest": summaries.get(fixture, {}).get("digest", "")}
            for fixture, outcome in state.outcomes.items()
        },
        "rulings": rulings,
    }


def _tables(state: SeasonState) -> list[list[Any]]:
    """Rows of all tables, one for each team of each table."""
    counts = ("place", "shared", "by_lot", "played", "won", "drawn", "lost", "goals", "conceded", "points")
    lines: list[list[Any]] = [["stage", "table", "team", "name", *counts, "values"]]
    for stage in state.stages:
        for table in stage.tables:
            for row in table.rows:
                values = " ".join(map(str, row.values))
                numbers = [int(value) if isinstance(value := getattr(row, key), bool) else value for key in counts]
                lines.append([stage.name, table.name, row.team, team_words(state.teams, row.team), *numbers, values])
    return lines


def _matches(state: SeasonState) -> list[list[Any]]:
    """Rows of all matches with an outcome."""
    lines: list[list[Any]] = [["match", "stage", "round", "sides", "scores", "ruled", "reason"]]
    for stage in state.stages:
        for fixture in stage.fixtures:
            outcome = state.outcomes.get(fixture.id)
            if outcome is not None:
                sides = " - ".join("+".join(side.teams) for side in fixture.sides)
                scores = ":".join(f"{score:g}" for score in outcome.scores)
                row = [fixture.id, stage.name, fixture.round, sides, scores, outcome.ruled.value, outcome.reason]
                lines.append(row)
    return lines
