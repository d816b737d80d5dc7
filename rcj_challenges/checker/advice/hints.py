"""Finds help for a failed program: tries the special cases and the table in turn."""

from __future__ import annotations

import os
import re
from collections.abc import Mapping, Sequence
from pathlib import Path, PurePosixPath, PureWindowsPath
from posixpath import relpath
from typing import Any

from rcj_challenges.checker.advice.devices import device_help, missing_devices, none_help
from rcj_challenges.checker.advice.endings import ending_loop_help, hidden_error_help
from rcj_challenges.checker.advice.packets import packet_help
from rcj_challenges.checker.advice.table import help_for_error
from rcj_challenges.checker.file_beside import help_for_module_beside
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.core.traffic import Note
from rcj_challenges.programs.log import AFTER_ITS_END, ANOTHER_THREAD
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.submissions.team import Team

WHEREABOUTS = "It was here, the innermost call first:\n"
"""What the match writes into a program's log after stopping it."""

_BETWEEN = (ANOTHER_THREAD.strip(), AFTER_ITS_END)
"""What stands between the places that a log names."""
HELP_BY_FAULT = {
    "crash": "the last line of the report below says what is wrong, the lines above it where",
    "exit": "call robot.step(32) in a loop until it returns -1; a program that ends leaves its robot standing",
    "start_timeout": "call robot.step(32) sooner: is there a loop before it, or something that takes long to load?",
    "step_timeout": "look for a loop that never calls robot.step(32), at the place below if one is named",
    "half_timeout": "do less in each step: the program may only compute and wait for that long in a whole half",
    "memory": "keep less, start fewer threads: is there a list that grows in every step?",
    "output_flood": "print less, and write fewer files",
    "protocol": "leave the channel to the match alone: let the controller module do the talking",
    "start": "if the files are in order, this computer may be the reason: ask the organizers",
}
"""Help by the kind of fault, if nothing more specific is known."""
_STANDS = 'if it waits on purpose, all is well; else call setPosition(float("inf")) and setVelocity on both motors'
_CALLED_EXIT = (
    "leave out exit(), quit() and sys.exit(), or call them only after step has returned -1: "
    "the robot of a program that ends stands for the rest of the half"
)
_THREADS_ALONE = (
    "the program itself came to its end, and only its threads go on: let one of them call robot.step(32) in a loop, or "
    "keep that loop in the program itself"
)
_MAX_CODE_CHARACTERS = 80
_MAX_LOG_BYTES = 100_000  # at each end
_PLACE = re.compile(r'^  File "(?P<file>[^"]+)", line (?P<line>[0-9]{1,7})\b', re.MULTILINE)
_NO_MODULE = re.compile(r"^ModuleNotFoundError: No module named '(?P<name>\w{1,100})")
_NO_FILE = re.compile(r"^FileNotFoundError: \[Errno 2\] No such file or directory: '(?P<path>[^']{1,300})'")


def hint_for(
    scenario: Scenario, team: Team, fault: Mapping[str, Any], notes: Sequence[Note] = (), whereabouts: str = ""
) -> str:
    """Advice on a fault whose cause is clear; empty on any other.

    Args:
        scenario: what was played.
        team: whose program failed.
        fault: as in the result.
        notes: of the robot's program.
        whereabouts: where the program was when it was stopped; empty if that is not known.
    """
    kind, detail = fault["kind"], fault["detail"]
    entry = PurePosixPath(team.entries.get(fault["robot"], ""))
    if kind == "crash":
        special = packet_help(scenario, team, fault) or none_help(scenario, team, fault, notes)
        return special or _missing_help(team, detail, entry.parent) or help_for_error(detail)
    if kind == "exit" and detail.startswith("the program called sys.exit"):
        return _CALLED_EXIT
    if kind == "exit" and detail.startswith("the program came to its end"):
        return ending_loop_help(team.files, entry) or hidden_error_help(team.files, entry)
    if kind in ("step_timeout", "start_timeout") and whereabouts:
        return _timeout_help(team, whereabouts)
    return ""


