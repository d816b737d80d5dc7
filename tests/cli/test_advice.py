"""``run`` says at its end what ``check`` says of programs that failed, as far as it shows without starting them again."""

from __future__ import annotations

import json

import pytest

from rcj_challenges.cli.advice import advice_on
from rcj_challenges.records.result import RunResult
from rcj_challenges.scenario.load import load
from rcj_challenges.submissions.team import open_team
from tests.cli.in_this_process import here
from tests.cli.test_run import DUEL, short

OF_2021 = load("match_2021").scenario
JSON_PROGRAM = """\
import json
from controller import Robot
robot = Robot()
receiver = robot.getDevice("supervisor receiver")
receiver.enable(32)
while robot.step(32) != -1:
    while receiver.getQueueLength() > 0:
        waiting = json.loads(receiver.getString())["waiting_for_kickoff"]
        receiver.nextPacket()
"""


@pytest.fixture
def printed(tmp_path):
    (tmp_path / "robot.py").write_text("packet = receiver.getData()\n", encoding="utf-8")
    logs = tmp_path / "logs"

    def of(*faults):
        return advice_on(OF_2021, {"yellow": open_team(tmp_path / "robot.py")}, faults, (), {}, logs)

    return of


def fault(robot, half=1, detail="struct.error: unpack requires a buffer of 160 bytes", **others):
    printed = {
        "robot": robot,
        "team": "yellow",
        "half": half,
        "tick": 2,
        "kind": "crash",
        "detail": detail,
        "traceback": "",
    }
    return {**printed, **others}


def test_the_end_of_a_match_and_the_log_name_the_messages_that_a_program_was_written_for(tmp_path, monkeypatch, capsys):
    (tmp_path / "team.py").write_text(JSON_PROGRAM, encoding="utf-8")
    assert here(monkeypatch, tmp_path, *short("team.py", "--quiet", "--no-replay", *DUEL)) == 0
    (line,) = [line for line in capsys.readouterr().out.splitlines() if line.startswith("hint")]
    assert line.startswith("hint for B1, Y2: ")
    assert "--set kits.v2.messages=v2.2" in line
    for robot in ("B1", "Y2"):
        (log,) = tmp_path.glob(f"runs/*/logs/{robot}.log")
        assert log.read_text(encoding="utf-8").splitlines()[-1] == "hint: " + line.partition(": ")[2]


def test_hints_are_in_the_printed_json_and_not_in_the_record(tmp_path, monkeypatch, capsys):
    (tmp_path / "team.py").write_text(JSON_PROGRAM, encoding="utf-8")
    assert here(monkeypatch, tmp_path, *short("team.py", "--json", "--no-replay", *DUEL)) == 0
    printed = json.loads(capsys.readouterr().out)
    (hint,) = printed["hints"]
    assert hint["robots"] == ["B1", "Y2"]
    assert "--set kits.v2.messages=v2.2" in hint["help"]
    RunResult.model_validate(printed)
    (result,) = tmp_path.glob("runs/*/result.json")
    assert "hints" not in json.loads(result.read_text(encoding="utf-8"))


@pytest.mark.parametrize("output", ["--json", "--quiet"])
def test_result_is_printed_when_the_hints_fail(tmp_path, monkeypatch, capsys, output):
    def fails(*_):
        raise LookupError("no such advice")

    monkeypatch.setattr("rcj_challenges.cli.advice.advice_on", fails)
    (tmp_path / "team.py").write_text(JSON_PROGRAM, encoding="utf-8")
    assert here(monkeypatch, tmp_path, *short("team.py", output, "--no-replay", *DUEL)) == 3
    printed = capsys.readouterr()
    assert "our fault" in printed.err
    if output == "--json":
        RunResult.model_validate(json.loads(printed.out))
    else:
        assert "record:" in printed.out


@pytest.mark.parametrize(
    ("program", "part"),
    [
        ("x = math.pi\n", '"import math"'),
        ("open('C:/me/speeds.csv')\n", "speeds.csv"),
        ("robot = controller.Robot()\nwhile robot.step(32): pass\n", "line 3"),
        ("controller.Robot().getDevice('left_wheel_motor').setPosition(0)\n", '"left wheel motor"'),
        ("lidar = None\nlidar = controller.Robot().getDevice('lidar')\nlidar.enable(9)\n", 'getDevice("lidar")'),
        ("controller.Robot().getDevice('lidar')\nball = None\nball.angle\n", "if ball is not None"),
        ("1 / 0\n", ""),
    ],
)
def test_run_prints_a_hint_for_a_program_that_failed(tmp_path, monkeypatch, capsys, program, part):
    folder = tmp_path / "mine"
    folder.mkdir()
    (folder / "team.py").write_text("import controller\n" + program, encoding="utf-8")
    assert here(monkeypatch, tmp_path, *short("mine/team.py", "--quiet", "--no-replay", *DUEL)) == 0
    lines = [line for line in capsys.readouterr().out.splitlines() if line.startswith("hint")]
    assert [part in line for line in lines[:1]] == [True] * bool(part)


WITH_MISTAKES = """\
import controller
robot = controller.Robot()
left, gps = robot.getDevice("left wheel motor"), robot.getDevice("gps")
robot.getDevice("left whel motor")
left.setPosition(float("inf"))
left.setVelocity(float("nan"))
while robot.step(32) != -1:
    gps.getValues()
    left.setVelocity(100)
"""


def test_each_warning_of_the_log_stands_once_at_the_end_of_a_match_with_what_helps(tmp_path, monkeypatch, capsys):
    (tmp_path / "team.py").write_text(WITH_MISTAKES, encoding="utf-8")
    assert here(monkeypatch, tmp_path, *short("team.py", "--json", "--no-replay", *DUEL)) == 0
    hints = json.loads(capsys.readouterr().out)["hints"]
    assert all(hint["robots"] == ["B1", "Y2"] for hint in hints)
    parts = (('"left whel motor"', '"left wheel motor"'), ("NaN",), ("'gps'", "enable(32)"), ("100", "10 rad/s"))
    assert [all(part in hint["help"] for part in one) for hint, one in zip(hints, parts, strict=True)] == [True] * 4


def test_of_robots_that_fail_alike_one_line_is_enough_and_each_log_reports_it_once(tmp_path, printed):
    (tmp_path / "logs").mkdir()
    (hint,) = printed(fault("Y1"), fault("Y2"), fault("Y1", half=2))
    assert hint["robots"] == ["Y1", "Y2"]
    assert "--set kits.legacy_2021.packet_has_flag=false" in hint["help"]
    for robot in ("Y1", "Y2"):
        assert (tmp_path / "logs" / f"{robot}.log").read_text(encoding="utf-8").count("hint: ") == 1


def test_a_log_that_cannot_be_written_keeps_nothing_back(printed):
    assert len(printed(fault("Y1"))) == 1  # there is no folder for it
