"""What a program prints: counted, capped, UTF-8 whatever it prints."""

from __future__ import annotations

import io
import os
import sys

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any


class Output:
    """Standard output and error, both into the program's log, counted together."""

    def __init__(self, limit_bytes: int, on_flood: Callable[[], None], names: list[tuple[str, str]]) -> None:
        """Take the place of the program's streams.

        ``names`` are folders of this computer and their replacements in the log: warnings, tracebacks and the program's
        own messages show paths as in the submission, the same in every match.
        """
        self.printed_bytes = 0
        self._names = [(os.fsencode(path), os.fsencode(short)) for path, short in names]
        self.limit_bytes = limit_bytes
        self.on_flood = on_flood
        sys.stdout = self._stream(1)
        sys.stderr = self._stream(2)
        for name in ("stdout", "stderr"):
            setattr(sys, f"__{name}__", getattr(sys, name))

    def with_short_paths(self, data: bytes | memoryview) -> bytes | memoryview:
        """Return printed text with short names of folders."""
        text = bytes(data)
        for path, short in self._names:
            if path in text:
                text = data = text.replace(path, short)
        return data

    def _stream(self, fd: int) -> io.TextIOWrapper:
        # Straight onto the file, as `python -u` does: a line is in the log as soon as it is printed, whatever follows.
        raw: Any = _CountedFile(fd, self)
        # A line ends alike on all systems, so that a program is stopped for its output at the same tick on each.
        return io.TextIOWrapper(raw, encoding="utf-8", errors="backslashreplace", newline="\n", line_buffering=True)


class _CountedFile(io.FileIO):
    """A file descriptor that counts what is written to it."""

    def __init__(self, fd: int, output: Output) -> None:
        super().__init__(fd, "w", closefd=False)
        self._output = output

    def write(self, data: Any, /) -> int:
        output, given = self._output, memoryview(data).cast("B")
        view = output.with_short_paths(given)
        size, room = len(view), output.limit_bytes - output.printed_bytes
        output.printed_bytes += size
        if room < size:
            super().write(view[: max(room, 0)])
            output.on_flood()  # this ends the program, and no `except` of it can help
        at = 0
        while at < size:
            at += super().write(view[at:]) or 0
        return len(given)
