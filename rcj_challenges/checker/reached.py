"""Finds the files of a submission that a program may import."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import PurePosixPath

_MAX_BYTES = 16_384
"""Imports stand at the top of a file."""

_IMPORT = re.compile(rb"^[ \t]*(?:from|import)[ \t]+([^\r\n#]{1,500})", re.MULTILINE)
_WORD = re.compile(rb"[\w\x80-\xff]+")


def reached_from(entry: PurePosixPath, files: Mapping[PurePosixPath, bytes]) -> list[PurePosixPath]:
    """Return a program and all files that it may import, itself or through others; itself first."""
    importable: dict[bytes, list[PurePosixPath]] = {}
    for path in files:
        if path.suffix == ".py":
            name = path.parent.name if path.stem == "__init__" else path.stem
            importable.setdefault(name.encode("utf-8", "surrogateescape"), []).append(path)
    reached = [entry] if entry in files else []
    for path in reached:
        for word in imported_words(files[path]):
            reached += [other for other in importable.pop(word, ()) if other != entry]
    return reached


def imported_words(content: bytes) -> list[bytes]:
    """Return all words of the lines of a program that import something, in order."""
    return [word for line in _IMPORT.findall(content, 0, _MAX_BYTES) for word in _WORD.findall(line)]
