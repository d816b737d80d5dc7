"""A team's programs, as the match uses them: files, name, entry points."""

from __future__ import annotations

import hashlib
import unicodedata
from collections.abc import Iterable, Sequence
from difflib import get_close_matches
from pathlib import Path, PurePosixPath
from typing import Self

from rcj_challenges.controllers.archive import Files, TeamError, read_files
from rcj_challenges.scenario.models.robots import Entrant, EntryPoints

__all__ = ["Team", "TeamError", "open_team"]

MOST_NAME_LETTERS = 32
"""A team's name has at most 32 characters (reference, section 7)."""

_NAME_FILE = "team_name.txt"
_MOST_TOP_FOLDERS = 3
_SHOWN_FILES = 12
_JOINER = "\u200d"  # holds some emoji together


class Team:
    """The files of one team, held in memory: what happens to the folder afterwards does not change a match.

    Attributes:
        source: where it was opened.
        name: its name, safe to show: one line of at most 32 printable characters.
        digest: SHA-256 over names and contents of its files, the same for a folder and its ZIP.
        notes: what is not as a submission should be, but does not hinder play.
    """

    def __init__(self, source: Path, files: Files, name: str, notes: tuple[str, ...]) -> None:
        self.source = source
        self.name = name
        self.notes = notes
        self.digest = _digest(files)
        self._files = files
        self._entries: dict[str, str] = {}

    def entry_for(self, robot: str, entry_points: EntryPoints | None = None) -> str:
        """Return the path of the program that drives a robot, inside the team's folder.

        Args:
            robot: its name.
            entry_points: those of its seat; needed only for a seat that `open_team` was not told of.

        Raises:
            TeamError: there is no such program.
        """
        if entry_points is not None:
            found = self._first_of(entry_points)
            if found is None:
                raise TeamError(_missing(self.source, self._files, {robot: _alternatives(entry_points)}))
            return found
        if robot not in self._entries:
            raise TeamError(f"{self.source}: opened for {', '.join(self._entries)}, not for {robot}")
        return self._entries[robot]

    def unpack(self, folder: Path) -> None:
        """Write a copy of the team's files into an existing empty folder.

        Raises:
            TeamError: this computer cannot hold them (names it does not allow).
        """
        try:
            for name, content in self._files.items():
                target = folder.joinpath(*name.parts)
                target.parent.mkdir(parents=True, exist_ok=True)
                target.write_bytes(content)
        except (OSError, ValueError) as error:
            raise TeamError(f"{self.source}: {name} cannot be written on this computer: {error}") from error

    def size_bytes(self) -> int:
        """Return the size of all files together."""
        return sum(map(len, self._files.values()))

    def close(self) -> None:
        """Forget the files."""
        self._files = {}

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _first_of(self, entry_points: EntryPoints) -> str | None:
        alternatives = _alternatives(entry_points)
        if self.source.suffix == ".py" and len(self._files) == 1:
            return str(next(iter(self._files)))  # a single file drives all robots
        return next((entry for entry in alternatives if PurePosixPath(entry) in self._files), None)

    def _find_entries(self, seats: Iterable[Entrant]) -> dict[str, tuple[str, ...]]:
        """Find the entry points of all robots; return what was looked for in vain."""
        missing = {}
        for seat in seats:
            for robot, entry_points in seat.robots.items():
                found = self._first_of(entry_points)
                if found is None:
                    missing[robot] = _alternatives(entry_points)
                else:
                    self._entries[robot] = found
        return missing


def open_team(path: str | Path, *seats: Entrant) -> Team:
    """Open a team's folder, ZIP or single ``.py`` file.

    An extra top folder is looked through, and the folder of the program itself will do as well.

    Args:
        path: where it is.
        seats: the entrants whose robots it will drive; all of them, if teams change sides.

    Raises:
        TeamError: it cannot be read, or lacks a program.
    """
    source = Path(path)
    files = read_files(source)
    if not files:
        raise TeamError(f"{source}: there are no files in it")
    name, notes = _team_name(source, files)
    candidates = [*_without_top_folders(files), *_inside_entry_folder(files, seats)]
    for candidate in candidates:
        team = Team(source, candidate, name, notes)
        if not team._find_entries(seats):  # noqa: SLF001 - the module's own class
            return team
    raise TeamError(_missing(source, files, Team(source, files, name, notes)._find_entries(seats)))  # noqa: SLF001


