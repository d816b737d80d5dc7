"""What is kept of the record of a match, by the tournament's ``records:``; what is dropped can be made again."""

from __future__ import annotations

import shutil
from collections.abc import Mapping
from pathlib import Path

from rcj_challenges.records.folder import REPLAY, SENSORS, TRAJECTORY
from rcj_challenges.tournament.models import Records

STATS = "stats.json"
"""Of a record: the statistics of the match, so that they outlive the trajectory from which they are counted."""

_DROPPED: Mapping[Records, tuple[str, ...]] = {
    "full": (),
    # The page has all that it shows in itself. Of 17 MB of a match of 20 minutes less than 1 MB is left.
    "replay": (SENSORS, TRAJECTORY),
    "result": (SENSORS, TRAJECTORY, REPLAY),
}


def trim_record(folder: Path, records: Records) -> None:
    """Remove from a record that is complete what is not kept.

    Raises:
        OSError: something cannot be removed.
    """
    for name in _DROPPED[records]:
        path = folder / name
        if path.is_dir():
            shutil.rmtree(path)
        else:
            path.unlink(missing_ok=True)


def sizes(folder: Path) -> dict[str, int]:
    """Return the size of each file of a record by its name, logs included: a record with others is damaged.

    Raises:
        OSError: it cannot be read.
    """
    found = {}
    for path in sorted(folder.rglob("*")):
        if path.is_file():
            found[path.relative_to(folder).as_posix()] = path.stat().st_size
    return found
