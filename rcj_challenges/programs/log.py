"""The log of one program: what it printed, and the match's own lines about it."""

from __future__ import annotations

import codecs
import contextlib
import os
import re
import sys
import tempfile
from pathlib import Path

_DUMP_BEGINS = b"Fatal Python error:"
_DUMP_OF_WINDOWS = re.compile(
    rb"Windows fatal exception: .*\n(?:\n|(?:  |Thread |Current thread(?:'s)? |Extension modules: ).*\n)*\Z"
)
"""The interpreter also dumps errors there that a program then catches, so only a dump at the end counts."""
AFTER_ITS_END = "  after its last line: it waited there for its threads to end"
"""Logged for a program whose main thread has ended while others run."""
_WAITS_FOR_THREADS = re.compile(r'^  File ".*", line [0-9]+ in _wait_for_threads$')
"""What the dump says then, of the code that started the program."""
ANOTHER_THREAD = "Beside it, another thread was here:\n"
_THREAD = re.compile(r"^(?P<current>Current thread|Thread) 0x[0-9a-f]+ ")
_CURRENT = "Current thread"
_MAX_DUMP_BYTES = 32_768
_CHUNK = 1 << 16
_BINARY = getattr(os, "O_BINARY", 0)


class ProgramLog:
    """A file to which the match appends its own lines and what the program printed.

    The program never has this file open: it writes into an unnamed one (``fd``), from which everything is copied. So
    it can neither find the record through its output nor truncate, overwrite or lock the log, and nothing that it does
    to its file (seeking, a hole of a terabyte) has an effect elsewhere.
    """

    def __init__(self, path: Path, most_bytes: int, temporary: Path) -> None:
        """Open it, at its end; its folder is made if it is not there.

        So many bytes of the program's output are taken over; the file that the program writes into is in ``temporary``.

        Raises:
            OSError: it cannot be written.
        """
        path.parent.mkdir(parents=True, exist_ok=True)
        self._log_fd = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_APPEND | _BINARY, 0o644)
        try:
            self.fd, name = tempfile.mkstemp(prefix="output-", dir=temporary)
        except OSError:
            os.close(self._log_fd)
            raise
        self._output_path = Path(name)
        self._output_fd = os.open(name, os.O_RDONLY | _BINARY)  # reads at a place of its own
        if sys.platform != "win32":
            self._output_path.unlink()
        self.written_bytes = 0
        self._path = path
        self._most_bytes = most_bytes
        self._taken_bytes = 0
        self._at = self._seen_bytes = 0
        self._shown = self._size_bytes()
        self._decoder = codecs.getincrementaldecoder("utf-8")("replace")

    def output_bytes(self) -> int:
        """Return the size of the output when that was last taken over; 0 when closed."""
        if self.fd < 0:
            return 0
        return self._taken_bytes + max(0, self._seen_bytes - self._at)

    def take_over(self) -> None:
        """Copy what the program has printed since. A full disk does not stop a match."""
        if self.fd < 0:
            return
        size = self._seen_bytes = os.fstat(self._output_fd).st_size
        if size == self._at:  # as nearly always: it has printed nothing
            return
        if size < self._at:
            self._at = 0  # it has cut its file
        os.lseek(self._output_fd, self._at, os.SEEK_SET)
        while (room := self._most_bytes - self._taken_bytes) > 0:
            chunk = os.read(self._output_fd, min(room, _CHUNK))
            if not chunk:
                return
            self._at += len(chunk)
            self._taken_bytes += len(chunk)
            self._write(chunk)

    def append(self, text: str) -> None:
        """Append text of the match's own, after what the program printed until now."""
        self.take_over()
        self._write(text.encode("utf-8", "replace"))

    def new_text(self) -> str:
        """Return the text appended since the last call; also after it is closed."""
        self.take_over()
        if self.fd >= 0 and self._size_bytes() == self._shown:
            return ""
        chunk = self._from(self._shown)
        self._shown += len(chunk)
        return self._decoder.decode(chunk)

    def take_dump(self, folder: Path) -> str:
        """Take the interpreter's dump of a dying process from the end; return its lines about files in ``folder``."""
        self.take_over()
        size = self._size_bytes()
        tail = self._from(max(0, size - _MAX_DUMP_BYTES))
        at = _place_of_dump(tail)
        if at < 0:
            return ""
        os.ftruncate(self._log_fd, size - len(tail) + at)
        escaped = str(folder).encode("ascii", "backslashreplace").decode()
        before = f'  File "{escaped}{os.sep}'
        lines = tail[at:].decode("utf-8", "replace").splitlines()
        lines_shown = list[str]()
        for thread in _threads_of_dump(lines):
            own = [line.removeprefix(before).partition('"') for line in thread if line.startswith(before)]
            if own and lines_shown:
                lines_shown.append(ANOTHER_THREAD)
            lines_shown += [f'  File "{path.replace(os.sep, "/")}"{place}\n' for path, _, place in own]
        if any(_WAITS_FOR_THREADS.match(line) for line in lines if not line.startswith(before)):
            lines_shown.append(f"{AFTER_ITS_END}\n")
        return "".join(lines_shown)

    def close(self) -> None:
        """Take over what is left, and close it."""
        if self.fd < 0:
            return
        self.take_over()
        for fd in (self.fd, self._output_fd, self._log_fd):
            os.close(fd)
        self.fd = -1
        if sys.platform == "win32":
            with contextlib.suppress(OSError):
                self._output_path.unlink()

    def _from(self, at: int) -> bytes:
        """Return what is in the log from a place on; nothing if it cannot be read."""
        with contextlib.suppress(OSError), self._path.open("rb") as file:
            file.seek(at)
            return file.read()
        return b""

    def _size_bytes(self) -> int:
        return os.fstat(self._log_fd).st_size

    def _write(self, data: bytes) -> None:
        self.written_bytes += len(data)
        with contextlib.suppress(OSError):
            os.write(self._log_fd, data)


def _place_of_dump(tail: bytes) -> int:
    """Return the place of a dying interpreter's dump in the end of a log; -1: there is none."""
    at = tail.rfind(_DUMP_BEGINS)
    if at < 0 and (of_windows := _DUMP_OF_WINDOWS.search(tail)):
        return of_windows.start()
    return at


def _threads_of_dump(lines: list[str]) -> list[list[str]]:
    """Return the lines of each thread: of the current one first, then of the oldest, which began the program.

    A dump begins with the newest. The current thread broke the interpreter, or received the match's signal.
    """
    threads, current = [list[str]()], -1
    for line in lines:
        if begins := _THREAD.match(line):
            if begins["current"] == _CURRENT:
                current = len(threads)
            threads.append([])
        threads[-1].append(line)
    first = [threads.pop(current)] if current > 0 else []
    return first + threads[::-1]
