"""Many matches at once: one subprocess each, so that one that dies takes no other with it."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import threading
from collections.abc import Callable, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rcj_challenges.facts.errors import told_of

_POLL_S = 0.2
_LEAVE_S = 5.0
_WRONG_INPUT = 2
_START = "import sys; sys.path.append(sys.argv.pop(1)); from rcj_challenges.cli.child import main; main()"


@dataclass(frozen=True)
class Job:
    """One match to be played.

    Attributes:
        seed: of the match.
        arguments: of ``rcj-challenge run``, without seed and output format.
    """

    seed: int
    arguments: tuple[str, ...]


@dataclass(frozen=True)
class Outcome:
    """What became of a job.

    Attributes:
        job: the job.
        result: as in ``result.json``; None if the match could not be played.
        complaint: what its process said on stderr, if it could not.
        wrong_input: True if that was the input's fault, so that trying again is of no use.
    """

    job: Job
    result: dict[str, Any] | None
    complaint: str = ""
    wrong_input: bool = False


def play_many(jobs: Sequence[Job], at_once: int, on_done: Callable[[Outcome], None]) -> list[Outcome]:
    """Play all jobs, a few at a time, and return their outcomes in the order of the jobs.

    A match whose process died for a reason of its own (exit code 3 or a signal) is tried once more. On Ctrl-C the
    running ones are interrupted, their records stay, and what is done is lost to nobody: ``on_done`` has seen it. If
    this process is killed, they end as on Ctrl-C.

    Args:
        jobs: what to play.
        at_once: how many processes at a time.
        on_done: called in this thread for each outcome as it comes.

    Raises:
        KeyboardInterrupt: after the running matches have been ended.
    """
    running = _Running()

    def play(job: Job) -> Outcome:
        outcome = _play_one(job, running)
        retry = outcome.result is None and not outcome.wrong_input and not running.stopped
        return _play_one(job, running) if retry else outcome

    with ThreadPoolExecutor(max_workers=max(1, at_once)) as pool:
        futures: list[Future[Outcome]] = [pool.submit(play, job) for job in jobs]
        try:
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


class _Running:
    """The processes that run at present.

    Standard input of each is a pipe, its lifeline: that ends when this process does, and it with it. One for all would
    do, but on Windows a process cannot start while another one reads from the pipe that it is given.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._lifelines: dict[subprocess.Popen[str], int] = {}
        self.stopped = False

    def start(self, arguments: Sequence[str]) -> subprocess.Popen[str] | None:
        """Start a process; None if all shall end.

        Raises:
            OSError: it cannot be started.
        """
        # -P: what lies in the current folder, perhaps submissions, is not to be imported.
        command = [sys.executable, "-P", "-c", _START, str(Path(__file__).resolve().parents[2]), *arguments]
        with self._lock:
            if self.stopped:
                return None
            lifeline, our_end = os.pipe()
            try:
                process = subprocess.Popen(
                    command, stdin=lifeline, stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8",
                    errors="replace",
                )  # fmt: skip
            except BaseException:
                os.close(our_end)
                raise
            finally:
                os.close(lifeline)
            self._lifelines[process] = our_end
            return process

    def forget(self, process: subprocess.Popen[str]) -> None:
        """Take note that a process is over."""
        with self._lock:
            os.close(self._lifelines.pop(process))

    def end_all(self) -> None:
        """Interrupt all processes, so that they can close their records, then end them."""
        with self._lock:
            self.stopped = True
            left = list(self._lifelines)
        for process in left:
            process.terminate()
        for process in left:
            try:
                process.wait(_LEAVE_S)
            except subprocess.TimeoutExpired:
                process.kill()


def _play_one(job: Job, running: _Running) -> Outcome:
    try:
        process = running.start(["run", *job.arguments, "--seed", str(job.seed), "--json"])
    except OSError as error:
        return Outcome(job, None, f"this computer cannot start one more match: {told_of(error)}", wrong_input=True)
    if process is None:
        return Outcome(job, None, "interrupted", wrong_input=True)
    try:
        out, complaint = process.communicate()
    finally:
        running.forget(process)
    if process.returncode:
        return Outcome(job, None, complaint.strip(), wrong_input=process.returncode == _WRONG_INPUT)
    try:
        return Outcome(job, json.loads(out))
    except ValueError:
        return Outcome(job, None, f"its process ended without a result: {complaint.strip()}")
