"""``rcj-challenge new``: a commented starter, and a program that plays it. Nothing is ever overwritten."""

from __future__ import annotations

import json
import os
import re
import sys
from pathlib import Path

from rcj_challenges.cli.says import typed
from rcj_challenges.facts.errors import RcjError, error_hint
from rcj_challenges.facts.file_names import is_device_of_windows
from rcj_challenges.facts.sanitize import sanitize
from rcj_challenges.scenario.errors import listing, nearest
from rcj_challenges.scenario.json_schema import FILE
from rcj_challenges.scenario.resources import names_in, starters_folder

_LONGEST_ID = 64
_LONGEST_TITLE = 120
_NO_LETTER = re.compile("[\x00-\x1f\x7f-\x9f\u2028\u2029\ud800-\udfff\ufeff\ufffe\uffff]")
"""What cannot stand in a line of YAML, where the file names itself: line breaks, control characters, lone bytes."""


class StarterError(RcjError):
    """A starter that cannot be written."""


def new_scenario(name: str, preset: str) -> int:
    """Write a starter scenario and a folder with its first program; print what to do with them.

    Args:
        name: its name or path, with or without ``.yaml``.
        preset: on which preset it stands.

    Returns:
        0.

    Raises:
        StarterError: there is no such preset, the name is none, or a file of that name exists.
    """
    known = names_in(starters_folder())
    if preset not in known:
        raise StarterError(f"no preset '{preset}'; there are {listing(known)}{nearest(preset, known)}")
    file = Path(name if name.endswith((".yaml", ".yml")) else f"{name}.yaml")
    refuse_name("" if file.name in (".yaml", ".yml") else file.name, name)
    short = _identifier(file.stem)
    program = file.with_name(f"{file.stem}_team") / "robot.py"
    for path in (file, program):
        if os.path.exists(path):  # noqa: PTH110 - that of pathlib raises for names that are too long
            raise StarterError(f"{path} exists already; nothing was written. Choose another name, or move it away")
    text = (starters_folder() / f"{preset}.yaml").read_text(encoding="utf-8")
    title = " ".join(part for part in re.split(r"[-_\s]+", file.stem) if part).capitalize()[:_LONGEST_TITLE]
    written = {
        "id: starter": f"id: {short}",
        "title: Starter": f"title: {json.dumps(title, ensure_ascii=False)}",
        "SCHEMA_FILE": _schema_seen_from(file),
        "FILE_NAME": typed(file.name),
        "TEAM_FOLDER": typed(program.parent.name),
    }
    # In one go: a file may be called FILE_NAME.
    write_new(file, re.sub("|".join(written), lambda found: written[found[0]], text))
    write_new(program, (starters_folder() / f"{preset}.robot.txt").read_text(encoding="utf-8"))
    sys.stdout.write(f"""{file}
{program}
Now:
  rcj-challenge validate {typed(file)}
  rcj-challenge test {typed(file)}
  rcj-challenge draw {typed(file)} --out {typed(file.with_suffix(".svg"))}
  rcj-challenge run {typed(file)} --yellow {typed(program.parent)}
""")
    return 0


def refuse_name(file: str, given: str) -> None:
    """Refuse a name that a file cannot have everywhere, or that cannot stand in a line of YAML.

    Args:
        file: without folders; empty: none is left of what was given.
        given: as typed.

    Raises:
        StarterError: says why.
    """
    if not file.strip("."):
        raise StarterError(f"'{sanitize(given)}' is no name of a file; choose one such as relay_race")
    if is_device_of_windows(file):
        stem = Path(file).stem
        raise StarterError(f"'{stem}' is a device on Windows, where no file has that name; choose another name")
    if _NO_LETTER.search(file):
        what = "a line break, a control character or stray bytes"
        raise StarterError(f"'{sanitize(given)}' has {what} in it; choose a name such as relay_race")


def _schema_seen_from(file: Path) -> str:
    """Return where ``schema``, typed in the current folder, writes its file, as seen from the scenario's folder.

    Of a scenario outside the current folder it is the place beside it.
    """
    try:
        depth = len(Path(os.path.abspath(file.parent)).relative_to(Path.cwd()).parts)  # noqa: PTH100 - links stay
    except ValueError:
        depth = 0
    return "../" * depth + f"schemas/{FILE}"


def _identifier(stem: str) -> str:
    """Return a file's stem as a name: letters, digits and _, not beginning with a digit."""
    found = re.sub(r"[^A-Za-z0-9_]+", "_", stem).strip("_")[:_LONGEST_ID]
    if not found:
        raise StarterError(f"'{stem}' has no letter a to z and no digit in it; choose a name such as relay_race")
    return f"_{found}"[:_LONGEST_ID] if found[0].isdigit() else found


def write_new(path: Path, text: str) -> None:
    """Write a file that is not there yet, and its folders.

    Raises:
        StarterError: it cannot be written.
    """
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        # Exclusive: a file that appeared meanwhile is not overwritten either.
        stream = path.open("x", encoding="utf-8", newline="\n")
        try:
            with stream:
                stream.write(text)
        except OSError:  # half of it, or nothing, would be in the way of the next attempt
            path.unlink()
            raise
    except OSError as error:
        raise StarterError(f"{sanitize(path)}: cannot be written: {error_hint(error)}") from error
