"""File names in a submission: which of them are valid and unambiguous on every computer."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Collection, Iterable, Iterator
from pathlib import PurePosixPath

from rcj_challenges.core.code import Code
from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.core.files import is_device_of_windows
from rcj_challenges.submissions import codes
from rcj_challenges.submissions.problems import safe_text

MAX_PATH_CHARACTERS = 160
"""Windows takes 260 characters for a whole path; the private folder of a program needs up to 100 of them."""
MAX_PART_BYTES = 255
"""Longest name of one file or folder on the file systems of Linux and macOS, in bytes of UTF-8."""

_IGNORED_FOLDERS = frozenset(
    {"__MACOSX", "__pycache__", ".git", ".hg", ".svn", ".idea", ".vscode", ".venv", "venv", ".mypy_cache"}
)
_IGNORED_FILES = frozenset({".DS_Store", "Thumbs.db", "desktop.ini", "Icon\r"})

_DRIVE = re.compile(r"[A-Za-z]:")
_FORBIDDEN = frozenset('<>:"|?*')

_RENAME = "rename it"


def ignored_folder(name: str) -> bool:
    """Return whether a folder of this name is what a tool left behind."""
    return name in _IGNORED_FOLDERS


def ignored(parts: tuple[str, ...]) -> bool:
    """Return whether a file is what a tool left behind: no part of the submission."""
    if not parts:
        return False
    return not _IGNORED_FOLDERS.isdisjoint(parts[:-1]) or parts[-1] in _IGNORED_FILES or parts[-1].endswith(".pyc")


def is_record(folders: Iterable[str], files: Collection[str]) -> bool:
    """Return whether a folder with these in it is the record of a run, from its first moment on.

    Other matches may begin or end while a team is read, so this does not wait for the files that come a little later. A
    folder with a program anywhere in it is not a record, whatever else is there: the caller checks this.
    """
    return "logs" in set(folders) and "trajectory.chunks" in files


def record_folders(files: Iterable[PurePosixPath], empty: Iterable[PurePosixPath]) -> frozenset[PurePosixPath]:
    """Return the folders below the top that are records of runs.

    ``empty`` are the folders that have an entry of their own in the archive: in some of them nothing may be.
    """
    names: dict[PurePosixPath, set[str]] = {}
    folders: dict[PurePosixPath, set[str]] = {}
    others = {PurePosixPath()}
    below = set(empty)
    for path in files:
        names.setdefault(path.parent, set()).add(path.name)
        below.update(path.parents[:1])
        if path.suffix == ".py":
            others.update(path.parents)
    for path in below:
        for folder in (path, *path.parents)[:-1]:
            folders.setdefault(folder.parent, set()).add(folder.name)
    return frozenset(
        folder for folder in (names.keys() | folders.keys()) - others
        if is_record(folders.get(folder, ()), names.get(folder, ()))
    )  # fmt: skip


def path_of(name: str) -> PurePosixPath:
    """Return the path that an archive's name means."""
    return composed(str(spelled_path_of(name)))


def spelled_path_of(name: str) -> PurePosixPath:
    """Return that path character by character as the archive spells it; some Windows tools write backslashes."""
    return PurePosixPath(name.replace("\\", "/"))


def composed(name: str) -> PurePosixPath:
    """Return a path with its characters composed, as programs write and import it; macOS takes them apart (o and ¨)."""
    return PurePosixPath(unicodedata.normalize("NFC", name))


def folded(path: PurePosixPath) -> str:
    """Return a key that is equal for paths that are one file on a computer that ignores case or composes characters."""
    return unicodedata.normalize("NFC", unicodedata.normalize("NFD", str(path)).casefold())


