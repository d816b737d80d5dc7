"""Reading a team's files, from a folder, a ZIP or a single program, without trusting any of them."""

from __future__ import annotations

import itertools
import os
import re
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from pathlib import Path, PurePosixPath
from typing import Literal, NoReturn

from rcj_challenges.core.code import Code
from rcj_challenges.core.codes import CANNOT_OPEN
from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.core.errors import RcjError
from rcj_challenges.submissions import codes, zip_reader
from rcj_challenges.submissions.limits import (
    FREE_UNPACKED_BYTES,
    MAX_DEPTH,
    MAX_FILES,
    MAX_FOLDERS,
    MAX_PACKED_BYTES,
    MAX_RATIO,
    MAX_UNPACKED_BYTES,
)
from rcj_challenges.submissions.paths import (
    MAX_PATH_CHARACTERS,
    composed,
    folded,
    ignored,
    ignored_folder,
    is_record,
    name_problems,
    path_of,
    record_folders,
    spelled_path_of,
)
from rcj_challenges.submissions.problems import MAX_PATH_SHOWN, Problems, safe_text
from rcj_challenges.submissions.zip_reader import UnreadableError

_KINDS = (
    (0, b"Rar!\x1a\x07", "a RAR archive"),
    (0, b"7z\xbc\xaf\x27\x1c", "a 7-Zip archive"),
    (0, b"\x1f\x8b", "a gzip archive"),
    (0, b"BZh", "a bzip2 archive"),
    (0, b"\xfd7zXZ", "an xz archive"),
    (0, b"\x28\xb5\x2f\xfd", "a Zstandard archive"),
    (257, b"ustar", "a tar archive"),
    (0, b"MSCF", "a Windows cabinet"),
    (0, b"%PDF", "a PDF document"),
    (0, b"<!DOCTYPE", "a web page"),
    (0, b"<!doctype", "a web page"),
    (0, b"<html", "a web page"),
)
_HEAD_BYTES = 264
_CONTAINERS = (
    (0, b"PK\x03\x04", "a ZIP archive"),
    *(kind for kind in _KINDS if kind[2] in ("a RAR archive", "a 7-Zip archive", "a tar archive")),
)
_TARRED = re.compile(r"\.(tar\.\w+|tgz|tbz2?|txz)$", re.IGNORECASE)
# Files that happen to be ZIPs: weights, tables, documents.
_DATA_ENDINGS = frozenset({".npz", ".pt", ".pth", ".keras", ".docx", ".xlsx", ".pptx", ".odt", ".ods", ".whl", ".jar"})
_SHOWN_NAMES = 4
_DEFLATE_RATIO = 1032
_MAX_WASTED_BYTES = 300_000_000  # unpacked in vain from damaged entries: a second's work


class TeamError(RcjError):
    """A team's folder or archive cannot be used; the message says why, ``help`` what to do."""

    CODE = codes.UNUSABLE_TEAM


Files = dict[PurePosixPath, bytes]
"""A team's files: contents by path, ``/`` between the parts, in order of path."""


@dataclass(frozen=True)
class Contents:
    """What a team handed in, as far as it can be read.

    Attributes:
        kind: what it was read from.
        files: what can be used, without what tools leave behind.
        problems: everything odd about it.
        complete: whether nothing is missing because it could not be read.
        unsafe: files whose names must not be used, by the name they came with.
    """

    kind: Literal["folder", "zip", "program"]
    files: Files
    problems: tuple[Diagnostic, ...] = ()
    complete: bool = True
    unsafe: dict[str, bytes] = field(default_factory=dict)

    @property
    def refused(self) -> list[Diagnostic]:
        """The problems for which it is not used."""
        return [problem for problem in self.problems if problem.level == "error"]


