"""``rcj-challenge tournament verify``: plays matches again, and compares the digests."""

from __future__ import annotations

import os
import random
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Annotated

import typer

from rcj_challenges.cli.app import ORGANIZE
from rcj_challenges.cli.options import AtOnce, Json
from rcj_challenges.cli.tournament.group import Data, File, opened, tournament_app
from rcj_challenges.cli.verify import VerifyLines
from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError
from rcj_challenges.tournament.codes import NOT_PLAYED

if TYPE_CHECKING:
    from rcj_challenges.tournament.models import Records
    from rcj_challenges.tournament.opened import OpenTournament
    from rcj_challenges.tournament.verify import Recorded


@tournament_app.register(ORGANIZE, "rcj-challenge tournament verify cup --sample 5")
def verify(
    file: File,
    matches: Annotated[
        list[str] | None, typer.Argument(metavar="[MATCH...]", help="Which matches; default: all.")
    ] = None,
    sample: Annotated[
        int | None, typer.Option("--sample", metavar="N", min=1, help="Only this many, drawn at random.")
    ] = None,
    data: Data = None,
    at_once: AtOnce = None,
    json_: Json = False,
) -> int:
    """Play matches again and compare their digests.

    Exit status 0: none differs; 1: one differs; 2: wrong input; 3: one could not be played.
    """
    from rcj_challenges.tournament.executor import LocalExecutor
    from rcj_challenges.tournament.verify import verify_all

    with opened(file, data, writing=True) as tournament:
        found = recorded_matches(tournament, matches or [], "result")
        if sample is not None and sample < len(found):
            found = random.SystemRandom().sample(found, sample)
        lines = VerifyLines(len(found), as_json=json_)
        verify_all(found, LocalExecutor(tournament.store.place, at_once or os.cpu_count() or 1), lines.done)
        return lines.finish()


def recorded_matches(tournament: OpenTournament, matches: Sequence[str], records: Records) -> list[Recorded]:
    """Matches to be played again; those that share a job once.

    Raises:
        DiagnosticError: one of them has not been played.
    """
    from rcj_challenges.tournament.jobs import MatchJob
    from rcj_challenges.tournament.verify import Recorded

    played, rows = tournament.store.played(), tournament.store.jobs()
    missing = [name for name in matches if name not in played]
    if missing:
        help_ = "'tournament results FILE' lists the matches that were played"
        raise DiagnosticError(*(Diagnostic(NOT_PLAYED, f"'{name}' has not been played", help_) for name in missing))
    found: dict[str, Recorded] = {}
    for name in matches or played:
        row = rows[played[name].job_id]
        job = replace(MatchJob.from_json(row.job), records=records)
        found.setdefault(
            job.id, Recorded(name, job, row.summary["digest"], job.versions, is_timed=row.summary["is_timed"])
        )
    return list(found.values())
