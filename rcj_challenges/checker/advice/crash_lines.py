"""Where a program crashed, by the last line of its report: the file and the line, and how Python quotes in it."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import islice
from pathlib import PurePosixPath

PLACE = re.compile(r" \((?P<file>[^()]{1,300}), line (?P<line>[0-9]{1,7})\)$")
"""The place at the end of the last line that a program told of its end."""
OF_NONE = re.compile(r"AttributeError: 'NoneType' object has no attribute '(?P<attribute>\w{1,100})'")
"""What Python says of a program that asks None for something."""

_MOST_LINE = 500  # letters
_MOST_SET = 300  # letters behind "=": of a line full of them each would be looked at as often as there are letters
_MOST_SETTINGS = 1000


@dataclass(frozen=True)
class CrashLine:
    """A line of a team's program.

    Attributes:
        file: in which it is.
        number: of the line, from 1.
        code: its beginning.
    """

    file: PurePosixPath
    number: int
    code: str


def crash_line(detail: str, files: Mapping[PurePosixPath, bytes]) -> CrashLine | None:
    """Return the line that a crash names; None if it names none of the team's.

    Args:
        detail: the last line of what the program told of its end, and its place.
        files: of the team.
    """
    found = PLACE.search(detail)
    file = PurePosixPath(found["file"].replace("\\", "/")) if found is not None else None
    content = files.get(file) if file is not None else None
    if found is None or file is None or content is None:
        return None
    lines = content.splitlines()  # of bytes: at the same places as Python does
    number = int(found["line"])
    return CrashLine(file, number, text_of(lines[number - 1][:_MOST_LINE])) if 0 < number <= len(lines) else None


def used_none(detail: str, files: Mapping[PurePosixPath, bytes]) -> tuple[str, str]:
    """Return the line of a crash over None, and the name there of what was None; empty if that is not known.

    Args:
        detail: the last line of what the program told of its end, and its place.
        files: of the team.
    """
    found, line = OF_NONE.search(detail), crash_line(detail, files)
    if found is None or line is None:
        return "", ""
    held = re.search(rf"\b(\w{{1,100}})\.{found['attribute']}\b", line.code)
    return line.code, held[1] if held is not None else ""


def set_in(name: str, files: Mapping[PurePosixPath, bytes]) -> list[str]:
    """Return the lines of a team's programs that set a name, from that name on; none if there is no name."""
    setting = re.compile(rb"\b%b[ \t]{0,4}=(?!=)[^\r\n]{0,%d}" % (name.encode(), _MOST_SET))
    programs = [content for path, content in files.items() if name and path.suffix == ".py"]
    found = (one[0] for content in programs for one in setting.finditer(content))
    return [text_of(line) for line in islice(found, _MOST_SETTINGS)]


def unquoted(text: str) -> str:
    """Return the name of a file without the quotation marks and backslashes that Python adds.

    A program may have written all of it: so whatever it is, it is taken as it stands, and not as a text of Python's. A
    tab in it stays a backslash and a t: it has come of these two, which part folders on Windows.
    """
    return re.sub(r"""\\([\\'"])""", r"\1", text[1:-1])


def text_of(content: bytes) -> str:
    """Return a program as text, with the line ends of Unix."""
    return content.decode("utf-8", "replace").replace("\r\n", "\n").replace("\r", "\n")
