"""Editors resolve ``controller``, know the classes of devices, and mark pupils' mistakes."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
MISTAKES = Path(__file__).with_name("ten_mistakes.py")
IMPLEMENTATION = ROOT / "rcj_challenges" / "programs" / "program_side"
CLEAN = {key: value for key, value in os.environ.items() if not key.startswith(("PYTHON", "COV_"))}


def pyright(folder: Path, **settings: str) -> dict[str, set[int]]:
    """Return the lines that pyright marks as errors, by file name."""
    command = [sys.executable, "-m", "basedpyright", "--outputjson", "--pythonpath", sys.executable, "-p", str(folder)]
    config = json.dumps({"typeCheckingMode": "standard", **settings})
    (folder / "pyrightconfig.json").write_text(config, encoding="utf-8")
    done = subprocess.run(command, capture_output=True, text=True, encoding="utf-8", check=False)
    marked: dict[str, set[int]] = {}
    for found in json.loads(done.stdout)["generalDiagnostics"]:
        marked.setdefault(Path(found["file"]).name, set()).add(found["range"]["start"]["line"] + 1)
    return marked


def test_pyright_finds_all_ten_mistakes_and_nothing_else(tmp_path):
    shutil.copy(MISTAKES, tmp_path)
    lines = MISTAKES.read_text(encoding="utf-8").splitlines()
    expected = {number for number, line in enumerate(lines, 1) if re.search(r"# \d+: ", line)}
    assert len(expected) == 10
    assert pyright(tmp_path) == {"ten_mistakes.py": expected}


DEVICES = """\
from controller import Robot
robot = Robot()
robot.getDevice("left whel motor")
robot.getDevice("lidar")
for name in ("left wheel motor", "right wheel motor", input()):
    robot.getDevice(name).setVelocity(5)
"""


def test_a_slip_in_the_name_of_a_device_is_marked(tmp_path):
    (tmp_path / "robot.py").write_text(DEVICES, encoding="utf-8")
    assert pyright(tmp_path, reportDeprecated="error") == {"robot.py": {3}}


@pytest.mark.nightly
@pytest.mark.parametrize("team", ["ball_chaser", "roles_and_radio", "all_sensors"])
def test_pyright_finds_nothing_in_the_sample_teams(team, tmp_path):
    shutil.copytree(ROOT / "examples" / "teams" / team, tmp_path / team)
    assert pyright(tmp_path / team) == {}


def test_stub_is_made_from_the_implementation():
    command = [sys.executable, str(ROOT / "scripts" / "write_stubs.py"), "--check"]
    assert subprocess.run(command, check=False, env=CLEAN).returncode == 0


@pytest.mark.nightly
def test_stubtest_finds_stub_and_implementation_equal(tmp_path):
    allowed = tmp_path / "allowed.txt"
    # Classes of their own modules (R2023a) are typed where they are defined; `__new__` takes what a subclass may pass.
    allowed.write_text("controller\\.[a-z_]+\ncontroller\\.Robot\\.__new__\n", encoding="utf-8")
    command = [sys.executable, "-P", "-m", "mypy.stubtest", "controller", "--allowlist", str(allowed)]
    env = {**CLEAN, "PYTHONPATH": str(IMPLEMENTATION), "MYPYPATH": str(ROOT)}
    done = subprocess.run(command, capture_output=True, text=True, check=False, env=env)
    assert done.returncode == 0, done.stdout


def test_program_run_directly_exits_with_one_line(tmp_path):
    program = tmp_path / "robot.py"
    program.write_text("from controller import Robot\nrobot = Robot()\n", encoding="utf-8")
    done = subprocess.run([sys.executable, str(program)], capture_output=True, text=True, check=False, env=CLEAN)
    assert done.returncode == 1
    assert done.stderr.count("\n") == 1
    assert f"rcj-challenge run match --yellow {program}" in done.stderr


PROGRAM = """
import controller
from controller import Robot

robot = Robot()
print("implementation" if "program_side" in controller.__file__ else controller.__file__)
gps, left = robot.getDevice("gps"), robot.getDevice("left wheel motor")
right = robot.getDevice("right wheel motor")
gps.enable(32)
for wheel in (left, right):
    wheel.setPosition(float("inf"))
    wheel.target_acceleration = 1.0
    wheel.target_velocity = 10
    wheel.velocty = 3
    wheel.my_own_note = 3
    wheel.force = 1
while robot.step(32) != -1:
    print("speed", not gps.getSpeed() > 0.05)
"""


def test_program_in_a_match_gets_the_implementation_and_warnings_about_slips(tmp_path):
    (tmp_path / "robot.py").write_text(PROGRAM, encoding="utf-8")
    command = [sys.executable, "-m", "rcj_challenges", "run", "match", "--yellow", "robot.py", "--halves", "1"]
    command += ["--duration", "1", "--no-replay", "--quiet"]
    subprocess.run(command, check=True, env=CLEAN, cwd=tmp_path, capture_output=True)
    (log,) = tmp_path.glob("runs/*/logs/Y1.log")
    text = log.read_text(encoding="utf-8")
    assert "implementation" in text
    assert (
        text.count("'left wheel motor' has no attribute 'velocty': setting it does nothing; did you mean 'velocity'?")
        == 1
    )
    assert "my_own_note" not in text
    assert "setTorque is not offered" in text
    assert "speed False" not in text  # 1 rad/s² for a second is 0.02 m/s
