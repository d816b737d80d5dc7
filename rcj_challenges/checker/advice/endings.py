"""Why a program ended while the match goes on, or why its robot stands still, from the lines of its files.

Lines are only searched as text: strange programs are parsed in a separate process (`reader`).
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from pathlib import PurePosixPath

from rcj_challenges.checker.reached import reached_from
from rcj_challenges.core.sanitize import sanitize

_MAX_BYTES = 1_000_000  # a longer file is not written by hand
_MAX_LINE_BYTES = 300
_STEP = rb"[\w.]{1,80}\.step\([\w\s.*/+,=-]{0,80}(?:\([\w\s.*/+-]{0,80}\))?\)"
_ENDS_AT_ZERO = re.compile(rb"while[ \t(]{1,4}" + _STEP + rb"[ \t]{0,4}(?:==[ \t]?-?1|!=[ \t]?0|>[ \t]?0)?[ \t)]{0,4}:")
_ASKS_ITS_NAME = re.compile(rb"""if[ \t(]{1,4}__name__[ \t]{0,4}==[ \t]{0,4}["'](?P<name>[^"']{0,80})["']""")
_FUNCTION = re.compile(rb"def[ \t]+(\w{1,80})[ \t]*\(")
_QUIET_EXCEPT = re.compile(
    rb"except[ \t]*(?:(?:Base)?Exception[ \t]*)?:[ \t]*(?:(?P<does>pass|continue|break|return)\b.*)?"
)
_QUIET = re.compile(rb"(?:pass|continue|break|return)\b")


def why_it_ended(files: Mapping[PurePosixPath, bytes], entry: PurePosixPath, *, has_stepped: bool) -> tuple[str, str]:
    """Return code and help for a program that ended without a fault; both empty if its lines do not show why.

    Args:
        files: of its team.
        entry: the file that was started.
        has_stepped: whether it ever called step.
    """
    reached = {path: files[path] for path in reached_from(entry, files) if len(files[path]) <= _MAX_BYTES}
    for path, content in reached.items():
        for number, _, code in _lines(content):
            if _ENDS_AT_ZERO.match(code):
                return "loop_ends", (
                    "step returns 0 while the match goes on and -1 at its end, so the loop in "
                    f"{_place(path, number, entry)} ends at once: write while robot.step(32) != -1:"
                )
    own = list(_lines(reached.get(entry, b"")))
    asked = [(number, found["name"]) for number, _, code in own if (found := _ASKS_ITS_NAME.match(code))]
    if asked and b"__main__" not in {name for _, name in asked}:
        return "wrong_main", f'line {asked[0][0]} is never true: write if __name__ == "__main__":'
    uncalled = _uncalled(own, reached) if not has_stepped else None
    if uncalled is not None:
        return "never_called", (
            f"the loop with step is in {uncalled[1]}(), line {uncalled[0]}, and nothing calls it: call it at the end "
            "of the program"
        )
    quiet = hidden_error(files, entry)
    return ("hidden_error", quiet) if quiet else ("", "")


def hidden_error(files: Mapping[PurePosixPath, bytes], entry: PurePosixPath) -> str:
    """Return what to do about an ``except`` that hides every error; empty if there is none.

    Args:
        files: of the team.
        entry: the file that was started.
    """
    for path in reached_from(entry, files):
        lines = list(_lines(files[path])) if len(files[path]) <= _MAX_BYTES else []
        for (number, _, code), (_, _, below) in zip(lines, [*lines[1:], (0, 0, b"")], strict=True):
            found = _QUIET_EXCEPT.fullmatch(code)
            if found is not None and (found["does"] or _QUIET.match(below)):
                return (
                    f'the "except" in {_place(path, number, entry)} hides every error: write traceback.print_exc() '
                    "there, and import traceback at the top"
                )
    return ""


def _uncalled(own: list[tuple[int, int, bytes]], reached: Mapping[PurePosixPath, bytes]) -> tuple[int, str] | None:
    """Return line and name of the first function with a call of step that nothing uses."""
    text = b"\n".join(reached.values())
    at, indent, name = 0, 0, b""
    for number, depth, code in own:
        if (found := _FUNCTION.match(code)) is not None:
            at, indent, name = number, depth, found[1]
        elif depth <= indent:
            name = b""
        if name and b".step(" in code and not name.startswith(b"__"):
            if len(re.findall(rb"\b%b\b" % name, text)) == 1:
                return at, sanitize(name)
            name = b""
    return None


def _lines(content: bytes) -> Iterator[tuple[int, int, bytes]]:
    """Yield number, indentation and code of each line that is neither empty, a comment nor very long."""
    for number, line in enumerate(content.splitlines(), start=1):
        code = line.strip()
        if code and not code.startswith(b"#") and len(line) <= _MAX_LINE_BYTES:
            yield number, len(line) - len(line.lstrip()), code


def _place(path: PurePosixPath, number: int, entry: PurePosixPath) -> str:
    return f"line {number}" + ("" if path == entry else f" of {sanitize(path)}")
