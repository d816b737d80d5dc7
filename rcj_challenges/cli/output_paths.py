"""Output of commands: file names that are valid on every system, and documents to files or standard output."""

from __future__ import annotations

import sys
from pathlib import Path

from rcj_challenges.cli.codes import BAD_OUT, DEVICE_NAME
from rcj_challenges.core.codes import FILE_EXISTS
from rcj_challenges.core.errors import RcjError, unwritable
from rcj_challenges.core.files import is_device_of_windows


def refuse_devices(**outputs: Path | None) -> None:
    """Refuse names of Windows devices on every system: files are handed on.

    Only the last name of a path counts: a folder of such a name exists where it can. ``outputs`` are by option.

    Raises:
        RcjError: one of them is the name of a device.
    """
    for option, path in outputs.items():
        if path is not None and is_device_of_windows(path.name):
            name = path.name.partition(".")[0].rstrip()
            message = f"--{option} {path}: '{name}' is a device on Windows, where no file has that name"
            raise RcjError(message, "choose another name", code=DEVICE_NAME)


def check_ending(out: Path | None, endings: tuple[str, ...], complaint: str) -> None:
    """Refuse a file whose ending does not fit its content.

    Raises:
        RcjError: it has none of these endings.
        RcjError: it is the name of a device.
    """
    refuse_devices(out=out)
    if out is not None and out.suffix.lower() not in endings:
        help_ = f"rename it: --out {out.with_suffix(endings[0])}" if out.stem else ""
        raise RcjError(f"--out {out}: {complaint}", help_, code=BAD_OUT)


def file_for_terminal(name: str) -> Path | None:
    """The file for a document without ``--out`` on a terminal, which cannot show it; None elsewhere.

    Raises:
        RcjError: there is one of that name.
    """
    if not sys.stdout.isatty():
        return None
    if Path(name).exists():
        raise RcjError(f"{name} exists already; nothing was written", f"--out {name}", code=FILE_EXISTS)
    return Path(name)


def deliver(content: str | bytes, out: Path | None, *, make_folder: bool = False) -> None:
    """Write a document to a file, whose folder may be made, and print where; or to standard output.

    Raises:
        RcjError: it cannot be written.
    """
    if out is None:
        document = str(content)  # pictures of bytes always have a file
        if sys.stdout.isatty():
            sys.stdout.write(document)
        else:  # UTF-8, as in files
            sys.stdout.flush()
            sys.stdout.buffer.write(document.encode("utf-8"))
        return
    try:
        if make_folder:
            out.parent.mkdir(parents=True, exist_ok=True)
        # Bytes, so that no system changes the ends of lines.
        out.write_bytes(content.encode("utf-8") if isinstance(content, str) else content)
    except OSError as error:
        raise unwritable(out, error) from error
    sys.stdout.write(f"{out}\n")
