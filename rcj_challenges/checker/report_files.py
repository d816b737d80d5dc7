"""Output files of a check: tested for writability before it begins; old ones are kept if writing fails."""

from __future__ import annotations

import errno
import os
from pathlib import Path

from rcj_challenges.programs.scratch import ensure_room
from rcj_challenges.records.folder import replaced


def ensure_folder(folder: Path) -> None:
    """Make a folder if it is not there, and find out whether files can be written into it.

    Raises:
        OSError: as of `ensure_room`, or it cannot be made: perhaps it is a file.
    """
    if folder.exists() and not folder.is_dir():
        raise NotADirectoryError(errno.ENOTDIR, "it is a file, not a folder")
    folder.mkdir(parents=True, exist_ok=True)
    ensure_room(folder)


def ensure_page(path: Path) -> None:
    """Make the folder of a page if it is not there, and find out whether the page can be written.

    Raises:
        OSError: it cannot.
    """
    target = _target(path)
    if target.is_dir():
        raise IsADirectoryError(errno.EISDIR, "it is a folder, not a file")
    if not _is_device(target):
        ensure_folder(target.parent)


def write_page(path: Path, text: str) -> None:
    """Write a page; the one that was there stays until the new one is whole.

    Raises:
        OSError: it cannot be written.
    """
    target = _target(path)
    if _is_device(target):  # a file must not replace /dev/stdout
        target.write_text(text, encoding="utf-8", newline="\n")
        return
    with replaced(target) as file:
        file.write(text.encode("utf-8"))


def _target(path: Path) -> Path:
    """Return the file to which a link leads: the link itself stays."""
    return Path(os.path.realpath(path))


def _is_device(path: Path) -> bool:
    return path.exists() and not path.is_file()
