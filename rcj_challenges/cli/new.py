"""``rcj-challenge new``: a commented challenge with a program that plays it, a team that plays, or its robots.

Nothing is ever overwritten.
"""

from __future__ import annotations

import json
import os
import re
import sys
from pathlib import Path
from typing import Annotated

import typer

from rcj_challenges.cli.app import WRITE, app
from rcj_challenges.cli.codes import BAD_ARGUMENTS, BAD_NAME, OPTION_DOES_NOT_FIT, UNKNOWN_PRESET
from rcj_challenges.cli.stdio import shell_quoted
from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError
from rcj_challenges.core.errors import RcjError, taken
from rcj_challenges.core.files import is_device_of_windows, write_new
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.scenario.errors import choice_of
from rcj_challenges.scenario.resources import STARTERS_FOLDER, names_in

_CHOOSE = "choose another name, such as relay_race"
_MAX_ID_LENGTH = 64
_MAX_TITLE_LENGTH = 120
_NO_LETTER = re.compile("[\x00-\x1f\x7f-\x9f\u2028\u2029\ud800-\udfff\ufeff\ufffe\uffff]")
"""What cannot stand in a line of YAML, where the file names itself: line breaks, control characters, lone bytes."""
_KINDS = ("team", "challenge", "robot")
_TEAM_FILES = {
    "robot.py": "robot.txt",
    "README.md": "README.md",
    ".vscode/launch.json": "vscode/launch.json",
    ".vscode/tasks.json": "vscode/tasks.json",
}


@app.register(
    WRITE, "rcj-challenge new team my_team", "rcj-challenge new robot my_team", "rcj-challenge new challenge relay_race"
)
def new(
    words: Annotated[
        list[str],
        typer.Argument(
            metavar="[team|challenge|robot] NAME",
            help="What, and its name or path, of a robot that of the team's folder; one name alone: a challenge.",
        ),
    ],
    preset: Annotated[
        str | None,
        typer.Option(
            "--from",
            metavar="PRESET",
            help="Field and robots of a challenge: soccersim_v2 (default), soccersim_2021 or empty_field.",
        ),
    ] = None,
    design: Annotated[
        bool, typer.Option("--design", help="A team also gets robot.yaml, for challenges in which teams design robots.")
    ] = False,
) -> None:
    """Write a new team, robot.yaml for one, or a challenge with a first program; nothing is overwritten."""
    kind, name = ("challenge", words[0]) if len(words) == 1 else (words[0], words[-1])
    if kind not in _KINDS or len(words) > 2 or words in [[kind] for kind in _KINDS]:
        asked = "rcj-challenge new team NAME, rcj-challenge new robot TEAM, or rcj-challenge new challenge NAME"
        raise DiagnosticError(Diagnostic(BAD_ARGUMENTS, "new takes one name, and before it what it is", asked))
    if kind != "challenge" and preset is not None:
        raise DiagnosticError(Diagnostic(OPTION_DOES_NOT_FIT, "--from is for challenges", "leave it out"))
    if design and kind != "team":
        raise DiagnosticError(Diagnostic(OPTION_DOES_NOT_FIT, "--design is for teams", "leave it out"))
    if kind == "team":
        _write_team(name)
        if design:
            _write_robots(Path(name))
    elif kind == "robot":
        _write_robots(Path(name))
    else:
        _write_challenge(name, preset or "soccersim_v2")


def _write_team(name: str) -> None:
    """Write a team's folder with what VS Code needs to run and debug it; print what to do with it.

    Raises:
        RcjError: the name is none, or there is something of that name.
    """
    folder = Path(name)
    _refuse_name(folder.name, name)
    _refuse_existing(folder)
    title = " ".join(folder.name.replace("_", " ").replace("-", " ").split()).capitalize()
    words = {
        "TEAM_NAME": title,
        "TEAM_FOLDER": shell_quoted(folder.name),
        "TEAM_ZIP": shell_quoted(f"{folder.name}.zip"),
    }
    for target, source in _TEAM_FILES.items():
        text = (STARTERS_FOLDER / "team" / source).read_text(encoding="utf-8")
        for word, value in words.items() if target == "README.md" else ():
            text = text.replace(word, value)
        write_new(folder / target, text.encode())
    write_new(folder / "team_name.txt", f"{title}\n".encode())
    sys.stdout.write(f"""{folder}
Now:
  rcj-challenge run match --yellow {shell_quoted(folder)} --blue ball_chaser --duration 1:00 --open
  rcj-challenge check {shell_quoted(folder)}
""")


