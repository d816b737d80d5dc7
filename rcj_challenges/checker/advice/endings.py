"""Why a program ended while the match goes on, or hides its errors, from the lines of its files.

Lines are only searched as text: untrusted programs are parsed in a separate process (`reader`).
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import PurePosixPath

from rcj_challenges.core.sanitize import sanitize

_MAX_BYTES = 1_000_000  # a longer file is not written by hand
_ENDS_AT_ZERO = re.compile(
    rb"^[ \t]*while[ \t(]{1,4}[\w.]{1,80}\.step\([\w \t.*/+,=-]{0,80}(?:\([\w \t.*/+-]{0,80}\))?\)[ \t]{0,4}"
    rb"(?:==[ \t]?-?1|!=[ \t]?0|>[ \t]?0)?[ \t)]{0,4}:",
    re.MULTILINE,
)
_QUIET_EXCEPT = re.compile(
    rb"^[ \t]*except[ \t]*(?:(?:Base)?Exception[ \t]*)?:\s*(?:pass|continue|break|return)\b", re.MULTILINE
)


def ending_loop_help(files: Mapping[PurePosixPath, bytes], entry: PurePosixPath) -> str:
    """Advice on a main loop that ends at once; empty if there is none."""
    place = _find(_ENDS_AT_ZERO, files, entry)
    return place and (
        f"step returns 0 while the match goes on and -1 at its end, so the loop in {place} ends at once: write while "
        "robot.step(32) != -1:"
    )


def hidden_error_help(files: Mapping[PurePosixPath, bytes], entry: PurePosixPath) -> str:
    """Advice on an ``except`` that hides every error; empty if there is none."""
    place = _find(_QUIET_EXCEPT, files, entry)
    return place and (
        f'the "except" in {place} hides every error: write traceback.print_exc() there, and import traceback at the top'
    )


def _find(pattern: re.Pattern[bytes], files: Mapping[PurePosixPath, bytes], entry: PurePosixPath) -> str:
    """Return the first place of a pattern in the programs beside the entry, the entry first; empty if there is none."""
    programs = [path for path in files if path.parent == entry.parent and path.suffix == ".py"]
    for path in sorted(programs, key=lambda path: (path != entry, path)):
        if (found := pattern.search(files[path], 0, _MAX_BYTES)) is not None:
            line = files[path].count(b"\n", 0, found.start()) + 1
            return f"line {line}" + ("" if path == entry else f" of {sanitize(path)}")
    return ""
