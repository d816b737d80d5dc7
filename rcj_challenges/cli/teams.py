"""Sample teams by name, and ``rcj-challenge teams``, which lists them."""

from __future__ import annotations

import ast
import os
import shutil
import sys
import textwrap
from pathlib import Path

from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError
from rcj_challenges.core.likeness import nearest_name
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.scenario.resources import shipped_teams


class UnknownTeamError(DiagnosticError):
    """A name that is no path and no sample team."""


def locate_team(given: str) -> Path:
    """Return where a team is: at a path that exists, else the sample team of that name.

    Args:
        given: as typed.

    Raises:
        UnknownTeamError: it looks like a name, and there is no such file, folder or sample team.
    """
    path = path_or_sample_team(Path(given))
    if os.path.exists(path) or path.name != given or path.suffix:  # noqa: PTH110 - pathlib's raises for long names
        return path
    near = nearest_name(given.casefold(), shipped_teams())
    suggestion = f"did you mean {near}? " if near else ""
    raise UnknownTeamError(
        Diagnostic(
            "unknown-team",
            f"no file, folder or sample team '{sanitize(given)}'",
            f"{suggestion}'rcj-challenge teams' lists the sample teams",
        )
    )


def path_or_sample_team(given: Path) -> Path:
    """Return the folder of the sample team of that name if nothing else is there, else what was given."""
    if os.path.exists(given):  # noqa: PTH110 - pathlib's raises for long names
        return given
    return shipped_teams().get(str(given), given)


def list_teams() -> int:
    """Print the sample teams, one sentence each; returns 0."""
    teams = shipped_teams()
    indent = max(map(len, teams), default=0) + 2
    width = min(shutil.get_terminal_size().columns, 120)
    for name, folder in teams.items():
        lines = textwrap.wrap(_sentence_about(folder), max(width - indent, 20)) or [""]
        sys.stdout.write(f"{name:<{indent}}{lines[0]}\n")
        sys.stdout.writelines(f"{'':{indent}}{line}\n" for line in lines[1:])
    return 0


def _sentence_about(team: Path) -> str:
    """Return the first sentence of the docstring of a team's program."""
    programs = [path for path in sorted(team.rglob("*.py")) if path.stem in ("robot", path.parent.name)]
    for program in programs[:1]:
        text = ast.get_docstring(ast.parse(program.read_text(encoding="utf-8"))) or ""
        return text.partition("\n")[0].partition(". ")[0].rstrip(".") + "."
    return ""
