"""Batches of matches: one subprocess each, so that a crash in one does not affect the others."""

from __future__ import annotations

import json
import os
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from rcj_challenges.core.errors import format_error
from rcj_challenges.match.worker_pool import Attempt, python_command

_WRONG_INPUT = 2
_START = "import sys; sys.path.append(sys.argv.pop(1)); from rcj_challenges.cli.child import main; main()"
_HAS_SIGNALS = os.name == "posix"
"""Whether a signal lets a match close its record. On Windows only the end of its lifeline does."""


class MatchProcess(subprocess.Popen[str]):
    """A process that plays a match.

    Its standard input is a pipe, the lifeline: it ends when this process does, and the match with it. One pipe for all
    would do, but on Windows a process cannot start while another one reads from the pipe that it is given.
    """

    def __init__(self, arguments: Sequence[str]) -> None:
        """Start it with arguments of ``rcj-challenge``.

        Raises:
            OSError: it cannot be started.
        """
        lifeline, self._our_end = os.pipe()
        try:
            super().__init__(
                python_command(_START, *arguments), stdin=lifeline, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                encoding="utf-8", errors="replace",
            )  # fmt: skip
        except BaseException:
            self.cut_lifeline()
            raise
        finally:
            os.close(lifeline)

    def cut_lifeline(self) -> None:
        """Close our end of the lifeline, unless it is closed."""
        our_end, self._our_end = self._our_end, -1
        if our_end >= 0:
            os.close(our_end)


@dataclass(frozen=True)
class Job:
    """One match to be played; the arguments of ``rcj-challenge run`` are without seed and output format."""

    seed: int
    arguments: tuple[str, ...]

    def start(self) -> MatchProcess:
        """Start the match.

        Raises:
            OSError: its process cannot be started.
        """
        return MatchProcess(["run", *self.arguments, "--seed", str(self.seed), "--json"])

    def interrupt(self, process: MatchProcess) -> None:
        """Let the match close its record and end."""
        if _HAS_SIGNALS:
            process.terminate()
        else:
            process.cut_lifeline()

    def read_outcome(self, process: MatchProcess) -> Attempt[Outcome]:
        """Wait for the match to end and read its result; final unless the process died, other than by wrong input."""
        try:
            out, complaint = process.communicate()
        finally:
            process.cut_lifeline()
        if process.returncode:
            wrong_input = process.returncode == _WRONG_INPUT
            outcome = Outcome(self, None, complaint.strip(), wrong_input=wrong_input, code=_code_in(out))
            return Attempt(outcome, is_final=wrong_input)
        try:
            return Attempt(Outcome(self, json.loads(out)))
        except ValueError:
            complaint = f"its process ended without a result: {complaint.strip()}"
            return Attempt(Outcome(self, None, complaint), is_final=False)

    def start_failed(self, error: OSError) -> Outcome:
        """Return the outcome of a match whose process could not be started."""
        complaint = f"this computer cannot start one more match: {format_error(error)}"
        return Outcome(self, None, complaint, wrong_input=True)


@dataclass(frozen=True)
class Outcome:
    """The outcome of a job.

    Attributes:
        result: as in ``result.json``; None if the match could not be played.
        complaint: what its process wrote to stderr, if it could not.
        wrong_input: True if the input was wrong, so that a retry is useless.
        code: of the error that its process ended with; empty if it has none.
    """

    job: Job
    result: dict[str, Any] | None
    complaint: str = ""
    wrong_input: bool = False
    code: str = ""


def _code_in(out: str) -> str:
    """Return the code of an error in the last line of what a process wrote; empty if it was killed before that."""
    try:
        return str(json.loads(out.splitlines()[-1])["code"])
    except (ValueError, LookupError, TypeError):
        return ""
