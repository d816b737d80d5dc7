"""``rcj-challenge teams``: lists the sample teams."""

from __future__ import annotations

import ast
import shutil
import sys
import textwrap
from pathlib import Path

from rcj_challenges.cli.app import PLAY, app
from rcj_challenges.scenario.resources import shipped_teams


@app.register(PLAY, "rcj-challenge teams")
def teams() -> None:
    """List the sample teams, which can be used by name: --blue ball_chaser."""
    shipped = shipped_teams()
    indent = max(map(len, shipped), default=0) + 2
    width = min(shutil.get_terminal_size().columns, 120)
    for name, folder in shipped.items():
        lines = textwrap.wrap(_sentence_about(folder), max(width - indent, 20)) or [""]
        sys.stdout.write(f"{name:<{indent}}{lines[0]}\n")
        sys.stdout.writelines(f"{'':{indent}}{line}\n" for line in lines[1:])


def _sentence_about(team: Path) -> str:
    """The first sentence of the docstring of a team's program."""
    programs = [path for path in sorted(team.rglob("*.py")) if path.stem in ("robot", path.parent.name)]
    for program in programs[:1]:
        text = ast.get_docstring(ast.parse(program.read_text(encoding="utf-8"))) or ""
        return text.partition("\n")[0].partition(". ")[0].rstrip(".") + "."
    return ""
