"""A folder of files that is replaced as a whole: readers see the old one or the new one, never a mixture.

What has not changed since the last time is linked from the old folder instead of being made again.
"""

from __future__ import annotations

import hashlib
import json
import os
import shutil
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path, PurePosixPath
from typing import Any, Self

from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.records.folder import when_free
from rcj_challenges.tournament.codes import FOLDER_IN_THE_WAY

_MANIFEST = ".made_from.json"


def fingerprint(value: Any) -> str:
    """Return a hash of JSON-able data."""
    return hashlib.sha256(json.dumps(value, sort_keys=True, default=str).encode()).hexdigest()


class Tree:
    """Builds a folder beside its target and swaps the two at the end; a context manager.

    If the block fails, the target, which need not exist, stays as it was. ``reused`` counts the folders that were taken
    from before.

    Raises:
        DiagnosticError: there is something else in the target.
    """

    def __init__(self, target: Path) -> None:
        if target.exists() and not _is_ours(target):
            message = (
                f"{sanitize(target)} is in the way: it was not made by 'tournament publish', so it is not replaced"
            )
            help_ = "move it elsewhere, or give another folder with --data"
            raise DiagnosticError(Diagnostic(FOLDER_IN_THE_WAY, message, help_))
        self.target = target
        self.reused = 0
        self._new = target.with_name(f".{target.name}.new")
        self._old = target.with_name(f".{target.name}.old")
        self._manifest: dict[str, str] = {}
        self._known: dict[str, str] = {}

    def __enter__(self) -> Self:
        for left_over in (self._new, self._old):  # of one that was killed
            shutil.rmtree(left_over, ignore_errors=True)
        self._new.mkdir(parents=True)
        with suppress(OSError, ValueError):
            known = json.loads((self.target / _MANIFEST).read_text("utf-8"))
            self._known = known if isinstance(known, dict) else {}
        return self

    def __exit__(self, kind: object, error: object, trace: object) -> None:
        if error is not None:
            shutil.rmtree(self._new, ignore_errors=True)
            return
        (self._new / _MANIFEST).write_text(json.dumps(self._manifest, indent=0, sort_keys=True), "utf-8")
        if self.target.exists():
            when_free(lambda: self.target.replace(self._old))
        try:
            when_free(lambda: self._new.replace(self.target))
        except OSError:
            if self._old.exists():
                self._old.replace(self.target)
            raise
        shutil.rmtree(self._old, ignore_errors=True)

    @property
    def folders_before(self) -> int:
        """Number of folders of the target the last time (see `folder`)."""
        return len(self._known)

    def write(self, path: str, content: str | bytes) -> None:
        """Write one file; one whose content is the same as before keeps its time, so that uploads skip it."""
        # Half of a surrogate pair in a name must not stop the whole site.
        data = content.encode("utf-8", "replace") if isinstance(content, str) else content
        before, place = self.target / path, self._place(path)
        with suppress(OSError):
            if before.stat().st_size == len(data) and before.read_bytes() == data:
                _link(before, place)
                return
        place.write_bytes(data)

    def copy(self, source: Path, path: str) -> None:
        """Copy one file."""
        shutil.copyfile(source, self._place(path))

    def folder(self, path: str, made_from: str, make: Callable[[], None]) -> None:
        """Fill a folder, or take the one from before if the hash of all that decides its content is the same."""
        self._manifest[path] = made_from
        before = self.target / path
        if self._known.get(path) == made_from and before.is_dir():
            for file in sorted(before.rglob("*")):
                if file.is_file():
                    _link(file, self._place((PurePosixPath(path) / file.relative_to(before).as_posix()).as_posix()))
            self.reused += 1
        else:
            make()

    def listed(self, path: str) -> list[str]:
        """Return the names of the files that are in a folder by now."""
        folder = self._new / path
        return sorted(file.name for file in folder.iterdir()) if folder.is_dir() else []

    def _place(self, path: str) -> Path:
        place = self._new / path
        place.parent.mkdir(parents=True, exist_ok=True)
        return place


def _is_ours(folder: Path) -> bool:
    return folder.is_dir() and ((folder / _MANIFEST).is_file() or not any(folder.iterdir()))


def _link(before: Path, place: Path) -> None:
    try:
        os.link(before, place)
    except OSError:  # a file system without hard links
        shutil.copy2(before, place)
