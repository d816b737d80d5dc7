"""Programs in a submission that look like ones to be started, and that no robot is started with."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from pathlib import PurePosixPath

from rcj_challenges.checker.findings import Finding
from rcj_challenges.checker.likeness import BLANK, alike, like_an_entry, mentioned
from rcj_challenges.controllers.troubles import told

_MOST_FINDINGS = 10


def never_started(
    files: Mapping[PurePosixPath, bytes], entries: Sequence[PurePosixPath], asked: Collection[PurePosixPath]
) -> list[Finding]:
    """Tell of programs in a folder of their own name that no robot is started with, though one might think so.

    These are alternatives that the scenario names and does not take, and folders that are called much as one that it
    takes. What the other programs mention is theirs.

    Args:
        files: of the submission.
        entries: the programs that robots are started with.
        asked: all paths at which the scenario looks for programs.
    """
    folders = {entry.parent.name for entry in entries}
    likely = [
        path
        for path, content in files.items()
        if path not in entries
        and like_an_entry(path)
        and content.strip(BLANK)
        and (path in asked or any(alike(path.stem, folder) for folder in folders))
    ]
    found = []
    for path in likely[:_MOST_FINDINGS]:
        others = {other: content for other, content in files.items() if other.parts[0] != path.parts[0]}
        if not mentioned(others, [path.stem]):
            found.append(_finding(files, path, entries))
    return found


def _finding(files: Mapping[PurePosixPath, bytes], path: PurePosixPath, entries: Sequence[PurePosixPath]) -> Finding:
    twin = next((entry for entry in entries if _content(files, path) == _content(files, entry)), None)
    if twin is not None:
        message = f"{told(path)} is never started; what is in its folder is the same as in {told(twin.parent)}"
        return Finding("layout.same_program", "passed", message, where=told(path))
    started = [told(entry) for entry in dict.fromkeys(entries)]
    if len(started) > 1:
        why = f"robots are started with {', '.join(started)}"
    else:
        why = f"{started[0]} is what all robots are started with, whatever their colour"
    message = f"{told(path)} is never started: {why}"
    remedy = (
        "put what it does into the program that is started, which can ask robot.getName() who it is; else delete it"
    )
    return Finding("layout.never_started", "warning", message, remedy, told(path))


def _content(files: Mapping[PurePosixPath, bytes], entry: PurePosixPath) -> dict[PurePosixPath, bytes]:
    """Return what is in the folder of a program, the program itself under a name that is the same for all."""
    return {
        PurePosixPath() if path == entry else path.relative_to(entry.parent): content
        for path, content in files.items()
        if path.is_relative_to(entry.parent)
    }
