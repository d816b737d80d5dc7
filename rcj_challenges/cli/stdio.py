"""Output for other programs, and handling of standard streams that are closed, narrow, or unread."""

from __future__ import annotations

import codecs
import contextlib
import errno
import io
import json
import os
import re
import shlex
import stat
import sys
from typing import TYPE_CHECKING, Any, TypeGuard

from rcj_challenges.cli.codes import CANNOT_WRITE_OUTPUT
from rcj_challenges.core.codes import DISK_FULL

if TYPE_CHECKING:
    from _typeshed import ReadableBuffer
    from rich.console import Console

from rcj_challenges.core.errors import HostError, format_error, is_held, is_no_room, is_of_the_host, room_help
from rcj_challenges.core.letters import READABLE
from rcj_challenges.core.sanitize import sanitize, sanitize_lines


def print_json(value: Any) -> None:
    """Print a value as JSON and nothing else. A reader that goes away does not change the exit code.

    Characters are printed as they are if the output is UTF-8, else as JSON's escapes.

    Raises:
        HostError: it cannot be written, as to a file on a full disk.
    """
    wide = codecs.lookup(getattr(sys.stdout, "encoding", None) or "utf-8").name == "utf-8"
    text = json.dumps(value, ensure_ascii=not wide, indent=2)
    if any("\ud800" <= character <= "\udfff" for character in text):
        text = json.dumps(value, indent=2)
    try:
        sys.stdout.write(text + "\n")
        sys.stdout.flush()
    except BrokenPipeError:
        discard_output(sys.stdout)
    except OSError as error:
        unwritable = output_error(error)
        discard_output(sys.stdout)
        raise unwritable from error


def print_safely(text: str, *, to_stderr: bool = False) -> None:
    """Print harmless lines; nothing if there are none. A closed output does not change the exit code."""
    if not text:
        return
    # A terminal that cannot show a character must not hide the whole message.
    stream: Any = sys.stderr if to_stderr else sys.stdout  # may be replaced by anything that writes
    encoding = getattr(stream, "encoding", None) or "utf-8"
    try:
        stream.write(sanitize_lines(text).encode(encoding, READABLE).decode(encoding) + "\n")
    except BrokenPipeError:
        discard_output(stream)


def print_lines(console: Console, *lines: str) -> None:
    """Print lines as they are, without markup and however long they are."""
    for line in lines:
        console.print(line, markup=False, highlight=False, soft_wrap=True)


def require_layers(sandbox: str) -> None:
    """Print, on standard error, each layer of isolation that programs should get and do not get here.

    Raises:
        RcjError: ``strict``, and layers are missing; or no such sandbox.
    """
    from rcj_challenges.programs.isolation import active_layers, dropped_layers
    from rcj_challenges.views.console import console_for

    active_layers(sandbox)
    for layer, why in dropped_layers(sandbox).items():
        print_lines(console_for(to_stderr=True), f"isolation: programs run without the layer {layer}: {why}")


def print_progress(console: Console, line: str) -> None:
    """Print progress of a long command. Errors while printing are ignored."""
    with contextlib.suppress(OSError):
        print_lines(console, line)


def as_host_error(error: BaseException) -> HostError | None:
    """An error about this computer with its file and what to do; None if it is about something else."""
    if isinstance(error, HostError):
        return error
    if is_output_error(error):
        return output_error(error)
    if not (is_of_the_host(error) or isinstance(error, PermissionError)):
        return None
    file = f"{sanitize(error.filename)}: " if isinstance(error, OSError) and error.filename else ""
    held = isinstance(error, OSError) and is_held(error)
    help_ = "close the program that may have it open" if held else room_help(error)
    return HostError(f"{file}{format_error(error)}", help_, code=DISK_FULL if is_no_room(error) else None)


def output_error(error: OSError) -> HostError:
    """An error of our output with the name of the file that it goes to (on Linux)."""
    where = ""
    with contextlib.suppress(OSError, ValueError):
        if _is_file(sys.stdout):
            where = f" ({sanitize(os.readlink(f'/proc/self/fd/{sys.stdout.fileno()}'))})"  # noqa: PTH115 - no path of ours
    message = f"the output{where} cannot be written: {format_error(error)}"
    return HostError(message, room_help(error), code=CANNOT_WRITE_OUTPUT)


