"""Writes a repaired copy of a submission: only repairs that need no decision. Programs are moved, never changed."""

from __future__ import annotations

import io
import os
import zipfile
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path, PurePosixPath

from rcj_challenges.checker.archives import Inspection, inspect
from rcj_challenges.checker.identity import find_logo
from rcj_challenges.checker.images import PictureError, as_png
from rcj_challenges.checker.layout import empty_programs
from rcj_challenges.checker.others import others_that_fit
from rcj_challenges.checker.renaming import plan_moves
from rcj_challenges.core.amounts import counted
from rcj_challenges.core.errors import taken
from rcj_challenges.core.files import write_new
from rcj_challenges.programs.private_folders import PrivateFolders
from rcj_challenges.records.logos import LogoError, checked_png
from rcj_challenges.scenario.models.robots import Entrant
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.submissions.archive import Files
from rcj_challenges.submissions.paths import clean, folded
from rcj_challenges.submissions.problems import MAX_OF_A_KIND, safe_text
from rcj_challenges.submissions.team import LOGO_FILE, Opening, called_after, opening_of, wanted_programs
from rcj_challenges.submissions.team_name import NAME_FILE, find_team_name

_NAME_PATH, _LOGO_PATH = PurePosixPath(NAME_FILE), PurePosixPath(LOGO_FILE)
_FIRST_DAY = (1980, 1, 1, 0, 0, 0)  # the earliest that a ZIP can say
_FILE_MODE, _FOLDER_MODE = 0o100644 << 16, 0o040755 << 16
_FOLDER_MARK = 0x10
_UNIX = 3
# What writing a new archive repairs, and the message about it.
_BY_WRITING = {
    "archive.leftovers": "left out what is none of the team's work (of the system, of editors, records of runs)",
    "archive.backslashes": "separated folders and files by /",
    "archive.no_folders": "added entries for the folders",
    "archive.prepended": "left out what stood before the archive",
    "archive.trailing": "left out what followed the archive",
    "archive.headers": "corrected sizes and checksums",
    "archive.outside_folder": "left out folders that led out of the archive",
    "archive.duplicate": "kept one of two equal files",
}


@dataclass
class Repaired:
    """The result of a repair.

    Attributes:
        out: the archive that was written; None if the submission cannot be read well enough to write any.
        done: what was put right, one line each; empty if nothing had to be.
        left: what has to be put right by hand, one line each.
    """

    out: Path | None = None
    done: list[str] = field(default_factory=list)
    left: list[str] = field(default_factory=list)


def repair(path: Path, out: Path, scenario: Scenario) -> Repaired:
    """Write a corrected archive of a submission.

    The same submission always gives the same bytes. What a program consists of is not changed.

    Args:
        path: a ZIP, a folder or a single program; it is only read.
        out: where to write; nothing may be there.
        scenario: says which programs are asked for.

    Raises:
        RcjError: something is at ``out`` already, or it cannot be written.
        TeamError: there is nothing at ``path`` that can be opened.
    """
    if os.path.lexists(out):
        raise taken(out)
    found = inspect(path, scenario)
    hopeless = _hopeless(found)
    if hopeless:
        return Repaired(left=hopeless)
    result = Repaired(out)
    data = _zipped(_with_its_name(_corrected(found, scenario, result.done), found.opening.name.text, out, result.done))
    with PrivateFolders() as folders:
        # Under the name it will have: a team without a name is called after its archive.
        trial = folders.place / "trial" / out.name
        trial.parent.mkdir()
        trial.write_bytes(data)
        written = inspect(trial, scenario)
    result.left = [
        finding.sentence for stage in written.stages for finding in stage.findings if finding.level != "passed"
    ]
    if written.stages[0].failed:  # two names, or a file and a folder, in one place
        return Repaired(left=result.left)
    write_new(out, data)
    return result


def _hopeless(found: Inspection) -> list[str]:
    """Return why nothing can be written: parts cannot be read, or it is unclear which file to use."""
    contents = found.opening.contents
    if not contents.complete or any(not problem.repair for problem in contents.refused):
        return [problem.sentence for problem in contents.refused]
    taken = set(map(folded, contents.files))
    clashes = []
    for name in contents.unsafe:
        path = clean(name)
        if path is None or folded(path) in taken:
            clashes.append(f"'{safe_text(name)}' would lie where another file is: rename one")
        else:
            taken.add(folded(path))
    return clashes


def _corrected(found: Inspection, scenario: Scenario, done: list[str]) -> Files:
    """Return the files as they should be, and note what was done."""
    contents = found.opening.contents
    codes = dict.fromkeys(problem.code for problem in contents.problems if problem.repair)
    done += [text for code, text in _BY_WRITING.items() if code in codes]
    # The new archive names the encoding of its file names: nothing shows any more that it was guessed.
    guessed = (problem for problem in contents.problems if problem.code == "archive.name_guessed")
    done += [
        f"wrote names as they were read, maybe wrongly; use plain letters: {problem.message.partition(': ')[2]}"
        for problem in guessed
    ]
    if contents.kind == "program":
        return _as_folder(found.opening, found.seats, done)
    if contents.kind == "folder":
        done.append("packed the folder as a ZIP archive")
    opening = _with_safe_names(found.opening, found.seats, done)
    files = _laid_out(opening, found.seats, scenario, done)
    files = _named(files, opening.name.text, done)
    return _with_a_logo(files, done)


