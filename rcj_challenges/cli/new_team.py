"""``rcj-challenge new team``: a team that plays, with what VS Code needs to run and debug it."""

from __future__ import annotations

import os
import sys
from pathlib import Path

from rcj_challenges.cli.says import typed
from rcj_challenges.cli.starter import StarterError, refuse_name, write_new
from rcj_challenges.scenario.resources import starters_folder

_FILES = {
    "robot.py": "robot.txt",
    "README.md": "README.md",
    ".vscode/launch.json": "vscode/launch.json",
    ".vscode/tasks.json": "vscode/tasks.json",
}


def new_team(name: str) -> int:
    """Write a team's folder; print what to do with it. Returns 0.

    Args:
        name: its name or path.

    Raises:
        StarterError: the name is none, or there is something of that name.
    """
    folder = Path(name)
    refuse_name(folder.name, name)
    if os.path.exists(folder):  # noqa: PTH110 - that of pathlib raises for names that are too long
        raise StarterError(f"{folder} exists already; nothing was written. Choose another name, or move it away")
    title = " ".join(folder.name.replace("_", " ").replace("-", " ").split()).capitalize()
    words = {"TEAM_NAME": title, "TEAM_FOLDER": typed(folder.name), "TEAM_ZIP": typed(f"{folder.name}.zip")}
    for target, source in _FILES.items():
        text = (starters_folder() / "team" / source).read_text(encoding="utf-8")
        for word, value in words.items() if target == "README.md" else ():
            text = text.replace(word, value)
        write_new(folder / target, text)
    write_new(folder / "team_name.txt", f"{title}\n")
    sys.stdout.write(f"""{folder}
Now:
  rcj-challenge run match --yellow {typed(folder)} --blue ball_chaser --duration 1:00 --open
  rcj-challenge check {typed(folder)}
""")
    return 0
