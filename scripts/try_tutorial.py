"""Does what docs/first-ten-minutes.md says, from the wheel in a fresh environment.

The commands, files and changes are taken from the page, so that page and program cannot drift apart:

* ``sh``: each line is run; ``pip install …`` installs the wheel instead of what the line names.
* ``console``: a command after ``$``, then what is typed into it after ``(Pdb)``.
* ``yaml`` or ``python`` below a line that ends with a file name and a colon: the file is written.
* ``diff`` below such a line: the file is changed.

Prints the seconds of each command, and exits with 1 if one fails, if what the page promises did not come out, or if all
of it took more than six minutes of processor time (what else the computer does at the same time does not count).
"""

from __future__ import annotations

import json
import os
import re
import shlex
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PAGE = ROOT / "docs" / "first-ten-minutes.md"
MAX_S = 360

_BLOCK = re.compile(r"^```(?P<kind>\w+)\n(?P<text>.*?)^```$", re.MULTILINE | re.DOTALL)
_FILE = re.compile(r"`(?P<file>[\w./]+)`:$")


@dataclass(frozen=True)
class Step:
    """One thing to do.

    Attributes:
        command: what is run; empty for a file.
        typed: what is typed into the command.
        file: what is written or changed; empty for a command.
        old: the lines that are replaced; empty for a new file.
        new: the lines that replace them, or the new file's.
    """

    command: str = ""
    typed: str = ""
    file: str = ""
    old: str = ""
    new: str = ""


def steps(page: str) -> Iterator[Step]:
    """Yield what the page says to do, in order."""
    for block in _BLOCK.finditer(page):
        named = _FILE.search(page[: block.start()].rstrip())
        lines = block["text"].splitlines()
        if block["kind"] == "sh":
            yield from (Step(command=line.partition("  #")[0]) for line in lines)
        elif block["kind"] == "console":
            typed = [line.removeprefix("(Pdb) ") for line in lines if line.startswith("(Pdb) ")]
            yield from (Step(line[2:], "".join(f"{one}\n" for one in typed)) for line in lines if line.startswith("$ "))
        elif named and block["kind"] == "diff":
            old, new = ("".join(f"{line[1:]}\n" for line in lines if line[:1] in (" ", mark)) for mark in "-+")
            yield Step(file=named["file"], old=old, new=new)
        elif named:
            yield Step(file=named["file"], new=block["text"])


def write(step: Step, folder: Path) -> None:
    """Write or change a file.

    Raises:
        ValueError: the lines that are to be replaced are not in it, or more than once.
    """
    path = folder / step.file
    text = step.new
    if step.old:
        before = path.read_text(encoding="utf-8")
        if before.count(step.old) != 1:
            raise ValueError(f"{step.file}: {before.count(step.old)} places for the change:\n{step.old}")
        text = before.replace(step.old, step.new)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def missing_promises(folder: Path) -> list[str]:
    """Return what the page promises and did not come out."""
    results = [json.loads(path.read_text(encoding="utf-8")) for path in sorted(folder.glob("runs/*/result.json"))]
    own = [one for one in results if one["entrants"]["yellow"]["name"] == "My team" and one["scenario"] == "match"]
    leads = [one["score"]["yellow"] - one["score"]["blue"] for one in own]
    by_rule = [one for one in results if one["scenario"] == "my_rules"]
    promises = {
        "the first match has goals": bool(results) and sum(results[0]["score"].values()) > 0,
        "the changed rule gave a point": any(one["score"]["yellow"] for one in by_rule),
        "the pupil's robot scored": any(one["score"]["yellow"] for one in own),
        "the new program did better": bool(leads) and leads[-1] > leads[0],
        "the ZIP was written": (folder / "my_team.zip").is_file(),
    }
    return [promise for promise, is_kept in promises.items() if not is_kept]


def main() -> int:
    """Run the page; returns the exit code."""
    with tempfile.TemporaryDirectory(prefix="rcj-tutorial-") as temporary:
        place = Path(temporary)
        subprocess.run([sys.executable, "-m", "venv", place / "venv"], check=True)
        programs = place / "venv" / ("Scripts" if os.name == "nt" else "bin")
        pip = [programs / "python", "-m", "pip"]
        subprocess.run([*pip, "wheel", "--quiet", "--no-deps", "-w", place, ROOT], check=True)
        folder = place / "pupil"
        folder.mkdir()
        # A browser that shows nothing, so that --open works on a server.
        environment = {**os.environ, "PATH": f"{programs}{os.pathsep}{os.environ['PATH']}", "BROWSER": "true"}
        (wheel,) = place.glob("*.whl")
        for step in steps(PAGE.read_text(encoding="utf-8")):
            if step.file:
                write(step, folder)
                continue
            words = shlex.split(step.command)
            if words[:2] == ["pip", "install"]:
                words = ["pip", "install", "--quiet", str(wheel)]
            started = time.monotonic()
            done = subprocess.run(
                words, cwd=folder, env=environment, input=step.typed, text=True, capture_output=True, check=False
            )
            print(f"{time.monotonic() - started:6.1f} s  {step.command}", flush=True)
            if done.returncode:
                print(done.stdout[-2000:], done.stderr[-2000:], sep="\n")
                return 1
        missing = missing_promises(folder)
    took_s = sum(os.times()[2:4])  # of the commands; 0 where the system does not count it
    print(f"{took_s:6.1f} s of processor time in all, at most {MAX_S} s")
    for promise in missing:
        print(f"MISSING: {promise}")
    return 1 if missing or took_s > MAX_S else 0


if __name__ == "__main__":
    sys.exit(main())
