"""``rcj-challenge tournament verify`` and ``rerun``: matches that are played again."""

from __future__ import annotations

import os
import random
from collections.abc import Sequence
from dataclasses import replace

from rcj_challenges.cli import OK
from rcj_challenges.cli.verify import VerifyLines
from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError
from rcj_challenges.tournament.executor import JobOutcome, LocalExecutor
from rcj_challenges.tournament.jobs import MatchJob
from rcj_challenges.tournament.models import Records
from rcj_challenges.tournament.opened import OpenTournament
from rcj_challenges.tournament.records import sizes
from rcj_challenges.tournament.runner import keep_record
from rcj_challenges.tournament.verify import Recorded, Verified, verify_all


def verify_tournament(
    tournament: OpenTournament, matches: Sequence[str], *, sample: int | None, at_once: int | None, as_json: bool
) -> int:
    """Play matches again and compare them; returns the exit code.

    Raises:
        DiagnosticError: one of the matches has not been played.
    """
    found = _recorded(tournament, matches, "result")
    if sample is not None and sample < len(found):
        found = random.SystemRandom().sample(found, sample)
    lines = VerifyLines(len(found), as_json=as_json)
    verify_all(found, _executor(tournament, at_once), lines.done)
    return lines.finish()


def rerun_matches(tournament: OpenTournament, matches: Sequence[str], records: Records, *, at_once: int | None) -> int:
    """Play matches again and keep their records, if the digest is the same; returns the exit code.

    Raises:
        DiagnosticError: one of the matches has not been played.
    """
    found = _recorded(tournament, matches, records)
    lines = VerifyLines(len(found), as_json=False)
    place = tournament.store.place

    def keep(recorded: Recorded, outcome: JobOutcome, verified: Verified) -> None:
        if verified.verdict == "same" and outcome.folder is not None:
            keep_record(outcome.folder, place, recorded.job.id)
            tournament.store.note_files(recorded.job.id, sizes(place.record_of(recorded.job.id)))
            lines.note(f"{recorded.name}: {place.record_of(recorded.job.id)}")

    verify_all(found, _executor(tournament, at_once), lines.done, keep)
    return lines.finish() or OK


def _executor(tournament: OpenTournament, at_once: int | None) -> LocalExecutor:
    return LocalExecutor(tournament.store.place, at_once or os.cpu_count() or 1)


def _recorded(tournament: OpenTournament, matches: Sequence[str], records: Records) -> list[Recorded]:
    """Return the matches to be played again; those that share a job once.

    Raises:
        DiagnosticError: one of them has not been played.
    """
    played, rows = tournament.store.played(), tournament.store.jobs()
    missing = [name for name in matches if name not in played]
    if missing:
        help_ = "'tournament results FILE' lists the matches that were played"
        raise DiagnosticError(*(Diagnostic("not-played", f"'{name}' has not been played", help_) for name in missing))
    found: dict[str, Recorded] = {}
    for name in matches or played:
        row = rows[played[name].job_id]
        job = replace(MatchJob.from_json(row.job), records=records)
        found.setdefault(
            job.id, Recorded(name, job, row.summary["digest"], job.versions, is_timed=row.summary["is_timed"])
        )
    return list(found.values())
