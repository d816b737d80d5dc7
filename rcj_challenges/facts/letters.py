"""Letters that a terminal or a file does not have: on Windows, what is piped has those of one country's code page."""

from __future__ import annotations

import codecs

READABLE = "rcj.readable"
"""For ``errors=`` of a text stream: what its encoding lacks is written in plain letters or as ``?``, never an error."""

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
