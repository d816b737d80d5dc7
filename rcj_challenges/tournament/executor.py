"""Executors of jobs: in processes of this computer, or on others."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol, Self

from rcj_challenges.match import batch
from rcj_challenges.match.worker_pool import WorkerPool
from rcj_challenges.tournament.jobs import MatchJob, Workplace

POLL_INTERVAL_S = 0.2


@dataclass(frozen=True)
class JobOutcome:
    """The outcome of a job.

    Attributes:
        result: as in ``result.json``; None if the match could not be played.
        folder: of the record, on a disk of this computer; None without a result.
        complaint: why it could not be played.
        is_host_error: whether a computer cannot go on (a full disk): it could play no other match either.
    """

    job: MatchJob
    result: dict[str, Any] | None
    folder: Path | None = None
    complaint: str = ""
    is_host_error: bool = False


class Executor(Protocol):
    """Plays jobs, some at a time; a context manager that ends what still runs when an exception leaves it.

    A job whose process dies for a reason of its own is tried once more before there is an outcome.
    """

    @property
    def lanes(self) -> int:
        """Number of jobs that are played at a time."""

    def submit(self, job: MatchJob) -> None:
        """Play a job as soon as a lane is free for it."""

    def poll(self) -> list[JobOutcome]:
        """Wait a moment, at most `POLL_INTERVAL_S`, and return what is done."""

    def __enter__(self) -> Self: ...

    def __exit__(self, *_: object) -> None: ...


class _LocalJob(batch.Job):
    """A job in a process of this computer: its arguments are the whole command ``tournament play-job``."""

    def start(self) -> batch.MatchProcess:
        """Start the match."""
        return batch.MatchProcess(self.arguments)


class LocalExecutor:
    """Plays each job in a process of this computer, which ends with this one."""

    def __init__(self, place: Workplace, lanes: int) -> None:
        self.lanes = lanes
        self._place = place
        self._pool: WorkerPool[batch.Outcome] = WorkerPool(lanes)
        self._jobs: dict[batch.Job, MatchJob] = {}

    def submit(self, job: MatchJob) -> None:
        """Play a job as soon as a lane is free for it."""
        arguments = ("tournament", "play-job", json.dumps(job.to_json()), str(self._place.folder))
        self._jobs[command := _LocalJob(job.seed, arguments)] = job
        self._pool.submit(command)

    def poll(self) -> list[JobOutcome]:
        """Wait a moment and return what is done."""
        return [_outcome(self._jobs.pop(one.job), one) for _, one in self._pool.poll(POLL_INTERVAL_S)]

    def __enter__(self) -> Self:
        self._pool.__enter__()
        return self

    def __exit__(self, *error: object) -> None:
        self._pool.__exit__(*error)


def _outcome(job: MatchJob, outcome: batch.Outcome) -> JobOutcome:
    if outcome.result is None:
        # A match for which the computer was too busy is not played; the others may be.
        is_host_error = outcome.wrong_input and outcome.code != "host-too-busy"
        return JobOutcome(job, None, complaint=outcome.complaint, is_host_error=is_host_error)
    result = dict(outcome.result)
    return JobOutcome(job, result, Path(result.pop("folder")))
