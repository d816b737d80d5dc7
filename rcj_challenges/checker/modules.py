"""Resolves imports: which file of the submission, Python itself, what is installed for programs, or nowhere.

The same places in the same order as `controllers` gives a program: its own folder, the folder above (which holds all of
a team's programs), Python's library, then numpy and scipy. A program that changes ``sys.path`` may find modules in any
of its folders; then only running it can show where they are.
"""

from __future__ import annotations

import importlib.util
import sys
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import islice
from pathlib import PurePosixPath

from rcj_challenges.checker.renaming import HIDDEN_ENDING

INSTALLED = ("numpy", "scipy", "controller")
"""What a program can import beside Python's own library (reference, sections 4.3 and 7)."""

WELL_KNOWN = frozenset(
    {
        *("cv2", "cvxpy", "gym", "gymnasium", "jax", "keras", "matplotlib", "numba", "onnxruntime", "pandas", "PIL"),
        *("psutil", "pydantic", "pygame", "pymunk", "PyQt5", "PyQt6", "PySide6", "pylab", "rclpy", "requests", "rospy"),
        *("seaborn", "serial", "shapely", "skimage", "sklearn", "stable_baselines3", "tensorflow", "tflite_runtime"),
        *("torch", "torchvision", "ultralytics", "websockets", "win32api", "zmq"),
    }
)
"""Libraries that no match has, and that no file beside a program replaces: compiled, or for what a match refuses."""

_TOP = PurePosixPath()
_ALL_PROGRAMS = "controllers"
"""Name of the folder with all of a team's programs, as in the original: `Robot.getProjectPath`."""
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
        is_everywhere: whether these may be any folders, also the one that holds all programs.
    """

    def __init__(
        self, files: Iterable[PurePosixPath], places: Sequence[PurePosixPath], *, is_everywhere: bool = False
    ) -> None:
        self._files = frozenset(files)
        self._folders = frozenset(parent for path in self._files for parent in path.parents)
        self._compiled = frozenset(
            path.parent / path.name.partition(".")[0] for path in self._files if path.suffix in COMPILED
        )
        self.places = tuple(dict.fromkeys(places))
        self._is_everywhere = is_everywhere
        self._found: dict[str, list[Module]] = {}

    @cached_property
    def _places_with(self) -> Mapping[str, list[PurePosixPath]]:
        """By name, the places in which something is called so, in order: there may be a thousand places."""
        rank = {place: number for number, place in enumerate(self.places)}
        named: dict[str, set[PurePosixPath]] = {}
        for path in (*self._files, *self._folders, *self._compiled):
            if path.parent in rank:
                named.setdefault(path.name.partition(".")[0], set()).add(path.parent)
        return {name: sorted(places, key=rank.__getitem__) for name, places in named.items()}

    def everywhere(self) -> Library:
        """Return the library of a program that changes ``sys.path``: all folders, the usual ones first."""
        return Library(self._files, (*self.places, *sorted(self._folders)), is_everywhere=True)

    def tops(self, name: str) -> list[Module]:
        """Return what ``import name`` can find in the submission, before Python's own modules: the first counts."""
        if name not in self._found:
            found = (self.inside(place, name, namespace=False) for place in self._places_with.get(name, ()))
            self._found[name] = list(islice(filter(None, found), _MAX_OF_A_NAME))
        return list(self._found[name])

    def has(self, module: Module, parts: Sequence[str]) -> bool:
        """Return whether there are all of ``module.part.part``."""
        for part in parts:
            inner = self.inside(module.folder, part) if module.folder is not None else None
            if inner is None:
                return False
            module = inner
        return True

    def top_namespace(self, name: str) -> Module | None:
        """Return the folder without ``__init__.py`` that ``import name`` finds when nothing else is of that name."""
        places = self._places_with.get(name, ())
        found = next((Module(place / name, None) for place in places if place / name in self._folders), None)
        return Module(_TOP, None) if found is None and name == _ALL_PROGRAMS and self._is_everywhere else found

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

    def names(self) -> list[str]:
        """Return the names that could be imported from the usual places."""
        found = [path.stem for path in self._files if path.suffix == ".py" and path.parent in self.places]
        found += [folder.name for folder in self._folders if folder.parent in self.places and folder != _TOP]
        return sorted({name for name in found if name.isidentifier()})

    def lies_at(self, name: str) -> PurePosixPath | None:
        """Return where a module of this name lies, if anywhere in the submission."""
        wanted = (f"{name}.py", f"{name}/__init__.py")
        places = (folder / file for folder in sorted(self._folders, key=str) for file in wanted)
        return next((place for place in places if place in self._files), None)

    def hidden(self, name: str) -> PurePosixPath | None:
        """Return the file that is a module of this name but for an ending that Windows does not show."""
        places = (place / f"{name}{HIDDEN_ENDING}" for place in self.places)
        return next((path for path in places if path in self._files), None)

    def shadows(self) -> list[PurePosixPath]:
        """Return the files that hide a module of Python's library, numpy or scipy from the program."""
        hidden = (sys.stdlib_module_names | {"numpy", "scipy"}) - set(sys.builtin_module_names)
        inside = (path for path in self._files if path.suffix == ".py" and path.parent in self.places)
        return sorted(path for path in inside if path.stem in hidden)


def places_of(entry: PurePosixPath) -> tuple[PurePosixPath, ...]:
    """Return the folders from which a program can import by default: its own, and the one above."""
    own = entry.parent
    return (own,) if own == _TOP else (own, own.parent)


def is_pythons(name: str) -> bool:
    """Return whether a top-level module is part of Python."""
    return name in sys.stdlib_module_names


def is_here(name: str) -> bool:
    """Return whether this computer has a module of Python's library (``msvcrt`` is on Windows only)."""
    if name in sys.builtin_module_names or name in sys.modules:
        return True
    try:
        return importlib.util.find_spec(name) is not None
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
"""What of them a match does not refuse."""


def refused_use(module: str, names: Sequence[str]) -> str:
    """Return what a module is for, if its use is refused in a match; else nothing."""
    asked = [f"{module}.{name}" for name in names]
    if module in _OF_THREADS or (asked and _OF_THREADS.issuperset(asked)):
        return ""
    for dotted in (module, *asked):
        parts = dotted.split(".")
        for length in range(1, len(parts) + 1):
            use = REFUSED.get(".".join(parts[:length]))
            if use:
                return use
    return ""
