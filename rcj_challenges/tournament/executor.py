"""Executors of jobs: in processes of this computer, or on others."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType
from typing import Any, Protocol, Self

from rcj_challenges.match import batch
from rcj_challenges.match.worker_pool import Attempt, WorkerPool
from rcj_challenges.tournament.jobs import MatchJob, Workplace

POLL_INTERVAL_S = 0.2


@dataclass(frozen=True)
class JobOutcome:
    """What came of a job.

    Attributes:
        job: the job.
        result: as in ``result.json``; None if the match could not be played.
        folder: of the record, on a disk of this computer; None without a result.
        complaint: why it could not be played.
        of_host: True if a computer cannot go on (a full disk): no other match could be played there either.
    """

    job: MatchJob
    result: dict[str, Any] | None
    folder: Path | None = None
    complaint: str = ""
    of_host: bool = False


class Executor(Protocol):
    """Plays jobs, some at a time; a context manager that ends what still runs when an exception leaves it.

    A job whose process dies for a reason of its own is tried once more before there is an outcome.
    """

    @property
    def lanes(self) -> int:
        """How many jobs are played at a time."""

    def submit(self, job: MatchJob) -> None:
        """Play a job as soon as a lane is free for it."""

    def poll(self) -> list[JobOutcome]:
        """Wait a moment, at most `POLL_INTERVAL_S`, and return what is done."""

    def __enter__(self) -> Self: ...

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None: ...


@dataclass(frozen=True)
class _LocalJob:
    """A job in a process of this computer: the command ``tournament play-job``."""

    job: MatchJob
    command: batch.Job

    def start(self) -> batch.MatchProcess:
        return batch.MatchProcess(self.command.arguments)

    def interrupt(self, process: batch.MatchProcess) -> None:
        self.command.interrupt(process)

    def read_outcome(self, process: batch.MatchProcess) -> Attempt[JobOutcome]:
        attempt = self.command.read_outcome(process)
        return Attempt(_outcome(self.job, attempt.outcome), attempt.is_final)

    def start_failed(self, error: OSError) -> JobOutcome:
        return _outcome(self.job, self.command.start_failed(error))


class LocalExecutor:
    """Plays each job in a process of this computer, which ends with this one."""

    def __init__(self, place: Workplace, lanes: int) -> None:
        """Prepare it.

        Args:
            place: the folder of the tournament's data.
            lanes: how many matches at a time.
        """
        self.lanes = lanes
        self._place = place
        self._pool: WorkerPool[JobOutcome] = WorkerPool(lanes)

    def submit(self, job: MatchJob) -> None:
        """Play a job as soon as a lane is free for it."""
        arguments = ("tournament", "play-job", json.dumps(job.to_json()), str(self._place.folder))
        self._pool.submit(_LocalJob(job, batch.Job(job.seed, arguments)))

    def poll(self) -> list[JobOutcome]:
        """Wait a moment and return what is done."""
        return [outcome for _, outcome in self._pool.poll(POLL_INTERVAL_S)]

    def __enter__(self) -> Self:
        self._pool.__enter__()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._pool.__exit__(kind, error, trace)


def _outcome(job: MatchJob, outcome: batch.Outcome) -> JobOutcome:
    if outcome.result is None:
        return JobOutcome(job, None, complaint=outcome.complaint, of_host=outcome.wrong_input)
    result = dict(outcome.result)
    return JobOutcome(job, result, Path(result.pop("folder")))