def read_contents(path: Path) -> Contents:
    """Read a folder, a ZIP or a single ``.py`` file, and report everything odd about the files.

    Raises:
        TeamError: there is nothing at this path that can be opened.
    """
    try:
        if path.is_dir():
            return _from_folder(path)
        if not path.exists():
            # There "my team\\" --blue … is read as one name: the backslash makes the quotation mark a letter.
            swallowed = "remove the backslash at its end" if os.sep == "\\" and '"' in str(path) else ""
            message = f"{safe_text(path, MAX_PATH_SHOWN)}: there is no such file or folder"
            raise TeamError(message, swallowed, code=codes.NO_SUCH_TEAM)
        if not path.is_file():
            raise TeamError(f"{safe_text(path, MAX_PATH_SHOWN)}: this is neither a file nor a folder", code=CANNOT_OPEN)
        if path.suffix.casefold() == ".py":
            return _from_program(path)
        return _from_zip(path)
    except UnreadableError as error:
        return _unreadable("folder", error.problem)
    except (OSError, ValueError, RecursionError) as error:  # the last: folders too deep to be searched
        reason = getattr(error, "strerror", None) or error
        where = getattr(error, "filename", None) or path  # a file or folder in it, perhaps
        message = f"{safe_text(Path(where), MAX_PATH_SHOWN)}: cannot be read: {reason}"
        raise TeamError(message, code=CANNOT_OPEN) from error


def refusal(path: Path, reasons: list[Diagnostic]) -> TeamError:
    """Return the error that says why something is not used: the first reason, and how many more there are."""
    more = f" (and {len(reasons) - 1} more)" if len(reasons) > 1 else ""
    first = reasons[0]
    return TeamError(f"{safe_text(path, MAX_PATH_SHOWN)}: {first.message}{more}", first.help, code=first.code)


def _from_program(path: Path) -> Contents:
    if path.stat().st_size > MAX_PACKED_BYTES:
        return _unreadable("program", _too_large(path.stat().st_size))
    # ROBOT.PY, as on old copies and memory sticks, is also a program.
    return Contents("program", {composed(path.with_suffix(".py").name): path.read_bytes()})


def _too_large(size: int) -> Diagnostic:
    message = f"{size / 1e6:.1f} MB is more than the {MAX_PACKED_BYTES // 1_000_000} MB allowed"
    return Diagnostic(codes.ARCHIVE_TOO_LARGE, message, "leave out what the programs do not need")


class _Folders:
    """The folders of a submission, counted as they are met."""

    def __init__(self) -> None:
        self._known: set[PurePosixPath] = set()

    def add(self, folder: PurePosixPath) -> None:
        """Count a folder and those above it; raise `UnreadableError` if it lies too deep, or there are too many."""
        if folder in self._known:
            return
        if len(folder.parts) > MAX_DEPTH:
            message = f"{safe_text(folder)} lies too deep: at most {MAX_DEPTH} folders may lie in one another"
            raise UnreadableError(codes.ARCHIVE_TOO_DEEP, message, _FEWER_FOLDERS)
        self._known.update((folder, *folder.parents))
        if len(self._known) > MAX_FOLDERS:
            message = f"there are more than {MAX_FOLDERS} folders"
            raise UnreadableError(codes.ARCHIVE_TOO_MANY_FOLDERS, message, _FEWER_FOLDERS)


_FEWER_FOLDERS = "leave out what the programs do not need"


def _no_files() -> Diagnostic:
    return Diagnostic(codes.ARCHIVE_EMPTY, "there are no files in it", "is this the folder of the robot programs?")


def _unreadable(kind: Literal["folder", "zip", "program"], *problems: Diagnostic) -> Contents:
    return Contents(kind, {}, problems, complete=False)


def _from_folder(folder: Path) -> Contents:
    files: Files = {}
    problems = Problems()
    total = 0
    inside = folder.resolve()
    for path in _walk(folder):
        relative = composed(path.relative_to(folder).as_posix())
        if ignored(relative.parts):
            continue
        leads_out = _leads_out(path, inside)
        if leads_out or path.is_dir():
            problems.add(_link(relative, leads_out=leads_out, is_folder=path.is_dir()))
            continue
        if not path.is_file():
            continue
        total += path.stat().st_size
        if total > MAX_UNPACKED_BYTES or len(files) >= MAX_FILES:
            message = f"more than {MAX_FILES} files or {MAX_UNPACKED_BYTES // 1_000_000} MB"
            help_ = "is this the folder of the robot programs?"
            return _unreadable("folder", *problems, Diagnostic(codes.ARCHIVE_TOO_MANY, message, help_))
        if relative in files:
            message = f"{safe_text(relative)} is there twice, with characters composed and taken apart; one is left out"
            problems.add(
                Diagnostic(codes.ARCHIVE_COLLISION, message, "delete one", safe_text(relative), level="warning")
            )
        files[relative] = path.read_bytes()
    # Names that only another computer refuses do not matter in a folder.
    for problem in itertools.chain.from_iterable(name_problems(str(path)) for path in files):
        problems.add(replace(problem, level="warning"))
    _report_nested(files, problems)
    if not files and not any(problem.code == "archive.link" for problem in problems):
        problems.add(_no_files())
    return Contents("folder", dict(sorted(files.items())), tuple(problems))


