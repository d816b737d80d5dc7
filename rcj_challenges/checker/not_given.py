"""What a program lacks because it was given as a single file, and not with the folder in which it lies."""

from __future__ import annotations

import re
from pathlib import PurePath, PurePosixPath, PureWindowsPath

from rcj_challenges.checker.advice.crash_site import unquote
from rcj_challenges.controllers.team import Team
from rcj_challenges.facts.shown import shown

_MOST_LETTERS = 300  # of a path that is looked for
_MODULE = re.compile(r"^ModuleNotFoundError: No module named '(?P<module>\w{1,100})")
_FILE = re.compile(
    rf"""^FileNotFoundError: \[Errno 2\] No such file or directory: (?P<path>'(?:[^'\\]|\\.){{1,{_MOST_LETTERS}}}')"""
)


def on_not_given(team: Team, detail: str) -> str:
    """Return what to do about a crash over what lies beside a single program; nothing if that is not the reason.

    Args:
        team: whose program failed.
        detail: the last line of what the program told of its end.
    """
    if (found := _MODULE.match(detail)) is not None:
        return module_not_given(team, found["module"])
    if (found := _FILE.match(detail)) is not None:
        asked: PurePath = PureWindowsPath(unquote(found["path"]))
        return _told(team, asked.parts[0]) if asked.parts and not asked.anchor else ""
    return ""


def module_not_given(team: Team, module: str) -> str:
    """Return what to do about an import of what lies beside a single program; nothing if there is nothing."""
    return _told(team, f"{module}.py") or _told(team, module)


def _told(team: Team, name: str) -> str:
    if not team.leaves_beside(name):
        return ""
    program = next(iter(team.files), PurePosixPath("the program"))
    return (
        f"{shown(name)} lies beside {shown(program)}, but only that one file was given: give the folder in which "
        "both lie"
    )
