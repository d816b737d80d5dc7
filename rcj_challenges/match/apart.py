"""Work in processes of our own, several at once: matches, and checks of submissions. They can all be ended together."""

from __future__ import annotations

import subprocess
import sys
import tempfile
import threading
from collections.abc import Callable, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from pathlib import Path
from typing import AnyStr, Generic, TypeVar

from rcj_challenges.controllers.private_folders import remove_left_overs

_POLL_S = 0.2
_LEAVE_S = 5.0
_PACKAGE = Path(__file__).resolve().parents[2]

Job = TypeVar("Job")
Result = TypeVar("Result")


def python(start: str, *arguments: str) -> list[str]:
    """Return the command of a Python that imports nothing from the current folder, where submissions may lie.

    Args:
        start: what it runs; ``sys.argv[1]`` is where this package is to be found.
        arguments: what follows that.
    """
    return [sys.executable, "-P", "-c", start, str(_PACKAGE), *arguments]


class Running(Generic[AnyStr]):
    """The processes that run at present.

    Attributes:
        stopped: whether none shall be started any more.
    """

    def __init__(self, interrupt: Callable[[subprocess.Popen[AnyStr]], object]) -> None:
        """Build it with no process.

        Args:
            interrupt: asks a process to end.
        """
        self._interrupt: Callable[[subprocess.Popen[AnyStr]], object] = interrupt
        self._lock = threading.Lock()
        self._processes: set[subprocess.Popen[AnyStr]] = set()
        self.stopped = False

    def begin(self, start: Callable[[], subprocess.Popen[AnyStr]]) -> subprocess.Popen[AnyStr] | None:
        """Start a process; None if all shall end.

        Raises:
            OSError: it cannot be started.
        """
        with self._lock:
            if self.stopped:
                return None
            process = start()
            self._processes.add(process)
            return process

    def forget(self, process: subprocess.Popen[AnyStr]) -> None:
        """Take note that a process is over."""
        with self._lock:
            self._processes.discard(process)

    def end_all(self) -> None:
        """Interrupt all processes, so that they can put their things in order, then end them.

        On a busy computer one may not be ready with that in time: what it leaves in the temporary folder is removed.
        """
        with self._lock:
            self.stopped = True
            left = list(self._processes)
        for process in left:
            self._interrupt(process)
        for process in left:
            try:
                process.wait(_LEAVE_S)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
        remove_left_overs(Path(tempfile.gettempdir()))


def do_all(
    jobs: Sequence[Job],
    do: Callable[[Job], Result],
    running: Running[AnyStr],
    at_once: int,
    on_done: Callable[[Result], None],
) -> list[Result]:
    """Do all jobs, a few at a time, and return what came of them in their order.

    Args:
        jobs: what is to be done.
        do: does one, in a thread of its own, and waits for the process that it begins.
        running: takes these processes; they are ended if this is interrupted.
        at_once: how many at a time.
        on_done: called in this thread for each result as it comes.

    Raises:
        KeyboardInterrupt: after the running processes have been ended.
    """
    futures: list[Future[Result]] = []
    with ThreadPoolExecutor(max_workers=max(1, at_once)) as pool:
        try:
            futures.extend(pool.submit(do, job) for job in jobs)  # the first is at work before the last is handed out
            pending = set(futures)
            while pending:
                done, pending = wait(pending, timeout=_POLL_S, return_when=FIRST_COMPLETED)
                for future in sorted(done, key=futures.index):
                    on_done(future.result())
        except BaseException:
            for future in futures:
                future.cancel()
            running.end_all()
            raise
    return [future.result() for future in futures]
