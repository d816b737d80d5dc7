"""``rcj-challenge tournament rerun``: plays matches again, and keeps their records."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from rcj_challenges.cli.app import ORGANIZE
from rcj_challenges.cli.options import AtOnce
from rcj_challenges.cli.tournament.group import Data, File, opened, tournament_app
from rcj_challenges.cli.tournament.verify import recorded_matches
from rcj_challenges.cli.verify import VerifyLines

if TYPE_CHECKING:
    from rcj_challenges.tournament.executor import JobOutcome
    from rcj_challenges.tournament.verify import Recorded, Verified


@tournament_app.register(ORGANIZE, "rcj-challenge tournament rerun cup")
def rerun(
    file: File,
    matches: Annotated[
        list[str] | None, typer.Argument(metavar="[MATCH...]", help="Which matches, as plan prints them; default: all.")
    ] = None,
    records: Annotated[
        Literal["full", "replay", "result"], typer.Option("--records", help="What to keep of the records now.")
    ] = "full",
    data: Data = None,
    at_once: AtOnce = None,
) -> int:
    """Play matches again to recreate parts of their records that were not kept; the results stay the same."""
    from rcj_challenges.tournament.executor import LocalExecutor
    from rcj_challenges.tournament.jobs import sizes
    from rcj_challenges.tournament.runner import keep_record
    from rcj_challenges.tournament.verify import verify_all

    with opened(file, data, writing=True) as tournament:
        found = recorded_matches(tournament, matches or [], records)
        lines = VerifyLines(len(found), as_json=False)
        place = tournament.store.place

        def keep(recorded: Recorded, outcome: JobOutcome, verified: Verified) -> None:
            if verified.verdict == "same" and outcome.folder is not None:
                keep_record(outcome.folder, place, recorded.job.id)
                tournament.store.note_files(recorded.job.id, sizes(place.record_of(recorded.job.id)))
                lines.note(f"{recorded.name}: {place.record_of(recorded.job.id)}")

        verify_all(found, LocalExecutor(place, at_once or os.cpu_count() or 1), lines.done, keep)
        return lines.finish()
