"""Errors about the folder for temporary files: where it is, and what helps."""

from __future__ import annotations

import sys
import tempfile

from rcj_challenges.core.codes import DISK_FULL, TEMPORARY_FOLDER
from rcj_challenges.core.errors import HostError, format_error
from rcj_challenges.core.sanitize import sanitize

_VARIABLE = "TEMP" if sys.platform == "win32" else "TMPDIR"


def temporary_folder_error(error: BaseException, trouble: str = "cannot be used") -> HostError:
    """Return an error about the temporary folder that says where it is, and what helps."""
    place = _temporary_folder()
    message = f"the temporary folder{place} {trouble}: {format_error(error)}"
    return HostError(message, f"make room there, or let {_VARIABLE} name another", code=TEMPORARY_FOLDER)


def disk_full_error() -> HostError:
    """Return the error of a full temporary folder that no program has filled."""
    message = (
        f"the disk of the temporary folder{_temporary_folder()} is full, although no program of the match has "
        "written more than its share"
    )
    help_ = f"free some space there, or set {_VARIABLE} to a folder with more room, and run the command again"
    return HostError(message, help_, code=DISK_FULL)


def _temporary_folder() -> str:
    try:
        return f" {sanitize(tempfile.gettempdir())}"
    except OSError:  # what the system said names the folders that were tried
        return ""
