"""Files that Python cannot read: why, and what to do about it, in words that a pupil understands."""

from __future__ import annotations

import platform
import re

from rcj_challenges.checker.reading import MAX_IMPORTS, MOST_BYTES, Source
from rcj_challenges.facts.shown import shown

PYTHON = f"Python {platform.python_version()}"

_MOST_LINE_BYTES = 500
_STRANGE = re.compile(r"invalid (?:character '(?P<letter>.)'|non-printable character) ")
_NO_NUMBER = "invalid decimal literal"
"""What Python up to 3.11.3 says of a strange letter behind a number."""
_BEHIND_A_NUMBER = re.compile(r"[0-9_.]+([^\x00-\x7f])")
_TYPED = {
    "\u201c\u201d\u201e\u201f\u00ab\u00bb\u2033\u2018\u2019\u201a\u2032\u00b4": "\" or '",
    "\u2010\u2011\u2012\u2013\u2014\u2212": "-",
    "\u00d7\u00b7\u22c5": "*",
    "\u00f7": "/",
    "\u2264": "<=",
    "\u2265": ">=",
    "\u2260": "!=",
}
"""By letters that a text processor makes: what is typed for them."""
_LEFT_BY_GIT = ("<<<<<<< ", ">>>>>>> ")
_PARENTHESES = "exception types must be parenthesized"
_CALL = re.compile(r"Missing parentheses in call to '(?P<name>print|exec)'")
# A name of its own for what was caught begins with a small letter, an error with a capital one.
_ERROR_WITH_A_NAME = re.compile(r"\s*except\s*(?P<several>\()?[^:#]*,\s*(?P<name>[a-z_]\w*)\s*:")
_SEVERAL_ERRORS = re.compile(r"\s*except\s+(?P<errors>[\w.]+(?:\s*,\s*[\w.]+)+)\s*:")
_RAISED = re.compile(r"\s*raise\s+(?P<error>[A-Za-z_][\w.]*)\s*,")

_SAVE_AS_UTF8 = "save the file as UTF-8 text in your editor"
_SMALLER_STEPS = "write it in several smaller steps"
_TOO_DEEP = (
    "too_deep",
    "brackets or expressions lie so deep in one another that Python cannot read the file",
    _SMALLER_STEPS,
)
# What ended the reading without a word of Python's own.
_WITHOUT_WORDS = {
    "depth": _TOO_DEEP,
    "crash": _TOO_DEEP,
    "slow": ("too_slow", "Python takes far too long to read the file", "split it, or put data into a file of its own"),
    "large": (
        "large",
        f"more than {MOST_BYTES / 1000:g} kB of Python: not looked into",
        "put large data into a file that is no program",
    ),
    "imports": (
        "too_many_imports",
        f"with this file the programs import more than {MAX_IMPORTS} modules and names: it is not looked into",
        "leave out what is not needed",
    ),
    "unread": ("unread", "not looked into: those before it are too much for Python", "leave out what is not needed"),
}


def what_is_wrong(source: Source, content: bytes) -> tuple[str, str, str]:
    """Return code, message and remedy of a file that is no Python.

    Args:
        source: what the reader says of it.
        content: of the file.
    """
    if source.wrong in _WITHOUT_WORDS:
        return _WITHOUT_WORDS[source.wrong]
    said = shown(source.said)
    if source.wrong == "odd_encoding":
        return "odd_encoding", f"the file says that it is written in {said}, which no editor writes", _SAVE_AS_UTF8
    if "null bytes" in said:
        return "null_bytes", "there are zero bytes in the file: it is no text", _SAVE_AS_UTF8
    if any(words in said for words in ("codec can't decode", "encoding", "Non-UTF-8")):
        return "encoding", f"the letters of the file cannot be read ({said})", _SAVE_AS_UTF8
    line = _line(content, source.line)
    deep = any(words in said for words in ("too many nested", "too many statically nested"))
    remedy = _SMALLER_STEPS if deep else _about_a_strange_letter(source, line) or _syntax_remedy(source, line)
    return "too_deep" if deep else "syntax", f"{PYTHON} cannot read this: {said}", remedy


def _line(content: bytes, number: int) -> str:
    """Return the beginning of a line, from 1; nothing if there is none."""
    lines = content.splitlines()  # of bytes: at the same places as Python does
    return lines[number - 1][:_MOST_LINE_BYTES].decode("utf-8", "replace") if 0 < number <= len(lines) else ""


def _syntax_remedy(source: Source, line: str) -> str:
    said = source.said
    if line.startswith(_LEFT_BY_GIT):
        return "git left this line, for it found two versions: keep one of them, and delete the lines <<<, === and >>>"
    instead = _instead_of_python_2(said, line)
    if instead:
        return f"this was written for Python 2: write {instead}"
    if _PARENTHESES in said and (several := _SEVERAL_ERRORS.match(line)):
        return f"write except ({shown(several['errors'], 200)}):"
    if "tabs and spaces" in said or source.wrong == "TabError":
        return "indent with spaces only"
    if source.wrong == "IndentationError":
        return "correct how far this line is indented"
    return f"correct this line or the one before it; {PYTHON} is used here, so newer words of Python do not exist yet"


def _about_a_strange_letter(source: Source, line: str) -> str:
    """Return what to do about a letter that is none of Python's; nothing if it is not such a one that is wrong."""
    strange = _STRANGE.search(shown(source.said))
    if strange:
        return _typed_anew(strange["letter"])
    behind = _BEHIND_A_NUMBER.match(line, max(0, source.column - 1)) if source.said == _NO_NUMBER else None
    if behind is None or f"_{behind[1]}".isidentifier():
        return ""
    return _typed_anew(behind[1] if behind[1].isprintable() else None)


def _typed_anew(letter: str | None) -> str:
    """Return what to do about a letter that is none of Python's.

    Args:
        letter: None if it cannot be seen.
    """
    from_where = "it comes from a web page or a text processor"
    if letter is None:
        return f"delete what cannot be seen in this line, and type its blanks anew: {from_where}"
    instead = next((f", as {typed}" for letters, typed in _TYPED.items() if letter in letters), "")
    return f"type {shown(letter)} anew{instead}: {from_where}"


def _instead_of_python_2(said: str, line: str) -> str:
    """Return what is written today where a line is as only Python 2 could read it; else nothing."""
    call = _CALL.search(said)
    if call is not None:
        return f"{call['name']}(…)"
    if _PARENTHESES in said and (caught := _ERROR_WITH_A_NAME.match(line)):
        errors = "(…)" if caught["several"] else "…"
        return f"except {errors} as {shown(caught['name'], 40)}"
    raised = _RAISED.match(line)
    return f"raise {shown(raised['error'], 80)}(…)" if raised is not None else ""
