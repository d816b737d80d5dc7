"""What happens when the fault is ours: one line, a report file, exit code 3."""

from __future__ import annotations

import contextlib
import platform
import sys
import tempfile
import traceback
from pathlib import Path

from rcj_challenges import __version__
from rcj_challenges.facts.errors import RcjError


def report_our_fault(error: BaseException) -> int:
    """Write a report that can be sent with a bug report, name it on stderr, and return exit code 3."""
    lines = [
        f"rcj-challenges {__version__}, Python {platform.python_version()}, {platform.system()} {platform.machine()}",
        f"arguments: {' '.join(sys.argv[1:])}",
        "",
        "".join(traceback.format_exception(error)),
    ]
    text = "\n".join(lines)
    try:
        where = f"A report is in {_written(text, Path.cwd()).name}"
    except OSError:
        where = f"No report can be written in this folder, so here it is:\n{text}"
    what = str(error) if isinstance(error, RcjError) else f"{type(error).__name__}: {error}"
    told = f"rcj-challenge: this is our fault, not yours: {what}"
    with contextlib.suppress(OSError):
        print(f"{told}\n{where}; please send it to the project.", file=sys.stderr)  # noqa: T201 - this is the terminal
    return 3


def _written(text: str, folder: Path) -> Path:
    with tempfile.NamedTemporaryFile(
        "w", prefix="rcj-challenge-report-", suffix=".txt", dir=folder, delete=False, encoding="utf-8",
        errors="backslashreplace",
    ) as file:  # fmt: skip
        file.write(text)
    return Path(file.name)
