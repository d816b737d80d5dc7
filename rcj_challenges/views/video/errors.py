"""Errors of ``video`` and ``snapshot``."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path

from rcj_challenges.core.code import Code
from rcj_challenges.core.codes import CANNOT_WRITE, MISSING_EXTRA
from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError
from rcj_challenges.core.errors import error_hint


class VideoError(DiagnosticError):
    """A video or picture that cannot be made as requested."""

    def __init__(self, code: Code, message: str, help_: str = "") -> None:
        super().__init__(Diagnostic(code, message, help_))


def cannot_write(path: Path, error: OSError) -> VideoError:
    """Return the error about a file that cannot be written."""
    return VideoError(CANNOT_WRITE, f"{path}: {error_hint(error)}", "write it elsewhere with --out FILE")


def require_packages(*packages: str) -> None:
    """Check that optional packages are installed, before any work is done.

    Raises:
        VideoError: one is missing.
    """
    if missing := [package for package in packages if find_spec(package) is None]:
        raise VideoError(
            MISSING_EXTRA,
            f"videos and pictures need optional packages (missing: {', '.join(missing)})",
            'pip install "rcj-challenges[video]"; or watch it in a browser: rcj-challenge view RUN',
        )
