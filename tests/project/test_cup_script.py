"""The scripts in docs/tournament.md that play a cup and make its table do what is said beside them."""

import json
import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "docs" / "tournament.md").read_text("utf-8")
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
needs_flock = pytest.mark.skipif(shutil.which("flock") is None, reason="flock is part of Linux")


def the_script() -> str:
    (script,) = re.findall(r"^```sh\n(#!/bin/bash\n.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)
    assert script.count("run match") == 1
    assert "--sandbox strict" in script  # which not every computer has that runs these tests
    script = script.replace("--sandbox strict", "--sandbox auto")
    return script.replace("run match", "run match --duration 0.3 --halves 1 --no-replay")


def zipped(folder: Path, name: str, program: str | None) -> None:
    (folder / name / "robot").mkdir(parents=True)
    (folder / name / ("read.me" if program is None else "robot.py")).write_text(program or "", encoding="utf-8")
    shutil.make_archive(str(folder / "teams" / name), "zip", folder / name)


@needs_flock
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
        assert (done.returncode, done.stderr) == (1, "")
        assert len(re.findall("NOT PLAYED, exit code 2: .*nobody.zip: no program for", done.stdout)) == 4, done.stdout
        assert done.stdout.splitlines()[-1].startswith("4 not played: ")
        started = (tmp_path / "started").read_text("utf-8").splitlines()
        (tmp_path / "started").unlink()
        return [line for line in started if "nobody" not in line]

    assert len(play()) == 2
    before = digest(tmp_path)
    assert play() == []
    (result,) = (tmp_path / "cup" / "häns e" / "kogge").glob("*/result.json")
    result.write_text(result.read_text("utf-8").replace('"complete": true', '"complete": false', 1), encoding="utf-8")
    assert '"complete": true' in result.read_text("utf-8")  # of a half: a match may be interrupted in its second one
    assert len(play()) == 1
    assert digest(tmp_path) == before


def digest(folder: Path) -> str:
    return json.loads((folder / "cup" / "häns e" / "kogge" / "last.json").read_text("utf-8"))["digest"]


PRETENDED = """\
#!/bin/sh
while [ "$1" != --out ]; do shift; done
echo "$2" >> started
sleep 0.1
mkdir "$2/record" && echo '{"complete": true}' > "$2/record/result.json"
"""
"""The command, as fast as that; it says in `started` which match it plays."""


def pretended_cup(folder: Path, *teams: str) -> dict[str, str]:
    (folder / "teams").mkdir()
    for team in teams:
        (folder / "teams" / f"{team}.zip").touch()
    command = folder / "rcj-challenge"
    command.write_text(PRETENDED, encoding="utf-8")
    command.chmod(0o755)
    return {**os.environ, "PATH": f"{folder}{os.pathsep}{os.environ['PATH']}"}


@needs_flock
@pytest.mark.nightly
def test_whatever_files_are_called_every_match_is_played(tmp_path):
    teams = ["a", "b-c", "a-b", "c", "-rf", "Löwen 🦁 & Co", "two  [1]", "$(touch x)'", "x" * 200]
    environment = pretended_cup(tmp_path, *teams)
    (tmp_path / "rcj-challenge").write_text(PRETENDED.replace("0.1", "0"), encoding="utf-8")
    done = subprocess.run(
        ["bash", "-c", the_script()], cwd=tmp_path, capture_output=True, text=True, check=False, timeout=300, env=environment
    )  # fmt: skip
    assert (done.returncode, done.stderr) == (0, "")
    assert len(done.stdout.splitlines()) == len(teams) * (len(teams) - 1)
    started = (tmp_path / "started").read_text("utf-8").splitlines()
    assert sorted(started) == sorted(f"cup/{a}/{b}" for a in teams for b in teams if a != b)


@needs_flock
def test_where_nothing_can_be_written_the_cup_does_not_end_as_if_it_were_played(tmp_path):
    environment = pretended_cup(tmp_path, "a", "b")
    (tmp_path / "cup" / "a" / "b" / "lock").mkdir(parents=True)  # as on a disk that has become read-only: no file there
    done = subprocess.run(
        ["bash", "-c", the_script()], cwd=tmp_path, capture_output=True, text=True, check=False, timeout=300, env=environment
    )  # fmt: skip
    assert done.returncode == 2
    assert "cup/a/b/lock" in done.stderr
    assert not (tmp_path / "started").exists()


@needs_flock
@pytest.mark.nightly
def test_two_scripts_at_once_share_the_matches(tmp_path):
    environment = pretended_cup(tmp_path, "a", "b", "c", "d")
    scripts = [subprocess.Popen(["bash", "-c", the_script()], cwd=tmp_path, env=environment) for _ in range(2)]
    assert [script.wait(timeout=300) for script in scripts] == [0, 0]
    started = (tmp_path / "started").read_text("utf-8").splitlines()
    assert len(started) == len(set(started)) == 12


@needs_flock
def test_a_match_that_outlives_its_script_is_not_played_twice(tmp_path):
    environment = pretended_cup(tmp_path, "a", "b")
    (tmp_path / "rcj-challenge").write_text(
        PRETENDED.replace("sleep 0.1", "[ $2 != cup/a/b ] || sleep 1"), encoding="utf-8"
    )
    script = subprocess.Popen(["bash", "-c", the_script()], cwd=tmp_path, env=environment)
    while not (tmp_path / "started").exists():
        assert script.poll() is None
        time.sleep(0.01)
    script.kill()
    script.wait()
    subprocess.run(["bash", "-c", the_script()], cwd=tmp_path, check=True, timeout=300, env=environment)
    assert sorted((tmp_path / "started").read_text("utf-8").splitlines()) == ["cup/a/b", "cup/b/a"]


def record(folder: Path, match: str, score: tuple[int, int], *, complete: bool = True, **changed: object) -> None:
    """Write what a table needs of ``result.json``, into `folder`/cup/BLUE/YELLOW/."""
    blue, yellow = match.split("/")
    place = folder / "cup" / match / f"{len(list(folder.glob('cup/*/*/*')))}-match"
    place.mkdir(parents=True)
    result = {
        "complete": complete,
        "entrants": {"blue": {"name": blue.upper(), "programs": blue}, "yellow": {"name": yellow.upper(), "programs": yellow}},
        "score": {"blue": score[0], "yellow": score[1]},
        "faults": [],
        "digest": str(score),
        **changed,
    }  # fmt: skip
    (place / "result.json").write_text(json.dumps(result), encoding="utf-8")


def table_of(folder: Path) -> list[str]:
    (program,) = re.findall(r"^```python\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)
    done = subprocess.run(
        [sys.executable, "-X", "utf8", "-c", program], cwd=folder, capture_output=True, encoding="utf-8", check=False
    )
    assert (done.returncode, done.stderr) == (0, "")
    return done.stdout.splitlines()


def test_the_table_is_of_points_then_goals(tmp_path):
    record(tmp_path, "löwe/b", (3, 0))
    record(tmp_path, "b/löwe", (1, 1))
    record(tmp_path, "b/c", (2, 1))
    record(tmp_path, "c/löwe", (0, 1))
    rows = [line.split() for line in table_of(tmp_path)[1:4]]
    assert rows == [
        ["7", "2", "1", "0", "5:1", "löwe", "(LÖWE)"],
        ["4", "1", "1", "1", "3:5", "b", "(B)"],
        ["0", "0", "0", "2", "1:3", "c", "(C)"],
    ]


def test_a_match_counts_once_and_only_when_it_is_complete(tmp_path):
    record(tmp_path, "a/b", (0, 9), complete=False)
    record(tmp_path, "a/b", (1, 0))
    record(tmp_path, "a/b", (1, 0))
    record(tmp_path, "b/a", (5, 0), complete=False)
    (tmp_path / "cup/b/a/cut-off").mkdir()
    (tmp_path / "cup/b/a/cut-off/result.json").touch()
    told = table_of(tmp_path)
    assert told[1].split() == ["3", "1", "0", "0", "1:0", "a", "(A)"]
    assert told[3:] == [f"not played: {Path('cup/b/a')}"]


def test_below_the_table_stands_what_must_be_looked_at(tmp_path):
    faults = [
        {"team": seat, "kind": kind} for seat, kind in (("yellow", "crash"), ("yellow", "crash"), ("blue", "exit"))
    ]
    record(tmp_path, "a/b", (1, 0), faults=faults)
    record(tmp_path, "b/a", (1, 0))
    record(tmp_path, "b/a", (2, 0))
    other = {"blue": {"name": "C", "programs": "c"}, "yellow": {"name": "A", "programs": "exchanged"}}
    record(tmp_path, "c/a", (0, 0), entrants=other)
    record(tmp_path, "b/c", (0, 0), faults=[{"team": "blue", "kind": "crash"}])
    (tmp_path / "cup" / "a" / "rar").mkdir()
    (tmp_path / "cup" / "rar" / "a").mkdir(parents=True)
    assert table_of(tmp_path)[4:] == [
        f"played 2 times, not always alike, the first counts: {Path('cup/b/a')}",
        f"a: exit in 1 of its matches, such as {Path('cup/a/b')}",
        f"b: crash in 2 of its matches, such as {Path('cup/a/b')}",
        "a: played with 2 different submissions",
        "rar: none of its matches is played",
    ]
