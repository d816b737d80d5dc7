"""Finding records and opening their pages: what ``view`` and ``replay`` do."""

from __future__ import annotations

import os
import webbrowser
from dataclasses import dataclass
from pathlib import Path

from rcj_challenges.facts.shown import shown
from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.folder import REPLAY, RESULT
from rcj_challenges.records.result import RunResult, read_result
from rcj_challenges.views.replay.page import write_replay


@dataclass(frozen=True)
class RunRow:
    """One record in a list.

    Attributes:
        folder: of the record.
        result: what it says, None if it cannot be read.
        problem: why it cannot be read, else empty.
    """

    folder: Path
    result: RunResult | None
    problem: str = ""

    @property
    def has_page(self) -> bool:
        """Whether its replay page is there."""
        return (self.folder / REPLAY).exists()


def list_runs(out: Path) -> list[RunRow]:
    """Return the records in a folder, the newest first; damaged ones are listed with what is wrong.

    Raises:
        RecordError: there is no such folder.
    """
    if not out.is_dir():
        raise RecordError(f"no folder {out}: no run was recorded there")
    return [_row(folder) for folder in _folders(out)]


def find_run(run: Path | None, out: Path) -> Path:
    """Return the folder of a record.

    Args:
        run: a record's folder, a file in it, or its name (or the beginning of it) in ``out``; None: the newest.
        out: where records are made.

    Raises:
        RecordError: there is none, or the beginning fits several.
    """
    if run is None:
        folders = _folders(out) if out.is_dir() else []
        if not folders:
            raise RecordError(f"no run was recorded in {out} yet")
        return folders[0]
    for folder in (run, run.parent, out / run):
        if (folder / RESULT).is_file():
            return folder
    fitting = [folder for folder in _folders(out) if folder.name.startswith(run.name)] if out.is_dir() else []
    if len(fitting) == 1:
        return fitting[0]
    if fitting:
        names = ", ".join(sorted(folder.name for folder in fitting)[:5])
        raise RecordError(f"{run.name!r} fits several records: {names}")
    if run.is_dir():
        raise RecordError(f"no record '{shown(run)}': there is no {RESULT} in this folder")
    raise RecordError(f"no record '{shown(run)}': give its folder, or its name in {out}")


def open_replay(folder: Path) -> tuple[Path, bool]:
    """Open a record's page in the browser, after writing it if it is missing.

    Returns:
        The page's path, and whether a browser took it (there may be none, as on a machine without a display).

    Raises:
        RecordError: the record cannot be shown.
    """
    page = folder / REPLAY
    if not page.exists():
        page = write_replay(folder)
    return page, webbrowser.open(page.resolve().as_uri())


def _folders(out: Path) -> list[Path]:
    """Return the records' folders, the newest first: names begin with the time. What is closed to us is none."""
    found = (path for path in out.iterdir() if os.path.isfile(path / RESULT))  # noqa: PTH113 - that of pathlib raises
    return sorted(found, key=lambda path: path.name, reverse=True)


def _row(folder: Path) -> RunRow:
    try:
        return RunRow(folder, read_result(folder))
    except RecordError as error:
        return RunRow(folder, None, str(error))
