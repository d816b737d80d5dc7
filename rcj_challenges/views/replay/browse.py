"""Finds records and opens their pages."""

from __future__ import annotations

import os
import sys
import webbrowser
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path

from rcj_challenges.core.amounts import Score
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.records.codes import AMBIGUOUS_RECORD, NO_RECORD
from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.folder import REPLAY, RESULT
from rcj_challenges.records.recorded_scenario import read_scenario
from rcj_challenges.records.referee_log import read_referee_log, score_so_far
from rcj_challenges.records.result import RunResult, read_result
from rcj_challenges.views.replay.page import write_replay

_RUN = "play one with rcj-challenge run, or name another folder with --out"


@dataclass(frozen=True)
class RunRow:
    """One record in a list; it has a ``problem`` if it has no result. The score may be that of a run so far."""

    folder: Path
    result: RunResult | None
    problem: str = ""
    score: Mapping[str, Score] = field(default_factory=dict)


def list_runs(out: Path) -> list[RunRow]:
    """Return the records in a folder, the newest first; damaged ones are listed with what is wrong.

    Raises:
        RecordError: there is no such folder, or none in it.
    """
    if not _is_folder(out):
        raise RecordError(NO_RECORD, f"no folder {sanitize(out)}: no run was recorded there", _RUN)
    folders = _folders(out)
    if not folders:
        help_ = f"it is a record itself: rcj-challenge view {sanitize(out)}" if _is_record(out) else _RUN
        raise RecordError(NO_RECORD, f"no run was recorded in {sanitize(out)} yet", help_)
    return [_row(folder) for folder in folders]


def find_run(run: Path | None, out: Path) -> Path:
    """Return a record's folder, by its path, a file in it, its name (or the beginning) in ``out``; None: the newest.

    Raises:
        RecordError: there is none, or the beginning fits several.
    """
    if run is None:
        if folders := _folders(out):
            return folders[0]
        raise RecordError(NO_RECORD, f"no run was recorded in {sanitize(out)} yet", _RUN)
    # In the folder of a record, the name of another one is no file of this one.
    in_it = [run.parent] if len(run.parts) > 1 or os.path.lexists(run) else []
    for folder in (run, *in_it, out / run):
        if _is_record(folder):
            return folder if folder.name not in ("", "..") else folder.resolve()  # which has a name
    fitting = [folder for folder in _folders(out) if folder.name.startswith(run.name)]
    if len(fitting) == 1:
        return fitting[0]
    if fitting:
        names = ", ".join(sorted(folder.name for folder in fitting)[:5])
        raise RecordError(AMBIGUOUS_RECORD, f"{run.name!r} fits several records", f"give one of {names}")
    help_ = f"give its folder, or its name in {sanitize(out)}"
    what = f": there is no {RESULT} in this folder" if _is_folder(run) else ""
    raise RecordError(NO_RECORD, f"no record '{sanitize(run)}'{what}", help_)


def open_replay(folder: Path) -> tuple[Path, bool]:
    """Open a record's page in the browser, after writing it if it is missing; return its path, and whether one opened.

    Raises:
        RecordError: the record cannot be shown.
    """
    page = folder / REPLAY
    if not page.exists():
        page = write_replay(folder)
    return page, webbrowser.open(playing_address(page.absolute()))


def playing_address(page: Path, system: str = sys.platform) -> str:
    """Return the address under which a replay plays by itself."""
    if system not in ("win32", "darwin"):
        return address_of(page, system) + "#play"
    start = page.with_name("play.html")  # these systems open a file without the fragment of its address
    try:
        start.write_text(f'<meta http-equiv="refresh" content="0; url={page.name}#play">\n', encoding="utf-8")
    except OSError:
        start = page
    return address_of(start, system)


def address_of(page: Path, system: str = sys.platform) -> str:
    """Return the address under which a browser opens a page.

    Windows reads escapes in the address of a file as characters of its old code pages, and does not find a page below
    Jörg's folder; there it is the path itself, which has no escapes.
    """
    return str(page) if system == "win32" else page.resolve().as_uri()


def _is_folder(path: Path) -> bool:
    return os.path.isdir(path)  # noqa: PTH112 - that of pathlib raises for names that are too long


def _is_record(folder: Path) -> bool:
    """Return whether a folder holds a record. What is closed to us, or no name that the system takes, is none."""
    return os.path.isfile(folder / RESULT)  # noqa: PTH113 - that of pathlib raises


def _folders(out: Path) -> list[Path]:
    """Return the records' folders, the newest first: names begin with the time; none if there is no such folder."""
    return sorted(
        filter(_is_record, out.iterdir() if _is_folder(out) else ()), key=lambda path: path.name, reverse=True
    )


def _row(folder: Path) -> RunRow:
    try:
        result = read_result(folder)
    except RecordError as error:
        return RunRow(folder, None, error.message)
    score = result.score  # of whole halves, where only they can be read
    if not result.complete:
        with suppress(RecordError):
            score = score_so_far(result, read_scenario(folder), read_referee_log(folder))
    return RunRow(folder, result, score=score)
