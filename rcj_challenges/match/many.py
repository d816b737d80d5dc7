"""Many matches at once: one subprocess each, so that one that dies takes no other with it."""

from __future__ import annotations

import json
import os
import subprocess
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from operator import methodcaller
from typing import Any

from rcj_challenges.facts.errors import told_of
from rcj_challenges.match.apart import Running, do_all, python

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
    running = _Matches()

    def play(job: Job) -> Outcome:
        outcome = _play_one(job, running)
        retry = outcome.result is None and not outcome.wrong_input and not running.stopped
        return _play_one(job, running) if retry else outcome

    return do_all(jobs, play, running, at_once, on_done)


class _Matches(Running[str]):
    """The matches that run at present.

    Standard input of each is a pipe, its lifeline: that ends when this process does, and it with it. One for all would
    do, but on Windows a process cannot start while another one reads from the pipe that it is given.
    """

    def __init__(self, *, by_lifeline: bool = os.name != "posix") -> None:
        """Build it with no match.

        Args:
            by_lifeline: whether a match is interrupted by the end of its lifeline, which lets it close its record;
                on Windows a signal would not.
        """
        super().__init__(self._cut_lifeline if by_lifeline else methodcaller("terminate"))
        self._lifelines: dict[subprocess.Popen[str], int] = {}

    def start(self, arguments: Sequence[str]) -> subprocess.Popen[str] | None:
        """Start a match; None if all shall end.

        Raises:
            OSError: it cannot be started.
        """
        return self.begin(lambda: self._process(arguments))

    def forget(self, process: subprocess.Popen[str]) -> None:
        """Take note that a match is over."""
        super().forget(process)
        self._cut_lifeline(process)

    def _cut_lifeline(self, process: subprocess.Popen[str]) -> None:
        our_end = self._lifelines.pop(process, None)  # whoever gets it closes it
        if our_end is not None:
            os.close(our_end)

    def _process(self, arguments: Sequence[str]) -> subprocess.Popen[str]:
        lifeline, our_end = os.pipe()
        try:
            process = subprocess.Popen(
                python(_START, *arguments), stdin=lifeline, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                encoding="utf-8", errors="replace",
            )  # fmt: skip
        except BaseException:
            os.close(our_end)
            raise
        finally:
            os.close(lifeline)
        self._lifelines[process] = our_end
        return process


def _play_one(job: Job, running: _Matches) -> Outcome:
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