def is_output_error(error: BaseException) -> TypeGuard[OSError]:
    """Whether an error without a file's name comes from our output, a file on a disk that is full."""
    if not isinstance(error, OSError) or error.filename is not None or not is_no_room(error):
        return False
    with contextlib.suppress(OSError, ValueError, AttributeError):  # Windows has no such call
        return _is_file(sys.stdout) and not os.fstatvfs(sys.stdout.fileno()).f_bavail
    return False


def _is_file(stream: Any) -> bool:
    return stat.S_ISREG(os.fstat(stream.fileno()).st_mode)


def shell_quoted(path: object) -> str:
    """A path as it is typed into a shell: in double quotes, which every shell knows, if it needs quotes."""
    text = str(path)
    if os.sep == "/" and not text.isprintable():  # a console prints escapes for what cannot be seen or is no UTF-8
        return "$'" + "".join(_shell_escaped(byte) for byte in os.fsencode(text)) + "'"
    if os.sep == "/" and re.search(r'[$`"\\!]', text):  # these mean something to a POSIX shell within double quotes
        return shlex.quote(text)
    return text if re.fullmatch(r"[\w./\\:@+,=-]+", text) else f'"{text}"'


def shown_path(path: object) -> str:
    """A path for a terminal: as it is, or where it would be printed with escapes as it is typed into a shell."""
    return str(path) if str(path).isprintable() else shell_quoted(path)


def _shell_escaped(byte: int) -> str:
    char = chr(byte)
    return char if char.isascii() and char.isprintable() and char not in "\\'" else f"\\x{byte:02x}"


def discard_output(stream: Any) -> None:
    """Discard what is still printed there: else the interpreter reports the error again at its end."""
    with contextlib.suppress(OSError, ValueError), contextlib.ExitStack() as stack:
        nowhere = os.open(os.devnull, os.O_WRONLY)
        stack.callback(os.close, nowhere)
        os.dup2(nowhere, stream.fileno())


def replace_unencodable() -> None:
    """Print replacements for characters that our output cannot encode: on Windows a path or title may have them.

    There Python's own choice is ``surrogateescape``. Where that keeps the bytes of names (``LC_ALL=C``), it stays.
    """
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            of_names = stream.errors == "surrogateescape" and codecs.lookup(stream.encoding).name in ("ascii", "utf-8")
            if stream.errors in ("strict", "surrogateescape") and not of_names:
                stream.reconfigure(errors=READABLE)


def detect_closed_pipes() -> None:
    """Raise a broken pipe for output without a reader also on Windows, which reports another error."""
    for name in ("stdout", "stderr"):
        stream = getattr(sys, name)
        with contextlib.suppress(OSError, AttributeError):
            if stat.S_ISFIFO(os.fstat(stream.fileno()).st_mode):
                buffer = io.BufferedWriter(_ToReader(stream.fileno()))
                wrapped = io.TextIOWrapper(
                    buffer, stream.encoding, stream.errors, None, stream.line_buffering, stream.write_through
                )
                setattr(sys, name, wrapped)


class _ToReader(io.RawIOBase):
    """One end of a pipe. If its reader is gone, Windows reports an invalid argument."""

    def __init__(self, fd: int) -> None:
        self._fd = fd

    def fileno(self) -> int:
        return self._fd

    def writable(self) -> bool:
        return True

    def write(self, data: ReadableBuffer, /) -> int:
        try:
            return os.write(self._fd, data)
        except OSError as error:
            if error.errno != errno.EINVAL:
                raise
            raise BrokenPipeError(errno.EPIPE, os.strerror(errno.EPIPE)) from error


def open_closed_streams() -> None:
    """Open standard streams that are closed, as cron and services may start commands.

    Else the next files that are opened, such as the log of the match, take their places and get what is printed.
    """
    for number, name in enumerate(("stdin", "stdout", "stderr")):
        try:
            os.fstat(number)
        except OSError:
            if os.open(os.devnull, os.O_RDWR) != number:
                return  # this system numbers otherwise
            file = io.FileIO(number, "r" if name == "stdin" else "w", closefd=False)
            buffered: Any = io.BufferedReader(file) if name == "stdin" else io.BufferedWriter(file)
            setattr(sys, name, io.TextIOWrapper(buffered, encoding="utf-8", errors="backslashreplace"))