def _leads_out(path: Path, inside: Path) -> bool:
    try:
        path.resolve(strict=True)  # only so does every Python say that links go in a circle
    except FileNotFoundError:
        pass
    except (OSError, RuntimeError):  # links in a circle lead nowhere
        return True
    return not path.resolve().is_relative_to(inside)


def _link(path: PurePosixPath, *, leads_out: bool, is_folder: bool) -> Diagnostic:
    """The problem of a link; one to another folder inside is left out, whatever leads out is refused."""
    shown = safe_text(path)
    if leads_out:
        message = f"{shown} is a link that leads out of the folder"
        help_ = f"copy the {'folder' if is_folder else 'file'} instead"
        return Diagnostic(codes.ARCHIVE_LINK, message, help_, shown)
    message = f"{shown} is a link to a folder: it is left out"
    return Diagnostic(codes.ARCHIVE_LINK_INSIDE, message, "copy the folder, if programs need it there", shown)


def _walk(folder: Path) -> Iterator[Path]:
    """Return all files, and the links to folders: those are not followed, for they may lead in a circle.

    Records of runs are left out: people who run matches in the team's folder have them there.

    Raises:
        OSError: a folder cannot be read.
        UnreadableError: there are too many, or they lie too deep.
    """
    counted = _Folders()

    def refused(error: OSError) -> NoReturn:  # else it would pass for an empty folder
        raise error

    for root, folders, names in os.walk(folder, onerror=refused):
        if is_record(folders, names) and Path(root) != folder and not any(Path(root).rglob("*.py")):
            folders.clear()
            continue
        counted.add(PurePosixPath(Path(root).relative_to(folder).as_posix()))
        folders[:] = sorted(name for name in folders if not ignored_folder(name))
        yield from (Path(root, name) for name in sorted(names))
        yield from (link for name in folders if (link := Path(root, name)).is_symlink())


def _from_zip(path: Path) -> Contents:
    size = path.stat().st_size
    with path.open("rb") as file:
        head = file.read(_HEAD_BYTES)
        data = head + file.read(max(0, MAX_PACKED_BYTES + 1 - len(head)))
    if not data:
        message, help_ = "the file is empty: this is not a ZIP archive", "pack the folder as a ZIP archive"
        return _unreadable("zip", Diagnostic(codes.ARCHIVE_EMPTY, message, help_))
    for at, magic, kind in _KINDS:
        if head[at:].startswith(magic):
            message, help_ = f"this is {kind}, not a ZIP", "pack the folder as a ZIP archive"
            return _unreadable("zip", Diagnostic(codes.ARCHIVE_OTHER_KIND, message, help_))
    if max(size, len(data)) > MAX_PACKED_BYTES:
        return _unreadable("zip", _too_large(max(size, len(data))))
    return _ZipReading(data).contents()


