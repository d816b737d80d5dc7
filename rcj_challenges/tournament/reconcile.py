"""The played matches that still count, when submissions, scenarios or records are not as they were."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError
from rcj_challenges.records.result import deciding, versions
from rcj_challenges.tournament.codes import OTHER_VERSIONS, STAGE_CLOSED
from rcj_challenges.tournament.fixtures import JobMaker
from rcj_challenges.tournament.jobs import Workplace, sizes
from rcj_challenges.tournament.opened import OpenTournament, later_stages, sides_of
from rcj_challenges.tournament.season import Fixture, SeasonState
from rcj_challenges.tournament.store.store import PlayedFixture, Store
from rcj_challenges.tournament.store.tables import JobRow


def reconcile(tournament: OpenTournament, jobs: JobMaker, *, cascade: bool) -> dict[str, str]:
    """Let no match count that would be played otherwise today, or has a damaged record.

    Return the fixtures that are to be played again, with the reason. With ``cascade`` matches may change too from which
    a stage that has begun took its teams.

    Raises:
        DiagnosticError: matches were played by other versions, or a later stage has begun.
    """
    store = tournament.store
    played = store.played()
    rows = store.jobs()
    again: dict[str, str] = {}
    while True:
        state = tournament.state(played)
        fixtures = [fixture for fixture in state.fixtures if fixture.id in played]
        stale = [one for one in fixtures if _is_stale(one, played[one.id], jobs, rows)]
        if not stale:
            break
        for fixture in stale:
            later = "" if cascade else begun_later_stage(tournament, state, fixture.stage)
            if later:
                raise stage_closed(
                    f"the match {fixture.id} would be played again, because a submission, the scenario or the seed has "
                    f"changed since, but stage '{later}' has taken its teams from '{fixture.stage}' and has begun"
                )
            again[fixture.id] = "a submission, the scenario, the seed or a team has changed"
            del played[fixture.id]
    for fixture in fixtures:
        if not has_whole_record(rows[played[fixture.id].job_id], store.place):
            again[fixture.id] = "its record is damaged"
    # What is in no stage now was not compared: if its teams meet again, the job of then is found by its address.
    known = {fixture.id for fixture in fixtures}
    store.forget([*again, *(fixture for fixture in played if fixture not in known)])
    return again


def _is_stale(fixture: Fixture, played: PlayedFixture, jobs: JobMaker, rows: Mapping[str, JobRow]) -> bool:
    if played.sides != sides_of(fixture):
        return True
    job = jobs.job_for(fixture)
    if job.id == played.job_id:
        return False
    before = rows[played.job_id].job["versions"]
    if deciding(before) != deciding(job.versions):
        raise _other_versions(before, job.versions)
    return replace(job, versions=before).id != played.job_id


def begun_later_stage(tournament: OpenTournament, state: SeasonState, stage: str) -> str:
    """Return a stage with outcomes that takes its teams from another, directly or not; empty if there is none."""
    later = (one for one in state.stages if one.name in later_stages(tournament.loaded, stage))
    return next((one.name for one in later if any(fixture.id in state.outcomes for fixture in one.fixtures)), "")


def stage_closed(message: str) -> DiagnosticError:
    """Return the error for a change that would change the teams of a stage that has begun."""
    help_ = "undo the change; or give --cascade: what depends on it is played again"
    return DiagnosticError(Diagnostic(STAGE_CLOSED, message, help_))


def _other_versions(before: Mapping[str, str], now: Mapping[str, str]) -> DiagnosticError:
    changed = [f"{name} {before.get(name, 'none')}, now {now[name]}" for name in now if before.get(name) != now[name]]
    message = f"matches of this tournament were played with {'; '.join(changed)}: results could not be compared"
    help_ = "install the versions of before; or play the whole tournament again into another folder: --data DIR"
    return DiagnosticError(Diagnostic(OTHER_VERSIONS, message, help_))


def other_pythons(store: Store) -> list[str]:
    """Return the other versions of Python with which matches that count were played."""
    rows = store.jobs()
    return sorted({rows[one.job_id].job["versions"]["python"] for one in store.played().values()} - {versions().python})


def has_whole_record(row: JobRow, place: Workplace) -> bool:
    """Return whether the record of a job is as it was left: each file there, none of another size."""
    try:
        return bool(row.files) and sizes(place.record_of(row.id)) == row.files
    except OSError:
        return False
