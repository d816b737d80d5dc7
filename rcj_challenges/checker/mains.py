"""Which file of a submission starts the others: the one that no other imports and that meets the robot."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import PurePosixPath

HIDDEN_ENDING = ".py.txt"
"""What an editor of Windows makes of ``.py``, and shows as ``.py``."""

_LOOKED_AT_BYTES = 16_384
"""Imports stand at the top of a file; there may be very many long ones."""

_IMPORT = re.compile(rb"^[ \t]*(?:from|import)[ \t]+([^\r\n#]{1,500})", re.MULTILINE)
_COMMENT = re.compile(rb"#[^\r\n]*")
_FROM_WHERE = re.compile(rb"^[ \t]*(?:from[ \t]|import[ \t]|sys\.path\.append|sys\.path\.insert)[^\r\n]*", re.MULTILINE)
_WORD = re.compile(rb"[\w\x80-\xff]+")
_ROBOT = re.compile(rb"\bcontroller\b|\bRobot\b")
# What is called so was meant for a place that some scenario names: its name says more than that it is alone.
_OF_ANOTHER_PLACE = re.compile(r"rcj_soccer_|score_goal|pass_ball|robot_?\d", re.IGNORECASE)

_TO_COME_THERE = frozenset(
    {b"import", b"from", b"as", b"sys", b"path", b"os", b"pathlib", b"Path", b"append", b"insert"}
)


@dataclass(frozen=True)
class Roles:
    """What the files of a submission are to each other. Files are told by their contents, for they may be moved.

    Attributes:
        libraries: those that others import, as far as their lines show.
        main: the only one that no other imports and that meets the robot, or imports others that may, and whose place
            is none that some scenario names; None if there is none, or more than one.
        main_of_a_place: likewise, but only its name is none of those: in the right folder it is meant.
    """

    libraries: frozenset[bytes]
    main: bytes | None = None
    main_of_a_place: bytes | None = None


def roles_of(files: Mapping[PurePosixPath, bytes]) -> Roles:
    """Find out what the Python files of a submission are to each other."""
    words = {path: frozenset(_words(content)) for path, content in files.items() if _is_python(path)}
    importers = Counter(word for theirs in words.values() for word in theirs)
    beside = Counter((path.parent, word) for path, theirs in words.items() for word in theirs)
    called = {path: _imported_as(path) for path in words}
    libraries = {
        path
        for path, name in called.items()
        if (beside[path.parent, name] if _gives_its_folder_the_name(path) else importers[name]) > (name in words[path])
    }
    names = {called[path] for path in libraries}
    mains = [
        path
        for path in words.keys() - libraries
        if not _OF_ANOTHER_PLACE.search(path.name)
        and (_ROBOT.search(files[path], 0, _LOOKED_AT_BYTES) or not names.isdisjoint(words[path]))
    ]
    elsewhere = [path for path in mains if not _OF_ANOTHER_PLACE.search(str(path))]
    return Roles(
        frozenset(files[path] for path in libraries),
        files[elsewhere[0]] if len(elsewhere) == 1 else None,
        files[mains[0]] if len(mains) == 1 else None,
    )


def reached_from(entry: PurePosixPath, files: Mapping[PurePosixPath, bytes]) -> list[PurePosixPath]:
    """Return a program and all files that it may import, itself or through others; itself first."""
    called: dict[bytes, list[PurePosixPath]] = {}
    for path in files:
        if _is_python(path):
            called.setdefault(_imported_as(path), []).append(path)
    reached = [entry] if entry in files else []
    for path in reached:
        for word in _words(files[path]):
            reached += [other for other in called.pop(word, ()) if other != entry]
    return reached


def what_it_does(content: bytes) -> bytes:
    """Return what can tell two programs apart, roughly: without comments and white space.

    Of imports only what is imported counts, and not from which program's folder: in 2021 all lay in that of the first.
    """
    code = _COMMENT.sub(b"", content)
    wanted = {word for line in _IMPORT.findall(code) for word in _WORD.findall(line)}
    named = sorted(
        word for word in wanted - _TO_COME_THERE if not _OF_ANOTHER_PLACE.search(word.decode("utf-8", "replace"))
    )
    return b" ".join([*_FROM_WHERE.sub(b"", code).split(), *named])


def _is_python(path: PurePosixPath) -> bool:
    """Whether it is a Python file, and no test of others."""
    if path.name.startswith(("test_", "tests_")):
        return False
    return path.suffix.casefold() == ".py" or path.name.casefold().endswith(HIDDEN_ENDING)


def _imported_as(path: PurePosixPath) -> bytes:
    """Return the last part of the name by which others import a file."""
    return (path.parent.name if path.stem == "__init__" else path.stem).encode("utf-8", "surrogateescape")


def _gives_its_folder_the_name(path: PurePosixPath) -> bool:
    """Whether others that import by its name mean its folder: ``from rcj_soccer_player_b1 import …``, as in 2021."""
    return path.stem == path.parent.name and _OF_ANOTHER_PLACE.search(path.name) is not None


def _words(content: bytes) -> list[bytes]:
    """Return all words of the lines that import something."""
    return [word for line in _IMPORT.findall(content, 0, _LOOKED_AT_BYTES) for word in _WORD.findall(line)]
