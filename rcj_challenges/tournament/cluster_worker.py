"""What runs on the workers of a cluster: a job in a process of its own, its files in the worker's own folder."""

from __future__ import annotations

import os
import shutil
import tempfile
from collections.abc import Mapping
from concurrent.futures import CancelledError
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any
from uuid import uuid4

from rcj_challenges.core.errors import format_error
from rcj_challenges.records.result import versions
from rcj_challenges.tournament.executor import JobOutcome, LocalExecutor
from rcj_challenges.tournament.jobs import MatchJob, Workplace


@dataclass(frozen=True)
class Returned:
    """The outcome of a job (`JobOutcome`), as it goes back over the network.

    Attributes:
        files: of the record by name, unless it is in the shared folder.
        folder: name of the record's folder in the shared one's ``playing``.
    """

    result: dict[str, Any] | None
    complaint: str = ""
    is_host_error: bool = False
    files: Mapping[str, bytes] = field(default_factory=dict)
    folder: str = ""


def introduce(shared: str | None) -> tuple[dict[str, str], bool]:
    """Return the versions of this worker, and whether it can use the shared folder; True if there is none."""
    return versions().model_dump(), shared is None or os.access(Workplace(Path(shared)).records, os.W_OK)


def play(job: Mapping[str, Any], inputs: Mapping[str, bytes], shared: str | None) -> Returned:
    """Play a job; runs in a thread of a Dask worker.

    Args:
        job: as data.
        inputs: its files by their names in the folder of the tournament's data; empty with `shared`.
        shared: folder of the tournament's data, if this worker sees it.

    Raises:
        CancelledError: the job was released: its run was interrupted, or has died.
    """
    from distributed import get_worker  # noqa: PLC0415 - an extra

    worker = get_worker()
    key = worker.get_current_task()
    made_job = MatchJob.from_json(job)
    try:
        # Dask removes this folder of a worker that was killed.
        with tempfile.TemporaryDirectory(prefix="match-", dir=worker.local_directory) as folder:
            place = Workplace(Path(folder))
            write_files(place.folder, inputs or Workplace(Path(shared or "")).read_inputs(made_job))
            with LocalExecutor(place, 1) as executor:
                executor.submit(made_job)
                while not (outcomes := executor.poll()):
                    task = worker.state.tasks.get(key)
                    if task is None or task.state == "cancelled":
                        raise CancelledError
            return _returned(outcomes[0], shared)
    except OSError as error:
        return Returned(None, format_error(error), is_host_error=True)


def write_files(folder: Path, files: Mapping[str, bytes]) -> None:
    """Write files into a folder by their names.

    Raises:
        OSError: one cannot be written.
    """
    for name, content in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)


def _returned(outcome: JobOutcome, shared: str | None) -> Returned:
    record = outcome.folder
    if record is None:
        return Returned(None, outcome.complaint, is_host_error=outcome.is_host_error)
    if shared is None:
        files = {path.relative_to(record).as_posix(): path.read_bytes() for path in record.rglob("*") if path.is_file()}
        return Returned(outcome.result, files=files)
    # A name of its own: a run that was killed may have left a copy that is still being written.
    target = Workplace(Path(shared)).playing / f"{record.name}-{uuid4().hex[:8]}"
    shutil.copytree(record, target)
    return Returned(outcome.result, folder=target.name)
