"""Names of folders and files that are almost the right ones, and names that programs mention."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from functools import lru_cache
from pathlib import PurePosixPath

from rcj_challenges.core.similarity import similarity

BLANK = b" \t\r\n\f\v\xef\xbb\xbf"
"""What an empty file may consist of."""

_MIN_SIMILARITY = 0.75
_LEAST_CHARACTERS = 5
_MANY_CHARACTERS = 9
"""A name of this length is not part of another one by chance; ``robot`` is part of the names of three robots."""
_MAX_IMPORT_BYTES = 16_384
"""Imports stand at the top of a file."""
_IMPORT = re.compile(rb"^[ \t]*(?:from|import)[ \t]+([^\r\n#]{1,500})", re.MULTILINE)
_WORD = re.compile(rb"[\w\x80-\xff]+")
_IMPORT_OR_TEXT = re.compile(
    rb"""(?<![\w.])(?:from|import)[ \t](?:[^\n#\\(;:"']|\\\r?\n|\([^()]*\))*"""
    rb"""|(?P<text>"[^"\n]{0,200}"|'[^'\n]{0,200}')"""
)


def like_an_entry(path: PurePosixPath) -> bool:
    """Return whether a file lies in a folder of its own name, as programs do."""
    return len(path.parts) == 2 and path.suffix == ".py" and path.parts[0] == path.stem


def alike(name: str, wanted: str) -> bool:
    """Return whether a name is probably another one, misspelt or with something added; never with another number."""
    one, other = (re.sub(r"[\W_]", "", text.casefold()) for text in (name, wanted))
    if one == other:
        return True
    if len(other) >= _MANY_CHARACTERS and not re.search(r"\d", other) and other in one:
        return True  # and what else there is counts the versions
    if re.findall(r"\d+", one) != re.findall(r"\d+", other):
        return False
    if min(len(one), len(other)) >= _LEAST_CHARACTERS and (one in other or other in one):
        return True
    return similarity(one, other) >= _MIN_SIMILARITY


def same_number(name: str, wanted: str) -> bool:
    """Return whether both names end with the same number: ``player_b1`` and ``robot1``."""
    one, other = (re.search(r"[0-9]+$", text) for text in (name, wanted))
    return one is not None and other is not None and one[0] == other[0]


def of_yellow(name: str) -> bool:
    """Return whether a name says that a program is for yellow: ``rcj_soccer_player_y1``, ``team_yellow``."""
    return re.search(r"(?:^|[\W_])(?:y\d?|yellow\d?)$", name.casefold()) is not None


@lru_cache(256)
def imported_words(content: bytes) -> frozenset[bytes]:
    """Return all words of the lines of a program that import something."""
    return frozenset(word for line in _IMPORT.findall(content, 0, _MAX_IMPORT_BYTES) for word in _WORD.findall(line))


def mentioned(files: Mapping[PurePosixPath, bytes], names: Iterable[str]) -> str:
    """Return the first of some names of files or folders that a program imports, or has in a text.

    A function of that name does not count: `main.py` begins with ``def main()`` more often than not.
    """
    programs = [content for path, content in files.items() if path.suffix == ".py"]
    return next((name for name in names if any(_mentions(content, name) for content in programs)), "")


def _mentions(content: bytes, name: str) -> bool:
    raw = name.encode("utf-8", "surrogateescape")
    word = re.compile(rb"(?<!\w)" + re.escape(raw) + rb"(?!\w)")
    places = _IMPORT_OR_TEXT.finditer(content) if raw in content else ()
    return any(word.search(place[0]) for place in places if b" " in raw or not _is_sentence(place["text"] or b""))


def _is_sentence(text: bytes) -> bool:
    return b" " in text and b"/" not in text and b"\\" not in text