def _alternatives(entry_points: EntryPoints) -> tuple[str, ...]:
    return (entry_points,) if isinstance(entry_points, str) else tuple(entry_points)


def _without_top_folders(files: Files) -> list[Files]:
    """Return the files as they are, then without the folder that holds all of them, if one does, and so on."""
    found = [files]
    for _ in range(_MOST_TOP_FOLDERS):
        folders = {path.parts[0] for path in found[-1] if len(path.parts) > 1}
        programs_beside = any(len(path.parts) == 1 and path.suffix == ".py" for path in found[-1])
        if len(folders) != 1 or programs_beside:
            break
        found.append({path.relative_to(path.parts[0]): data for path, data in found[-1].items() if len(path.parts) > 1})
    return found


def _inside_entry_folder(files: Files, seats: Sequence[Entrant]) -> list[Files]:
    """Return the files under the name of each folder that could be asked for: they may be what belongs in it."""
    asked = dict.fromkeys(
        PurePosixPath(entry)
        for seat in seats
        for entry_points in seat.robots.values()
        for entry in _alternatives(entry_points)
    )
    wrapped = []
    for content in _without_top_folders(files):
        for entry in asked:
            if len(entry.parts) > 1 and PurePosixPath(entry.name) in content:
                wrapped.append({entry.parent / path: data for path, data in content.items()})  # noqa: PERF401
    return wrapped


def _missing(source: Path, files: Files, missing: dict[str, tuple[str, ...]]) -> str:
    """Say which programs are missing, what was looked for, what is there and what comes nearest."""
    wanted = list(dict.fromkeys(missing.values()))
    told = "; ".join(
        f"{', '.join(robot for robot, entries in missing.items() if entries == alternatives)}: "
        f"looked for {' or '.join(alternatives)}"
        for alternatives in wanted
    )
    present = [str(path) for path in files]
    python = [name for name in present if name.endswith(".py")] or present
    shown = ", ".join(python[:_SHOWN_FILES]) + (", …" if len(python) > _SHOWN_FILES else "")
    nearest = next((near for entries in wanted for entry in entries if (near := _nearest(entry, python))), None)
    hint = f"; did you mean {nearest} to be {wanted[0][0]}?" if nearest else ""
    return f"{source}: no program for {told}; found: {shown or 'nothing'}{hint}"


def _nearest(entry: str, names: list[str]) -> str | None:
    wanted = PurePosixPath(entry).name
    by_file_name = {PurePosixPath(name).name: name for name in reversed(names)}
    found = get_close_matches(entry, names, 1, 0.75)
    if found:
        return found[0]
    close = get_close_matches(wanted, by_file_name, 1, 0.75)
    return by_file_name[close[0]] if close else None


def _team_name(source: Path, files: Files) -> tuple[str, tuple[str, ...]]:
    """Return the team's name and what is wrong with it."""
    fallback = safe_name(source.resolve().name.removesuffix(".zip").removesuffix(".py")) or "team"
    places = sorted((path for path in files if path.name.casefold() == _NAME_FILE), key=lambda path: len(path.parts))
    if not places:
        return fallback, (f"there is no {_NAME_FILE}: the name is taken from the file's",)
    lines = files[places[0]].decode("utf-8-sig", "replace").splitlines()
    line = next((line for line in lines if line.strip()), "")
    name = safe_name(line)
    if not name:
        return fallback, (f"{_NAME_FILE} is empty: the name is taken from the file's",)
    if name != line.strip():
        return name, (f"the name in {_NAME_FILE} is shown as {name!r}: at most {MOST_NAME_LETTERS} printable letters",)
    return name, ()


def safe_name(text: str) -> str:
    """Return text as a name: printable characters of one line, no direction marks, at most 32 of them."""
    printable = "".join(
        letter if letter == _JOINER or unicodedata.category(letter)[0] != "C" else " " for letter in text
    )
    return " ".join(printable.split())[:MOST_NAME_LETTERS].rstrip()


def _digest(files: Files) -> str:
    digest = hashlib.sha256()
    for path, content in sorted(files.items()):
        name = str(path).encode("utf-8", "surrogateescape")
        digest.update(f"{len(name)} {len(content)}\n".encode())
        digest.update(name)
        digest.update(content)
    return digest.hexdigest()
