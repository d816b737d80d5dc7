"""Files that a program needs and does not have because it was given alone, without its folder."""

from __future__ import annotations

import re
from pathlib import PurePath, PurePosixPath, PureWindowsPath

from rcj_challenges.checker.advice.crash_site import unquote
from rcj_challenges.controllers.team import Team
from rcj_challenges.core.sanitize import sanitize

_MAX_LETTERS = 300  # of a path that is looked for
_MODULE = re.compile(r"^ModuleNotFoundError: No module named '(?P<module>\w{1,100})")
_FILE = re.compile(
    rf"""^FileNotFoundError: \[Errno 2\] No such file or directory: (?P<path>'(?:[^'\\]|\\.){{1,{_MAX_LETTERS}}}')"""
)


def help_for_file_beside(team: Team, detail: str) -> str:
    """Return what to do about a crash over a file beside a single program; empty if that is not the reason.

    Args:
        team: whose program failed.
        detail: the last line of the traceback.
    """
    if (found := _MODULE.match(detail)) is not None:
        return help_for_module_beside(team, found["module"])
    if (found := _FILE.match(detail)) is not None:
        asked: PurePath = PureWindowsPath(unquote(found["path"]))
        return _help_for(team, asked.parts[0]) if asked.parts and not asked.anchor else ""
    return ""


def help_for_module_beside(team: Team, module: str) -> str:
    """Return what to do about an import of a file beside a single program; empty if there is none."""
    return _help_for(team, f"{module}.py") or _help_for(team, module)


def _help_for(team: Team, name: str) -> str:
    if not team.ignores_neighbour(name):
        return ""
    program = next(iter(team.files), PurePosixPath("the program"))
    return (
        f"{sanitize(name)} lies beside {sanitize(program)}, but only that one file was given: give the folder in which "
        "both lie"
    )
