"""Names of folders and files that were meant to be another one, and names that programs mention."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from difflib import SequenceMatcher
from pathlib import PurePosixPath

BLANK = b" \t\r\n\f\v\xef\xbb\xbf"
"""What an empty file may consist of."""

_LEAST_LIKENESS = 0.75
_LEAST_LETTERS = 5
_LETTERS_OF_ITS_OWN = 9
"""So long a name that is asked for is in no other one by chance; ``robot`` is in that of each of three robots."""
_IMPORT_OR_TEXT = re.compile(
    rb"""(?<![\w.])(?:from|import)[ \t](?:[^\n#\\(;:"']|\\\r?\n|\([^()]*\))*"""
    rb"""|(?P<text>"[^"\n]{0,200}"|'[^'\n]{0,200}')"""
)


def like_an_entry(path: PurePosixPath) -> bool:
    """Return whether a file lies in a folder of its own name, as programs do."""
    return len(path.parts) == 2 and path.suffix == ".py" and path.parts[0] == path.stem


def alike(name: str, wanted: str) -> bool:
    """Whether a name was meant to be another one: spelled otherwise, or with something added; never another number."""
    one, other = (re.sub(r"[\W_]", "", text.casefold()) for text in (name, wanted))
    if one == other:
        return True
    if len(other) >= _LETTERS_OF_ITS_OWN and not re.search(r"\d", other) and other in one:
        return True  # and what else there is counts the versions
    if re.findall(r"\d+", one) != re.findall(r"\d+", other):
        return False
    if min(len(one), len(other)) >= _LEAST_LETTERS and (one in other or other in one):
        return True
    return SequenceMatcher(None, one, other).ratio() >= _LEAST_LIKENESS


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
    for name in names:
        raw = name.encode("utf-8", "surrogateescape")
        word = re.compile(rb"(?<!\w)" + re.escape(raw) + rb"(?!\w)")
        programs = (content for path, content in files.items() if path.suffix == ".py" and raw in content)
        places = (place for content in programs for place in _named_places(content, has_blanks=b" " in raw))
        if any(map(word.search, places)):
            return name
    return ""


def _named_places(content: bytes, *, has_blanks: bool) -> Iterator[bytes]:
    """Return the parts of a program that name modules, files and folders.

    A text with blanks and no / is a sentence, unless the name that is looked for has blanks itself.
    """
    for found in _IMPORT_OR_TEXT.finditer(content):
        text = found["text"]
        if text is None or has_blanks or b" " not in text or b"/" in text or b"\\" in text:
            yield found[0]
