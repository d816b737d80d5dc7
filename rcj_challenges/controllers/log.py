"""The log of one program: what it printed, and the match's own lines about it."""

from __future__ import annotations

import codecs
import contextlib
import os
from pathlib import Path

_DUMP_BEGINS = b"Fatal Python error:"
_MOST_DUMP_BYTES = 32_768
_BINARY = getattr(os, "O_BINARY", 0)


class ProgramLog:
    """A file that the program and the match append to.

    Attributes:
        fd: for the program's output; -1 when closed.
    """

    def __init__(self, path: Path) -> None:
        """Open it, at its end.

        Raises:
            OSError: it cannot be written.
        """
        path.parent.mkdir(parents=True, exist_ok=True)
        self.fd = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_APPEND | _BINARY, 0o644)
        self._path = path
        self._shown = self.size_bytes()
        self._decoder = codecs.getincrementaldecoder("utf-8")("replace")

    def size_bytes(self) -> int:
        """Return its size; 0 when closed."""
        return os.fstat(self.fd).st_size if self.fd >= 0 else 0

    def append(self, text: str) -> None:
        """Append text of the match's own. A full disk is no reason to stop a match."""
        with contextlib.suppress(OSError):
            os.write(self.fd, text.encode("utf-8", "replace"))

    def new_text(self) -> str:
        """Return what was appended since the last call; also after it is closed."""
        if self.fd >= 0 and self.size_bytes() == self._shown:
            return ""
        try:
            with self._path.open("rb") as file:
                file.seek(self._shown)
                chunk = file.read()
        except OSError:
            return ""
        self._shown += len(chunk)
        return self._decoder.decode(chunk)

    def take_dump(self, folder: Path) -> str:
        """Take the interpreter's dump of a dying process from the end; return its lines about files in ``folder``.

        Args:
            folder: of the program's files; paths are told relative to it.
        """
        size = self.size_bytes()
        try:
            with self._path.open("rb") as file:
                file.seek(max(0, size - _MOST_DUMP_BYTES))
                tail = file.read()
        except OSError:
            return ""
        at = tail.rfind(_DUMP_BEGINS)
        if at < 0:
            return ""
        os.ftruncate(self.fd, size - len(tail) + at)
        inside = str(folder) + os.sep
        lines = tail[at:].decode("utf-8", "replace").splitlines()
        return "".join(line.replace(inside, "") + "\n" for line in lines if line.startswith(f'  File "{inside}'))

    def close(self) -> None:
        """Close it."""
        if self.fd >= 0:
            os.close(self.fd)
            self.fd = -1
