"""Reading a team's files, from a folder or a ZIP, without trusting either."""

from __future__ import annotations

import lzma
import os
import stat
import struct
import zipfile
import zlib
from collections.abc import Iterator
from pathlib import Path, PurePosixPath

from rcj_challenges.facts.errors import RcjError

MOST_PACKED_BYTES = 10_000_000
"""A submission is at most 10 MB (reference, section 7)."""
MOST_UNPACKED_BYTES = 100_000_000
MOST_FILES = 5_000

_IGNORED_FOLDERS = frozenset(
    {"__MACOSX", "__pycache__", ".git", ".hg", ".svn", ".idea", ".vscode", ".venv", "venv", ".mypy_cache"}
)
_IGNORED_FILES = frozenset({".DS_Store", "Thumbs.db", "desktop.ini", "Icon\r"})
_CHUNK = 1 << 16
_OTHER_KINDS = (
    (b"Rar!", "a RAR archive"),
    (b"7z\xbc\xaf\x27\x1c", "a 7-Zip archive"),
    (b"\x1f\x8b", "a gzip archive"),
    (b"BZh", "a bzip2 archive"),
    (b"\xfd7zXZ", "an xz archive"),
)


class TeamError(RcjError):
    """A team's folder or archive cannot be used; the message says why and what to do."""


Files = dict[PurePosixPath, bytes]
"""A team's files: contents by path, ``/`` between the parts, in order of path."""


def read_files(path: Path) -> Files:
    """Return the files of a folder, of a ZIP or, for a single ``.py``, that one file.

    What tools leave behind (``__pycache__``, ``.DS_Store`` …) is left out.

    Raises:
        TeamError: it cannot be read, is too large, is no ZIP, or holds what a submission must not.
    """
    try:
        if path.is_dir():
            files = _from_folder(path)
        elif path.suffix == ".py" and path.is_file():
            files = {PurePosixPath(path.name): path.read_bytes()}
        elif path.exists():
            files = _from_zip(path)
        else:
            raise TeamError(f"{path}: there is no such file or folder")
    except OSError as error:
        raise TeamError(f"{path}: cannot be read: {error.strerror or error}") from error
    return dict(sorted(files.items()))


def _ignored(parts: tuple[str, ...]) -> bool:
    return not _IGNORED_FOLDERS.isdisjoint(parts[:-1]) or parts[-1] in _IGNORED_FILES or parts[-1].endswith(".pyc")


def _from_folder(folder: Path) -> Files:
    files: Files = {}
    total = 0
    inside = folder.resolve()
    for path in _walk(folder):
        relative = PurePosixPath(path.relative_to(folder).as_posix())
        if _ignored(relative.parts):
            continue
        if not path.resolve().is_relative_to(inside):
            raise TeamError(f"{folder}: {relative} is a link that leads out of the folder: copy the file instead")
        if not path.is_file():
            continue
        total += path.stat().st_size
        if total > MOST_UNPACKED_BYTES or len(files) >= MOST_FILES:
            raise TeamError(
                f"{folder}: more than {MOST_FILES} files or {MOST_UNPACKED_BYTES // 1_000_000} MB: "
                "is this the folder of the robot programs?"
            )
        files[relative] = path.read_bytes()
    return files


def _walk(folder: Path) -> Iterator[Path]:
    for root, folders, names in os.walk(folder):
        folders[:] = sorted(name for name in folders if name not in _IGNORED_FOLDERS)
        yield from (Path(root, name) for name in sorted(names))


def _from_zip(path: Path) -> Files:
    size = path.stat().st_size
    with path.open("rb") as file:
        start = file.read(8)
    for magic, kind in _OTHER_KINDS:
        if start.startswith(magic):
            raise TeamError(f"{path}: this is {kind}, not a ZIP: pack the folder as a ZIP archive")
    if size > MOST_PACKED_BYTES:
        raise TeamError(f"{path}: {size / 1e6:.1f} MB is more than the {MOST_PACKED_BYTES // 1_000_000} MB allowed")
    try:
        with zipfile.ZipFile(path) as archive:
            return _members(path, archive)
    except TeamError:
        raise
    except zipfile.BadZipFile as error:
        raise TeamError(f"{path}: not a ZIP archive, or a damaged one ({error})") from error
    except (
        zlib.error,
        lzma.LZMAError,
        EOFError,
        NotImplementedError,
        RuntimeError,
        ValueError,
        OverflowError,
        LookupError,
        MemoryError,
        struct.error,
    ) as error:
        raise TeamError(f"{path}: this ZIP archive cannot be unpacked ({error})") from error


def _members(path: Path, archive: zipfile.ZipFile) -> Files:
    files: Files = {}
    seen: dict[str, str] = {}
    left = MOST_UNPACKED_BYTES
    for member in archive.infolist():
        name = _safe_name(path, member)
        if member.is_dir() or member.filename.endswith("\\") or _ignored(name.parts):
            continue
        folded = str(name).casefold()
        if folded in seen:
            raise TeamError(f"{path}: {name} and {seen[folded]} are one file on some computers: rename one")
        seen[folded] = str(name)
        if len(files) >= MOST_FILES:
            raise TeamError(f"{path}: more than {MOST_FILES} files")
        files[name] = _content(path, archive, member, left)
        left -= len(files[name])
    return files


def _safe_name(path: Path, member: zipfile.ZipInfo) -> PurePosixPath:
    shown = repr(member.filename)
    if member.flag_bits & 0x1:
        raise TeamError(f"{path}: {shown} is encrypted: pack the ZIP without a password")
    kind = stat.S_IFMT(member.external_attr >> 16)
    if kind not in (0, stat.S_IFREG, stat.S_IFDIR):
        raise TeamError(f"{path}: {shown} is a link or a device: pack the file itself")
    # Some Windows tools write backslashes.
    name = PurePosixPath(member.filename.replace("\\", "/"))
    if name.is_absolute() or ".." in name.parts or not name.parts or ":" in member.filename:
        raise TeamError(f"{path}: {shown} leads out of the archive")
    if any(ord(letter) < 32 and letter != "\r" for letter in member.filename):
        raise TeamError(f"{path}: {shown} has control characters in its name")
    return name


def _content(path: Path, archive: zipfile.ZipFile, member: zipfile.ZipInfo, left: int) -> bytes:
    """Return a member's bytes; what its header says about its size is not believed."""
    parts = []
    with archive.open(member) as file:
        while chunk := file.read(_CHUNK):
            left -= len(chunk)
            if left < 0:
                raise TeamError(f"{path}: unpacked, it is more than {MOST_UNPACKED_BYTES // 1_000_000} MB")
            parts.append(chunk)
    return b"".join(parts)
