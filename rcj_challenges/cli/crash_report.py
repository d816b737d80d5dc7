"""Reports bugs of this project: one line, a report file, exit code 3."""

from __future__ import annotations

import contextlib
import platform
import sys
import tempfile
import traceback
from pathlib import Path

from rcj_challenges import __version__
from rcj_challenges.cli.codes import INTERNAL_ERROR
from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.core.errors import RcjError


def write_crash_report(error: BaseException) -> int:
    """Write a report that can be sent with a bug report, name it on stderr, and return exit code 3."""
    lines = [
        f"rcj-challenges {__version__}, Python {platform.python_version()}, {platform.system()} {platform.machine()}",
        f"arguments: {' '.join(sys.argv[1:])}",
        "",
        "".join(traceback.format_exception(error)),
    ]
    text = "\n".join(lines)
    report = None
    try:
        where = f"a report is in {_written(text, Path.cwd()).name}"
    except OSError:
        where, report = "no report can be written in this folder, so it follows here", text
    what = str(error) if isinstance(error, RcjError) else f"{type(error).__name__}: {error}"
    message = f"this is our fault, not yours: {what}"
    found = Diagnostic(INTERNAL_ERROR, message, f"{where}; please send it to the project")
    with contextlib.suppress(OSError):
        print(found if report is None else f"{found}\n{report}", file=sys.stderr)  # noqa: T201 - this is the terminal
    return 3


def _written(text: str, folder: Path) -> Path:
    with tempfile.NamedTemporaryFile(
        "w", prefix="rcj-challenge-report-", suffix=".txt", dir=folder, delete=False, encoding="utf-8",
        errors="backslashreplace"
    ) as file:  # fmt: skip
        file.write(text)
    return Path(file.name)
