"""Resolves imports: which file of the submission, Python itself, what is installed for programs, or nowhere.

The same places in the same order as `programs` gives a program: its own folder, the folder above (which holds all of
a team's programs), Python's library, then numpy and scipy. A program that changes ``sys.path`` may find modules in any
of its folders; then only running it can show where they are.
"""

from __future__ import annotations

import importlib.util
import sys
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from importlib.machinery import BuiltinImporter, FrozenImporter
from itertools import islice
from pathlib import PurePosixPath

from rcj_challenges.checker.renaming import HIDDEN_ENDING

INSTALLED = ("numpy", "scipy", "controller")
"""What a program can import beside Python's own library (reference, sections 4.3 and 7)."""

_TOP = PurePosixPath()
COMPILED = frozenset({".so", ".pyd"})
_MAX_OF_A_NAME = 20
"""Modules of one name that are looked at, where a program may find them in any folder."""


@dataclass(frozen=True)
class Module:
    """A module of the submission.

    Attributes:
        folder: of a package, where its parts are; None for a single file.
        file: that is run when it is imported; None for a folder without ``__init__.py``, or for compiled code.
    """

    folder: PurePosixPath | None
    file: PurePosixPath | None


class Library:
    """The modules of a submission, for a program whose imports are looked for in certain folders.

    Args:
        files: paths of all files.
        places: folders in which imports are looked for, in order.
    """

    def __init__(self, files: Iterable[PurePosixPath], places: Sequence[PurePosixPath]) -> None:
        self._files = frozenset(files)
        self._folders = frozenset(parent for path in self._files for parent in path.parents)
        self._compiled = frozenset(
            path.parent / path.name.partition(".")[0] for path in self._files if path.suffix in COMPILED
        )
        self.places = tuple(dict.fromkeys(places))

    @cached_property
    def _places_with(self) -> Mapping[str, list[PurePosixPath]]:
        """By name, the places in which something is called so, in order: there may be a thousand places."""
        rank = {place: number for number, place in enumerate(self.places)}
        named: dict[str, set[PurePosixPath]] = {}
        for path in (*self._files, *self._folders, *self._compiled):
            if path.parent in rank:
                named.setdefault(path.name.partition(".")[0], set()).add(path.parent)
        return {name: sorted(places, key=rank.__getitem__) for name, places in named.items()}

    @cached_property
    def names(self) -> list[str]:
        """The names that could be imported from the places."""
        modules = (
            name for name, places in self._places_with.items() if any(self.inside(place, name) for place in places)
        )
        return sorted(filter(str.isidentifier, modules))

    def everywhere(self) -> Library:
        """Return the library of a program that changes ``sys.path``: all folders, the usual ones first."""
        return Library(self._files, (*self.places, *sorted(self._folders)))

    def top(self, name: str, parts: Sequence[str] = ()) -> Module | None:
        """The module that ``import name`` finds in the submission, before Python's own.

        Args:
            name: of the module.
            parts: asked for in it, one in the other: of several modules, the first that has all of them is taken.
        """
        found = (self.inside(place, name, namespace=False) for place in self._places_with.get(name, ()))
        modules = list(islice(filter(None, found), _MAX_OF_A_NAME))
        return next((module for module in modules if self._has(module, parts)), modules[0] if modules else None)

    def _has(self, module: Module, parts: Sequence[str]) -> bool:
        for part in parts:
            inner = self.inside(module.folder, part) if module.folder is not None else None
            if inner is None:
                return False
            module = inner
        return True

    def top_namespace(self, name: str) -> Module | None:
        """Return the folder without ``__init__.py`` that ``import name`` finds when nothing else is of that name."""
        places = (place / name for place in self._places_with.get(name, ()))
        return next((Module(folder, None) for folder in places if folder in self._folders), None)

    def inside(self, folder: PurePosixPath, name: str, *, namespace: bool = True) -> Module | None:
        """Return a module of a folder."""
        inner = folder / name
        if inner / "__init__.py" in self._files:
            return Module(inner, inner / "__init__.py")
        single = folder / f"{name}.py"
        if single in self._files:
            return Module(None, single)
        if inner in self._compiled:
            return Module(None, None)
        return Module(inner, None) if namespace and inner in self._folders else None

    def lies_at(self, name: str) -> PurePosixPath | None:
        """Return where a module of this name lies, if anywhere in the submission."""
        wanted = (f"{name}.py", f"{name}/__init__.py")
        places = (folder / file for folder in sorted(self._folders, key=str) for file in wanted)
        return next((place for place in places if place in self._files), None)

    def hidden(self, name: str) -> PurePosixPath | None:
        """Return the file that is a module of this name but for an ending that Windows does not show."""
        places = (place / f"{name}{HIDDEN_ENDING}" for place in self.places)
        return next((path for path in places if path in self._files), None)

    def named_like_pythons(self) -> list[PurePosixPath]:
        """Return the files with the name of a module of Python's library, numpy, scipy or the match."""
        taken = sys.stdlib_module_names | set(INSTALLED)
        return sorted(
            module.file
            for name in self.names
            if name in taken and (module := self.top(name)) is not None and module.file is not None
        )


def places_of(entry: PurePosixPath) -> tuple[PurePosixPath, ...]:
    """Return the folders from which a program can import by default: its own, and the one above."""
    own = entry.parent
    return (own,) if own == _TOP else (own, own.parent)


def is_always_pythons(name: str) -> bool:
    """Return whether a module is part of the interpreter (or of the match): no file of a team can replace it."""
    found = BuiltinImporter.find_spec(name) or FrozenImporter.find_spec(name)
    return name in ("__main__", "controller") or found is not None


def is_here(name: str) -> bool:
    """Return whether this computer has a module of Python's library (``msvcrt`` is on Windows only)."""
    try:
        return name in sys.modules or importlib.util.find_spec(name) is not None
    except (ImportError, ValueError):
        return False


REFUSED: Mapping[str, str] = {
    **dict.fromkeys(
        (
            "socket", "ssl", "socketserver", "http.client", "http.server", "urllib.request", "ftplib", "imaplib",
            "poplib", "smtplib", "telnetlib", "nntplib", "xmlrpc", "wsgiref",
        ),
        "the network",
    ),
    **dict.fromkeys(
        ("subprocess", "multiprocessing", "concurrent.futures.process", "pty", "webbrowser", "antigravity"),
        "other programs",
    ),
    **dict.fromkeys(("tkinter", "turtle", "curses"), "windows on the screen"),
}  # fmt: skip
"""Modules that can be imported, but whose use a match refuses, and what they are for."""


_OF_THREADS = frozenset({"multiprocessing.dummy", "multiprocessing.pool.ThreadPool"})
"""The parts of refused modules that a match allows."""


def refused_use(module: str, names: Sequence[str]) -> str:
    """The purpose of a module whose use is refused in a match; else nothing."""
    asked = [f"{module}.{name}" for name in names]
    if module in _OF_THREADS or (asked and _OF_THREADS.issuperset(asked)):
        return ""
    for dotted in (module, *asked):
        parts = dotted.split(".")
        prefixes = (".".join(parts[:length]) for length in range(1, len(parts) + 1))
        if use := next(filter(None, map(REFUSED.get, prefixes)), None):
            return use
    return ""
