"""Modules that a program needs and does not have because it was given alone, without its folder."""

from __future__ import annotations

from pathlib import PurePosixPath

from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.submissions.team import Team


def help_for_module_beside(team: Team, module: str) -> str:
    """Advice on an import of a file or folder beside a single program; empty if there is none."""
    name = next((name for name in (f"{module}.py", module) if team.ignores_neighbour(name)), "")
    program = next(iter(team.files), PurePosixPath("the program"))
    return name and (
        f"{sanitize(name)} lies beside {sanitize(program)}, but only that one file was given: give the folder in which "
        "both lie"
    )
