"""Finds the submissions among the paths that were given, their names, and what lies beside them."""

from __future__ import annotations

import hashlib
import os
import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from rcj_challenges.checker.report import LeftOut
from rcj_challenges.core.sanitize import sanitize

ARCHIVES = frozenset({".zip", ".rar", ".7z", ".tar", ".gz", ".tgz", ".bz2", ".xz"})
"""Endings of archives; all but ZIPs fail the check."""

_MAX_OLD_ARCHIVES = 1
"""Beside programs one archive is an older state of them; several are what was handed in."""


@dataclass(frozen=True)
class SubmissionName:
    """The unique names of a submission within one check.

    Attributes:
        name: its file's name, or its whole path where another file has the same name; safe to show.
        slug: how the names of its replay pages begin: legal everywhere, whatever the file is called.
    """

    name: str
    slug: str


@dataclass(frozen=True)
class Submissions:
    """The submissions to check.

    Attributes:
        paths: the submissions, none of them twice.
        left_out: other things beside them, which are not checked.
    """

    paths: list[Path]
    left_out: list[LeftOut]


def find_submissions(given: Sequence[Path]) -> Submissions:
    """Return the submissions: of a folder full of archives each of them, everything else as it is.

    Raises:
        OSError: a folder cannot be looked into.
    """
    paths: dict[str, Path] = {}
    beside: dict[str, LeftOut] = {}
    for path in given:
        found, others = _in_folder(path) if path.is_dir() else ([path], {})
        paths |= {_place(submission): submission for submission in found if _place(submission) not in paths}
        for other, reason in others.items():
            beside[_place(other)] = LeftOut(file=sanitize(str(other)), reason=reason)
    return Submissions(list(paths.values()), [other for place, other in beside.items() if place not in paths])


def name_submissions(paths: Sequence[Path]) -> list[SubmissionName]:
    """Return the names of the submissions at these paths, in their order."""
    places = [Path(_place(path)) for path in paths]
    tails = [["/".join(place.parts[-length:]) for length in (1, 2)] for place in places]
    counts = Counter(tail for own in tails for tail in set(own))
    names = [
        next((tail for tail in own if counts[tail] == 1), place.as_posix())
        for own, place in zip(tails, places, strict=True)
    ]
    slugs = [file_slug(name) for name in names]
    taken = Counter(map(str.casefold, slugs))
    shown = Counter(map(sanitize, names))
    found = []
    for name, slug, place in zip(names, slugs, places, strict=True):
        # Of very long names the middle is not shown; slugs are equal of team.zip, the folder team and TEAM.zip.
        digest = _digest(str(place))
        safe = sanitize(name) if shown[sanitize(name)] == 1 else f"{sanitize(name)} ({digest})"
        found.append(SubmissionName(safe, slug if taken[slug.casefold()] == 1 else f"{slug}-{digest}"))
    return found


def file_slug(name: str) -> str:
    """Return a name made from a file's name that is legal everywhere and differs where the file's does."""
    stem = name.removesuffix(".zip")
    slug = re.sub(r"[^A-Za-z0-9_-]+", "_", stem).strip("_")[:60]
    return slug if slug and slug == stem else f"{slug or 'team'}-{_digest(name)}"


def _digest(name: str) -> str:
    return hashlib.sha256(name.encode("utf-8", "surrogatepass")).hexdigest()[:8]


def _place(path: Path) -> str:
    """Return where something is, the same however it was given; links keep their own names."""
    return os.path.abspath(path)  # noqa: PTH100 - `absolute` leaves ".." as it is


def _in_folder(folder: Path) -> tuple[list[Path], dict[Path, str]]:
    """Return the submissions in a folder, or the folder if it is a team's own; and what else lies there, with why."""
    entries = sorted(folder.iterdir())
    archives = [entry for entry in entries if _is_archive(entry)]
    program = _a_program(entries)
    if archives and (program is None or len(archives) > _MAX_OLD_ARCHIVES):
        return archives, {entry: _why_not(entry) for entry in entries if entry not in archives}
    if program is None:
        return [folder], {entry: _why_not(entry) for entry in entries if _is_archive_by_name(entry)}
    reason = f"the folder was taken for one team's own because of {sanitize(program.relative_to(folder))}"
    return [folder], dict.fromkeys(archives, f"{reason}; give the archive by its name to check it")


def _is_archive(entry: Path) -> bool:
    return _is_archive_by_name(entry) and not entry.name.startswith(".") and entry.is_file()


def _is_archive_by_name(entry: Path) -> bool:
    return entry.suffix.lower() in ARCHIVES or entry.name.lower() in ARCHIVES  # ".zip" is all name


def _a_program(entries: Sequence[Path]) -> Path | None:
    """Return a program at the top of a folder or one step below; None if there is none."""
    inside = (inner for entry in entries if entry.is_dir() for inner in sorted(entry.glob("*.py")))
    programs = (entry for entry in (*entries, *inside) if entry.suffix == ".py" and not entry.name.startswith("."))
    return next(programs, None)


def _why_not(entry: Path) -> str:
    """Return why something beside archives is not looked at, and what to do if it should be."""
    if entry.name.startswith("."):
        return "its name begins with a dot, like files that other programs leave behind"
    if entry.is_dir():
        return "it is a folder: give it by its name if it is a submission, or if there are some in it"
    return "its name does not end like that of an archive: give it by its name if it is a submission"
