"""Output files of a check: tested for writability before it begins; old ones are kept if writing fails."""

from __future__ import annotations

import errno
import shutil
from pathlib import Path

from rcj_challenges.controllers.scratch import ensure_room
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
    if path.is_dir():
        raise IsADirectoryError(errno.EISDIR, "it is a folder, not a file")
    ensure_folder(path.parent)


def write_page(path: Path, text: str) -> None:
    """Write a page; the one that was there stays until the new one is whole.

    Raises:
        OSError: it cannot be written.
    """
    with replaced(path) as file:
        file.write(text.encode("utf-8"))


def copy_page(page: Path, target: Path) -> None:
    """Copy a page, perhaps to another disk; the one that was there stays until the new one is whole.

    Raises:
        OSError: it cannot be written.
    """
    with page.open("rb") as source, replaced(target) as file:
        shutil.copyfileobj(source, file)
