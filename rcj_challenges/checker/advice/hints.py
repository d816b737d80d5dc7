"""Finds help for a failed program: tries the table and the special cases in turn."""

from __future__ import annotations

import re
import sys
from collections.abc import Mapping
from pathlib import PurePosixPath, PureWindowsPath
from posixpath import relpath
from typing import Any

from rcj_challenges.checker.advice.crash_site import code_at, unquote
from rcj_challenges.checker.advice.devices import DeviceAdvice, missing_devices, none_hint
from rcj_challenges.checker.advice.endings import hidden_error, why_it_ended
from rcj_challenges.checker.advice.packets import packet_hint
from rcj_challenges.checker.advice.table import Hint, find_old_name, find_row
from rcj_challenges.checker.file_beside import help_for_file_beside
from rcj_challenges.controllers.log import AFTER_ITS_END, ANOTHER_THREAD
from rcj_challenges.controllers.team import Team
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.scenario.models.scenario import Scenario

WHEREABOUTS = "It was here, the innermost call first:\n"
"""What the match writes into a program's log after stopping it."""

_BETWEEN = (ANOTHER_THREAD.strip(), AFTER_ITS_END)
"""What stands between the places that a log names."""
REMEDIES = {
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

_MAX_CODE_LETTERS = 80
_PLACE = re.compile(r'^  File "(?P<file>[^"]+)", line (?P<line>[0-9]{1,7})\b', re.MULTILINE)
_OF_MODULE = re.compile(
    r"cannot import name '\w+' from (?:partially initialized module )?'(?P<a>\w+)'|module '(?P<b>\w+)' has no attribute"
)
_NO_FILE = re.compile(
    r"""^FileNotFoundError: \[Errno 2\] No such file or directory: """
    r"""(?P<path>'(?:[^'\\]|\\.){1,300}'|"(?:[^"\\]|\\.){1,300}")"""
)
_CALLED_EXIT = (
    "leave out exit(), quit() and sys.exit(), or call them only after step has returned -1: "
    "the robot of a program that ends stands for the rest of the half"
)
_THREADS_ALONE = (
    "the program itself came to its end, and only its threads go on: let one of them call robot.step(32) in a loop, or "
    "keep that loop in the program itself"
)


def hint_for(
    scenario: Scenario, team: Team, fault: Mapping[str, Any], log: str = "", whereabouts: str = ""
) -> Hint | None:
    """Return the cause of a fault, if the evidence is clear.

    Args:
        scenario: what was played.
        team: whose program failed.
        fault: as in the result.
        log: of the robot, or its beginning.
        whereabouts: where the program was when it was stopped; empty if that is not known.
    """
    kind, detail = fault["kind"], fault["detail"]
    entry = PurePosixPath(team.entries.get(fault["robot"], ""))
    if kind == "crash":
        return _crash_hint(scenario, team, fault, entry.parent, log)
    if kind == "exit" and detail.startswith("the program called sys.exit"):
        return Hint("called_exit", _CALLED_EXIT)
    if kind == "exit" and detail.startswith("the program came to its end"):
        code, remedy = why_it_ended(team.files, entry, has_stepped=fault["tick"] > 0)
        return Hint(code, remedy) if code else None
    if kind in ("step_timeout", "start_timeout") and whereabouts:
        return _timeout_hint(team, whereabouts)
    return None


def whereabouts_in(log: str) -> str:
    """Return the lines of a log that say where a program was when it was stopped; empty if there are none."""
    _, found, rest = log.rpartition(WHEREABOUTS)
    lines = rest.splitlines() if found else []
    inside = [line for line in lines if line.startswith("  File ") or line in _BETWEEN]
    return "\n".join([WHEREABOUTS.strip(), *inside]) if inside else ""


def standing_help(scenario: Scenario, team: Team, robot: str, log: str = "") -> str:
    """Return what to do about a robot that never moves although its program did not fail.

    Args:
        scenario: what was played.
        team: whose program it is.
        robot: its name.
        log: of the robot, or its beginning: there it asks for its devices.
    """
    missing = missing_devices(log)
    for name, has in missing.items():
        help_ = DeviceAdvice(scenario, team, missing).remedy(name, robot, has)
        return f'it asks for a device "{sanitize(name)}"; {help_}'
    hidden = hidden_error(team.files, PurePosixPath(team.entries[robot]))
    return f"{_STANDS}; or an error is hidden: {hidden}" if hidden else _STANDS


def _crash_hint(
    scenario: Scenario, team: Team, fault: Mapping[str, Any], current: PurePosixPath, log: str
) -> Hint | None:
    detail = fault["detail"]
    texts = (
        ("file_not_given", help_for_file_beside(team, detail)),
        ("no_device", none_hint(scenario, team, fault["robot"], detail, log)),
        ("hidden_module", _hidden_module(team, detail)),
        ("old_name", find_old_name(detail)),
        ("no_file", _missing_file(team, detail, current)),
    )
    special = next((Hint(code, text) for code, text in texts if text), None)
    return packet_hint(scenario, team, fault) or special or find_row(detail)


def _hidden_module(team: Team, detail: str) -> str:
    """Return what to do if a file of the team hides a module of Python; else empty."""
    found = _OF_MODULE.search(detail)
    module = (found["a"] or found["b"]) if found is not None else ""
    own = next((path for path in team.files if path.name == f"{module}.py"), None)
    if own is None or module not in sys.stdlib_module_names:
        return ""
    return (
        f'{sanitize(own)} has the name of a module of Python, "{module}": give it another name, and import it by that'
    )


def _missing_file(team: Team, detail: str, current: PurePosixPath) -> str:
    """Return where a file is that was not found, or where to put it; empty if that is not the reason."""
    missing = _NO_FILE.match(detail)
    if missing is None:
        return ""
    name = PureWindowsPath(unquote(missing["path"])).name
    found = next((path for path in team.files if path.name.casefold() == name.casefold()), None)
    root = PurePosixPath("/")  # so that the current folder of this process does not matter
    folder = sanitize(current) if current.parts else "the folder of the program"
    if found is not None:
        return (
            f'write "{sanitize(relpath(root / found, root / current))}": the file is {sanitize(found)}, and the '
            f"current folder is {folder}; capital and small letters count, and / separates folders"
        )
    return (
        f'{sanitize(name)} is not in the submission: put it into {folder} and open it as "{sanitize(name)}"; '
        "a folder to write into has to be made first (os.makedirs)"
    )


def _timeout_hint(team: Team, whereabouts: str) -> Hint | None:
    """Return the line in which a program was when it was stopped; with several threads none can be blamed."""
    lines = whereabouts.splitlines()
    if AFTER_ITS_END in lines:
        return Hint("threads_alone", _THREADS_ALONE)
    found = _PLACE.search(whereabouts)
    if found is None or ANOTHER_THREAD.strip() in lines:
        return None
    code = code_at(team.files, found["file"], int(found["line"]))
    where = f"line {found['line']} of {sanitize(found['file'])}" + (
        f" ({sanitize(code, _MAX_CODE_LETTERS)})" if code else ""
    )
    return Hint(
        "no_step",
        f"look for a loop or a wait that never calls robot.step(32): the program was in {where}; between two steps "
        "nothing arrives",
    )
