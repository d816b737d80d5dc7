"""A team's programs, as the match uses them: files, name, entry points; and several teams that play as one."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path, PurePath, PurePosixPath

from rcj_challenges.core.codes import CANNOT_WRITE
from rcj_challenges.core.errors import format_error, is_of_the_host
from rcj_challenges.core.similarity import MAX_COMPARED, nearest_name
from rcj_challenges.core.temporary_folder import temporary_folder_error
from rcj_challenges.scenario.designs import ROBOT_FILE
from rcj_challenges.scenario.models.robots import Entrant
from rcj_challenges.submissions.archive import Contents, Files, TeamError, read_contents, refusal
from rcj_challenges.submissions.codes import LAYOUT_MISSING
from rcj_challenges.submissions.problems import MAX_PATH_SHOWN, safe_text
from rcj_challenges.submissions.team_name import NAME_FILE, TeamName, find_team_name, may_be_name_file

__all__ = ["Opening", "SuperTeam", "Team", "TeamError", "look_into", "open_team", "wanted_programs"]

LOGO_FILE = "logo.png"

_LOGO_STEMS = frozenset({"logo", "teamlogo", "logoteam"})
_PICTURE_ENDINGS = frozenset({".png", ".jpg", ".jpeg", ".gif", ".bmp", ".webp", ""})
_MAX_TOP_FOLDERS = 3
_SHOWN_FILES = 12
_MIN_SIMILARITY = 0.75


@dataclass(frozen=True, eq=False)
class Team:
    """The files of one team, held in memory: what happens to the folder afterwards does not change a match.

    Attributes:
        source: where it was opened.
        files: contents by path, below the folder in which its programs are looked for.
        name: its name, safe to show: one line of at most 32 printable characters.
        notes: flaws of the submission that do not prevent play.
        entries: the path of the program by robot, for the seats that it was opened for.
        single: the program, if it was given alone.
        layout: how its files were found.
    """

    source: Path
    files: Files
    name: str
    notes: tuple[str, ...]
    entries: Mapping[str, str]
    single: str
    layout: Layout

    @cached_property
    def digest(self) -> str:
        """SHA-256 over names and contents of its files, the same for a folder and its ZIP."""
        digest = hashlib.sha256()
        for path, content in sorted(self.files.items()):
            name = str(path).encode("utf-8", "surrogateescape")
            digest.update(f"{len(name)} {len(content)}\n".encode())
            digest.update(name)
            digest.update(content)
        return digest.hexdigest()

    def driving(self, number: int) -> Team:
        """Return the team that drives a robot of its side, as a `SuperTeam` does: this one drives all of them."""
        return self

    def unpack(self, folder: Path) -> None:
        """Write a copy of the team's files into an existing empty folder.

        Raises:
            TeamError: this computer cannot hold them (names it does not allow).
            HostError: it has no room for them.
        """
        try:
            for name, content in self.files.items():
                target = folder.joinpath(str(name))
                target.parent.mkdir(parents=True, exist_ok=True)
                target.write_bytes(content)
        except (OSError, ValueError) as error:
            if is_of_the_host(error):
                raise temporary_folder_error(error, "cannot take the team's files") from error
            message = f"{self.source}: {name} cannot be written on this computer: {format_error(error)}"
            raise TeamError(message, code=CANNOT_WRITE) from error

    def ignores_neighbour(self, name: str) -> bool:
        """Return whether a file or folder of this name lies, unread, beside a program that was given alone."""
        if not self.single or name in ("", ".", "..") or PurePath(name).name != name:
            return False
        try:
            return self.source.with_name(name).exists()
        except (OSError, ValueError):
            return False

    def place_on_disk(self, entry: str) -> tuple[Path, Path] | None:
        """Return the folder in which the team has its files, and its program there; None if they are in an archive."""
        source = self.source.absolute()
        if self.single:
            return source.parent, source
        if not source.is_dir():
            return None
        folder, within = source / self.layout.top, self.layout.within
        program = folder / str(PurePosixPath(entry).relative_to(within) if within else entry)
        return (folder, program) if program.is_file() else None


@dataclass(frozen=True)
class SuperTeam:
    """Teams that play as one: the first robot of the side is driven by the first team's program, and so on.

    It takes the place of a `Team` in a match. Each robot has the files, the private folder and the log of its own team.

    Attributes:
        members: a team for each robot of the side, in the order of the scenario.
    """

    members: tuple[Team, ...]

    @property
    def name(self) -> str:
        """The members' names."""
        return " + ".join(member.name for member in self.members)

    @property
    def digest(self) -> str:
        """SHA-256 over the digests of the members, in their order."""
        return hashlib.sha256("\n".join(member.digest for member in self.members).encode("ascii")).hexdigest()

    @property
    def files(self) -> Mapping[PurePosixPath, bytes]:
        """Files that all members share: none, so a SuperTeam has no logo."""
        return {}

    def driving(self, number: int) -> Team:
        """Return the team that drives a robot, by its number on its side, from 0."""
        return self.members[number]