def name_problems(name: str) -> Iterator[Diagnostic]:
    """The problems of a name, as an archive has it."""
    shown = safe_text(name)
    path = path_of(name)
    if path.is_absolute() or ".." in path.parts or not path.parts or _DRIVE.match(name):
        yield Diagnostic(
            codes.ARCHIVE_OUTSIDE,
            f"'{shown}' leads out of the archive",
            "pack the folder itself, without .. and without the way to it",
            shown,
            repair=bool(clean(name)),
        )
        name = _without_drive(name)
    mendable = path.suffix.casefold() != ".py"  # programs import each other by name
    for code, message in _character_problems(path_of(name), shown):
        yield Diagnostic(code, message, _RENAME, shown, repair=mendable)
    if len(str(path)) > MAX_PATH_CHARACTERS or any(len(_encoded(part)) > MAX_PART_BYTES for part in path.parts):
        message = f"'{shown}' has too long a name: at most {MAX_PATH_CHARACTERS} characters with its folders"
        yield Diagnostic(
            codes.ARCHIVE_NAME_LONG, message, "give files and folders shorter names", shown, repair=mendable
        )


def _without_drive(name: str) -> str:
    return name[2:] if _DRIVE.match(name) else name


def _character_problems(path: PurePosixPath, shown: str) -> Iterator[tuple[Code, str]]:
    characters = frozenset(str(path))
    if any(unicodedata.category(character) in ("Cc", "Cf", "Zl", "Zp") for character in characters):
        yield codes.ARCHIVE_NAME_CONTROL, f"'{shown}' has control characters in its name"
    if any("\ud800" <= character <= "\udfff" for character in characters):
        yield codes.ARCHIVE_NAME_ENCODING, f"'{shown}' is not a name in UTF-8"
    if not characters.isdisjoint(_FORBIDDEN):
        found = " ".join(sorted(characters & _FORBIDDEN))
        yield codes.ARCHIVE_NAME_FORBIDDEN, f"'{shown}' has characters that Windows does not allow in a name ({found})"
    for part in path.parts:
        if part == "..":
            continue
        if is_device_of_windows(part):
            yield codes.ARCHIVE_NAME_RESERVED, f"'{shown}' is the name of a device on Windows"
        if part != part.rstrip(". "):
            yield codes.ARCHIVE_NAME_ENDING, f"'{shown}' ends in a dot or a space, which Windows removes"


def clean(name: str) -> PurePosixPath | None:
    """Return the nearest path inside the archive that every computer takes; None if nothing is left of it."""
    parts: list[str] = []
    given = path_of(_without_drive(name)).parts
    for part in given if len(given) < MAX_PATH_CHARACTERS else given[-1:]:
        if part == "..":
            del parts[-1:]
        elif part.strip("/"):
            parts.append(_clean_part(part))
    path = PurePosixPath(*parts) if parts else None
    if path is not None and len(str(path)) > MAX_PATH_CHARACTERS:
        return _shortened(path)
    return path


def _clean_part(part: str) -> str:
    characters = ("_" if _odd(character) else character for character in part)
    cleaned = "".join(characters).rstrip(". ") or "_"
    if is_device_of_windows(cleaned):
        cleaned = f"_{cleaned}"
    suffix = PurePosixPath(cleaned).suffix[:20]
    if len(cleaned) > MAX_PART_BYTES:
        cleaned = cleaned[: MAX_PART_BYTES - len(suffix)].rstrip(". ") + suffix
    while len(cleaned.encode()) > MAX_PART_BYTES:
        cleaned = cleaned.removesuffix(suffix)[:-1].rstrip(". ") + suffix
    return cleaned


def _shortened(path: PurePosixPath) -> PurePosixPath | None:
    for candidate in (path, PurePosixPath(path.name)):
        room = MAX_PATH_CHARACTERS - len(str(candidate.with_name("_"))) + 1 - len(candidate.suffix)
        if room > 0:
            return candidate.with_name(candidate.stem[:room].rstrip(". ") + candidate.suffix)
    return None


def _odd(character: str) -> bool:
    return character in _FORBIDDEN or unicodedata.category(character) in ("Cc", "Cf", "Cs", "Zl", "Zp")


def _encoded(part: str) -> bytes:
    return part.encode("utf-8", "surrogatepass")
