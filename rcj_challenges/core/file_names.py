"""File names that are valid on every computer."""

from __future__ import annotations

import hashlib
import re

_DEVICES = re.compile(r"con|prn|aux|nul|conin\$|conout\$|(com|lpt)[0-9¹²³]", re.IGNORECASE)
_INVALID = re.compile(r"[^A-Za-z0-9_.-]")
_MAX_SLUG = 120
_INDEX = "index"
"""The page of a folder of pages: no file that is named after something else takes its name."""


def is_device_of_windows(name: str) -> bool:
    """Return whether Windows reserves this name, whatever its ending."""
    return _DEVICES.fullmatch(name.partition(".")[0].rstrip()) is not None


def slug(identifier: str) -> str:
    """Return an id as the name of a file without its ending: ``groups.A.round2.ada-bee``.

    Two ids that differ by more than case never share one.
    """
    name = identifier.replace("/", ".")
    is_free = name.casefold() != _INDEX and not is_device_of_windows(name)
    if is_free and len(name) <= _MAX_SLUG and not _INVALID.search(name):
        return name
    digest = hashlib.sha256(identifier.encode()).hexdigest()[:16]
    return f"{'' if is_free else '_'}{_INVALID.sub('_', name)[:_MAX_SLUG]}.{digest}"
