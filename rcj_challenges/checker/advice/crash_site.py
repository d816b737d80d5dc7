"""Finds the line of a team's program at which it crashed, and reads the lines around it."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from itertools import islice
from pathlib import PurePosixPath

OF_NONE = re.compile(r"AttributeError: 'NoneType' object has no attribute '(?P<attribute>\w{1,100})'")

_PLACE = re.compile(r" \((?P<file>[^()]{1,300}), line (?P<line>[0-9]{1,7})\)$")
_MAX_CODE_BYTES = 500
_MAX_VALUE_LETTERS = 300  # in a line full of "=" each could be tried as often as there are letters
_MAX_SETTINGS = 1000


def programs(files: Mapping[PurePosixPath, bytes]) -> Iterator[bytes]:
    """Yield the Python files of a team."""
    return (content for path, content in files.items() if path.suffix == ".py")


def code_at(files: Mapping[PurePosixPath, bytes], file: str, line: int) -> str:
    """Return the beginning of a line, counted from 1; empty if there is none."""
    lines = files.get(PurePosixPath(file.replace("\\", "/")), b"").splitlines()
    return lines[line - 1][:_MAX_CODE_BYTES].decode("utf-8", "replace").strip() if 0 < line <= len(lines) else ""


def crash_code(detail: str, files: Mapping[PurePosixPath, bytes]) -> str:
    """Return the line that the last line of a traceback names; empty if it is not one of the team's."""
    found = _PLACE.search(detail)
    return code_at(files, found["file"], int(found["line"])) if found is not None else ""


def origins_of_none(detail: str, files: Mapping[PurePosixPath, bytes]) -> str:
    """Return the line of a crash over None, and all lines that set the name that was None there."""
    code, found = crash_code(detail, files), OF_NONE.search(detail)
    held = re.search(rf"\b(\w{{1,100}})\.{found['attribute']}\b", code) if found is not None else None
    if held is None:
        return code
    setting = re.compile(rb"\b%b[ \t]{0,4}=(?!=)[^\r\n]{0,%d}" % (held[1].encode(), _MAX_VALUE_LETTERS))
    found_lines = (
        one[0].decode("utf-8", "replace") for content in programs(files) for one in setting.finditer(content)
    )
    return "\n".join([code, *islice(found_lines, _MAX_SETTINGS)])


def unquote(text: str) -> str:
    r"""Return a file name without the quotation marks and backslashes that Python adds.

    A program may have written all of it, so it is never evaluated: ``\t`` stays a backslash and a t.
    """
    return re.sub(r"""\\([\\'"])""", r"\1", text[1:-1])
