"""Checks whether folders and programs are where the scenario looks for them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import PurePosixPath

from rcj_challenges.checker import codes
from rcj_challenges.checker.others import suggest_scenarios
from rcj_challenges.checker.renaming import all_entries, entries_of, plan_moves
from rcj_challenges.checker.similar_names import BLANK, alike, like_an_entry, mentioned
from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.core.grouping import grouped
from rcj_challenges.scenario.models.robots import Entrant
from rcj_challenges.submissions.codes import LAYOUT_MISSING
from rcj_challenges.submissions.problems import safe_text
from rcj_challenges.submissions.team import Opening, missing_programs

_MAX_EMPTY = 10
_MAX_NEVER_STARTED = 10


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


def layout_findings(opening: Opening, seats: Sequence[Entrant], others: Sequence[str]) -> list[Diagnostic]:
    """Return findings on the places of a submission's files.

    Args:
        opening: the result of opening it.
        seats: the entrants for which it was opened.
        others: the shipped scenarios that it fits, if it does not fit this one.
    """
    found = _folder_findings(opening)
    if opening.missing:
        return found + _missing(opening, seats, others)
    found += _empty_findings(opening, seats)
    return found if opening.contents.kind == "program" else [*found, *_program_findings(opening, seats)]


def empty_programs(files: Mapping[PurePosixPath, bytes], seats: Sequence[Entrant]) -> list[Empty]:
    """Find empty files that look like entry points."""
    chosen = entries_of(files, seats)
    asked = all_entries(seats)
    found: list[Empty] = []
    for path, content in files.items():
        if path.suffix != ".py" or content.strip(BLANK) or not (path in asked or like_an_entry(path)):
            continue
        if len(found) == _MAX_EMPTY:
            break
        started = tuple(robot for robot, entry in chosen.items() if entry == path)
        without = {other: data for other, data in files.items() if other != path}
        instead = entries_of(without, seats)
        served = all((entry := instead[robot]) is not None and without[entry].strip(BLANK) for robot in started)
        found.append(Empty(path, started, spare=served and not mentioned(files, [path.stem])))
    return found


def _folder_findings(opening: Opening) -> list[Diagnostic]:
    if opening.contents.kind == "program":
        message = f"a single program drives all robots: {safe_text(next(iter(opening.files), ''))}"
        return [Diagnostic(codes.LAYOUT_SINGLE_PROGRAM, message, "a submission is a ZIP")]
    if opening.contents.kind != "zip":
        return []
    top, found = opening.top, []
    if opening.within is not None and not top.parts:
        message = f"the programs are not in a folder {safe_text(opening.within)}"
        found.append(Diagnostic(codes.LAYOUT_NO_FOLDER, message, "pack that folder, not only what is in it"))
    elif opening.within is not None:
        message = f"the folder of the programs is called {safe_text(top.name)}"
        help_ = f"call it {safe_text(opening.within)}"
        found.append(Diagnostic(codes.LAYOUT_FOLDER_NAME, message, help_, safe_text(top)))
        top = top.parent
    if top.parts:
        message = f"everything lies in an extra folder: {safe_text(top)}"
        help_ = "pack what is in it, not the folder itself"
        found.append(Diagnostic(codes.LAYOUT_TOP_FOLDER, message, help_, safe_text(top)))
    return found


def _missing(opening: Opening, seats: Sequence[Entrant], others: Sequence[str]) -> list[Diagnostic]:
    files = opening.contents.files
    plan = plan_moves(files, seats) if not others else None
    message = missing_programs(files, opening.missing, hint=plan is None, others=all_entries(seats))
    if plan is not None:
        help_ = "; ".join(filter(None, (", ".join(map(str, plan.moves)), plan.caution)))
        return [
            Diagnostic(codes.LAYOUT_MISNAMED, message, help_, safe_text(plan.moves[0].old), repair=not plan.caution)
        ]
    nested = [problem for problem in opening.contents.problems if problem.code == "archive.nested"]
    if nested:
        help_ = f"pack what is in {nested[0].where}, not the archive itself"
    else:
        elsewhere = f"{suggest_scenarios(others)}; if it is for this scenario, " if others else ""
        help_ = f"{elsewhere}add or rename the program: {' or '.join(next(iter(opening.missing.values())))}"
    return [Diagnostic(LAYOUT_MISSING, message, help_)]


def _empty_findings(opening: Opening, seats: Sequence[Entrant]) -> list[Diagnostic]:
    found = []
    for empty in empty_programs(opening.files, seats):
        name = safe_text(empty.path)
        if empty.started:
            message = f"{name} is empty, and it is what {', '.join(empty.started)} would be started with"
            help_ = "delete it" if empty.spare else "put the program into it"
            found.append(Diagnostic(codes.LAYOUT_EMPTY_ENTRY, message, help_, name, repair=empty.spare))
        else:
            message = f"{name} is empty, and this scenario does not ask for it"
            found.append(Diagnostic(codes.LAYOUT_EMPTY_PROGRAM, message, "delete it", name, repair=empty.spare))
    return found


def _program_findings(opening: Opening, seats: Sequence[Entrant]) -> list[Diagnostic]:
    """Return which robots are started with which program, and the programs that no robot is started with.

    The latter are alternatives that the scenario names and does not take, and folders with a name much like one that it
    takes. What the other programs mention belongs to them.
    """
    chosen = entries_of(opening.files, seats)
    robots = grouped((entry, robot) for robot, entry in chosen.items() if entry is not None)
    found = [
        Diagnostic(codes.LAYOUT_PROGRAM, f"{', '.join(names)}: {safe_text(entry)}", where=safe_text(entry))
        for entry, names in robots.items()
    ]
    # Beside an empty file that is to be deleted, those that are started then are in use.
    spare = {empty.path for empty in empty_programs(opening.files, seats) if empty.started and empty.spare}
    files = {path: content for path, content in opening.files.items() if path not in spare}
    entries = [entry for entry in entries_of(files, seats).values() if entry is not None]
    folders, asked = {entry.parent.name for entry in entries}, all_entries(seats)
    likely = [
        path
        for path, content in files.items()
        if path not in entries
        and like_an_entry(path)
        and content.strip(BLANK)
        and (path in asked or any(alike(path.stem, folder) for folder in folders))
    ]
    for path in likely[:_MAX_NEVER_STARTED]:
        others = {other: content for other, content in files.items() if other.parts[0] != path.parts[0]}
        if not mentioned(others, [path.stem]):
            found.append(_never_started(files, path, entries))
    return found


def _never_started(
    files: Mapping[PurePosixPath, bytes], path: PurePosixPath, entries: Sequence[PurePosixPath]
) -> Diagnostic:
    place = safe_text(path)
    twin = next((entry for entry in entries if _content(files, path) == _content(files, entry)), None)
    if twin is not None:
        message = f"{place} is never started; what is in its folder is the same as in {safe_text(twin.parent)}"
        return Diagnostic(codes.LAYOUT_SAME_PROGRAM, message, where=place)
    started = ", ".join(safe_text(entry) for entry in dict.fromkeys(entries))
    message = f"{place} is never started: robots of either colour are started with {started}"
    help_ = "put what it does into the program that is started, which can call robot.getName(); else delete it"
    return Diagnostic(codes.LAYOUT_NEVER_STARTED, message, help_, place)


def _content(files: Mapping[PurePosixPath, bytes], entry: PurePosixPath) -> dict[PurePosixPath, bytes]:
    """The files in the folder of a program, the program itself under a name that is the same for all."""
    return {
        PurePosixPath() if path == entry else path.relative_to(entry.parent): content
        for path, content in files.items()
        if path.is_relative_to(entry.parent)
    }
