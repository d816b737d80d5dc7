"""Letters that the encoding of a terminal or a file lacks: on Windows, pipes use the code page of one country."""

from __future__ import annotations

import codecs

READABLE = "rcj.readable"
"""Error handler of text streams: writes letters that the encoding lacks as plain letters or ``?``, never raises."""

_PLAIN = {
    "→": "->",
    "…": "...",
    "·": "-",
    "±": "+-",
    "≥": ">=",
    "≤": "<=",
    "\N{MULTIPLICATION SIGN}": "x",
    "\N{MINUS SIGN}": "-",
    "\N{EN DASH}": "-",
    "“": '"',
    "”": '"',
    "\N{RIGHT SINGLE QUOTATION MARK}": "'",
    "°": " degrees",
    "²": "^2",
    "³": "^3",
    "µ": "u",
    "π": "pi",
}


def _readable(error: UnicodeError) -> tuple[str | bytes, int]:
    if not isinstance(error, UnicodeEncodeError):
        raise error
    return "".join(_PLAIN.get(letter, "?") for letter in error.object[error.start : error.end]), error.end


codecs.register_error(READABLE, _readable)