@dataclass(frozen=True)
class Opening:
    """What came of opening a submission: a team, or why there is none.

    Attributes:
        contents: what was read.
        files: the files as the programs will see them, extra top folders removed.
        team: the team; None if it cannot play.
        name: its name.
        top: the extra folders around everything that were looked through; ``.`` for none.
        within: the folder that the files were taken to be the content of; None if they have their own folders.
        missing: by robot the programs that were looked for in vain.
    """

    contents: Contents
    files: Files
    team: Team | None
    name: TeamName
    top: PurePosixPath
    within: PurePosixPath | None
    missing: Mapping[str, tuple[str, ...]] = field(default_factory=dict)


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
    opening = look_into(source, *seats)
    if opening.team is not None:
        return opening.team
    if opening.contents.refused:
        raise refusal(source, opening.contents.refused)
    message = f"{safe_text(source, MAX_PATH_SHOWN)}: {missing_programs(opening.contents.files, opening.missing)}"
    raise TeamError(message, code=LAYOUT_MISSING)


def look_into(path: Path, *seats: Entrant) -> Opening:
    """Open a submission as `open_team` does, but report everything instead of stopping at the first problem.

    Raises:
        TeamError: there is nothing at this path that can be opened.
    """
    return opening_of(path, read_contents(path), *seats)


def called_after(name: str) -> str:
    """Return the default name of a team, from the name of its file or folder."""
    for suffix in (".zip", ".py"):  # as .ZIP just as well
        if name.casefold().endswith(suffix):
            name = name[: -len(suffix)]
    return name


def opening_of(path: Path, contents: Contents, *seats: Entrant) -> Opening:
    """Open contents that have been read from a path; a team may be named after it."""
    fallback = called_after(path.resolve().name)
    layouts = [*without_top_folders(contents.files), *_inside_entry_folder(contents.files, seats)]
    single = str(next(iter(contents.files), "")) if contents.kind == "program" else ""
    for layout in layouts:
        files = layout.files
        if not files or _lacking(files, seats, single):
            continue
        name = find_team_name(files, fallback)
        team = None
        if not contents.refused:
            entries = {
                robot: single or next(entry for entry in wanted if PurePosixPath(entry) in files)
                for robot, wanted in wanted_programs(seats).items()
            }
            notes = tuple(problem.sentence for problem in name.problems if problem.level != "passed")
            team = Team(path, files, name.text, notes, entries, single, layout)
        return Opening(contents, files, team, name, layout.top, layout.within)
    whole = without_top_folders(contents.files)
    best = next((layout for layout in whole if PurePosixPath(NAME_FILE) in layout.files), whole[0])
    missing = _lacking(contents.files, seats, single)
    return Opening(contents, best.files, None, find_team_name(best.files, fallback), best.top, None, missing)


def _lacking(files: Files, seats: Iterable[Entrant], single: str) -> dict[str, tuple[str, ...]]:
    return {
        robot: wanted
        for robot, wanted in wanted_programs(seats).items()
        if not single and all(PurePosixPath(entry) not in files for entry in wanted)
    }


def wanted_programs(seats: Iterable[Entrant]) -> dict[str, tuple[str, ...]]:
    """Return by robot the paths of which the first that exists is its program."""
    return {
        robot: (wanted,) if isinstance(wanted, str) else wanted
        for seat in seats
        for robot, wanted in seat.robots.items()
    }


@dataclass(frozen=True)
class Layout:
    """One way to see a submission's files.

    Attributes:
        top: the folders around them that are looked through; ``.`` for none.
        within: the folder that the programs are taken to be the content of; None if they have their own folders.
        below: what is in ``top``.
        beside: what lies beside one of its folders and is kept.
    """

    top: PurePosixPath
    within: PurePosixPath | None
    below: Files
    beside: Files

    @property
    def files(self) -> Files:
        """The files as the programs will see them."""
        below = self.below
        if self.within is not None:
            below = {path if _belongs_to_team(path) else self.within / path: data for path, data in below.items()}
        return dict(sorted((below | self.beside).items()))


