"""Names with other letters than ASCII, where the system names files in ASCII: a service, a container, an old server."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import zipfile
from pathlib import Path
from typing import Any
from urllib.parse import quote, unquote

import pytest

pytestmark = pytest.mark.skipif(os.name != "posix", reason="Windows names files in Unicode whatever the locale")

NARROW = {"LC_ALL": "C", "PYTHONUTF8": "0"}  # where it is LC_ALL that says C, Python takes no other locale by itself
DUEL = [f"--set=entrants.{seat}.robots.{seat[0].upper()}{n}=null" for seat in ("blue", "yellow") for n in (2, 3)]
"""One robot on each side has a program, which starts a third as many."""
STANDS = "from controller import Robot\nrobot = Robot()\nwhile robot.step(32) != -1:\n    pass\n"
ENTRY = "rcj_soccer_team_blue/rcj_soccer_team_blue.py"
FILES = {
    ENTRY: """
from controller import Robot
import größe, os
assert open("Wörter.txt", encoding="utf-8").read() == open("Wörter.txt").read() == "Übung"
assert sorted(os.listdir()) == ["Wörter.txt", "größe.py", "rcj_soccer_team_blue.py"]
assert os.path.dirname(__file__) == os.getcwd()
robot = Robot()
if robot.getName() == "Y1":
    größe.berechne()
while robot.step(32) != -1:
    pass
""",
    "rcj_soccer_team_blue/größe.py": "def berechne():\n    return 1 / 0\n",
    "rcj_soccer_team_blue/Wörter.txt": "Übung",
}


def played(place: Path, command: list[str], surroundings: dict[str, str]) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "rcj_challenges", *command],
        cwd=place, env=os.environ | surroundings, capture_output=True, encoding="utf-8", timeout=120, check=False,
    )  # fmt: skip


@pytest.fixture
def submission(request: pytest.FixtureRequest, tmp_path: Path) -> str:
    folder = tmp_path / "Größenwahn"
    for name, text in FILES.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    if request.param == "folder":
        return "Größenwahn"
    with zipfile.ZipFile(tmp_path / "Größenwahn.zip", "w") as archive:
        for name in FILES:
            archive.write(folder / name, name)
    return "Größenwahn.zip"


def given_as(usual: str, other: str) -> pytest.MarkDecorator:
    """Tries a submission of one kind, and every night of the other one."""
    return pytest.mark.parametrize("submission", [usual, pytest.param(other, marks=pytest.mark.nightly)], indirect=True)


def verdict(report: str) -> list[Any]:
    """What a check found, without what is measured."""
    (checked,) = json.loads(report)["files"]
    stages = [(s["name"], s["level"], [f for f in s["findings"] if f["level"] != "passed"]) for s in checked["stages"]]
    return [checked["file"], checked["team"], checked["level"], stages]


@pytest.mark.nightly
@given_as("archive", "folder")
def test_a_check_finds_the_same_as_where_names_are_in_unicode(tmp_path: Path, submission: str) -> None:
    here, there = (
        played(tmp_path, ["check", submission, "--json", *DUEL], env) for env in ({"PYTHONUTF8": "1"}, NARROW)
    )
    assert verdict(there.stdout) == verdict(here.stdout)
    assert there.returncode == here.returncode == 1
    assert "größe.py, line 2" in str(verdict(there.stdout))


@given_as("folder", "archive")
def test_a_match_is_the_same_and_its_logs_name_files_as_the_team_knows_them(tmp_path: Path, submission: str) -> None:
    command = ["run", "match", "--blue", submission, "--yellow", submission, "--duration=0.3", "--halves=1", "--json"]
    command += [*DUEL, "--out", str(tmp_path / "Läufe")]
    (tmp_path / "für Vorläufiges").mkdir()
    narrow = NARROW | {"TMPDIR": str(tmp_path / "für Vorläufiges")}
    here, there = (played(tmp_path, command, env) for env in ({"PYTHONUTF8": "1"}, narrow))
    results = [json.loads(done.stdout) for done in (here, there)]
    kept = [(r["digest"], r["entrants"], [(f["robot"], f["detail"]) for f in r["faults"]]) for r in results]
    assert kept[0] == kept[1]
    assert "größe.py, line 2" in kept[1][2][0][1]
    assert results[1]["entrants"]["blue"]["name"] == "Größenwahn"
    logs = [log.read_text("utf-8") for log in tmp_path.glob("Läufe/*/logs/Y1.log")]
    assert len(logs) == 2
    assert all('File "rcj_soccer_team_blue/größe.py", line 2, in berechne' in log for log in logs)


@pytest.mark.nightly
def test_reports_and_replays_lie_where_they_are_asked_for(tmp_path: Path) -> None:
    team = tmp_path / "Größenwahn"
    (team / ENTRY).parent.mkdir(parents=True)
    (team / ENTRY).write_text(STANDS, encoding="utf-8")
    places = ["--html", "Übersicht.html", "--replay", "für später"]
    done = played(tmp_path, ["check", team.name, *DUEL, *places], NARROW)
    assert done.returncode == 0, done.stderr
    page = (tmp_path / "Übersicht.html").read_text("utf-8")
    assert "Größenwahn" in page
    links = re.findall(r'href="./([^"]*)"', page)
    assert all((tmp_path / unquote(link)).is_file() for link in links)
    assert [link.startswith(quote("für später/")) for link in links] == [True, True]
