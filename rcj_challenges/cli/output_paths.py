"""Output of commands: file names that are valid on every system, and documents to files or standard output."""

from __future__ import annotations

import sys
from pathlib import Path

from rcj_challenges.core.errors import RcjError, format_error, room_help
from rcj_challenges.core.file_names import is_device_of_windows


class OutputError(RcjError):
    """A file that cannot be written."""

    CODE = "cannot-write"


class OutputNameError(RcjError):
    """A name that a file or folder cannot have."""

    CODE = "device-name"


def refuse_devices(**outputs: Path | None) -> None:
    """Refuse what no file on Windows may be called, on every system: what is made is handed on.

    Only the last name of a path counts: who has a folder of such a name already knows where it works.

    Args:
        outputs: what was given, by the option's name without its dashes; None: nothing.

    Raises:
        OutputNameError: one of them is the name of a device.
    """
    for option, path in outputs.items():
        if path is not None and is_device_of_windows(path.name):
            name = path.name.partition(".")[0].rstrip()
            message = f"--{option} {path}: '{name}' is a device on Windows, where no file has that name"
            raise OutputNameError(message, "choose another name")


def _to_stdout(document: str) -> None:
    """Write a document as other files of it are, in UTF-8; a terminal gets the letters that it has."""
    if sys.stdout.isatty():
        sys.stdout.write(document)
    else:
        sys.stdout.flush()
        sys.stdout.buffer.write(document.encode("utf-8"))


def check_ending(out: Path | None, endings: tuple[str, ...], complaint: str) -> None:
    """Refuse a file whose name would promise something else than what is written, or is none everywhere.

    Raises:
        OutputError: it has none of these endings.
        OutputNameError: it is the name of a device.
    """
    refuse_devices(out=out)
    if out is not None and out.suffix.lower() not in endings:
        raise OutputError(f"--out {out}: {complaint}", code="bad-out")


def deliver(content: str | bytes, out: Path | None) -> int:
    """Write a document to a file and print where, or to standard output; returns 0.

    Raises:
        OutputError: it cannot be written.
    """
    if out is None:
        _to_stdout(str(content))  # pictures of bytes always have a file
        return 0
    try:
        # Bytes, so that no system changes the ends of lines.
        out.write_bytes(content.encode("utf-8") if isinstance(content, str) else content)
    except OSError as error:
        raise OutputError(f"{out}: cannot be written: {format_error(error)}", room_help(error)) from error
    sys.stdout.write(f"{out}\n")
    return 0
