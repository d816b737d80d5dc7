"""Many matches at once: one subprocess each, so that one that dies takes no other with it."""

from __future__ import annotations

import json
import subprocess
import sys
import threading
from collections.abc import Callable, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from dataclasses import dataclass
from typing import Any

from rcj_challenges.facts.errors import told_of

_POLL_S = 0.2
_LEAVE_S = 5.0
_WRONG_INPUT = 2


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
    running ones are interrupted, their records stay, and what is done is lost to nobody: ``on_done`` has seen it.

    Args:
        jobs: what to play.
        at_once: how many processes at a time.
        on_done: called in this thread for each outcome as it comes.

    Raises:
        KeyboardInterrupt: after the running matches have been ended.
    """
    running: set[subprocess.Popen[str]] = set()
    lock = threading.Lock()
    stopping = threading.Event()

    def play(job: Job) -> Outcome:
        outcome = _play_one(job, running, lock, stopping)
        retry = outcome.result is None and not outcome.wrong_input and not stopping.is_set()
        return _play_one(job, running, lock, stopping) if retry else outcome

    with ThreadPoolExecutor(max_workers=max(1, at_once)) as pool:
        futures: list[Future[Outcome]] = [pool.submit(play, job) for job in jobs]
        try:
            pending = set(futures)
            while pending:
                done, pending = wait(pending, timeout=_POLL_S, return_when=FIRST_COMPLETED)
                for future in sorted(done, key=futures.index):
                    on_done(future.result())
        except BaseException:
            stopping.set()
            for future in futures:
                future.cancel()
            _end_all(running, lock)
            raise
    return [future.result() for future in futures]


def _play_one(
    job: Job, running: set[subprocess.Popen[str]], lock: threading.Lock, stopping: threading.Event
) -> Outcome:
    command = [sys.executable, "-m", "rcj_challenges", "run", *job.arguments, "--seed", str(job.seed), "--json"]
    with lock:
        if stopping.is_set():
            return Outcome(job, None, "interrupted", wrong_input=True)
        try:
            process = subprocess.Popen(
                command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8",
                errors="replace",
            )  # fmt: skip
        except OSError as error:
            return Outcome(job, None, f"this computer cannot start one more match: {told_of(error)}", wrong_input=True)
        running.add(process)
    try:
        out, complaint = process.communicate()
    finally:
        with lock:
            running.discard(process)
    if process.returncode == 0:
        return Outcome(job, json.loads(out))
    return Outcome(job, None, complaint.strip(), wrong_input=process.returncode == _WRONG_INPUT)


def _end_all(running: set[subprocess.Popen[str]], lock: threading.Lock) -> None:
    with lock:
        left = list(running)
    for process in left:
        process.terminate()
    for process in left:
        try:
            process.wait(_LEAVE_S)
        except subprocess.TimeoutExpired:
            process.kill()
