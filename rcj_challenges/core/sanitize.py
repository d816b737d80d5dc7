r"""Makes untrusted text safe to show: characters that are invisible or move others are written as escapes.

A name such as ``"\x1b[2J"`` or one with a right-to-left mark is data. On a terminal, in JSON and in HTML it appears as
the same visible characters; HTML adds its own escaping where a page is written.
"""

from __future__ import annotations

import unicodedata

MAX_CHARACTERS = 200
"""File names and messages longer than this are cut: in a list more is useless."""

MAX_BLOCK_LINES = 60
MAX_BLOCK_CHARACTERS = 400

_JOINER = "\u200d"  # holds some emoji together, and moves nothing
_BREAKS = frozenset({"\u2028", "\u2029", "\x85"})
_MAX_MARKS = 4  # combining marks on one character; more of them cover the lines above
_MARKS = frozenset({"Mn", "Me"})


def sanitize(text: object, longest: int = MAX_CHARACTERS) -> str:
    r"""Return text as one harmless line of at most ``longest`` characters.

    Control characters, direction marks, line breaks, lone surrogates, private and unassigned characters become
    escapes that can be read (``\x1b``, ``\u202e``); a tower of accents ends after four.

    Args:
        text: anything; bytes are read as UTF-8.
        longest: what is longer is cut in the middle, where a path says least, and marked with ``…``.
    """
    said = text.decode("utf-8", "backslashreplace") if isinstance(text, bytes) else str(text)
    return _cut(_escaped(_cut(said, 2 * longest + 2)), longest)


def sanitize_block(text: str, most_lines: int = MAX_BLOCK_LINES) -> str:
    """Make text of several lines harmless: a traceback, or the output of a program.

    Of longer texts the first few and the last lines are kept: there a traceback says what went wrong.
    """
    lines = text.expandtabs(4).replace("\r\n", "\n").strip("\n").split("\n")
    if len(lines) > most_lines:
        head = most_lines // 4
        left_out = len(lines) - most_lines
        lines = [*lines[:head], f"… {left_out} lines left out …", *lines[len(lines) - (most_lines - head) :]]
    return "\n".join(sanitize(line, MAX_BLOCK_CHARACTERS) for line in lines)


def sanitize_lines(text: str) -> str:
    """Return a whole text, each line of it harmless: what is printed or drawn of a scenario, or says what is wrong."""
    return "\n".join(map(_escaped, text.split("\n")))


def _escaped(text: str) -> str:
    if text.isascii() and text.isprintable():
        return text
    characters: list[str] = []
    marks = 0
    for character in text:
        category = unicodedata.category(character)
        marks = marks + 1 if category in _MARKS else 0
        if marks > _MAX_MARKS:
            continue
        hidden = (category[0] == "C" and character != _JOINER) or character in _BREAKS
        characters.append(_escape(character) if hidden else character)
    return "".join(characters)


def _escape(character: str) -> str:
    """Return the escape of Python for a character that cannot be seen."""
    code = ord(character)
    if character in "\n\r\t":
        return {"\n": "\\n", "\r": "\\r", "\t": "\\t"}[character]
    return f"\\x{code:02x}" if code < 0x100 else f"\\u{code:04x}" if code < 0x10000 else f"\\U{code:08x}"


def _cut(text: str, longest: int) -> str:
    if len(text) <= longest:
        return text
    head = (longest - 1) // 2
    return text[:head] + "…" + text[len(text) - (longest - 1 - head) :]
