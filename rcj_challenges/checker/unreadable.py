"""Explains why Python cannot read a file, and what to do about it."""

from __future__ import annotations

import platform
import re

from rcj_challenges.checker import codes
from rcj_challenges.checker.reading import MAX_BYTES, MAX_IMPORTS, Source
from rcj_challenges.core.code import Code
from rcj_challenges.core.sanitize import sanitize

PYTHON = f"Python {platform.python_version()}"

_SMALLER_STEPS = "write it in several smaller steps"
_SAVE_AS_UTF8 = "save the file as UTF-8 text in your editor"
_LEAVE_OUT = "leave out what is not needed"
_LEFT_BY_GIT = (b"<<<<<<< ", b">>>>>>> ")
_SYNTAX_HELP = (
    (r"Missing parentheses in call to '(?:print|exec)'", "this is Python 2: a call needs brackets, print(…)"),
    (r"tabs and spaces|^TabError", "indent with spaces only"),
    (r"^IndentationError", "correct how far this line is indented"),
    (r"too many (?:statically )?nested", _SMALLER_STEPS),
    (
        r"invalid (?:character|non-printable character)",
        "delete this character (it may be invisible) and type it on the keyboard: web pages use other ones",
    ),
)
"""Help by Python's message."""

_TOO_DEEP = (
    codes.SOURCES_TOO_DEEP,
    "brackets or expressions lie so deep in one another that Python cannot read the file",
    _SMALLER_STEPS,
)
_WITHOUT_MESSAGE = {
    "depth": _TOO_DEEP,
    "crash": _TOO_DEEP,
    "slow": (
        codes.SOURCES_TOO_SLOW,
        "Python takes far too long to read the file",
        "split it, or put data into a file of its own",
    ),
    "large": (
        codes.SOURCES_LARGE,
        f"more than {MAX_BYTES / 1000:g} kB of Python: not looked into",
        "put large data into a file that is not a program",
    ),
    "imports": (
        codes.SOURCES_TOO_MANY_IMPORTS,
        f"with this file the programs import more than {MAX_IMPORTS} modules and names: it is not looked into",
        _LEAVE_OUT,
    ),
    "unread": (codes.SOURCES_UNREAD, "not looked into: those before it are too much for Python", _LEAVE_OUT),
}
"""Code, message and help where reading ended without a message from Python."""


def describe_error(source: Source, content: bytes) -> tuple[Code, str, str]:
    """Return code, message and help of a file that is not valid Python."""
    if source.wrong in _WITHOUT_MESSAGE:
        return _WITHOUT_MESSAGE[source.wrong]
    message = sanitize(source.message)
    if source.wrong == "odd_encoding":
        return (
            codes.SOURCES_ODD_ENCODING,
            f"the file declares the encoding {message}, which no editor writes",
            _SAVE_AS_UTF8,
        )
    if "null bytes" in message:
        return codes.SOURCES_NULL_BYTES, "there are zero bytes in the file: it is not text", _SAVE_AS_UTF8
    if any(words in message for words in ("codec can't decode", "encoding", "Non-UTF-8")):
        return codes.SOURCES_ENCODING, f"the characters of the file cannot be read ({message})", _SAVE_AS_UTF8
    lines = content.splitlines()
    if 0 < source.line <= len(lines) and lines[source.line - 1].startswith(_LEFT_BY_GIT):
        help_ = "git found two versions here: keep one of them, and delete the lines <<<, === and >>>"
    else:
        error = f"{source.wrong}: {message}"
        other = f"correct this line or the one before it; {PYTHON} is used here, so newer syntax does not exist yet"
        help_ = next((text for pattern, text in _SYNTAX_HELP if re.search(pattern, error)), other)
    code = codes.SOURCES_TOO_DEEP if help_ == _SMALLER_STEPS else codes.SOURCES_SYNTAX
    return code, f"{PYTHON} cannot read this: {message}", help_
