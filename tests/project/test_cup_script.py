"""The script in docs/records.md that plays a cup does what is said beside it."""

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
STAND = "from controller import Robot\nrobot = Robot()\nwhile robot.step(32) != -1:\n    pass\n"

COMMAND = """\
#!/bin/sh
echo "$*" >> "{folder}/started"
case "$*" in
    *nobody*) said="{folder}/said of nobody" ;;
    *) said="{folder}/said" ;;
esac
if [ -f "$said" ]; then
    cat "$said" >&2
    exit 2
fi
"{python}" -m rcj_challenges "$@" {one_robot} 2> "$said"
code=$?
cat "$said" >&2
[ "$code" = 2 ] || rm "$said"
exit "$code"
"""
"""The command; who has no program is refused in the same words again and again, without a process of his own."""

ONE_ROBOT = " ".join(
    f"--set=entrants.{seat}.robots.{seat[0].upper()}{n}=null" for seat in ("blue", "yellow") for n in (2, 3)
)
"""One robot on each side has a program, which starts a third as many."""

pytestmark = pytest.mark.skipif(os.name != "posix" or shutil.which("bash") is None, reason="it is a script for bash")


def the_script() -> str:
    (script,) = re.findall(
        r"^```sh\n(#!/bin/bash\n.*?)^```$", (ROOT / "docs" / "records.md").read_text("utf-8"), re.MULTILINE | re.DOTALL
    )
    assert script.count("run match") == 1
    return script.replace("run match", "run match --duration 0.3 --halves 1 --no-replay")


def zipped(folder: Path, name: str, program: str | None) -> None:
    (folder / name / "robot").mkdir(parents=True)
    (folder / name / ("read.me" if program is None else "robot.py")).write_text(program or "", encoding="utf-8")
    shutil.make_archive(str(folder / "teams" / name), "zip", folder / name)


def test_the_cup_is_played_and_what_is_played_is_not_played_again(tmp_path):
    (tmp_path / "teams").mkdir()
    zipped(tmp_path, "häns e", STAND)
    zipped(tmp_path, "kogge", STAND)
    zipped(tmp_path, "nobody", None)
    command = tmp_path / "rcj-challenge"
    text = COMMAND.format(folder=tmp_path, python=sys.executable, one_robot=ONE_ROBOT)
    command.write_text(text, encoding="utf-8")
    command.chmod(0o755)

    def play() -> list[str]:
        done = subprocess.run(
            ["bash", "-c", the_script()], cwd=tmp_path, capture_output=True, text=True, check=False, timeout=300,
            env={**os.environ, "PATH": f"{tmp_path}{os.pathsep}{os.environ['PATH']}"},
        )  # fmt: skip
        assert (done.returncode, done.stderr) == (0, "")
        assert len(re.findall("nobody.zip: no program for", done.stdout)) == 4, done.stdout
        started = (tmp_path / "started").read_text("utf-8").splitlines()
        (tmp_path / "started").unlink()
        return [line for line in started if "nobody" not in line]

    assert len(play()) == 2
    before = digest(tmp_path)
    assert play() == []
    (result,) = (tmp_path / "cup" / "häns e-kogge").glob("*/result.json")
    result.write_text(result.read_text("utf-8").replace('"complete": true', '"complete": false'), encoding="utf-8")
    assert len(play()) == 1
    assert digest(tmp_path) == before


def digest(folder: Path) -> str:
    return json.loads((folder / "cup" / "häns e-kogge.json").read_text("utf-8"))["digest"]
