"""``rcj-challenge tournament judge``: what changed rules would have made of a tournament."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, replace
from typing import TYPE_CHECKING

from rcj_challenges.cli.app import ORGANIZE
from rcj_challenges.cli.options import Json, Overrides
from rcj_challenges.cli.stdio import print_json, print_lines
from rcj_challenges.cli.tournament.group import Data, File, opened, tournament_app
from rcj_challenges.cli.tournament.tables import score_words, stage_tables
from rcj_challenges.core.amounts import counted
from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError
from rcj_challenges.tournament.codes import NO_TRAJECTORY

if TYPE_CHECKING:
    from rcj_challenges.tournament.jobs import Workplace
    from rcj_challenges.tournament.season import Fixture, Outcome
    from rcj_challenges.tournament.store.tables import JobRow


@tournament_app.register(ORGANIZE, "rcj-challenge tournament judge cup --set ball_progress_s=15")
def judge(
    file: File,
    set_: Overrides = None,
    data: Data = None,
    json_: Json = False,
) -> None:
    """Show how played matches would have ended under changed rules; no program runs."""
    from rcj_challenges.records.folder import TRAJECTORY
    from rcj_challenges.views.console import console_for

    with opened(file, data) as tournament:
        before, played = tournament.state(), tournament.store.played()
        fixtures = [one for one in before.fixtures if one.id in played]
        place = tournament.store.place
        missing = [one.id for one in fixtures if not (place.record_of(played[one.id].job_id) / TRAJECTORY).is_file()]
        if missing:
            message = f"{counted(len(missing), 'record')} without a trajectory, such as that of {missing[0]}"
            help_ = "play them again with 'tournament rerun FILE', which keeps it"
            raise DiagnosticError(Diagnostic(NO_TRAJECTORY, message, help_))
        rows = tournament.store.jobs()
        judged = {one.id: _judged(one, rows[played[one.id].job_id], place, set_ or []) for one in fixtures}
        changed = [one for one in fixtures if judged[one.id].scores != played[one.id].outcome.scores]
        again = {key: replace(one, outcome=judged.get(key, one.outcome)) for key, one in played.items()}
        after = tournament.state(again)
    if json_:
        outcomes = {one.id: {"recorded": asdict(played[one.id].outcome), "judged": asdict(judged[one.id])}
                    for one in fixtures}  # fmt: skip
        print_json({"outcomes": outcomes, "stages": [asdict(stage) for stage in after.stages]})
        return
    console = console_for()
    for one in changed:
        scores = (score_words(one, outcome, before.teams) for outcome in (played[one.id].outcome, judged[one.id]))
        print_lines(console, f"{one.id}  {'  ->  '.join(scores)}")
    print_lines(console, f"{counted(len(fixtures), 'match', 'matches')} judged, {len(changed)} with another score")
    for table in stage_tables(after):
        console.print(table)


def _judged(fixture: Fixture, row: JobRow, place: Workplace, overrides: Sequence[str]) -> Outcome:
    from rcj_challenges.match.rejudge import rejudge
    from rcj_challenges.records.trajectory import Trajectory
    from rcj_challenges.scenario.load import load_resolved
    from rcj_challenges.tournament.fixtures import outcome_of

    loaded = place.load_scenario(row.job["scenario"])
    scenario = load_resolved(loaded.resolved, overrides=overrides).scenario if overrides else loaded.scenario
    judgement = rejudge(Trajectory.open(place.record_of(row.id)), scenario)
    return outcome_of(fixture, {"score": judgement.scores, "ranking": judgement.ranking})
