"""Finds the moves of files and folders that put every program where the scenario looks for it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import PurePosixPath

from rcj_challenges.checker.similar_names import (
    BLANK,
    alike,
    imported_words,
    like_an_entry,
    mentioned,
    of_yellow,
    same_number,
)
from rcj_challenges.scenario.models.robots import Entrant
from rcj_challenges.submissions.archive import Files
from rcj_challenges.submissions.problems import safe_text
from rcj_challenges.submissions.team import wanted_programs

HIDDEN_ENDING = ".py.txt"
"""What an editor of Windows makes of ``.py``, and shows as ``.py``."""

_MAX_DEPTH = 3
_MAX_FOLDERS = 20
_MAX_PROGRAMS = 200  # among more files names are not enough
_CLEAR = 2
"""The rank of a file that has the right name, or a similar one in a similar folder."""


@dataclass(frozen=True)
class Move:
    """A folder or file that should be elsewhere.

    Attributes:
        old: where it is.
        new: where it belongs; ``.`` for the content of a folder that belongs at the top.
    """

    old: PurePosixPath
    new: PurePosixPath

    def __str__(self) -> str:
        """The repair, as a sentence."""
        if self.new == PurePosixPath():
            return f"move what is in {safe_text(self.old)} to the top"
        kind = "file" if self.new.suffix == ".py" else "folder"
        if kind == "file" and self.old.parent != self.new.parent:
            return f"move the file {safe_text(self.old)} into a folder {safe_text(self.new.parent)}"
        return f"rename the {kind} {safe_text(self.old)} to {safe_text(self.new)}"


@dataclass(frozen=True)
class Plan:
    """How misnamed files would work after moves.

    Attributes:
        moves: in this order.
        files: the result.
        caution: why this cannot be done without looking into the programs; else empty.
    """

    moves: tuple[Move, ...]
    files: Files
    caution: str = ""


def plan_moves(files: Files, seats: Sequence[Entrant]) -> Plan | None:
    """Return the moves after which every robot has its program, if there is exactly one plausible way.

    Args:
        files: of the submission, with its extra folders.
        seats: the entrants for which programs are asked.
    """
    if sum(path.suffix == ".py" for path in files) > _MAX_PROGRAMS:
        return None
    for folders in _roots(files):
        plans = [plan for folder in folders if (plan := _plan_from(folder, files, seats)) is not None]
        if plans:
            return plans[0] if len(plans) == 1 else None
    return None


def entries_of(files: Mapping[PurePosixPath, bytes], seats: Iterable[Entrant]) -> dict[str, PurePosixPath | None]:
    """Return the program of each robot: the first entry point that exists."""
    return {
        robot: next((path for path in map(PurePosixPath, wanted) if path in files), None)
        for robot, wanted in wanted_programs(seats).items()
    }


def all_entries(seats: Iterable[Entrant]) -> set[PurePosixPath]:
    """Return all paths at which a scenario looks for programs."""
    return {PurePosixPath(entry) for wanted in wanted_programs(seats).values() for entry in wanted}


def _roots(files: Files) -> Iterator[list[PurePosixPath]]:
    """Yield the folders in which the folders of programs may lie, by depth, as long as there are few."""
    programs = [path for path in files if path.suffix == ".py"]
    above = {PurePosixPath(), *(path.parent for path in programs), *(path.parent.parent for path in programs)}
    for depth in range(_MAX_DEPTH + 1):
        yield sorted(folder for folder in above if len(folder.parts) == depth)[:_MAX_FOLDERS]


def _plan_from(folder: PurePosixPath, files: Files, seats: Sequence[Entrant]) -> Plan | None:
    """Return the moves needed if the content of a folder, maybe the top itself, were moved to the top."""
    up = (Move(folder, PurePosixPath()),) if folder.parts else ()
    raised = _moved(files, up)
    if raised is None or _is_complete(raised, seats):
        return Plan(up, raised) if raised is not None else None
    chosen = entries_of(raised, seats)
    missing = [wanted for robot, wanted in wanted_programs(seats).items() if chosen[robot] is None]
    for choice in range(max(map(len, missing), default=0)):
        wanted = dict.fromkeys(PurePosixPath(entries[choice]) for entries in missing if choice < len(entries))
        is_only_one = len(wanted) == 1 and len(missing) == len(chosen)
        pairs = [
            (old, entry)
            for entry in wanted
            if (old := _find(entry, raised, seats, is_only_one=is_only_one)) is not None
        ]
        moves = _moves(pairs) if len(pairs) == len(wanted) else None
        result = _moved(raised, moves) if moves else None
        if moves and result is not None and _is_complete(result, seats):
            old_names = [
                move.old.stem if move.old.suffix == ".py" else move.old.name
                for move in moves
                if move.old.name != move.new.name
            ]
            name = mentioned(raised, old_names)
            caution = f"the programs mention {safe_text(name)}: change that as well" if name else ""
            return Plan((*up, *moves), result, caution)
    return None


def _find(entry: PurePosixPath, files: Files, seats: Sequence[Entrant], *, is_only_one: bool) -> PurePosixPath | None:
    """Return the file whose name comes nearest to an entry point, if there is exactly one.

    Args:
        entry: the entry point.
        files: of the submission.
        seats: the entrants for which programs are asked.
        is_only_one: whether one program drives all robots: then it may have any name.
    """
    asked = all_entries(seats)
    asked_names = {path.name for path in asked}
    programs = [
        path
        for path in files
        if path.name.casefold().endswith((".py", HIDDEN_ENDING)) and len(path.parts) == len(entry.parts)
    ]
    imports = Counter(word for path in programs for word in imported_words(files[path]))
    stems = {path.stem.encode("utf-8", "surrogateescape") for path in files}
    ranks: dict[int, list[PurePosixPath]] = {}
    for path in programs:
        stem, own_imports = path.stem.encode("utf-8", "surrogateescape"), imported_words(files[path])
        is_library = imports[stem] > (stem in own_imports)
        is_program = b"controller" in own_imports or like_an_entry(path) or not own_imports.isdisjoint(stems - {stem})
        rank = _score(path, entry, is_program=is_program)
        if is_library and (len(entry.parts) == 1 or rank < _CLEAR):
            rank = 0
        elif not rank:
            rank = int(is_only_one and is_program and path.name not in asked_names)
        if rank and path not in asked and files[path].strip(BLANK):
            ranks.setdefault(rank, []).append(path)
    best = ranks[max(ranks)] if ranks else []
    if len(best) > 1 and len({files[path] for path in best}) == 1:
        best = [path for path in best if not of_yellow(path.stem)]  # one program for both colours
    return best[0] if len(best) == 1 else None


def _score(path: PurePosixPath, entry: PurePosixPath, *, is_program: bool) -> int:
    """How much the names suggest that a file is an entry point; 0: not at all.

    The folder alone suggests it only of a file that drives a robot: another may be all that is left of the team's work.
    """
    is_same = path.name == entry.name or path.name.casefold() == entry.name + ".txt"
    is_like = alike(path.stem, entry.stem) or (like_an_entry(path) and same_number(path.stem, entry.stem))
    is_in_its_folder = len(entry.parts) > 1 and alike(str(path.parent), str(entry.parent))
    is_in_its_folder = is_in_its_folder and (is_same or is_like or is_program)
    return _CLEAR * is_same + is_like + is_in_its_folder


def _moves(pairs: Sequence[tuple[PurePosixPath, PurePosixPath]]) -> list[Move] | None:
    """Return the renaming of folders, then of files; None if one folder would need two names."""
    folders: dict[PurePosixPath, PurePosixPath] = {}
    files = []
    for old, new in pairs:
        if folders.setdefault(old.parent, new.parent) != new.parent:
            return None
        if old.name != new.name:
            files.append(Move(new.parent / old.name, new))
    return [Move(old, new) for old, new in folders.items() if old != new] + files


def _moved(files: Files, moves: Iterable[Move]) -> Files | None:
    """Return the files after moving some; None if two of them would be in one place."""
    current = dict(files)
    for move in moves:
        result: Files = {}
        for path, content in current.items():
            new = move.new / path.relative_to(move.old) if path.is_relative_to(move.old) else path
            if new in result:
                return None
            result[new] = content
        current = result
    return dict(sorted(current.items()))


def _is_complete(files: Files, seats: Sequence[Entrant]) -> bool:
    """Return whether every robot has its program, and no file lies where a folder is."""
    if any(entry is None for entry in entries_of(files, seats).values()):
        return False
    return files.keys().isdisjoint(folder for path in files for folder in path.parents)
