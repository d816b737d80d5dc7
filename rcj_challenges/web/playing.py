"""Matches of a ladder as the code of tournaments plays them."""

from __future__ import annotations

import os
import shutil
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rcj_challenges.tournament.jobs import MatchJob, Program, Workplace
from rcj_challenges.web.blobs import Blobs, match_folder

if TYPE_CHECKING:
    from rcj_challenges.web.models import Match


class MatchPlace(Workplace):
    """Where matches find scenarios and archives.

    Args:
        site: the folder of the site.
        playing: where records are written while matches are played.
    """

    def __init__(self, site: Path, playing: Path | None = None) -> None:
        super().__init__(match_folder(site))
        self.playing = playing or self.playing
        self._blobs = Blobs(site)

    def submission(self, archive: str) -> Path:
        """Return the file of a submission by its hash.

        Raises:
            DiagnosticError: it is not there.
        """
        path = self._blobs.path(archive)
        return path if path.is_file() else super().submission(archive)


def job_of(match: Match, sandbox: str) -> MatchJob:
    """The job of a match."""
    sides = {"blue": match.blue, "yellow": match.yellow}
    names = {side: one.team.public_name for side, one in sides.items()}
    seats = {side: (Program(one.sha256, one.digest, names[side]),) for side, one in sides.items()}
    return MatchJob(
        scenario=match.basis.scenario, seats=seats, names=names, seed=match.seed, versions=match.basis.versions,
        match_id=match.number, sandbox=sandbox,
    )  # fmt: skip


def play(request: Mapping[str, Any]) -> dict[str, Any]:
    """Play a match in this process; one in which a program was ended from outside is repeated, and that counts.

    Returns:
        The result, the folder of its record, and whether the first attempt ended differently.

    Raises:
        RcjError: it cannot be played on this computer.
    """
    os.environ.setdefault("MUJOCO_GL", "disable")  # would load a window system's library, and a match draws nothing
    from rcj_challenges.tournament.playing import play_job  # noqa: PLC0415 - only in a process that plays

    job, place = MatchJob.from_json(request["job"]), MatchPlace(Path(request["site"]), Path(request["folder"]))
    played = play_job(job, place)
    first = played.result["digest"]
    if any(_is_from_outside(fault) for fault in played.result["faults"]):
        shutil.rmtree(played.folder)
        played = play_job(job, place)
    return {"result": played.result, "folder": str(played.folder), "is_doubtful": played.result["digest"] != first}


def _is_from_outside(fault: Mapping[str, Any]) -> bool:
    """Return whether a limit of time or a signal ended a program: what it did itself it does again."""
    return fault["timed"] or (fault["kind"] == "crash" and not fault["traceback"])
