"""Checks many submissions at once, each in its own process, so that a crash in one does not affect the others."""

from __future__ import annotations

import base64
import json
import os
import signal
import subprocess
import sys
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from rcj_challenges.checker.check import CheckOptions, check_file, crashed_report, unchecked_report
from rcj_challenges.checker.discovery import SubmissionName, name_submissions
from rcj_challenges.checker.report import FileReport
from rcj_challenges.core.diagnostics import one_line
from rcj_challenges.core.errors import format_error
from rcj_challenges.match.worker_pool import Attempt, python_command, run_all
from rcj_challenges.scenario.load import Loaded, load_resolved
from rcj_challenges.submissions.team import TeamError

_SLACK_S = 120.0
_MAX_SHORT_MATCHES = 12
_START = "import sys; sys.path.append(sys.argv[1]); from rcj_challenges.checker.many import work; work()"


@dataclass(frozen=True)
class _Job:
    """One submission to be checked.

    Attributes:
        path: of the submission.
        named: its names.
        message: what its process reads from standard input, without the path, as JSON.
        max_s: how long its process may take; only a fault of ours takes longer.
    """

    path: Path
    named: SubmissionName
    message: dict[str, Any]
    max_s: float

    def start(self) -> subprocess.Popen[bytes]:
        command = python_command(_START)
        return subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def interrupt(self, process: subprocess.Popen[bytes]) -> None:
        """End a check in a way that lets it remove its files."""
        if os.name == "posix":
            process.send_signal(signal.SIGINT)
        else:
            process.terminate()

    def read_outcome(self, process: subprocess.Popen[bytes]) -> Attempt[FileReport]:
        message = json.dumps({**self.message, "path": str(self.path), "named": asdict(self.named)}).encode()
        try:
            out, err = process.communicate(message, self.max_s)
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            return Attempt(crashed_report(self.named, f"the check did not end within {self.max_s:.0f} s"))
        report = _report(out)
        if report is not None:
            return Attempt(report)
        return Attempt(_dead_report(self.named, process.returncode, err.decode("utf-8", "replace")), is_final=False)

    def start_failed(self, error: OSError) -> FileReport:
        return unchecked_report(self.named, f"no process could be started for it: {format_error(error)}")


def check_many(
    paths: Sequence[Path], loaded: Loaded, options: CheckOptions, jobs: int, on_done: Callable[[FileReport], None]
) -> list[FileReport]:
    """Check all submissions, a few at a time; return the reports in the order of the paths.

    Args:
        paths: that exist.
        loaded: the scenario that they are for.
        options: what to do.
        jobs: how many at a time.
        on_done: called in this thread for each report as it comes.

    Raises:
        KeyboardInterrupt: after the running checks have been ended.
    """
    fields = asdict(options) | {"replays": None if options.replays is None else str(options.replays.resolve())}
    message = {"scenario": loaded.resolved, "options": fields}
    limits = loaded.scenario.limits
    # Far above what the limits of all programs in all short matches together allow.
    max_s = _SLACK_S + _MAX_SHORT_MATCHES * (limits.start_s + len(loaded.scenario.robots) * limits.half_s)
    named = zip(paths, name_submissions(paths), strict=True)
    return run_all([_Job(path, name, message, max_s) for path, name in named], jobs, on_done)


def work() -> None:
    """Check one submission in this process: the job is JSON on standard input, the report JSON on standard output."""
    signal.signal(signal.SIGINT, _leave)
    request = json.loads(sys.stdin.buffer.read())
    named = SubmissionName(**request["named"])
    options = request["options"]
    replays = options.pop("replays")
    path = Path(request["path"])
    try:
        report = check_file(
            path,
            load_resolved(request["scenario"]),
            CheckOptions(**options, replays=None if replays is None else Path(replays)),
            named=named,
        )
    except TeamError as error:  # it could be opened when the check began
        report = unchecked_report(named, one_line(error))
    logo = None if report.logo is None else base64.b64encode(report.logo).decode("ascii")
    sys.stdout.write(json.dumps({"report": report.model_dump(mode="json"), "logo": logo}) + "\n")


def _leave(*_: object) -> None:
    """End this process, which removes what it has on the disk; a second signal does not disturb it in that."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    raise KeyboardInterrupt


def _dead_report(named: SubmissionName, status: int, errors: str) -> FileReport:
    """Return the report on a submission whose process died without one."""
    if os.name == "posix" and status == -signal.SIGKILL:  # nothing of ours does that here
        return unchecked_report(named, "the system ended its process; perhaps there is not enough memory")
    return crashed_report(named, f"the check came to a bad end (exit status {status})", errors)


def _report(out: bytes) -> FileReport | None:
    """Return the report that a process wrote, if it wrote one."""
    try:
        answer = json.loads(out)
        logo = None if answer["logo"] is None else base64.b64decode(answer["logo"])
        return FileReport.model_validate({**answer["report"], "logo": logo})
    except (ValueError, ValidationError, KeyError, TypeError):
        return None
