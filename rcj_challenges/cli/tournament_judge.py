"""``rcj-challenge tournament judge``: what changed rules would have made of a tournament."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, replace

from rich.text import Text

from rcj_challenges.cli import OK
from rcj_challenges.cli.stdio import print_json
from rcj_challenges.cli.tournament_tables import score_words, stage_tables
from rcj_challenges.core.amounts import counted
from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError
from rcj_challenges.match.rejudge import rejudge
from rcj_challenges.records.folder import TRAJECTORY
from rcj_challenges.records.trajectory import Trajectory
from rcj_challenges.scenario.load import load_resolved
from rcj_challenges.tournament.fixtures import outcome_of
from rcj_challenges.tournament.jobs import Workplace
from rcj_challenges.tournament.opened import OpenTournament
from rcj_challenges.tournament.season import Fixture, Outcome
from rcj_challenges.tournament.store.tables import JobRow
from rcj_challenges.views.console import console_for


def judge_tournament(tournament: OpenTournament, overrides: Sequence[str], *, as_json: bool) -> int:
    """Judge the records of all matches by changed rules; print the tables that follow; returns the exit code.

    Poses and programs stay as they were. A stage whose teams would be others shows the matches that stand.

    Raises:
        RcjError: rules that cannot be used, or a record without a trajectory.
    """
    before, played = tournament.state(), tournament.store.played()
    fixtures = [one for one in before.fixtures if one.id in played]
    place = tournament.store.place
    missing = [one.id for one in fixtures if not (place.record_of(played[one.id].job_id) / TRAJECTORY).is_file()]
    if missing:
        message = f"{counted(len(missing), 'record')} without a trajectory, such as that of {missing[0]}"
        help_ = "play them again with 'tournament rerun FILE', which keeps it"
        raise DiagnosticError(Diagnostic("no-trajectory", message, help_))
    rows = tournament.store.jobs()
    judged = {one.id: _judged(one, rows[played[one.id].job_id], place, overrides) for one in fixtures}
    changed = [one for one in fixtures if judged[one.id].scores != played[one.id].outcome.scores]
    after = tournament.state({key: replace(one, outcome=judged.get(key, one.outcome)) for key, one in played.items()})
    if as_json:
        outcomes = {one.id: {"recorded": asdict(played[one.id].outcome), "judged": asdict(judged[one.id])}
                    for one in fixtures}  # fmt: skip
        print_json({"outcomes": outcomes, "stages": [asdict(stage) for stage in after.stages]})
        return OK
    console = console_for()
    for one in changed:
        scores = (score_words(one, outcome, before.teams) for outcome in (played[one.id].outcome, judged[one.id]))
        console.print(Text(f"{one.id}  {'  ->  '.join(scores)}"), soft_wrap=True)
    console.print(Text(f"{counted(len(fixtures), 'match', 'matches')} judged, {len(changed)} with another score"))
    for table in stage_tables(after):
        console.print(table)
    return OK


def _judged(fixture: Fixture, row: JobRow, place: Workplace, overrides: Sequence[str]) -> Outcome:
    loaded = place.load_scenario(row.job["scenario"])
    scenario = load_resolved(loaded.resolved, overrides=overrides).scenario if overrides else loaded.scenario
    judgement = rejudge(Trajectory.open(place.record_of(row.id)), scenario)
    return outcome_of(fixture, {"score": judgement.scores, "ranking": judgement.ranking})
