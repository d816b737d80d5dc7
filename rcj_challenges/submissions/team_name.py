"""Finds the team's name and makes it one line that can be shown anywhere."""

from __future__ import annotations

import codecs
import unicodedata
from dataclasses import dataclass, replace
from pathlib import PurePosixPath

from rcj_challenges.core.code import Code
from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.core.similarity import similarity
from rcj_challenges.submissions import codes
from rcj_challenges.submissions.archive import Files
from rcj_challenges.submissions.problems import safe_text

MAX_NAME_CHARACTERS = 32
"""A team's name has at most 32 characters (reference, section 7)."""
NAME_FILE = "team_name.txt"

_MAX_NAME_FILE_BYTES = 65_536
_NEAR_STEMS = frozenset({"teamname", "teamsname", "teamnames", "teamnametxt", "team", "name"})
_NEAR_ENDINGS = frozenset({"", ".txt", ".text", ".md"})
_DOCUMENT_ENDINGS = frozenset({".rtf", ".doc", ".docx", ".odt", ".pdf", ".pages"})
_MIN_SIMILARITY = 0.85
_JOINER = "\u200d"  # holds some emoji together
# Letters that show nothing: fillers of Hangul and the empty Braille pattern.
_BLANKS = dict.fromkeys((0x115F, 0x1160, 0x2800, 0x3164, 0xFFA0), " ")
_QUOTES = "\"'`\u201c\u201d\u2018\u2019\u00ab\u00bb\u201e"


@dataclass(frozen=True)
class TeamName:
    """A team's name.

    Attributes:
        text: safe to show: one line of at most 32 printable characters.
        path: the file it was read from; None if there is none.
        given: whether it comes from that file, not from the archive's own name.
        problems: what is odd about it.
    """

    text: str
    path: PurePosixPath | None
    given: bool
    problems: tuple[Diagnostic, ...]


def find_team_name(files: Files, fallback: str) -> TeamName:
    """Return the name that a team gave itself, or else ``fallback``, the name of its folder or archive."""
    instead = safe_name(fallback) or "team"
    path, problems = _name_file(files)
    if path is None:
        return TeamName(instead, None, given=False, problems=problems)
    text, more = _decoded(files[path])
    lines = [line.strip() for line in unicodedata.normalize("NFC", text).splitlines() if line.strip()]
    name = safe_name(lines[0]) if lines else ""
    if not name:
        message = f"{NAME_FILE} is empty: the name is taken from the file's ({instead})"
        more = (*more, _problem(codes.IDENTITY_NAME_EMPTY, message, "write the team's name into it"))
        return TeamName(instead, path, given=False, problems=(*problems, *more))
    about = _line_problems(lines, name)
    if any(problem.code == "identity.name_encoding" for problem in more):
        about = [replace(problem, repair=False) for problem in about]  # only the team knows what it says
    return TeamName(name, path, given=True, problems=(*problems, *more, *about))


def safe_name(text: str) -> str:
    """Return text as a name: printable characters of one line, no direction marks, at most 32 of them.

    Letters with accents are composed (ö, not o and ¨), so that they count as one.
    """
    printable = "".join(
        character if character == _JOINER or unicodedata.category(character)[0] != "C" else " "
        for character in unicodedata.normalize("NFC", text).translate(_BLANKS)
    )
    name = " ".join(printable.split())[:MAX_NAME_CHARACTERS].rstrip()
    return name if any(character != _JOINER and unicodedata.category(character)[0] != "M" for character in name) else ""


def _problem(code: Code, message: str, help_: str = "") -> Diagnostic:
    return Diagnostic(code, message, help_, NAME_FILE)


def _name_file(files: Files) -> tuple[PurePosixPath | None, tuple[Diagnostic, ...]]:
    """Find the file with the name, or one that was probably intended for it."""
    exact = [path for path in files if path.name.casefold() == NAME_FILE]
    near = [path for path in files if len(path.parts) == 1 and may_be_name_file(path)]
    for path in sorted(exact, key=lambda path: (len(path.parts), path.name != NAME_FILE)) + sorted(near):
        if path == PurePosixPath(NAME_FILE):
            return path, ()
        shown = safe_text(path)
        if path.name == NAME_FILE:
            message, help_ = f"{NAME_FILE} is in a folder: {shown}", "put it beside the folders of the programs"
        else:
            message, help_ = f"the file with the team's name is called {shown}", f"call it {NAME_FILE}"
        return path, (Diagnostic(codes.IDENTITY_NAME_FILE, message, help_, shown),)
    document = next((path for path in files if path.suffix.casefold() in _DOCUMENT_ENDINGS and _near_stem(path)), None)
    if document is not None:
        message = f"{safe_text(document)} is not plain text: the name is taken from the file's"
        return None, (_problem(codes.IDENTITY_NAME_DOCUMENT, message, f"save the name as plain text in {NAME_FILE}"),)
    message = f"there is no {NAME_FILE}: the name is taken from the file's"
    return None, (_problem(codes.IDENTITY_NAME_MISSING, message, "add it, with the team's name in one line"),)


