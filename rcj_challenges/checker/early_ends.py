"""Why a program came to its end while the match goes on: a loop that ends at once, or one that nobody comes to.

Lines are looked at as text: strange programs are parsed in a process of their own only (`reader`).
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from pathlib import PurePosixPath

from rcj_challenges.checker.mains import reached_from
from rcj_challenges.facts.shown import shown

_MOST_BYTES = 1_000_000  # of a file; a longer one is no program by hand
_MOST_LINE_BYTES = 300

_STEP = rb"[\w.]{1,80}\.step\([\w\s.*/+,=-]{0,80}(?:\([\w\s.*/+-]{0,80}\))?\)"
# Loops that go on only as long as step returns something other than 0, which it does at the end of the match.
_ENDS_AT_ZERO = re.compile(rb"while[ \t(]{1,4}" + _STEP + rb"[ \t]{0,4}(?:==[ \t]?-?1|!=[ \t]?0|>[ \t]?0)?[ \t)]{0,4}:")
_FUNCTION = re.compile(rb"def[ \t]+(\w{1,80})[ \t]*\(")
_USE = re.compile(rb"(?<!def )\b\w+")


def why_it_ended(files: Mapping[PurePosixPath, bytes], entry: PurePosixPath) -> str:
    """Return what to do about a program that ended without a fault; empty if its lines do not tell.

    Args:
        files: of its team.
        entry: the file that was started.
    """
    programs = {path: files[path] for path in reached_from(entry, files) if len(files[path]) <= _MOST_BYTES}
    for path, content in programs.items():
        for number, _, code in _lines(content):
            if _ENDS_AT_ZERO.match(code):
                place = "" if path == entry else f" of {shown(path)}"
                return (
                    f"step returns 0 while the match goes on and -1 at its end, so the loop in line {number}{place} "
                    "ends at once: write while robot.step(32) != -1:"
                )
    loops = dict(_functions_that_step(programs.get(entry, b"")))
    called = {name[0] for content in programs.values() for name in _USE.finditer(content)} if loops else set()
    for name, number in loops.items():
        if name not in called:
            told = shown(name)
            return (
                f"the loop with step is in {told}(), line {number}, and nothing calls it: call {told}() at the end of "
                "the program"
            )
    return ""


def _lines(content: bytes) -> Iterator[tuple[int, int, bytes]]:
    """Return number, indentation and code of each line that has any and is not too long to be looked at."""
    for number, line in enumerate(content.splitlines(), start=1):
        code = line.strip()
        if code and not code.startswith(b"#") and len(line) <= _MOST_LINE_BYTES:
            yield number, len(line) - len(line.lstrip()), code


def _functions_that_step(content: bytes) -> Iterator[tuple[bytes, int]]:
    """Return names and lines of the functions and methods in which a loop calls step."""
    name, at, indentation, loops = b"", 0, 0, False
    for number, depth, code in _lines(content):
        if name and depth <= indentation:
            name = b""
        function = _FUNCTION.match(code)
        if function is not None:
            name, at, indentation, loops = function[1], number, depth, False
        loops = loops or code.startswith(b"while")
        if name and loops and b".step(" in code:
            yield name, at
            name = b""
