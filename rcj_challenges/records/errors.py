"""What can be wrong with a record."""

from __future__ import annotations

import errno
from pathlib import Path
from typing import Self

from rcj_challenges.facts.errors import HostError, RcjError, format_error, is_held
from rcj_challenges.facts.sanitize import sanitize


class RecordError(RcjError):
    """A record that is missing, damaged, foreign or newer than this package."""

    CODE = "unusable-record"


class UnwritableError(HostError, RecordError):
    """A record that cannot be written on this computer, as it is at present."""

    CODE = "cannot-write-record"

    @classmethod
    def of(cls, error: OSError, place: Path) -> Self | None:
        """Return what an error means for the record; None if it is not about a file in its place.

        Args:
            error: what the system said, with the file's name.
            place: the record's folder, or the one that it is in.
        """
        if not isinstance(error.filename, str) or not Path(error.filename).is_relative_to(place):
            return None
        advice = _HELD_ADVICE if is_held(error) else _ADVICE.get(error.errno or 0, "")
        return cls(f"the record cannot be written: {sanitize(error.filename)}: {format_error(error)}{advice}")


_HELD_ADVICE = "; close the program that may have it open, or give a folder with --out in which you may write"
_ADVICE = {
    **dict.fromkeys(
        (getattr(errno, name) for name in ("ENOSPC", "EDQUOT", "EFBIG") if hasattr(errno, name)),
        "; make room there, or give another folder with --out",
    ),
    **dict.fromkeys((errno.EACCES, errno.EPERM, errno.EROFS), "; give a folder with --out in which you may write"),
    errno.ENOENT: "; has somebody moved or deleted it?",
}