def may_be_name_file(path: PurePosixPath) -> bool:
    """Whether a file holds the team's name, or was probably intended to."""
    return path.suffix.casefold() in _NEAR_ENDINGS and _near_stem(path)


def _near_stem(path: PurePosixPath) -> bool:
    stem = "".join(character for character in path.stem.casefold() if character.isalnum())
    return stem in _NEAR_STEMS or similarity(stem, "teamname") >= _MIN_SIMILARITY


def _decoded(content: bytes) -> tuple[str, tuple[Diagnostic, ...]]:
    """Return the text of the file, and what is odd about how it is written.

    UTF-8, with or without a mark, and UTF-16 with one are recognized. Any other encoding is guessed.
    """
    content = content[:_MAX_NAME_FILE_BYTES]
    marked = content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE))
    encoding = "utf-16" if marked else "utf-8-sig"
    # What was cut off here, or ends in the middle of a character of UTF-16, is not held against it.
    cut = len(content) == _MAX_NAME_FILE_BYTES or marked
    text = codecs.getincrementaldecoder(encoding)("replace").decode(content, final=not cut)
    problems = []
    if marked:
        message = f"{NAME_FILE} is in UTF-16; the name was read all the same"
        problems.append(_problem(codes.IDENTITY_NAME_UTF16, message))
    elif "\ufffd" in text and "\ufffd".encode() not in content:
        # Letters beyond ASCII that are whole are those of a text in UTF-8, of which a part is damaged.
        if any(character > "\x7f" for character in text.replace("\ufffd", "")):
            message = f"{NAME_FILE} is not in UTF-8: characters that cannot be read are shown as \ufffd"
            problems.append(_problem(codes.IDENTITY_NAME_ENCODING, message, "save it in UTF-8"))
        else:
            text = content.decode("cp1252", "replace")
            message = f"{NAME_FILE} is not in UTF-8: it was read as Windows-1252, the letters of Western Europe"
            help_ = 'open it in an editor and save it in UTF-8 (in Windows\' Notepad: "Save as", Encoding "UTF-8")'
            problems.append(_problem(codes.IDENTITY_NAME_ENCODING, f"{message}, which may be wrong", help_))
    elif content.startswith(codecs.BOM_UTF8):
        message = f"{NAME_FILE} begins with a byte order mark, which is not part of the name"
        problems.append(_problem(codes.IDENTITY_NAME_BOM, message))
    if "\r" in text:
        message = f"{NAME_FILE} has the line ends of Windows, which are not part of the name"
        problems.append(_problem(codes.IDENTITY_NAME_LINE_ENDS, message))
    return text, tuple(problems)


def _line_problems(lines: list[str], name: str) -> list[Diagnostic]:
    line = " ".join(lines[0].split())
    found = []
    if len(lines) > 1:
        message = f"{NAME_FILE} has several lines: the first is the name ({name})"
        found.append(_problem(codes.IDENTITY_NAME_LINES, message, "leave one line"))
    if len(line) > MAX_NAME_CHARACTERS:
        message = f"the name is longer than {MAX_NAME_CHARACTERS} characters and is shown as '{name}'"
        found.append(_problem(codes.IDENTITY_NAME_LONG, message, "choose a shorter one"))
    if safe_name(line[:MAX_NAME_CHARACTERS]) != line[:MAX_NAME_CHARACTERS].rstrip():
        message = f"the name in {NAME_FILE} has characters that cannot be seen; it is shown as '{name}'"
        found.append(
            _problem(
                codes.IDENTITY_NAME_UNSAFE, message, f"write it with at most {MAX_NAME_CHARACTERS} printable characters"
            )
        )
    if name[0] in _QUOTES or name[-1] in _QUOTES:
        found.append(_problem(codes.IDENTITY_NAME_QUOTES, f"the quotation marks are part of the name: {name}"))
    elif any(character in "./\\<>&!;:|" for character in name):
        found.append(
            _problem(codes.IDENTITY_NAME_SIGNS, f"the name is shown as it is, and no file is named after it: {name}")
        )
    return found
