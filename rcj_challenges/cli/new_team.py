"""``rcj-challenge new team``: a team that plays, with what VS Code needs to run and debug it."""

from __future__ import annotations

import sys
from pathlib import Path

from rcj_challenges.cli.new import refuse_existing, refuse_name, write_new
from rcj_challenges.cli.stdio import shell_quoted
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
    refuse_existing(folder)
    title = " ".join(folder.name.replace("_", " ").replace("-", " ").split()).capitalize()
    words = {
        "TEAM_NAME": title,
        "TEAM_FOLDER": shell_quoted(folder.name),
        "TEAM_ZIP": shell_quoted(f"{folder.name}.zip"),
    }
    for target, source in _FILES.items():
        text = (starters_folder() / "team" / source).read_text(encoding="utf-8")
        for word, value in words.items() if target == "README.md" else ():
            text = text.replace(word, value)
        write_new(folder / target, text)
    write_new(folder / "team_name.txt", f"{title}\n")
    sys.stdout.write(f"""{folder}
Now:
  rcj-challenge run match --yellow {shell_quoted(folder)} --blue ball_chaser --duration 1:00 --open
  rcj-challenge check {shell_quoted(folder)}
""")
    return 0
