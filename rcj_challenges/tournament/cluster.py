"""Plays jobs on the workers of a Dask cluster; the client assigns each job to a worker.

Dask itself would give a job to any worker and repeat it as often as it likes. Here a worker is compared before its
first job, and a job is handed out twice at most, as in the local pool.
"""

from __future__ import annotations

import threading
import time
from collections import Counter, deque
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Self

from rcj_challenges.core.amounts import counted
from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.tournament import cluster_worker, codes
from rcj_challenges.tournament.executor import POLL_INTERVAL_S, JobOutcome
from rcj_challenges.tournament.jobs import MatchJob, Workplace

if TYPE_CHECKING:
    from distributed import Client, Future

_CONNECT_S = 10
_FIRST_WORKER_S = 10.0
_WORKERS_EVERY_S = 1.0
_RESULT_S = 60.0  # a full record, 45 MB, over a slow network
_MAX_ATTEMPTS = 2  # as in the local pool
_UNFIT_HELP = "install the same versions there, or end that worker; with --shared the folder must have the same path"


@dataclass
class _Running:
    job: MatchJob
    worker: str
    future: Future


@dataclass
class ClusterExecutor:
    """Plays each job on a worker of a Dask cluster, as many at a time as the worker has threads.

    Attributes:
        address: of the scheduler.
        versions: that each worker must have.
        is_shared: whether the workers see `place` under the same path; else files are sent.
        on_note: called with a line about workers that come, go or fail.
    """

    place: Workplace
    address: str
    versions: Mapping[str, str]
    is_shared: bool
    on_note: Callable[[str], None]
    _queue: deque[MatchJob] = field(default_factory=deque)
    _failures: Counter[str] = field(default_factory=Counter)
    _running: list[_Running] = field(default_factory=list)
    _threads: dict[str, int] = field(default_factory=dict)
    _refused: dict[str, str] = field(default_factory=dict)
    _woken: threading.Event = field(default_factory=threading.Event)
    _looked_at_s: float = 0.0

    def __post_init__(self) -> None:
        """Connect, and compare the workers that are there.

        Raises:
            DiagnosticError: Dask is missing, there is no cluster or no worker, or one cannot play these matches.
        """
        self._client = _connect(self.address)
        try:
            notes = self._wait_for_workers()
            if self._refused:
                unfit = (
                    f"the worker {worker} cannot play these matches: {why}" for worker, why in self._refused.items()
                )
                raise DiagnosticError(
                    *(Diagnostic(codes.CLUSTER_WORKER_UNFIT, message, _UNFIT_HELP) for message in unfit)
                )
            self._note(notes)
        except BaseException:
            self._client.close()
            raise

    @property
    def lanes(self) -> int:
        """Number of jobs that are played at a time; 1 while there is no worker, so that one job waits for it."""
        return max(1, sum(self._threads.values()))

    def submit(self, job: MatchJob) -> None:
        """Play a job as soon as a worker is free for it."""
        self._queue.append(job)
        self._hand_out()

    def poll(self) -> list[JobOutcome]:
        """Wait a moment and return what is done.

        Raises:
            DiagnosticError: the scheduler is gone.
        """
        self._woken.wait(POLL_INTERVAL_S)
        self._woken.clear()
        if time.monotonic() >= self._looked_at_s + _WORKERS_EVERY_S:
            self._note(self._look_for_workers())
        running, self._running = self._running, []
        outcomes = [outcome for one in running if (outcome := self._outcome(one)) is not None]
        self._hand_out()
        return outcomes

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        try:
            # A worker ends its match as soon as the scheduler has released it.
            if self._client.status == "running":
                self._client.cancel([one.future for one in self._running])
        finally:
            self._client.close()

    # --- jobs ---------------------------------------------------------------------------------------------------------

    def _hand_out(self) -> None:
        free = dict(self._threads)
        for one in self._running:
            if one.worker in free:  # a refused one may still have another job
                free[one.worker] -= 1
        while self._queue and max(free.values(), default=0) > 0:
            worker = max(free, key=free.__getitem__)
            free[worker] -= 1
            job = self._queue.popleft()
            inputs = {} if self.is_shared else self.place.read_inputs(job)
            future = self._client.submit(
                cluster_worker.play, job.to_json(), inputs, self._shared_folder, workers=[worker], pure=False
            )
            future.add_done_callback(lambda _: self._woken.set())
            self._running.append(_Running(job, worker, future))

    def _outcome(self, one: _Running) -> JobOutcome | None:
        """Return the outcome of a job; None if it still runs, or waits for another worker."""
        is_lost = not one.future.done()
        if is_lost and one.worker in self._threads:
            self._running.append(one)
            return None
        if one.future.status == "finished":
            try:
                returned: cluster_worker.Returned = one.future.result(_RESULT_S)
            except TimeoutError:  # the worker took its result with it
                is_lost = True
        if is_lost:
            one.future.cancel()
            return self._failed(one, f"the worker {one.worker} was lost")
        if one.future.status != "finished":
            error = one.future.exception() if one.future.status == "error" else "its job was released"
            return self._failed(one, f"the worker {one.worker} failed: {error}")
        one.future.release()
        if returned.is_host_error:
            self._refused[one.worker] = returned.complaint
            self._threads.pop(one.worker, None)
            return self._failed(one, f"the worker {one.worker} cannot go on: {returned.complaint}", is_host_error=True)
        if returned.result is None:
            return JobOutcome(one.job, None, complaint=returned.complaint)
        folder = self.place.playing / (returned.folder or one.job.id)
        cluster_worker.write_files(folder, returned.files)
        return JobOutcome(one.job, returned.result, folder)

    def _failed(self, one: _Running, complaint: str, *, is_host_error: bool = False) -> JobOutcome | None:
        """Hand a job out again if it may be, and there is still a worker if this one cannot go on."""
        self._failures[one.job.id] += 1
        if self._failures[one.job.id] < _MAX_ATTEMPTS and (self._threads or not is_host_error):
            self._queue.appendleft(one.job)
            self._note([f"{complaint}; its match is handed out again"])
            return None
        return JobOutcome(one.job, None, complaint=complaint, is_host_error=is_host_error)

    # --- workers ------------------------------------------------------------------------------------------------------

    def _wait_for_workers(self) -> list[str]:
        """Wait until there are workers; returns notes.

        Raises:
            DiagnosticError: none has come.
        """
        until_s = time.monotonic() + _FIRST_WORKER_S
        while not (notes := self._look_for_workers()):
            if time.monotonic() > until_s:
                message = f"the cluster at {self.address} has no workers"
                help_ = f"start one on each computer: dask worker {self.address} --nthreads 2"
                raise DiagnosticError(Diagnostic(codes.CLUSTER_NO_WORKERS, message, help_))
            time.sleep(POLL_INTERVAL_S)
        return notes

    def _look_for_workers(self) -> list[str]:
        """See which workers have come and gone; the new ones are compared. Returns notes.

        Raises:
            DiagnosticError: the scheduler is gone.
        """
        if self._client.status != "running":
            raise _lost(self.address)
        try:
            here: dict[str, int] = self._client.nthreads()
        except OSError as error:
            raise _lost(self.address) from error
        self._looked_at_s = time.monotonic()
        notes = []
        for worker in self._threads.keys() - here.keys():
            del self._threads[worker]
            notes.append(f"the worker {worker} has gone")
        new = [worker for worker in here if worker not in self._threads and worker not in self._refused]
        if not new:
            return notes
        introduced = self._client.run(cluster_worker.introduce, self._shared_folder, workers=new, on_error="return")
        for worker, one in introduced.items():
            why = f"it does not answer: {one}" if isinstance(one, BaseException) else self._unfitness(*one)
            if why:
                self._refused[worker] = why
                notes.append(f"the worker {worker} gets no match: {why}")
            else:
                self._threads[worker] = here[worker]
                notes.append(f"the worker {worker} plays {counted(here[worker], 'match', 'matches')} at a time")
        return notes

    def _unfitness(self, versions: Mapping[str, str], sees_folder: bool) -> str:
        others = [f"{name} {versions.get(name, 'none')}, here {version}"
                  for name, version in self.versions.items() if versions.get(name) != version]  # fmt: skip
        if others:
            return f"it has other versions: {'; '.join(others)}"
        return "" if sees_folder else f"it does not see the folder {self._shared_folder}"

    def _note(self, lines: Iterable[str]) -> None:
        for line in lines:
            self.on_note(sanitize(line))

    @property
    def _shared_folder(self) -> str | None:
        return str(self.place.folder.resolve()) if self.is_shared else None


def _connect(address: str) -> Client:
    try:
        from distributed import Client  # noqa: PLC0415 - an extra, and slow to import
    except ImportError as error:
        help_ = 'install it here and on each worker: pip install "rcj-challenges[cluster]"'
        raise DiagnosticError(Diagnostic(codes.CLUSTER_MISSING, "--cluster needs dask.distributed", help_)) from error
    try:
        return Client(address, timeout=_CONNECT_S, set_as_default=False)
    except (OSError, ValueError) as error:
        message = f"no cluster can be reached at {address}: {error}"
        help_ = "start one with 'dask scheduler', and give the address that it prints: tcp://192.168.0.7:8786"
        raise DiagnosticError(Diagnostic(codes.CLUSTER_UNREACHABLE, message, help_)) from error


def _lost(address: str) -> DiagnosticError:
    message = f"the connection to the cluster at {address} was lost"
    help_ = "start the scheduler and its workers, and run again: it continues where it stopped"
    return DiagnosticError(Diagnostic(codes.CLUSTER_LOST, message, help_))
