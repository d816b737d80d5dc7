"""Parses durations as people type them."""

from __future__ import annotations

import re

from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError

_FORM = re.compile(r"(?:(?P<minutes>[0-9]+):(?=[0-5]?[0-9](?:\.|$)))?(?P<seconds>[0-9]+(?:\.[0-9]+)?|\.[0-9]+)s?")


class DurationError(DiagnosticError):
    """Text that is not a duration."""


def parse_duration(option: str, text: str) -> float:
    """Return seconds from ``90``, ``90s`` or ``1:30``.

    Args:
        option: for which it was given, named in the error.
        text: as typed.

    Raises:
        DurationError: it is no time.
    """
    found = _FORM.fullmatch(text.strip())
    if found is None:
        raise DurationError(Diagnostic("bad-duration", f"{option} {text}: not a time", "write 90, 90s or 1:30"))
    return int(found["minutes"] or 0) * 60 + float(found["seconds"])
