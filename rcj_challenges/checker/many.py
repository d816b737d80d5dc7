"""Many submissions at once: a process for each, so that one that comes to a bad end takes no other with it."""

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
from rcj_challenges.checker.many_given import Called, called
from rcj_challenges.checker.report import FileReport
from rcj_challenges.controllers.team import TeamError
from rcj_challenges.facts.errors import told_of
from rcj_challenges.match.apart import Running, do_all, python
from rcj_challenges.scenario.load import Loaded, load_resolved
from rcj_challenges.scenario.models.scenario import Limits

_SLACK_S = 120.0
_MOST_SHORT_MATCHES = 12
_ATTEMPTS = 2
_START = "import sys; sys.path.append(sys.argv[1]); from rcj_challenges.checker.many import work; work()"


@dataclass(frozen=True)
class _Worker:
    """What a process of its own is told.

    Attributes:
        told: all but the path, as JSON.
        patience_s: how long it may take; only a fault of ours takes longer.
    """

    told: dict[str, Any]
    patience_s: float


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
    worker = _Worker(_told(loaded, options), _patience_s(loaded.scenario.limits, len(loaded.scenario.robots)))
    running: Running[bytes] = Running(_interrupt)

    def check(job: tuple[Path, Called]) -> FileReport:
        return _check_apart(*job, worker, running)

    return do_all(list(zip(paths, called(paths), strict=True)), check, running, jobs, on_done)


def work() -> None:
    """Check one submission in this process: what it is told comes on standard input, the report goes out as JSON."""
    signal.signal(signal.SIGINT, _leave)
    told = json.loads(sys.stdin.buffer.read())
    named = Called(**told["called"])
    options = told["options"]
    replays = options.pop("replays")
    path = Path(told["path"])
    try:
        report = check_file(
            path,
            load_resolved(told["scenario"]),
            CheckOptions(**options, replays=None if replays is None else Path(replays)),
            named=named,
        )
    except TeamError as error:  # it could be opened when the check began
        report = unchecked_report(named, str(error))
    logo = None if report.logo is None else base64.b64encode(report.logo).decode("ascii")
    said = json.dumps({"report": report.model_dump(mode="json"), "logo": logo})
    sys.stdout.write(said + "\n")


def _leave(*_: object) -> None:
    """End this process, which removes what it has on the disk; a second signal does not disturb it in that."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    raise KeyboardInterrupt


def _interrupt(process: subprocess.Popen[bytes]) -> None:
    """Let a check end so that it can remove what it has on the disk."""
    if os.name == "posix":
        process.send_signal(signal.SIGINT)
    else:
        process.terminate()


def _start() -> subprocess.Popen[bytes]:
    return subprocess.Popen(
        python(_START), stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE
    )  # fmt: skip


def _check_apart(path: Path, named: Called, worker: _Worker, running: Running[bytes]) -> FileReport:
    """Check a submission in a process of its own; one that dies for a reason of its own is tried once more."""
    told = json.dumps({**worker.told, "path": str(path), "called": asdict(named)}).encode()
    report = unchecked_report(named, "the check was interrupted")
    for _ in range(_ATTEMPTS):
        try:
            process = running.begin(_start)
        except OSError as error:
            return unchecked_report(named, f"no process could be started for it: {told_of(error)}")
        if process is None:
            break
        try:
            out, err = process.communicate(told, worker.patience_s)
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            return crashed_report(named, f"the check did not end within {worker.patience_s:.0f} s")
        finally:
            running.forget(process)
        written = _report(out)
        if written is not None:
            return written
        report = _dead_report(named, process.returncode, err.decode("utf-8", "replace"))
    return report


def _dead_report(named: Called, status: int, said: str) -> FileReport:
    """Return the report on a submission whose process died without one."""
    if os.name == "posix" and status == -signal.SIGKILL:  # nothing of ours does that here
        return unchecked_report(named, "the system ended its process; perhaps there is not enough memory")
    return crashed_report(named, f"the check came to a bad end (exit status {status})", said)


def _report(out: bytes) -> FileReport | None:
    """Return the report that a process wrote, if it came that far."""
    try:
        said = json.loads(out)
        logo = None if said["logo"] is None else base64.b64decode(said["logo"])
        return FileReport.model_validate({**said["report"], "logo": logo})
    except (ValueError, ValidationError, KeyError, TypeError):
        return None


def _told(loaded: Loaded, options: CheckOptions) -> dict[str, Any]:
    told = asdict(options)
    told["replays"] = None if options.replays is None else str(options.replays.resolve())
    return {"scenario": loaded.resolved, "options": told}


def _patience_s(limits: Limits, robots: int) -> float:
    """Return far more than the limits of all programs of all short matches together let a check last."""
    return _SLACK_S + _MOST_SHORT_MATCHES * (limits.start_s + robots * limits.half_s)
