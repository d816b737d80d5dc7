"""Whether folders and programs are where the scenario asks for them, and which renaming would put them there."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import PurePosixPath

from rcj_challenges.checker.findings import Finding
from rcj_challenges.checker.left_over import never_started
from rcj_challenges.checker.likeness import BLANK, alike, like_an_entry, mentioned, of_blue, of_yellow, same_number
from rcj_challenges.checker.mains import HIDDEN_ENDING, Roles, roles_of, what_it_does
from rcj_challenges.checker.others import looks_like
from rcj_challenges.controllers.archive import Files
from rcj_challenges.controllers.team import Opening, alternatives, missing_programs
from rcj_challenges.controllers.troubles import told
from rcj_challenges.scenario.models.robots import Entrant

_MOST_DEPTH = 3
_MOST_BESIDE = 300  # names of which a program may use any
_MOST_FOLDERS = 20
_MOST_PROGRAMS = 200  # among more files nobody can say which was meant
_MOST_EMPTY = 10
_LIKE, _SAME = 2, 3  # how much names speak for a file; less than either is a program that is the only one


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
        """Return what to do, as a sentence."""
        if self.new == PurePosixPath():
            return f"move what is in {told(self.old)} to the top"
        kind = "file" if self.new.suffix == ".py" else "folder"
        if kind == "file" and self.old.parent != self.new.parent:
            return f"move the file {told(self.old)} into a folder {told(self.new.parent)}"
        return f"rename the {kind} {told(self.old)} to {told(self.new)}"


@dataclass(frozen=True)
class Plan:
    """How files that are called otherwise than asked for would serve.

    Attributes:
        moves: in this order.
        files: what comes of it.
        mentioned: an old name that a program mentions: renaming might break it.
    """

    moves: tuple[Move, ...]
    files: Files
    mentioned: str


@dataclass(frozen=True)
class Empty:
    """A program's file without a program in it.

    Attributes:
        path: which.
        started: the robots for which it would be started.
        spare: whether leaving it out does no harm.
    """

    path: PurePosixPath
    started: tuple[str, ...]
    spare: bool


def layout_findings(opening: Opening, seats: Sequence[Entrant], others: Sequence[str]) -> list[Finding]:
    """Tell what is odd about the places of a submission's files.

    Args:
        opening: what came of opening it.
        seats: the entrants for which it was opened.
        others: the shipped scenarios that it fits, if it does not fit this one.
    """
    if opening.missing:
        return [*_surroundings(opening), *_missing(opening, seats, others)]
    return [
        *_surroundings(opening),
        *_empties(opening, seats),
        *_served(opening, seats),
        *_left_over(opening, seats),
    ]


def entries_of(files: Mapping[PurePosixPath, bytes], seats: Iterable[Entrant]) -> dict[str, PurePosixPath | None]:
    """Return the program of each robot: the first entry point that exists."""
    return {
        robot: next((PurePosixPath(entry) for entry in alternatives(wanted) if PurePosixPath(entry) in files), None)
        for seat in seats
        for robot, wanted in seat.robots.items()
    }


def empty_programs(files: Mapping[PurePosixPath, bytes], seats: Sequence[Entrant]) -> list[Empty]:
    """Find files that look like entry points and hold nothing."""
    chosen = entries_of(files, seats)
    asked = _asked(seats)
    found: list[Empty] = []
    for path, content in files.items():
        if path.suffix != ".py" or content.strip(BLANK) or not (path in asked or like_an_entry(path)):
            continue
        if len(found) == _MOST_EMPTY:
            break
        started = tuple(robot for robot, entry in chosen.items() if entry == path)
        without = {other: data for other, data in files.items() if other != path}
        instead = entries_of(without, seats)
        served = all((entry := instead[robot]) is not None and without[entry].strip(BLANK) for robot in started)
        found.append(Empty(path, started, spare=served and not mentioned(files, [path.stem])))
    return found


def plan_moves(opening: Opening, seats: Sequence[Entrant]) -> Plan | None:
    """Return the moves after which every robot has its program, if exactly one way suggests itself."""
    files = opening.contents.files
    if sum(path.suffix == ".py" for path in files) > _MOST_PROGRAMS:
        return None
    roles = roles_of(files)
    # What names say comes first.
    for known in [Roles(roles.libraries)] + [roles] * (roles.main_of_a_place is not None or roles.main is not None):
        for folders in _roots(files):
            plans = [plan for folder in folders if (plan := _out_of(folder, files, seats, known)) is not None]
            if plans:
                return plans[0] if len(plans) == 1 else None
    return None


def _surroundings(opening: Opening) -> list[Finding]:
    found = []
    if opening.contents.kind == "program":
        message = f"a single program drives all robots: {told(next(iter(opening.files), ''))}"
        found.append(Finding("layout.single_program", "warning", message, "a submission is a ZIP", repair=True))
    if opening.contents.kind != "zip":
        return found
    top = opening.top
    if opening.within is not None and not top.parts:
        message = f"the programs are not in a folder {told(opening.within)}"
        remedy = "pack that folder, not only what is in it"
        found.append(Finding("layout.no_folder", "warning", message, remedy, repair=True))
    elif opening.within is not None:
        message = f"the folder of the programs is called {told(top.name)}"
        found.append(
            Finding("layout.folder_name", "warning", message, f"call it {told(opening.within)}", told(top), repair=True)
        )
        top = top.parent
    if top.parts:
        message = f"everything lies in an extra folder: {told(top)}"
        remedy = "pack what is in it, not the folder itself"
        found.append(Finding("layout.top_folder", "warning", message, remedy, told(top), repair=True))
    return found


def _missing(opening: Opening, seats: Sequence[Entrant], others: Sequence[str]) -> list[Finding]:
    plan = plan_moves(opening, seats)
    files = opening.contents.files
    into_folders = _into_folders_with_copies(opening) if plan is None else ""
    libraries = roles_of(files).libraries
    not_meant = _asked(seats).union(path for path, content in files.items() if content in libraries)
    is_unclear = plan is None and not into_folders
    message = missing_programs(files, opening.missing, hint=is_unclear, not_meant=not_meant)
    nested = [trouble for trouble in opening.contents.troubles if trouble.code == "archive.nested"]
    if plan is None and nested:
        remedy = f"pack what is in {nested[0].where}, not the archive itself"
        return [Finding("layout.missing", "failure", message, remedy)]
    if plan is None:
        remedy = into_folders or _of_one_colour(opening, seats)
        remedy = _elsewhere(others) + (remedy or _add_it(opening, seats, libraries) or _call_it_so(opening))
        return [Finding("layout.missing", "failure", message, remedy)]
    remedy = _elsewhere(others) + _in_words(plan)
    return [Finding("layout.misnamed", "failure", message, remedy, told(plan.moves[0].old), not plan.mentioned)]


def _of_one_colour(opening: Opening, seats: Sequence[Entrant]) -> str:
    """Return what to do where programs for blue and yellow differ, as if those for blue were meant; else nothing."""
    files = opening.contents.files
    rest = {path: data for path, data in files.items() if not any(map(of_yellow, (*path.parts[:-1], path.stem)))}
    if len(rest) == len(files) or not any(of_blue(name) for path in rest for name in (*path.parts[:-1], path.stem)):
        return ""
    plan = plan_moves(replace(opening, contents=replace(opening.contents, files=rest)), seats)
    if plan is None:
        return ""
    return (
        f"{_in_words(plan)}; or do so with the programs of yellow, if these are yours: they differ, and the same ones "
        "play for both colours"
    )


def _in_words(plan: Plan) -> str:
    change = f"; the programs mention {told(plan.mentioned)}: change that as well" if plan.mentioned else ""
    return f"{', '.join(map(str, plan.moves))}{change}"


def _into_folders_with_copies(opening: Opening) -> str:
    """Return what to do about programs beside their folders that use what lies there; empty if it is not so."""
    for wanted in zip(*opening.missing.values(), strict=False):
        entries = dict.fromkeys(map(PurePosixPath, wanted))
        moves = _beside_their_folders(opening.contents.files, entries)
        if moves:
            each = "each " if len(moves) > 1 else ""
            return f"{', '.join(map(str, moves))}, {each}with a copy of what it imports or opens beside it"
    return ""


def _add_it(opening: Opening, seats: Sequence[Entrant], libraries: frozenset[bytes]) -> str:
    """Return what to do where each program that is there drives another robot; empty if one is left to be renamed."""
    driving = {robot: entry for robot, entry in entries_of(opening.files, seats).items() if entry is not None}
    left = [
        path
        for path, content in opening.files.items()
        if path.suffix == ".py" and path not in driving.values() and content not in libraries
    ]
    if not driving or left:
        return ""
    # Of several layouts that the scenario knows the one that these programs have.
    wanted = {
        robot: [PurePosixPath(one) for one in alternatives(entry)] for s in seats for robot, entry in s.robots.items()
    }
    robot, entry = next(iter(driving.items()))
    layout = wanted[robot].index(entry)
    lacking = dict.fromkeys(str(wanted[one][min(layout, len(wanted[one]) - 1)]) for one in opening.missing)
    return f"add {', '.join(lacking)}: the programs that are there drive {', '.join(driving)}"


def _call_it_so(opening: Opening) -> str:
    return f"call the program {' or '.join(next(iter(opening.missing.values())))}"


def _elsewhere(others: Sequence[str]) -> str:
    return f"{looks_like(others)}; if it is for this scenario, " if others else ""


def _left_over(opening: Opening, seats: Sequence[Entrant]) -> list[Finding]:
    if opening.contents.kind == "program":
        return []
    # Beside an empty file that is to be deleted, those that are started then are no left-overs.
    spare = {empty.path for empty in empty_programs(opening.files, seats) if empty.started and empty.spare}
    files = {path: content for path, content in opening.files.items() if path not in spare}
    entries = [entry for entry in entries_of(files, seats).values() if entry is not None]
    return never_started(files, entries, _asked(seats))


def _empties(opening: Opening, seats: Sequence[Entrant]) -> list[Finding]:
    found = []
    for empty in empty_programs(opening.files, seats):
        name = told(empty.path)
        if empty.started:
            message = f"{name} is empty, and it is what {', '.join(empty.started)} would be started with"
            remedy = "delete it" if empty.spare else "put the program into it"
            found.append(Finding("layout.empty_entry", "failure", message, remedy, name, repair=empty.spare))
        else:
            message = f"{name} is empty, and this scenario does not ask for it"
            found.append(Finding("layout.empty_program", "warning", message, "delete it", name, repair=empty.spare))
    return found


def _served(opening: Opening, seats: Sequence[Entrant]) -> list[Finding]:
    if opening.contents.kind == "program":
        return []
    robots: dict[PurePosixPath, list[str]] = {}
    for robot, entry in entries_of(opening.files, seats).items():
        if entry is not None:
            robots.setdefault(entry, []).append(robot)
    return [
        Finding("layout.program", "passed", f"{', '.join(names)}: {told(entry)}", where=told(entry))
        for entry, names in robots.items()
    ]


def _asked(seats: Iterable[Entrant]) -> set[PurePosixPath]:
    return {PurePosixPath(entry) for seat in seats for wanted in seat.robots.values() for entry in alternatives(wanted)}


def _asked_by_all(seats: Iterable[Entrant]) -> set[PurePosixPath]:
    """Return the places in which one program may lie that drives every robot."""
    wanted = [set(map(PurePosixPath, alternatives(one))) for seat in seats for one in seat.robots.values()]
    return set.intersection(*wanted) if wanted else set()


def _complete(files: Files, seats: Sequence[Entrant]) -> bool:
    """Return whether every robot has its program, and no file lies where a folder is."""
    if any(entry is None for entry in entries_of(files, seats).values()):
        return False
    return files.keys().isdisjoint(folder for path in files for folder in path.parents)


def _roots(files: Files) -> Iterator[list[PurePosixPath]]:
    """Return the folders in which the folders of programs may lie, by depth, as long as there are few."""
    programs = [path for path in files if path.suffix == ".py"]
    above = {PurePosixPath(), *(path.parent for path in programs), *(path.parent.parent for path in programs)}
    for depth in range(_MOST_DEPTH + 1):
        yield sorted(folder for folder in above if len(folder.parts) == depth)[:_MOST_FOLDERS]


def _out_of(folder: PurePosixPath, files: Files, seats: Sequence[Entrant], roles: Roles) -> Plan | None:
    """Return how what is in a folder would serve at the top.

    Args:
        folder: it may be the top itself.
        files: all files.
        seats: who asks for programs.
        roles: of the files; its main program is taken whatever it is called.
    """
    up = (Move(folder, PurePosixPath()),) if folder.parts else ()
    raised = moved(files, up)
    if raised is None:
        return None
    if _complete(raised, seats):
        return Plan(up, raised, "")
    plan = _by_renaming(raised, seats, roles)
    return None if plan is None else Plan((*up, *plan.moves), plan.files, plan.mentioned)


def _by_renaming(files: Files, seats: Sequence[Entrant], roles: Roles) -> Plan | None:
    """Match each missing program with the file that was meant to be it."""
    missing = [
        alternatives(wanted)
        for seat in seats
        for robot, wanted in seat.robots.items()
        if entries_of(files, [seat])[robot] is None
    ]
    for choice in range(max(map(len, missing), default=0)):
        wanted = list(dict.fromkeys(PurePosixPath(entries[choice]) for entries in missing if choice < len(entries)))
        pairs = [(found, entry) for entry in wanted if (found := _meant_to_be(entry, files, seats, roles)) is not None]
        moves = _moves(pairs) if len(pairs) == len(wanted) else _into_folders(files, wanted)
        result = None if moves is None else moved(files, moves)
        if moves and result is not None and _complete(result, seats):
            old_names = [
                move.old.stem if move.old.suffix == ".py" else move.old.name
                for move in moves
                if move.old.name != move.new.name
            ]
            return Plan(tuple(moves), result, mentioned(files, old_names))
    return None


def _into_folders(files: Files, wanted: Sequence[PurePosixPath]) -> list[Move] | None:
    """Return how programs that lie beside the folders in which they belong come into them.

    None if one is not there, or if one mentions what lies beside it: that would lie elsewhere then.
    """
    moves = _beside_their_folders(files, wanted)
    names = {path.parts[0].partition(".")[0] for path in files} - {""}
    if len(names) > _MOST_BESIDE:
        return None
    uses = (mentioned({move.old: files[move.old]}, names - {move.old.stem}) for move in moves)
    return None if any(uses) else moves


def _beside_their_folders(files: Files, wanted: Iterable[PurePosixPath]) -> list[Move]:
    """Return the moves of programs at the top into the folders in which they belong; none if one is not there."""
    moves = [Move(PurePosixPath(entry.name), entry) for entry in wanted]
    there = (len(move.new.parts) > 1 and files.get(move.old, b"").strip(BLANK) for move in moves)
    return moves if all(there) else []


def _meant_to_be(
    entry: PurePosixPath, files: Files, seats: Sequence[Entrant], roles: Roles
) -> PurePosixPath | None:  # fmt: skip
    asked, for_all = _asked(seats), _asked_by_all(seats)
    endings = (".py", HIDDEN_ENDING)
    programs = [
        path for path in files if path.name.casefold().endswith(endings) and len(path.parts) == len(entry.parts)
    ]
    ranks: dict[int, list[PurePosixPath]] = {}
    for path in programs:
        if path not in asked and files[path].strip(BLANK):
            alone = sum(other.parent == path.parent for other in programs) == 1
            rank = _likeness(path, entry, alone=alone)
            # A program without its folder is named after the folder that it should lie in.
            if len(entry.parts) == 1 and entry in for_all:
                rank = max(rank, _LIKE * any(alike(path.stem, one.stem) for one in for_all))
            # Of what others import, only the very name can say that it is a program all the same.
            if files[path] in roles.libraries and rank < _SAME:
                rank = 0
            here = len(entry.parts) > 1 and path.parent == entry.parent and files[path] == roles.main_of_a_place
            ranks.setdefault(rank or int(here or files[path] == roles.main), []).append(path)
    best = ranks[max(ranks)] if ranks else []
    if len(best) > 1 and len({what_it_does(files[path]) for path in best}) == 1:
        best = [path for path in best if not of_yellow(path.stem)]  # one program for either colour
    return best[0] if len(best) == 1 and max(ranks) > 0 else None


def _likeness(path: PurePosixPath, entry: PurePosixPath, *, alone: bool) -> int:
    """Return how much the names speak for a file being meant as an entry point; 0 if too little."""
    same, likely = path.name == entry.name, alike(path.stem, entry.stem)
    hidden = path.name.casefold() == entry.name + ".txt"
    if len(entry.parts) == 1:
        return _SAME if hidden else _LIKE * likely
    in_its_folder = alike(str(path.parent), str(entry.parent))
    if in_its_folder and (same or likely or hidden):
        return _SAME + 1 + hidden
    if same or hidden:
        return _SAME
    return _LIKE * ((in_its_folder and alone) or (like_an_entry(path) and same_number(path.stem, entry.stem)))


def _moves(pairs: Iterable[tuple[PurePosixPath, PurePosixPath]]) -> list[Move] | None:
    """Return the renaming of folders, then of files; None if one folder would need two names."""
    folders: dict[PurePosixPath, PurePosixPath] = {}
    files = []
    for old, new in pairs:
        if folders.setdefault(old.parent, new.parent) != new.parent:
            return None
        if old.name != new.name:
            files.append(Move(new.parent / old.name, new))
    return [Move(old, new) for old, new in folders.items() if old != new] + files


def moved(files: Files, moves: Iterable[Move]) -> Files | None:
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
