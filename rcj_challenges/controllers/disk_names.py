"""File names as Python spells them if the system's encoding of names is not UTF-8.

Under an ASCII or Latin-1 locale Python reads and writes the bytes of a name in that encoding; but most files are named
in UTF-8, and robots' programs always use it. So this package keeps a team's names in Unicode, and their bytes on disk
are UTF-8, wherever a match is played. Where the system's encoding is UTF-8 (Windows and macOS among them), nothing
changes.
"""

from __future__ import annotations

import os
import sys

_UTF_8 = sys.getfilesystemencoding().replace("-", "").casefold() == "utf8"


def on_disk(name: str) -> str:
    """Return what to call a file here, so that its name has the bytes of ``name`` in UTF-8."""
    return name if _UTF_8 else os.fsdecode(name.encode("utf-8", "surrogateescape"))


def from_disk(name: str) -> str:
    """Return a name that Python gave, read as UTF-8; bytes that are none stay lone surrogates."""
    return name if _UTF_8 else os.fsencode(name).decode("utf-8", "surrogateescape")
