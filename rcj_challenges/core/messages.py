"""Messages from robots to the referee by radio: from the bytes of a packet to text, a number or a position."""

from __future__ import annotations

import re
import struct
from collections.abc import Callable
from math import isfinite

MAX_CHARACTERS = 200
"""Of a message; the rest is ignored."""

LARGEST_NUMBER = 1e9
FURTHEST_M = 10.0
"""Larger numbers and positions are refused: results computed with them must stay finite, and nothing may be placed
where no field can be. Up to there everything around a field is solid, so that nothing finds room."""

# Digits match in one way only: otherwise refusing a near-number takes a hundred times as long.
_NUMBER = r"[-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d{1,3})?"
_ONE_NUMBER = re.compile(_NUMBER, re.ASCII)
# Two numbers as people and programs write them: "0.1 -0.2", "0.1, -0.2", "[0.1, -0.2]", "(0.1,-0.2)".
_POSITION = re.compile(rf"[\[(]?\s*({_NUMBER})(?:\s*[,;]\s*|\s+)({_NUMBER})\s*[\])]?", re.ASCII)
_DOUBLE = 8
_MAX_DOUBLES = 8
_DIGITS = 6
"""To the micrometre: `send([x, y])` arrives as "0.31 -0.295637"."""
_BLANKS = str.maketrans("\t\r\n", "   ")


def message_text(data: bytes) -> str:
    """Return the text of a packet, without surrounding blanks and unreadable characters.

    Packets of a few doubles (``send([0.1, -0.2])``) are numbers; a packet that is also valid text is text.
    """
    # A text may end with one zero byte. The bytes of doubles hold more of them as a rule.
    body = data.removesuffix(b"\0")
    text = None if b"\0" in body else _readable(body)
    if not text and len(data) in range(_DOUBLE, _MAX_DOUBLES * _DOUBLE + 1, _DOUBLE):
        numbers = struct.unpack(f"<{len(data) // _DOUBLE}d", data)
        if all(map(isfinite, numbers)):
            return " ".join(repr(round(number, _DIGITS)) for number in numbers)
    if not text:
        text = data.split(b"\0", 1)[0].decode("utf-8", "replace")
        text = "".join(letter if letter.isprintable() else " " for letter in text)
    return text.strip()[:MAX_CHARACTERS].strip()


def _readable(data: bytes) -> str | None:
    """Decode bytes as text; None if they are not text."""
    try:
        text = data.decode()
    except UnicodeDecodeError:
        return None
    text = text.translate(_BLANKS)
    return " ".join(text.split()) if text.isprintable() else None


def number_in(text: str) -> float | None:
    """Parse a message as a number; None if it is not one."""
    number = float(text) if _ONE_NUMBER.fullmatch(text) else None
    return number if number is not None and abs(number) <= LARGEST_NUMBER else None


def position_in(text: str) -> tuple[float, float] | None:
    """Parse a message as a position [x, y] in m; None if it is not one."""
    found = _POSITION.fullmatch(text)
    if found is None:
        return None
    x, y = float(found[1]), float(found[2])
    return (x, y) if max(abs(x), abs(y)) <= FURTHEST_M else None


READS: dict[str | None, Callable[[str], object]] = {
    None: lambda text: text,
    "number": number_in,
    "position": position_in,
}
"""The kinds of messages with their parsers, which return None for other messages."""


def matches_text(text: str, wanted: str | float | bool) -> bool:
    """Return whether a message equals the wanted value: the same text, or the same number.

    True and false (the value of a draw may be one) equal "true", "True" and the like.
    """
    if isinstance(wanted, bool):
        return text.lower() == str(wanted).lower()
    if isinstance(wanted, str):
        return text == wanted or (number_in(wanted) is not None and number_in(text) == number_in(wanted))
    return number_in(text) == wanted