def _as_folder(opening: Opening, seats: Sequence[Entrant], done: list[str]) -> Files:
    """Return a single program as the program of each robot."""
    content = next(iter(opening.files.values()))
    wanted = dict.fromkeys(entries[0] for entries in wanted_programs(seats).values())
    done.append(f"packed the program as {', '.join(wanted)}")
    return {PurePosixPath(entry): content for entry in sorted(wanted)}


def _with_safe_names(opening: Opening, seats: Sequence[Entrant], done: list[str]) -> Opening:
    """Return the submission with every file in a place that every computer has."""
    contents = opening.contents
    files, renamed_files = dict(contents.files), []
    for name, content in contents.unsafe.items():
        path = clean(name)
        if path is not None:  # see _hopeless
            files[path] = content
            renamed_files.append(f"renamed '{safe_text(name)}' to {safe_text(path)}")
    done += renamed_files[:MAX_OF_A_KIND]
    if len(renamed_files) > MAX_OF_A_KIND:
        done.append(f"and {counted(len(renamed_files) - MAX_OF_A_KIND, 'more file')}")
    renamed = replace(contents, files=dict(sorted(files.items())), problems=(), unsafe={})
    source = opening.team.source if opening.team else Path(opening.name.text)
    return opening_of(source, renamed, *seats)


def _laid_out(opening: Opening, seats: Sequence[Entrant], scenario: Scenario, done: list[str]) -> Files:
    """Return the files with programs and folders where they are asked for."""
    files = opening.files
    if opening.missing:
        others = others_that_fit(opening.contents.files, scenario)
        plan = plan_moves(opening.contents.files, seats) if not others else None
        if plan is None or plan.caution:
            return opening.contents.files
        files = plan.files
        done += [f"as asked: {move}" for move in plan.moves]
    else:
        done += _changed_folders(opening)
    for empty in empty_programs(files, seats):
        if empty.spare:
            done.append(f"left out the empty {safe_text(empty.path)}")
            files = {path: content for path, content in files.items() if path != empty.path}
    return files


def _changed_folders(opening: Opening) -> list[str]:
    """Return which folders have changed."""
    top, done = opening.top, []
    if opening.within is not None and top.parts:
        done.append(f"renamed the folder {safe_text(top)} to {safe_text(opening.within)}")
        top = top.parent
    elif opening.within is not None:
        done.append(f"put the programs into the folder {safe_text(opening.within)}")
    if top.parts:
        done.append(f"took everything out of the extra folder {safe_text(top)}")
    return done


def _named(files: Files, fallback: str, done: list[str]) -> Files:
    """Return the files with the team's name in its proper place, as it is shown."""
    name = find_team_name(files, fallback)
    codes = {problem.code for problem in name.problems if problem.repair}
    if name.path is None or not codes:
        return files
    readable = name.given and all(problem.code != "identity.name_encoding" for problem in name.problems)
    content = f"{name.text}\n".encode() if readable else files[name.path]
    if name.path != _NAME_PATH:
        done.append(f"took the team's name from {safe_text(name.path)} to {NAME_FILE}")
    if codes - {"identity.name_file"}:
        done.append(f"rewrote {NAME_FILE}: {name.text}")
    return _placed(files, name.path, _NAME_PATH, content)


def _with_its_name(files: Files, shown: str, out: Path, done: list[str]) -> Files:
    """Return the files with the name that the team is shown by, where that of its new file would take its place."""
    name = find_team_name(files, called_after(out.name))
    in_a_document = any(problem.code == "identity.name_document" for problem in name.problems)  # for the team to open
    if name.given or name.text == shown or in_a_document:
        return files
    done.append(f"wrote {NAME_FILE}: {shown}, as the team is called by its file's name")
    return dict(sorted((files | {_NAME_PATH: f"{shown}\n".encode()}).items()))


def _with_a_logo(files: Files, done: list[str]) -> Files:
    """Return the files with a logo that can be shown, or without one."""
    logo = find_logo(files)
    path = logo.path
    if path is None or not any(finding.repair for finding in logo.findings):
        return files
    picture = files[path]
    try:
        sound = checked_png(picture) and not any(finding.code == "identity.logo_animated" for finding in logo.findings)
    except LogoError:
        sound = False
    try:
        content = picture if sound else as_png(picture)
    except PictureError as error:
        if len(path.parts) > 1:
            return files
        done.append(f"left out {safe_text(path)}: {error}")
        return {other: data for other, data in files.items() if other != path}
    if not sound:
        done.append(f"made a PNG of {safe_text(path)} that can be shown")
    if path != _LOGO_PATH:
        done.append(f"took the logo from {safe_text(path)} to {LOGO_FILE}")
    return _placed(files, path, _LOGO_PATH, content)


def _placed(files: Files, old: PurePosixPath, new: PurePosixPath, content: bytes) -> Files:
    """Return the files with one put at the top; a copy stays in its folder, where a program may need it."""
    kept = {path: data for path, data in files.items() if path != old or len(old.parts) > 1}
    return dict(sorted((kept | {new: content}).items()))


def _zipped(files: Files) -> bytes:
    """Return an archive with folders before what is in them, and nothing of this computer or this moment."""
    folders = {parent for path in files for parent in path.parents if parent.parts}
    members = {f"{folder}/": b"" for folder in folders} | {str(path): content for path, content in files.items()}
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in sorted(members.items()):
            entry = zipfile.ZipInfo(name, _FIRST_DAY)
            entry.create_system = _UNIX
            entry.compress_type = zipfile.ZIP_STORED if name.endswith("/") else zipfile.ZIP_DEFLATED
            entry.external_attr = _FOLDER_MODE | _FOLDER_MARK if name.endswith("/") else _FILE_MODE
            archive.writestr(entry, content)
    return out.getvalue()
