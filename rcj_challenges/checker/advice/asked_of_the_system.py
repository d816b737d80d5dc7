"""Files that a program did not find or may not write, and what else of the computer it was refused."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import PurePosixPath, PureWindowsPath

from rcj_challenges.checker.advice.crash_lines import unquoted
from rcj_challenges.checker.modules import REFUSED
from rcj_challenges.facts.shown import shown

_MOST_LETTERS = 300  # of a path that is looked for
_PATH = rf"""(?P<path>'(?:[^'\\]|\\.){{1,{_MOST_LETTERS}}}'|"(?:[^"\\]|\\.){{1,{_MOST_LETTERS}}}")"""
_NOT_FOUND = re.compile(rf"^FileNotFoundError: \[Errno 2\] No such file or directory: {_PATH}")
_REFUSED = re.compile(
    r"^(?:PermissionError: \[Errno 1\] Operation not permitted|PermissionError: \[Errno 13\] Permission denied"
    rf"|OSError: \[Errno 30\] Read-only file system)(?:: {_PATH})?"
)
_OF_THE_SYSTEM = ("dev", "proc", "sys")  # nobody keeps a log there
_OPENED_TO_WRITE = re.compile(rb"""open\(.{1,120},\s{0,4}(?:mode\s{0,4}=\s{0,4})?["'][wax]""")
_IMPORT = re.compile(rb"^[ \t]*(?:import|from)[ \t]+([\w., \t]{1,200})", re.MULTILINE)
_WITHOUT_PROCESSES = (
    "a match refuses to start other programs: do without; what multiprocessing was to do, threads can do as well "
    "(concurrent.futures.ThreadPoolExecutor)"
)
_WITHOUT_NETWORK = "a match refuses the network: do without it; robots of a team talk by the team emitter"
_WITHOUT = "a match refuses what reaches beyond the program, as other programs and the network do: do without it"


def on_system(detail: str, entry: PurePosixPath, files: Mapping[PurePosixPath, bytes]) -> str:
    """Return what to do about a crash over a file, or over what a match refuses; nothing if that is not the reason.

    Args:
        detail: the last line of what the program told of its end.
        entry: the file that was started; its folder is the current one.
        files: of the team.
    """
    if (found := _NOT_FOUND.match(detail)) is not None:
        return _on_missing(unquoted(found["path"]), entry.parent, files)
    if (found := _REFUSED.match(detail)) is None:
        return ""
    path = unquoted(found["path"]) if found["path"] else ""
    parts = PurePosixPath(path).parts
    if not path or (parts[1:2] and parts[1] in _OF_THE_SYSTEM):
        return _on_refused(files)
    name = shown(PureWindowsPath(path).name)
    return (
        f'a program may write only into its own folder, which is the current one: write "{name}" without a folder. '
        "The file is gone after the half: what you want to read then, print"
    )


def _on_missing(asked: str, current: PurePosixPath, files: Mapping[PurePosixPath, bytes]) -> str:
    """Tell where a file lies that was looked for elsewhere; or that there is none of its name."""
    windows = PureWindowsPath(asked)
    wanted = PurePosixPath(windows.as_posix())
    is_absolute = bool(windows.drive) or wanted.is_absolute()
    place = _place(wanted, current, files)
    if place is None:
        return _on_nowhere(wanted, current, files, is_absolute=is_absolute)
    way = shown(_way(place, current))
    if is_absolute:
        return f'write "{way}": {shown(asked)} is a place on your own computer'
    if place == current / wanted:
        return f'write "{way}": only on Windows a backslash parts folders'
    if place not in (wanted, current / wanted) and _is_but_for_case(place, wanted, current):
        return f'write "{way}": capital and small letters count; on Windows and macOS the mistake does not show'
    return f'write "{way}": the file is {shown(place)}, and the current folder is {_named(current)}'


def _place(wanted: PurePosixPath, current: PurePosixPath, files: Mapping[PurePosixPath, bytes]) -> PurePosixPath | None:
    """Return the file that was meant: at that place but for capital letters; else one of that name anywhere."""
    near = [path for path in files if path.name.casefold() == wanted.name.casefold()]

    def order(path: PurePosixPath) -> tuple[bool, bool, str]:
        return not _is_but_for_case(path, wanted, current), path.parent != current, str(path)

    return min(near, key=order, default=None)


def _is_but_for_case(place: PurePosixPath, wanted: PurePosixPath, current: PurePosixPath) -> bool:
    """Return whether a file lies where it was looked for; reports name files as they lie in the submission, too."""
    return str(place).casefold() in (str(wanted).casefold(), str(current / wanted).casefold())


def _on_nowhere(
    wanted: PurePosixPath, current: PurePosixPath, files: Mapping[PurePosixPath, bytes], *, is_absolute: bool
) -> str:
    name = shown(wanted.name)
    if is_absolute:
        return f'that is a place on your own computer: put {name} into {_named(current)}, and open it as "{name}"'
    if wanted.parent != PurePosixPath() and _writes(wanted, files):
        folder = shown(wanted.parent)
        return f'there is no folder {folder} to write into: make it first, os.makedirs("{folder}", exist_ok=True)'
    # What is beside the program by its `__file__` is named in reports as it would lie in the submission.
    inside = wanted.relative_to(current) if wanted.is_relative_to(current) else wanted
    return f"{shown(inside)} was not handed in: put it into {_named(current / inside.parent)}, or do without it"


def _writes(wanted: PurePosixPath, files: Mapping[PurePosixPath, bytes]) -> bool:
    """Return whether a line opens a file to write it and names this one."""
    name = wanted.name.encode()
    lines = (line for path, content in files.items() if path.suffix == ".py" for line in content.splitlines())
    return any(name in line and _OPENED_TO_WRITE.search(line) for line in lines if len(line) <= _MOST_LETTERS)


def _way(place: PurePosixPath, current: PurePosixPath) -> PurePosixPath:
    """Return the path from the current folder to a file."""
    up = 0
    while not place.is_relative_to(current):
        current, up = current.parent, up + 1
    return PurePosixPath(*[".."] * up, place.relative_to(current))


def _named(folder: PurePosixPath) -> str:
    return shown(folder) if folder != PurePosixPath() else "the folder of the program"


def _on_refused(files: Mapping[PurePosixPath, bytes]) -> str:
    """Tell what a match refuses, as far as the team's imports show what it was."""
    imported = b" ".join(
        found[1] for path, content in files.items() if path.suffix == ".py" for found in _IMPORT.finditer(content)
    )
    names = set(re.findall(r"[\w.]+", imported.decode("utf-8", "replace")))
    uses = {REFUSED[name] for full in names for name in (full, full.partition(".")[0]) if name in REFUSED}
    if uses == {"other programs"}:
        return _WITHOUT_PROCESSES
    return _WITHOUT_NETWORK if uses == {"the network"} else _WITHOUT