def _write_robots(folder: Path) -> None:
    """Write the robots of a team into its folder; print what to do with them.

    Raises:
        RcjError: it has some.
    """
    file = folder / "robot.yaml"
    _refuse_existing(file)
    write_new(file, (STARTERS_FOLDER / "team" / "robot_yaml.txt").read_bytes())
    sys.stdout.write(f"""{file}
Now, with a challenge that has guidelines for robots:
  rcj-challenge check {shell_quoted(folder)} --scenario SCENARIO
  rcj-challenge draw SCENARIO --design {shell_quoted(folder)} --out design.svg
""")


def _write_challenge(name: str, preset: str) -> None:
    """Write a starter scenario and a folder with its first program; print what to do with them.

    Args:
        name: its name or path, with or without ``.yaml``.
        preset: on which preset it stands.

    Raises:
        RcjError: there is no such preset, the name is none, or a file of that name exists.
    """
    known = names_in(STARTERS_FOLDER)
    if preset not in known:
        raise RcjError(f"unknown preset '{preset}'", choice_of(preset, known), code=UNKNOWN_PRESET)
    file = Path(name if name.endswith((".yaml", ".yml")) else f"{name}.yaml")
    _refuse_name("" if file.name in (".yaml", ".yml") else file.name, name)
    short = _identifier(file.stem)
    program = file.with_name(f"{file.stem}_team") / "robot.py"
    _refuse_existing(file, program)
    text = (STARTERS_FOLDER / f"{preset}.yaml").read_text(encoding="utf-8")
    title = " ".join(part for part in re.split(r"[-_\s]+", file.stem) if part).capitalize()[:_MAX_TITLE_LENGTH]
    written = {
        "id: starter": f"id: {short}",
        "title: Starter": f"title: {json.dumps(title, ensure_ascii=False)}",
        "SCHEMA_FILE": _schema_seen_from(file),
        "FILE_NAME": shell_quoted(file.name),
        "TEAM_FOLDER": shell_quoted(program.parent.name),
    }
    # In one go: a file may be called FILE_NAME.
    write_new(file, re.sub("|".join(written), lambda found: written[found[0]], text).encode())
    write_new(program, (STARTERS_FOLDER / f"{preset}.robot.txt").read_bytes())
    sys.stdout.write(f"""{file}
{program}
Now:
  rcj-challenge validate {shell_quoted(file)}
  rcj-challenge test {shell_quoted(file)}
  rcj-challenge draw {shell_quoted(file)} --out {shell_quoted(file.with_suffix(".svg"))}
  rcj-challenge run {shell_quoted(file)} --yellow {shell_quoted(program.parent)}
""")


def _refuse_name(file: str, given: str) -> None:
    """Refuse a name that a file cannot have everywhere, or that cannot stand in a line of YAML.

    Args:
        file: without folders; empty: none is left of what was given.
        given: as typed.

    Raises:
        RcjError: the name is such a one.
    """
    if not file.strip("."):
        raise RcjError(f"'{sanitize(given)}' cannot be the name of a file", _CHOOSE, code=BAD_NAME)
    if is_device_of_windows(file):
        stem = Path(file).stem
        raise RcjError(f"'{stem}' is a device on Windows, where no file has that name", _CHOOSE, code=BAD_NAME)
    if _NO_LETTER.search(file):
        raise RcjError(
            f"'{sanitize(given)}' has a line break, a control character or stray bytes in it", _CHOOSE, code=BAD_NAME
        )


def _refuse_existing(*paths: Path) -> None:
    """Refuse to write where something is.

    Raises:
        RcjError: one of the paths exists.
    """
    for path in paths:
        if os.path.exists(path):  # noqa: PTH110 - that of pathlib raises for names that are too long
            raise taken(path)


def _schema_seen_from(file: Path) -> str:
    """The place where ``schema``, typed in the current folder, writes its file, as seen from the scenario's folder.

    Of a scenario outside the current folder it is the place beside it.
    """
    from rcj_challenges.scenario.json_schema import FILE

    try:
        depth = len(Path(os.path.abspath(file.parent)).relative_to(Path.cwd()).parts)  # noqa: PTH100 - links stay
    except ValueError:
        depth = 0
    return "../" * depth + f"schemas/{FILE}"


def _identifier(stem: str) -> str:
    """A file's stem as a name: letters, digits and _, not beginning with a digit."""
    found = re.sub(r"[^A-Za-z0-9_]+", "_", stem).strip("_")[:_MAX_ID_LENGTH]
    if not found:
        raise RcjError(f"'{stem}' has no letter a to z and no digit in it", _CHOOSE, code=BAD_NAME)
    return f"_{found}"[:_MAX_ID_LENGTH] if found[0].isdigit() else found
