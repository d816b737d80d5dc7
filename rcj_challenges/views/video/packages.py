"""The optional packages of ``video`` and ``snapshot``."""

from __future__ import annotations

from importlib.util import find_spec

from rcj_challenges.core.codes import MISSING_EXTRA
from rcj_challenges.core.errors import RcjError


def require_packages(*packages: str) -> None:
    """Check that optional packages are installed, before any work is done.

    Raises:
        RcjError: one is missing.
    """
    if missing := [package for package in packages if find_spec(package) is None]:
        message = f"videos and pictures need optional packages (missing: {', '.join(missing)})"
        help_ = 'pip install "rcj-challenges[video]"; or watch it in a browser: rcj-challenge view RUN'
        raise RcjError(message, help_, code=MISSING_EXTRA)
