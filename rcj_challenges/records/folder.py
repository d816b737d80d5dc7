"""The folder of a run: its name, the names of its files, and writing a file so that it is never half there."""

from __future__ import annotations

import os
import stat
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from datetime import UTC, datetime
from pathlib import Path
from typing import Any, BinaryIO

from rcj_challenges.core.errors import format_error, is_held
from rcj_challenges.core.files import open_without_waiting
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.records import codes
from rcj_challenges.records.errors import COPY_AGAIN, RecordError

RECORD_VERSION = 2
"""Version of everything in the folder; another one is refused."""

MAX_FILE_BYTES = 256_000_000
"""Of a file that is read; a log with a firing in each tick of a half of ten minutes has about 5 MB."""

RESULT = "result.json"
SCENARIO = "scenario.json"
UNRESOLVED = "scenario.unresolved.json"
REFLOG = "reflog.jsonl"
REFEREE_LOG = "referee.jsonl"
TRAJECTORY = "trajectory.chunks"
LOGS = "logs"
SENSORS = "sensors"
REPLAY = "replay.html"

_OTHER_FOLDER = "give another folder with --out"
_MAX_RUNS_A_SECOND = 10_000

_WAIT_FOR_OTHERS_S = 2.0
"""Virus scanners and indexers look into what was just written for a few tenths of a second."""
_POLL_INTERVAL_S = 0.02


def check_version(record: int, name: str) -> None:
    """Refuse a record of another version; ``name`` is that of its folder.

    Raises:
        RecordError: it is older or newer than what this package reads.
    """
    message = f"{name}: its record has version {record}, this package reads version {RECORD_VERSION}"
    if record > RECORD_VERSION:
        raise RecordError(codes.RECORD_TOO_NEW, message, "read it with a newer rcj-challenges")
    if record < RECORD_VERSION:
        help_ = "play the match again; its replay.html still opens in a browser"
        raise RecordError(codes.RECORD_TOO_OLD, f"{message} only", help_)


def read_file(path: Path, max_bytes: int = MAX_FILE_BYTES) -> bytes:
    """Return the contents of a file of a record.

    Records are untrusted: a named pipe in place of a file would block for ever, a device might never end.

    Raises:
        RecordError: it is missing, cannot be read, is a pipe or a device, or is too large.
    """
    name = f"{path.parent.name}: {path.name}"
    try:
        with open_without_waiting(path) as file:
            found = os.fstat(file.fileno())
            if stat.S_ISREG(found.st_mode) and found.st_size <= max_bytes:
                return file.read(found.st_size)  # a number, because it may grow meanwhile
    except FileNotFoundError:
        help_ = "give the folder of a record, with all its files"
        raise RecordError(codes.RECORD_INCOMPLETE, f"{name} is missing", help_) from None
    except OSError as error:
        raise RecordError(codes.RECORD_UNREADABLE, f"{name} cannot be read: {format_error(error)}") from error
    if stat.S_ISREG(found.st_mode):
        message = f"{name} has {found.st_size / 1e6:.0f} MB, more than {max_bytes / 1e6:.0f}"
        raise RecordError(codes.RECORD_TOO_LARGE, message, "no run writes such a file: copy the whole record again")
    raise RecordError(codes.RECORD_NOT_A_FILE, f"{name} is a pipe or a device, not a file", COPY_AGAIN)


def write_all(file: Any, pending: bytearray) -> None:
    """Write everything, and remove from ``pending`` what is written: an unbuffered file may take less than given.

    Raises:
        OSError: it takes no more; with its name. What is left in ``pending`` may be written later.
    """
    with naming(file.name):
        while pending:
            del pending[: file.write(pending)]


def utc_now() -> datetime:
    """Return the wall clock, for folder names and ``datetime`` fields. It never affects results."""
    return datetime.now(UTC)


def timestamp(moment: datetime) -> str:
    """Return ``2021-06-18T00:11:59.888153Z``, as the original's reflog has it."""
    return moment.astimezone(UTC).replace(tzinfo=None).isoformat(timespec="microseconds") + "Z"


def folder_name(moment: datetime, scenario_id: str) -> str:
    """Return ``20210618-001159-match``: it sorts by time and is a legal name on every system."""
    return f"{moment.astimezone(UTC):%Y%m%d-%H%M%S}-{scenario_id}"


def make_out_folder(out: Path, what: str = "the record") -> None:
    """Make the folder in which records' folders are made, if it is not there.

    Raises:
        RecordError: it cannot be made.
    """
    try:
        out.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        # Systems differ in what they say of a file, or a link to nowhere, that is the folder or on the way to it.
        other = next((path for path in (out, *out.parents) if os.path.lexists(path) and not path.is_dir()), None)
        why = format_error(error) if other is None else f"{sanitize(other)} is not a folder"
        message = f"cannot make a folder for {what} in {sanitize(out)}: {why}"
        raise RecordError(codes.CANNOT_WRITE_RECORD, message, _OTHER_FOLDER) from error


def make_run_folder(out: Path, name: str) -> Path:
    """Make ``out/name``, or ``out/name-2`` and so on if that exists: two runs never share a folder.

    Raises:
        RecordError: the folder cannot be made.
    """
    make_out_folder(out)
    for number in range(1, _MAX_RUNS_A_SECOND):
        folder = out / (name if number == 1 else f"{name}-{number}")
        try:
            folder.mkdir()
        except FileExistsError:
            continue
        except OSError as error:
            message = f"cannot make a folder for the record in {sanitize(out)}: {format_error(error)}"
            raise RecordError(codes.CANNOT_WRITE_RECORD, message, _OTHER_FOLDER) from error
        return folder
    raise RecordError(codes.CANNOT_WRITE_RECORD, f"too many records of this second in {sanitize(out)}", _OTHER_FOLDER)


@contextmanager
def replaced(path: Path) -> Iterator[BinaryIO]:
    """Write a file that appears whole or not at all: a temporary neighbour, synced, then renamed over it.

    Two processes may write the same file: each uses its own temporary file, and the last to finish wins.

    Raises:
        OSError: it cannot be written; with its name.
    """
    temporary = path.with_name(f"{path.name}.{os.getpid()}.tmp")
    try:
        with naming(path), temporary.open("wb") as file:
            yield file
            file.flush()
            os.fsync(file.fileno())
        try:
            when_free(lambda: temporary.replace(path))
        except OSError as error:
            error.filename = str(path)  # that is the file that is open elsewhere, or must not be changed
            raise
    except BaseException:
        with suppress(OSError):
            temporary.unlink()
        raise


def when_free(do: Callable[[], object]) -> None:
    """Rename or remove files; if Windows refuses it while another program has one open, try again for a while.

    Raises:
        OSError: it cannot be done, or the other program still has the file.
    """
    until_s = time.monotonic() + _WAIT_FOR_OTHERS_S
    while True:
        try:
            do()
        except OSError as error:
            if not is_held(error) or time.monotonic() >= until_s:
                raise
        else:
            return
        time.sleep(_POLL_INTERVAL_S)


@contextmanager
def naming(path: object) -> Iterator[None]:
    """Add the file's name to an error of writing, as one of opening has it."""
    try:
        yield
    except OSError as error:
        if error.filename is None:
            error.filename = str(path)
        raise
