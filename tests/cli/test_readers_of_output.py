"""Whoever reads what the command prints may go away: the match is played to its end all the same."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

STAND = "from controller import Robot\nrobot = Robot()\nwhile robot.step(32) != -1:\n    pass\n"


@pytest.mark.skipif(sys.platform == "win32", reason="a pipe without a reader is told otherwise")
def test_a_match_goes_on_when_nobody_reads_its_lines_any_more(tmp_path: Path) -> None:
    Path(tmp_path, "team.py").write_text(STAND, encoding="utf-8")
    teams = ["--blue", "team.py", "--yellow", "team.py"]
    command = [sys.executable, "-m", "rcj_challenges", "run", "match", *teams, "--halves", "1", "--duration", "2"]
    with subprocess.Popen(command, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as playing:
        assert playing.stdout is not None
        assert playing.stderr is not None
        assert playing.stdout.readline()
        playing.stdout.close()
        told = playing.stderr.read()
    assert (playing.returncode, told) == (0, "")
    (result,) = Path(tmp_path, "runs").glob("*/result.json")
    assert json.loads(result.read_text(encoding="utf-8"))["complete"]