def without_top_folders(files: Files) -> list[Layout]:
    """Return the files as they are, then without the folder that holds all programs, if one does, and so on."""
    found = [Layout(PurePosixPath(), None, files, {})]
    for _ in range(_MAX_TOP_FOLDERS):
        last = found[-1]
        folders = {path.parts[0] for path in last.below if len(path.parts) > 1}
        programs_beside = any(len(path.parts) == 1 and path.suffix == ".py" for path in last.below)
        if len(folders) != 1 or programs_beside:
            break
        folder = folders.pop()
        below = {path.relative_to(folder): data for path, data in last.below.items() if len(path.parts) > 1}
        here = {path: data for path, data in last.below.items() if len(path.parts) == 1}
        beside = {path: data for path, data in (here | last.beside).items() if path not in below}
        if any(path.parts[0] in {str(other) for other in beside} for path in below):
            break  # a file and a folder of one name
        found.append(Layout(last.top / folder, None, below, beside))
    return found


def _inside_entry_folder(files: Files, seats: Sequence[Entrant]) -> list[Layout]:
    """Return the files under the name of each folder that could be asked for: they may be what belongs in it."""
    asked = dict.fromkeys(PurePosixPath(entry) for wanted in wanted_programs(seats).values() for entry in wanted)
    return [
        Layout(layout.top, entry.parent, layout.below, layout.beside)
        for layout in without_top_folders(files)
        for entry in asked
        if len(entry.parts) > 1
        and PurePosixPath(entry.name) in layout.below
        and PurePosixPath(entry.parts[0]) not in layout.beside
    ]


def _belongs_to_team(path: PurePosixPath) -> bool:
    """Whether a file belongs beside the folder of the programs: the team's name and logo."""
    return len(path.parts) == 1 and (may_be_name_file(path) or may_be_logo(path))


def may_be_logo(path: PurePosixPath) -> bool:
    """Whether a file is the logo, or probably intended as the logo."""
    stem = "".join(letter for letter in path.stem.casefold() if letter.isalnum())
    return stem in _LOGO_STEMS and path.suffix.casefold() in _PICTURE_ENDINGS


def missing_programs(
    files: Files,
    missing: Mapping[str, tuple[str, ...]],
    *,
    hint: bool = True,
    others: Collection[PurePosixPath] = (),
) -> str:
    """Return a message: missing programs, what was looked for, what is there and, as a hint, the nearest name.

    Args:
        files: of the submission.
        missing: by robot, what was looked for in vain.
        hint: whether to say what comes nearest.
        others: files that are none of those that are missing: others import them, or robots have them.
    """
    wanted = list(dict.fromkeys(missing.values()))
    looked_for = "; ".join(
        f"{', '.join(robot for robot, paths in missing.items() if paths == entries)}: looked for {' or '.join(entries)}"
        for entries in wanted
    )
    present = [str(path) for path in files]
    python = ([name for name in present if name.endswith(".py")] or present)[:MAX_COMPARED]
    found = ", ".join(map(safe_text, python[:_SHOWN_FILES])) + (", …" if len(python) > _SHOWN_FILES else "")
    message = f"no program for {looked_for}; found: {found or 'nothing'}"
    candidates = [name for name in python if PurePosixPath(name) not in others and name != ROBOT_FILE]
    nearest = ((near, entry) for entries in wanted for entry in entries if (near := _nearest(entry, candidates)))
    for near, entry in nearest if hint else ():
        return f"{message}; did you mean {safe_text(near)} to be {entry}?"
    return message


def _nearest(entry: str, names: list[str]) -> str | None:
    """Return the name that comes nearest; of robot1, robot2 and robot3 none is another one misspelled."""
    wanted = PurePosixPath(entry).name
    names = [name for name in names if _numbers(PurePosixPath(name).stem) == _numbers(PurePosixPath(entry).stem)]
    by_file_name = {PurePosixPath(name).name: name for name in reversed(names)}
    found = nearest_name(entry, names, _MIN_SIMILARITY)
    if found is not None:
        return found
    close = nearest_name(wanted, by_file_name, _MIN_SIMILARITY)
    return None if close is None else by_file_name[close]


def _numbers(name: str) -> list[str]:
    return re.findall(r"[0-9]+", name)