def read_log(logs: Path, robot: str) -> str:
    """Return the beginning of a robot's log, where its program asks for devices, and the end, where a fault stands.

    Args:
        logs: the folder with the robots' logs.
        robot: its name.
    """
    try:
        with (logs / f"{robot}.log").open("rb") as file:
            head = file.read(_MAX_LOG_BYTES)
            size = file.seek(0, os.SEEK_END)
            file.seek(max(len(head), size - _MAX_LOG_BYTES))
            rest = file.read(_MAX_LOG_BYTES)
    except OSError:
        return ""
    gap = b"\n...\n" if size > len(head) + len(rest) else b""
    return (head + gap + rest).decode("utf-8", "replace")


def whereabouts_in(log: str) -> str:
    """Return the lines of a log that say where a program was when it was stopped; empty if there are none."""
    _, found, rest = log.rpartition(WHEREABOUTS)
    lines = rest.splitlines() if found else []
    inside = [line for line in lines if line.startswith("  File ") or line in _BETWEEN]
    return "\n".join([WHEREABOUTS.strip(), *inside]) if inside else ""


def standing_help(scenario: Scenario, team: Team, robot: str, notes: Sequence[Note] = ()) -> str:
    """Advice on a robot that never moves although its program did not fail."""
    missing = missing_devices(notes)
    for name in missing:
        return f'it asks for a device "{sanitize(name)}"; {device_help(scenario, team, robot, name, missing)}'
    hidden = hidden_error_help(team.files, PurePosixPath(team.entries[robot]))
    return f"{_STANDS}; or an error is hidden: {hidden}" if hidden else _STANDS


def _missing_help(team: Team, detail: str, current: PurePosixPath) -> str:
    """Return where a module or a file is that was not found, or where to put it; empty if that is not the reason."""
    module = _NO_MODULE.match(detail)
    beside = help_for_module_beside(team, module["name"]) if module is not None else ""
    if beside:
        return beside
    missing = _NO_FILE.match(detail)
    if missing is None:
        return ""
    name = PureWindowsPath(missing["path"]).name
    found = next((path for path in team.files if path.name.casefold() == name.casefold()), None)
    folder = sanitize(current) if current.parts else "the folder of the program"
    if found is not None:
        root = PurePosixPath("/")  # so that the current folder of this process does not matter
        return (
            f'write "{sanitize(relpath(root / found, root / current))}": the file is {sanitize(found)}, and the '
            f"current folder is {folder}; upper and lower case matter, and / separates folders"
        )
    return (
        f'{sanitize(name)} is not in the submission: put it into {folder} and open it as "{sanitize(name)}"; '
        "a folder to write into has to be made first (os.makedirs)"
    )


def _timeout_help(team: Team, whereabouts: str) -> str:
    """Return the line in which a program was when it was stopped; with several threads none can be blamed."""
    lines = whereabouts.splitlines()
    if AFTER_ITS_END in lines:
        return _THREADS_ALONE
    found = _PLACE.search(whereabouts)
    if found is None or ANOTHER_THREAD.strip() in lines:
        return ""
    code = _code_at(team.files, found["file"], int(found["line"]))
    place = f"line {found['line']} of {sanitize(found['file'])}" + (f" ({code})" if code else "")
    return (
        f"look for a loop or a wait that never calls robot.step(32): the program was in {place}; between two steps "
        "nothing arrives"
    )


def _code_at(files: Mapping[PurePosixPath, bytes], file: str, line: int) -> str:
    """Return the beginning of a line, counted from 1; empty if there is none."""
    lines = files.get(PurePosixPath(file.replace("\\", "/")), b"").splitlines()
    return sanitize(lines[line - 1][:500].strip(), _MAX_CODE_CHARACTERS) if 0 < line <= len(lines) else ""
