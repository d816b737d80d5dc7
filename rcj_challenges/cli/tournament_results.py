"""``rcj-challenge tournament status`` and ``results``: how far a tournament is, and what came out."""

from __future__ import annotations

import sys
from contextlib import suppress
from dataclasses import asdict
from typing import Any, Literal

from rcj_challenges.cli import OK
from rcj_challenges.cli.stdio import print_json, say
from rcj_challenges.cli.tournament_tables import duration_words, score_words, stage_tables, team_words
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.records.lines import parsed
from rcj_challenges.tournament.csv_text import csv_text
from rcj_challenges.tournament.jobs import Workplace
from rcj_challenges.tournament.opened import OpenTournament
from rcj_challenges.tournament.season import SeasonState
from rcj_challenges.tournament.store.lock import is_locked

_NEWEST_SHOWN = 5


def _progress(place: Workplace) -> dict[str, Any]:
    """Return what a run has left about its progress; empty if there is nothing yet."""
    with suppress(OSError, ValueError):
        return dict(parsed(place.progress.read_bytes()))
    return {}


def print_status(tournament: OpenTournament, *, as_json: bool) -> int:
    """Print how far it is; returns the exit code."""
    state, store = tournament.state(), tournament.store
    stages = [
        {
            "stage": stage.name,
            "title": stage.title,
            "status": stage.status.value,
            "done": sum(fixture.id in state.outcomes for fixture in stage.fixtures),
            "expected": stage.expected_matches,
        }
        for stage in state.stages
    ]
    is_running = is_locked(store.place.folder)
    progress = _progress(store.place) if is_running else {}
    newest = [one for one in store.latest_fixtures(_NEWEST_SHOWN) if one in state.outcomes]
    fixtures = {fixture.id: fixture for fixture in state.fixtures}
    status: dict[str, Any] = {
        "title": tournament.loaded.tournament.title,
        "is_running": is_running,
        "in_play": progress.get("in_play", []),
        "left_s": progress.get("left_s"),
        "latest": [{"match": one, "scores": state.outcomes[one].scores} for one in newest],
        "failed_submissions": store.failed_submissions(),
        "stages": stages,
        "doubtful": store.doubtful_fixtures(),
        "failed": store.complaints(),
        "withdrawn": sorted(team.id for team in state.teams.values() if team.withdrawn),
    }
    if as_json:
        print_json(status)
        return OK
    doing = "is being written to at present" if status["is_running"] else "nothing is running"
    lines = [f"{sanitize(status['title'])}: {doing}"]
    lines += [f"in play: {fixture}" for fixture in status["in_play"]]
    lines += [f"about {duration_words(status['left_s'])} left"] if status["left_s"] else []
    lines += [f"{one['stage']}: {one['status']}, {one['done']} of {one['expected']} matches" for one in stages]
    lines += [f"played: {one}  {score_words(fixtures[one], state.outcomes[one], state.teams)}" for one in newest]
    lines += [f"fails the check: {team}: {sanitize(why)}" for team, why in status["failed_submissions"].items()]
    lines += [f"doubtful, a time limit decided something: {fixture}" for fixture in status["doubtful"]]
    lines += [f"withdrawn: {team}" for team in status["withdrawn"]]
    lines += [f"could not be played: {sanitize(complaint.strip())}" for complaint in status["failed"]]
    say("\n".join(lines), sys.stdout)
    return OK


def print_results(tournament: OpenTournament, *, as_json: bool, as_csv: Literal["tables", "matches"] | None) -> int:
    """Print what came out; returns the exit code."""
    state = tournament.state()
    if as_json:
        print_json(results_json(tournament, state))
    elif as_csv is not None:
        sys.stdout.write(tables_csv(state) if as_csv == "tables" else matches_csv(state))
    else:
        from rcj_challenges.views.console import console_for

        played = (fixture for fixture in state.fixtures if fixture.id in state.outcomes)
        lines = [f"{one.id}  {score_words(one, state.outcomes[one.id], state.teams)}" for one in played]
        say("\n".join(lines), sys.stdout)
        console = console_for()
        for table in stage_tables(state):
            console.print(table)
    return OK


def results_json(tournament: OpenTournament, state: SeasonState) -> dict[str, Any]:
    """Return the state as JSON-able data, with digests and rulings."""
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


def tables_csv(state: SeasonState) -> str:
    """Return all tables as CSV, one line for each team of each table."""
    counts = ("place", "shared", "by_lot", "played", "won", "drawn", "lost", "goals", "conceded", "points")
    lines: list[list[Any]] = [["stage", "table", "team", "name", *counts, "values"]]
    for stage in state.stages:
        for table in stage.tables:
            for row in table.rows:
                values = " ".join(map(str, row.values))
                numbers = [int(value) if isinstance(value := getattr(row, key), bool) else value for key in counts]
                lines.append([stage.name, table.name, row.team, team_words(state.teams, row.team), *numbers, values])
    return csv_text(lines)


def matches_csv(state: SeasonState) -> str:
    """Return all matches with an outcome as CSV."""
    lines: list[list[Any]] = [["match", "stage", "round", "sides", "scores", "ruled", "reason"]]
    for stage in state.stages:
        for fixture in stage.fixtures:
            outcome = state.outcomes.get(fixture.id)
            if outcome is not None:
                sides = " - ".join("+".join(side.teams) for side in fixture.sides)
                scores = ":".join(f"{score:g}" for score in outcome.scores)
                row = [fixture.id, stage.name, fixture.round, sides, scores, outcome.ruled.value, outcome.reason]
                lines.append(row)
    return csv_text(lines)
