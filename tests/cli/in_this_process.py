"""What commands do, run in the process of the tests: the result is the same, and nothing has to be loaded again."""

import gc
import io
import json
import sys
from collections.abc import Callable, Sequence
from contextlib import redirect_stdout
from pathlib import Path

import pytest

from rcj_challenges import cli
from rcj_challenges.checker.check import CheckOptions, check_file
from rcj_challenges.checker.discovery import name_submissions
from rcj_challenges.checker.report import FileReport
from rcj_challenges.cli.commands import load_app
from rcj_challenges.match.batch import Job, Outcome
from rcj_challenges.scenario.load import Loaded


def here(monkeypatch: pytest.MonkeyPatch, folder: Path, *arguments: str) -> object:
    """Run the command in a folder; returns its exit code."""
    with monkeypatch.context() as patched:
        patched.chdir(folder)
        patched.setattr(sys, "argv", ["rcj-challenge", *arguments])
        # This process has more to do than one command.
        patched.setattr(gc, "set_threshold", lambda *_: None)
        patched.setattr(gc, "freeze", lambda: None)
        patched.setattr(cli, "_install_signal_handlers", list)
        with pytest.raises(SystemExit) as left:
            cli.main()
    return left.value.code


def one_after_the_other(
    paths: Sequence[Path], loaded: Loaded, options: CheckOptions, jobs: int, on_done: Callable[[FileReport], None]
) -> list[FileReport]:
    """Check as `check_many` does, where it does not matter that each submission has a process of its own."""
    reports = [
        check_file(path, loaded, options, named=one) for path, one in zip(paths, name_submissions(paths), strict=True)
    ]
    for report in reports:
        on_done(report)
    return reports


def played_one_after_the_other(jobs: Sequence[Job], at_once: int, on_done: Callable[[Outcome], None]) -> list[Outcome]:
    """Play as `run_all` does, where it does not matter that each match has a process of its own."""
    outcomes = []
    for job in jobs:
        with redirect_stdout(io.StringIO()) as printed:
            assert load_app()(["run", *job.arguments, "--seed", str(job.seed), "--json"], standalone_mode=False) == 0
        outcomes.append(Outcome(job, json.loads(printed.getvalue())))
        on_done(outcomes[-1])
    return outcomes