class _ZipReading:
    """Goes through an archive's entries once and notes everything odd."""

    def __init__(self, data: bytes) -> None:
        self._data = data
        self._problems = Problems()
        self._files: Files = {}
        self._unsafe: dict[str, bytes] = {}
        self._complete = True
        self._paths: dict[str, PurePosixPath] = {}
        self._most = min(MAX_UNPACKED_BYTES, max(FREE_UNPACKED_BYTES, MAX_RATIO * len(data)))
        self._left = self._most
        self._wasted = 0

    def contents(self) -> Contents:
        try:
            entries = zip_reader.read_entries(self._data, self._problems)
            self._report_leftovers([entry for entry in entries if ignored(path_of(entry.name).parts)])
            used = [entry for entry in entries if not ignored(path_of(entry.name).parts)]
            self._count_folders(used)
        except UnreadableError as error:
            self._problems.add(error.problem)
            return _unreadable("zip", *self._problems)
        used = self._without_records(used)
        self._report_guessed([entry for entry in used if entry.guessed])
        self._read_all([entry for entry in used if not entry.is_folder])
        self._report_folders([entry for entry in used if entry.is_folder])
        self._refuse_files_in_files()
        _report_nested(self._files, self._problems)
        if not self._files and not self._unsafe and self._complete:
            self._problems.add(_no_files())
        files = dict(sorted(self._files.items()))
        return Contents("zip", files, tuple(self._problems), self._complete, self._unsafe)

    def _count_folders(self, entries: list[zip_reader.Entry]) -> None:
        """Refuse archives with too many folders; entries with too long names are refused one by one."""
        folders = _Folders()
        for entry in entries:
            if len(entry.name) <= MAX_PATH_CHARACTERS:
                path = path_of(entry.name)
                folders.add(path if entry.is_folder else path.parent)

    def _report(self, code: Code, message: str, help_: str = "", where: str = "") -> None:
        self._problems.add(Diagnostic(code, message, help_, where))

    def _read_all(self, entries: list[zip_reader.Entry]) -> None:
        if len(entries) > MAX_FILES:
            self._complete = False
            help_ = "pack the folder of the robot programs only"
            self._report(codes.ARCHIVE_TOO_MANY, f"the archive has more than {MAX_FILES} files", help_)
            return
        if any("\\" in entry.name for entry in entries):
            message = "folders and files are separated by backslashes, which few programs understand"
            help_ = "pack the folder again with another program"
            self._report(codes.ARCHIVE_BACKSLASHES, message, help_)
        for entry in entries:
            try:
                self._read(entry)
            except UnreadableError as error:
                self._complete = False
                self._problems.add(error.problem)
                self._wasted += min(self._left, _DEFLATE_RATIO * entry.packed)
                if self._wasted > _MAX_WASTED_BYTES:
                    return
            except zip_reader.SizeLimitError:
                self._complete = False
                self._report_bomb(safe_text(entry.name))
                return

    def _report_bomb(self, where: str) -> None:
        message = f"unpacked, it is more than {self._most // 1_000_000} MB"
        if self._most < MAX_UNPACKED_BYTES:
            message += f" and more than {MAX_RATIO} times its size"
        self._report(codes.ARCHIVE_BOMB, message, "leave out what the programs do not need", where)

    def _read(self, entry: zip_reader.Entry) -> None:
        shown = safe_text(entry.name)
        if entry.encrypted:
            self._complete = False
            self._report(codes.ARCHIVE_ENCRYPTED, f"'{shown}' is encrypted", "pack the ZIP without a password", shown)
            return
        if entry.special:
            self._report(codes.ARCHIVE_LINK, f"'{shown}' is a link or a device", "pack the file itself", shown)
            return
        if entry.unknown_method:
            self._complete = False
            message = f"'{shown}' is packed in a way that not every program can unpack ({entry.unknown_method})"
            self._report(codes.ARCHIVE_METHOD, message, "pack the folder again, as an ordinary ZIP archive", shown)
            return
        content, lie = zip_reader.unpack(self._data, entry, self._left)
        self._left -= len(content)
        if lie:
            self._report(codes.ARCHIVE_HEADERS, lie, "pack the folder again", shown)
        self._take(entry.name, content)

    def _take(self, name: str, content: bytes) -> None:
        bad = list(name_problems(name))
        for problem in bad:
            self._problems.add(problem)
        path, spelled = path_of(name), spelled_path_of(name)
        if bad:
            self._unsafe[name] = content
        elif path in self._files and self._paths[folded(path)] == spelled:
            same = self._files[path] == content
            message = f"'{safe_text(path)}' is in the archive twice" + ("" if same else ", with different contents")
            duplicate = Diagnostic(codes.ARCHIVE_DUPLICATE, message, "keep one of them", safe_text(path), repair=same)
            self._problems.add(duplicate)
        elif self._fits(spelled):
            self._files[path] = content

    def _fits(self, path: PurePosixPath) -> bool:
        """Whether no other file or folder so far is the same place on some computer."""
        for place in (path, *list(path.parents)[:-1]):
            other = self._paths.setdefault(folded(place), place)
            if other != place:
                message = f"{safe_text(place)} and {safe_text(other)} are one file on some computers"
                self._report(codes.ARCHIVE_COLLISION, message, "rename one", safe_text(place))
                return False
        return True

    def _refuse_files_in_files(self) -> None:
        for path in [path for path in self._files if not self._files.keys().isdisjoint(path.parents)]:
            del self._files[path]
            message = f"{safe_text(path)} lies in a folder that is a file as well"
            self._report(codes.ARCHIVE_COLLISION, message, "rename one", safe_text(path))

    def _report_leftovers(self, entries: list[zip_reader.Entry]) -> None:
        if not entries:
            return
        message = f"other programs left behind what is not used: {_some(entries)}"
        self._report(codes.ARCHIVE_LEFTOVERS, message, "delete them before packing")

    def _without_records(self, entries: list[zip_reader.Entry]) -> list[zip_reader.Entry]:
        """Leave out records of runs, and report them: they get packed with a team's working folder."""
        short = [entry for entry in entries if len(entry.name) <= MAX_PATH_CHARACTERS]  # others are refused as they are
        files, folders = ([path_of(entry.name) for entry in short if entry.is_folder is kind] for kind in (False, True))
        records = record_folders(files, folders)
        for record in sorted(records):
            message = f"{safe_text(record)} is the record of a run: it is not used"
            self._report(codes.ARCHIVE_LEFTOVERS, message, "delete it before packing", safe_text(record))
        of_records = {
            entry.name for entry in short if not records.isdisjoint([path_of(entry.name), *path_of(entry.name).parents])
        }
        return [entry for entry in entries if entry.name not in of_records]

    def _report_guessed(self, entries: list[zip_reader.Entry]) -> None:
        if not entries:
            return
        message = f"the archive does not say how its names are encoded; they may be read wrongly: {_some(entries)}"
        help_ = "use plain letters (a to z) in names of files and folders, also where programs import or open them"
        self._report(codes.ARCHIVE_NAME_GUESSED, message, help_)

    def _report_folders(self, entries: list[zip_reader.Entry]) -> None:
        for entry in entries:
            for problem in name_problems(entry.name) if path_of(entry.name).parts else ():  # "./" is harmless
                if problem.code == "archive.outside":
                    # A folder without its files is not missed.
                    self._problems.add(replace(problem, code=codes.ARCHIVE_OUTSIDE_FOLDER, repair=True))
            if entry.special:
                self._report(
                    codes.ARCHIVE_LINK, f"'{safe_text(entry.name)}' is a link or a device", "pack the folder itself"
                )
        have = {path_of(entry.name) for entry in entries}
        needed = {parent for path in self._files for parent in list(path.parents)[:-1]}
        if needed - have:
            message = "the archive has no entries of their own for its folders, which does no harm"
            self._report(codes.ARCHIVE_NO_FOLDERS, message)


def _some(entries: list[zip_reader.Entry]) -> str:
    names = list(dict.fromkeys(safe_text(entry.name) for entry in entries))
    return ", ".join(names[:_SHOWN_NAMES]) + (", …" if len(names) > _SHOWN_NAMES else "")


def _report_nested(files: Files, problems: Problems) -> None:
    for path, content in files.items():
        kinds = (kind for at, magic, kind in _CONTAINERS if content[at : at + len(magic)] == magic)
        kind = next(kinds, "a tar archive" if _TARRED.search(path.name) else "")
        if kind and path.suffix.casefold() not in _DATA_ENDINGS:
            shown = safe_text(path)
            message = f"{shown} is {kind} inside the submission, which is not unpacked"
            help_ = "pack what is in it instead, if the programs need it"
            problems.add(Diagnostic(codes.ARCHIVE_NESTED, message, help_, shown))
