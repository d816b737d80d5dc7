"""Names of folders and files that are almost the right ones, and names that programs mention."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from functools import cached_property
from pathlib import PurePosixPath

from rcj_challenges.core.likeness import likeness_of

BLANK = b" \t\r\n\f\v\xef\xbb\xbf"
"""What an empty file may consist of."""

_LEAST_LIKENESS = 0.75
_LEAST_LETTERS = 5
_LETTERS_OF_ITS_OWN = 9
"""A name of this length is not part of another one by chance; ``robot`` is part of the names of three robots."""
_IMPORT_OR_TEXT = re.compile(
    rb"""(?<![\w.])(?:from|import)[ \t](?:[^\n#\\(;:"']|\\\r?\n|\([^()]*\))*"""
    rb"""|(?P<text>"[^"\n]{0,200}"|'[^'\n]{0,200}')"""
)
_ONE_WORD = re.compile(rb"\w+")


def like_an_entry(path: PurePosixPath) -> bool:
    """Return whether a file lies in a folder of its own name, as programs do."""
    return len(path.parts) == 2 and path.suffix == ".py" and path.parts[0] == path.stem


def alike(name: str, wanted: str) -> bool:
    """Return whether a name is probably another one, misspelt or with something added; never with another number."""
    one, other = (re.sub(r"[\W_]", "", text.casefold()) for text in (name, wanted))
    if one == other:
        return True
    if len(other) >= _LETTERS_OF_ITS_OWN and not re.search(r"\d", other) and other in one:
        return True  # and what else there is counts the versions
    if re.findall(r"\d+", one) != re.findall(r"\d+", other):
        return False
    if min(len(one), len(other)) >= _LEAST_LETTERS and (one in other or other in one):
        return True
    return likeness_of(one, other) >= _LEAST_LIKENESS


def same_number(name: str, wanted: str) -> bool:
    """Whether both names end with a number, and with the same one: ``player_b1`` and ``robot1``."""
    one, other = (re.search(r"[0-9]+$", text) for text in (name, wanted))
    return one is not None and other is not None and one[0] == other[0]


def of_yellow(name: str) -> bool:
    """Whether a name says that a program is for yellow: ``rcj_soccer_player_y1``, ``team_yellow``."""
    return re.search(r"(?:^|[\W_])(?:y\d?|yellow\d?)$", name.casefold()) is not None


def mentioned(files: Mapping[PurePosixPath, bytes], names: Iterable[str]) -> str:
    """Return the first of some names of files or folders that a program imports, or has in a text.

    A function of that name is none of them: `main.py` begins with ``def main()`` more often than not.
    """
    programs = [_Mentions(content) for path, content in files.items() if path.suffix == ".py"]
    for name in names:
        raw = name.encode("utf-8", "surrogateescape")
        if any(program.has(raw) for program in programs):
            return name
    return ""


class _Mentions:
    """The names that a program mentions. It is read once, however many names are looked for."""

    def __init__(self, content: bytes) -> None:
        self._content = content

    def has(self, name: bytes) -> bool:
        if name not in self._content:
            return False
        if _ONE_WORD.fullmatch(name):
            return name in self._words
        places = self._with_sentences if b" " in name else self._places
        return re.search(rb"(?<!\w)" + re.escape(name) + rb"(?!\w)", places) is not None

    @cached_property
    def _words(self) -> frozenset[bytes]:
        return frozenset(_ONE_WORD.findall(self._places))

    @cached_property
    def _places(self) -> bytes:
        """The parts that name modules, files and folders: a text with blanks and no / is a sentence."""
        found = ((place[0], place["text"]) for place in _IMPORT_OR_TEXT.finditer(self._content))
        return b"\0".join(
            place for place, text in found if text is None or b" " not in text or b"/" in text or b"\\" in text
        )

    @cached_property
    def _with_sentences(self) -> bytes:
        """Those and all texts, in which a name with blanks stands."""
        return b"\0".join(found[0] for found in _IMPORT_OR_TEXT.finditer(self._content))
