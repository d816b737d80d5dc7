"""Archives on the disk, named by their SHA-256. What has been stored is never changed."""

from __future__ import annotations

import hashlib
import os
import shutil
import time
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rcj_challenges.web.models import Job, Match, Submission

MIN_FREE_BYTES = 2_000_000_000
_STALE_S = 3600.0


class Blobs:
    """The archives of a site.

    Args:
        folder: of the site.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder / "blobs"
        self.incoming = folder / "incoming"

    def path(self, sha256: str) -> Path:
        """Return where an archive is, or would be."""
        return self._folder / sha256[:2] / f"{sha256}.zip"

    def keep(self, received: Path, sha256: str) -> Path:
        """Move a received file to its place, where a power cut cannot take it away.

        Args:
            received: a file in `incoming`, on the same disk.
            sha256: of its content.

        Raises:
            OSError: the disk is full or broken.
        """
        target = self.path(sha256)
        target.parent.mkdir(parents=True, exist_ok=True)
        with received.open("rb") as file:
            os.fsync(file.fileno())
        received.replace(target)
        for folder in (target.parent, self._folder):
            descriptor = os.open(folder, os.O_RDONLY)
            try:
                os.fsync(descriptor)
            finally:
                os.close(descriptor)
        return target

    def keep_bytes(self, data: bytes) -> tuple[str, int]:
        """Keep an archive; return its SHA-256 and size in bytes."""
        sha256 = hashlib.sha256(data).hexdigest()
        received = self.incoming / f"copy-{os.getpid()}-{sha256}"
        received.write_bytes(data)
        self.keep(received, sha256)
        return sha256, len(data)

    def working(self, job: Job) -> Path:
        """Return the folder of an attempt at a job: what it makes stays there until the result is stored."""
        return self.incoming / f"job-{job.pk}-{job.attempt}"

    def remove_left(self, job: Job) -> None:
        """Remove what attempts at a job have left."""
        for folder in self.incoming.glob(f"job-{job.pk}-*"):
            shutil.rmtree(folder, ignore_errors=True)

    def sweep(self) -> None:
        """Remove what uploads that were cut off have left."""
        before = time.time() - _STALE_S
        for path in self.incoming.iterdir():
            if path.is_file() and path.stat().st_mtime < before:
                path.unlink(missing_ok=True)

    def has_room(self) -> bool:
        """Return whether enough of the disk is free to take more."""
        state = os.statvfs(self._folder)
        return state.f_bavail * state.f_frsize >= MIN_FREE_BYTES


def report_folder(site: Path, submission: Submission) -> Path:
    """Return the folder with the page and the replays of a check."""
    return site / "reports" / str(submission.pk)


def match_folder(site: Path) -> Path:
    """Return the folder of the scenarios and records of matches."""
    return site / "matches"


def record_folder(site: Path, match: Match) -> Path:
    """Return the folder with the replay and the logs of a match; they are kept for a while only."""
    return match_folder(site) / "records" / str(match.pk)


def stage_folder(site: Path) -> Path:
    """Return the folder of what is shown on the stage."""
    return site / "live"
