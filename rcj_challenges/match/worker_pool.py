"""A pool of worker processes for matches and checks of submissions, each job in its own process."""

from __future__ import annotations

import subprocess
import sys
import tempfile
import threading
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, CancelledError, Future, ThreadPoolExecutor, wait
from pathlib import Path
from typing import Any, Generic, NamedTuple, Protocol, Self, TypeVar

from rcj_challenges.programs.private_folders import remove_left_overs

_POLL_INTERVAL_S = 0.2
_MAX_SHUTDOWN_S = 5.0
_MAX_ATTEMPTS = 2
_PACKAGE = Path(__file__).resolve().parents[2]

Process = TypeVar("Process", bound="subprocess.Popen[Any]")
Outcome = TypeVar("Outcome")
Outcome_co = TypeVar("Outcome_co", covariant=True)


class Attempt(NamedTuple, Generic[Outcome_co]):
    """The result of one process of a job; not final if it died for a reason of its own: a second one may succeed."""

    outcome: Outcome_co
    is_final: bool = True


class Job(Protocol[Process, Outcome_co]):
    """A job for one worker process. All methods but `interrupt` run in a thread of the pool."""

    def start(self) -> Process:
        """Start a process.

        Raises:
            OSError: it cannot be started.
        """

    def interrupt(self, process: Process) -> None:
        """Ask a process to clean up and end; runs while `read_outcome` waits for the same process."""

    def read_outcome(self, process: Process) -> Attempt[Outcome_co]:
        """Wait for a process to end, and return its result."""

    def start_failed(self, error: OSError) -> Outcome_co:
        """Return the outcome of a job whose process could not be started."""


class WorkerPool(Generic[Outcome]):
    """Runs jobs in processes, a few at a time; used as a context manager.

    Jobs can be submitted at any time by the thread that reads the results. If the block is left by an exception, such
    as KeyboardInterrupt, all processes are ended.
    """

    def __init__(self, max_processes: int) -> None:
        self._executor = ThreadPoolExecutor(max_workers=max(1, max_processes))
        self._pending: dict[Future[Outcome], Job[Any, Outcome]] = {}
        self._lock = threading.Lock()
        self._running: dict[subprocess.Popen[Any], Job[Any, Outcome]] = {}
        self._is_stopped = False

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: object, error: object, traceback: object) -> None:
        try:
            if error is not None:
                self.end_all()
        finally:
            self._executor.shutdown()

    def submit(self, job: Job[Any, Outcome]) -> None:
        """Run a job as soon as a process is free for it."""
        self._pending[self._executor.submit(self._run, job)] = job

    def results(self) -> Iterator[tuple[Job[Any, Outcome], Outcome]]:
        """Yield each job with its outcome as it is done, until no job is left; more may be submitted meanwhile."""
        while self._pending:
            yield from self.poll()

    def poll(self, timeout_s: float = _POLL_INTERVAL_S) -> list[tuple[Job[Any, Outcome], Outcome]]:
        """Wait until a job is done or the time is up; return the jobs that are done, in the order of submission."""
        done, _ = wait(self._pending, timeout=timeout_s, return_when=FIRST_COMPLETED)
        return [(self._pending.pop(future), future.result()) for future in list(self._pending) if future in done]

    def end_all(self) -> None:
        """Drop all waiting jobs, and end all processes: interrupt them, and kill those that take too long.

        What a killed process leaves in the temporary folder is removed.
        """
        for future in self._pending:
            future.cancel()
        with self._lock:
            self._is_stopped = True
            running = dict(self._running)
        for process, job in running.items():
            job.interrupt(process)
        for process in running:
            try:
                process.wait(_MAX_SHUTDOWN_S)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
        remove_left_overs(Path(tempfile.gettempdir()))

    def _run(self, job: Job[Any, Outcome]) -> Outcome:
        for _ in range(_MAX_ATTEMPTS):
            try:
                process = self._start(job)
            except OSError as error:
                return job.start_failed(error)
            try:
                attempt = job.read_outcome(process)
            finally:
                with self._lock:
                    del self._running[process]
            if attempt.is_final:
                break
        return attempt.outcome

    def _start(self, job: Job[Any, Outcome]) -> subprocess.Popen[Any]:
        """Start a process, unless all are to end.

        Raises:
            CancelledError: the pool is stopped.
            OSError: the process cannot be started.
        """
        with self._lock:
            if self._is_stopped:
                raise CancelledError
            process: subprocess.Popen[Any] = job.start()
            self._running[process] = job
            return process


def run_all(
    jobs: Iterable[Job[Any, Outcome]], max_processes: int, on_outcome: Callable[[Outcome], None]
) -> list[Outcome]:
    """Run jobs, no object twice, a few at a time, and return their outcomes in the order of the jobs.

    ``on_outcome`` is called in this thread with each outcome as it comes.

    Raises:
        KeyboardInterrupt: after the running processes have been ended.
    """
    outcomes: dict[int, Outcome] = {}
    submitted: list[Job[Any, Outcome]] = []
    with WorkerPool[Outcome](max_processes) as pool:
        for job in jobs:
            pool.submit(job)
            submitted.append(job)
        for job, outcome in pool.results():
            outcomes[id(job)] = outcome
            on_outcome(outcome)
    return [outcomes[id(job)] for job in submitted]


def python_command(code: str, *arguments: str) -> list[str]:
    """Return the command of a Python that imports nothing from the current folder, where submissions may lie.

    In the code ``sys.argv[1]`` is the folder of this package; the arguments follow.
    """
    return [sys.executable, "-P", "-c", code, str(_PACKAGE), *arguments]
