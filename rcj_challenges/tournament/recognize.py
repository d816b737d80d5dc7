"""Telling tournament files from scenario files without reading either."""

from __future__ import annotations

import re
from pathlib import Path

from rcj_challenges.core.files import open_regular
from rcj_challenges.scenario.resources import TOURNAMENTS_FOLDER, names_in

_VERSION = re.compile(rb"^[\"']?tournament_version[\"']?\s*:", re.MULTILINE)
_MAX_BYTES = 1_000_000


def is_tournament(source: str) -> bool:
    """Return whether a file has the key ``tournament_version``, or ``source`` is the name of a shipped tournament."""
    try:
        with open_regular(Path(source)) as file:
            return _VERSION.search(file.read(_MAX_BYTES)) is not None
    except (OSError, ValueError):
        return source in names_in(TOURNAMENTS_FOLDER)
