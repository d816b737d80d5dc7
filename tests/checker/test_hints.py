"""What a check says about a fault beyond the fault's own words, so that a pupil knows what to change."""

from __future__ import annotations

import time
import zipfile
from pathlib import Path

import pytest

from rcj_challenges.checker.check import CheckOptions, check_file
from rcj_challenges.checker.hints import hint_on
from rcj_challenges.controllers.team import open_team
from rcj_challenges.scenario.load import load

ENTRY = "rcj_soccer_team_blue/rcj_soccer_team_blue.py"
ALONE = [
    *("limits.start_s=10", "limits.step_s=0.5"),
    *(f"entrants.{seat}.robots.{seat[0].upper()}{number}=null" for seat in ("blue", "yellow") for number in (2, 3)),
]
"""One robot on each side has a program."""
V21, V22 = load("match", ALONE), load("match", [*ALONE, "kits.v2.messages=v2.2"])
STYLES = Path(__file__).resolve().parents[1] / "programs" / "styles"

BEGIN = """\
import json, struct
from controller import Robot
robot = Robot()
receiver = robot.getDevice("supervisor receiver")
receiver.enable(32)
for name in ("left wheel motor", "right wheel motor"):
    robot.getDevice(name).setPosition(float("inf"))
"""
LOOP = """\
while robot.step(32) != -1:
    while receiver.getQueueLength() > 0:
        waiting = READ
        receiver.nextPacket()
"""
JSON_PROGRAM = BEGIN + LOOP.replace("READ", "json.loads(receiver.getString())")
BYTE_PROGRAM = BEGIN + LOOP.replace("READ", 'struct.unpack("?", receiver.getData())[0]')


@pytest.fixture
def check(tmp_path):
    def checked(program, scenario=V21, play_s=1.0, **others):
        path = tmp_path / "team.zip"
        with zipfile.ZipFile(path, "w") as archive:
            archive.writestr(ENTRY, program)
            archive.writestr("team_name.txt", "Hanse")
            for name, text in others.items():
                archive.writestr(f"rcj_soccer_team_blue/{name}.py", text)
        return check_file(path, scenario, CheckOptions(play_s=play_s))

    return checked


def failure(report):
    """Return the only failure."""
    (found,) = [finding for stage in report.stages for finding in stage.findings if finding.level == "failure"]
    return found


@pytest.mark.parametrize("read", ["json.loads(receiver.getString())", "json.loads(receiver.getData())"])
def test_a_program_that_reads_json_where_the_packet_is_a_byte_is_told_how_to_play_with_v2_2(check, read):
    found = failure(check(BEGIN + LOOP.replace("READ", read)))
    assert found.code == "start.crash"
    assert "JSONDecodeError" in found.message
    assert found.message.endswith("this program seems to be written for messages v2.2")
    assert "--set kits.v2.messages=v2.2" in found.remedy
    assert "one byte" in found.remedy


def test_a_program_that_reads_bytes_where_the_packet_is_json_is_told_how_to_play_with_v2_1(check):
    found = failure(check(BYTE_PROGRAM, V22))
    assert found.message.endswith("this program seems to be written for messages v2.1")
    assert "--set kits.v2.messages=v2.1" in found.remedy
    assert "getBytes()" in found.remedy


def test_a_whole_program_of_2022_is_told_so_too():
    (blue,) = [
        finding
        for finding in check_file(STYLES / "style_2022", V22, CheckOptions(play_s=1.0)).stages[4].findings
        if finding.level == "failure"
    ]
    assert "--set kits.v2.messages=v2.1" in blue.remedy


@pytest.mark.parametrize(("program", "scenario"), [(JSON_PROGRAM, V22), (BYTE_PROGRAM, V21)])
def test_a_program_plays_with_the_messages_that_it_was_written_for(check, program, scenario):
    assert check(program, scenario).level != "failure"


@pytest.mark.parametrize(
    "line",
    [
        'json.loads("")',  # in a program that knows the byte of v2.1
        'json.loads(open("empty.json", "w+").read())',
        "robot.getTime() / 0",
    ],
)
def test_other_crashes_in_the_first_step_say_nothing_about_messages(check, line):
    loop = LOOP.replace("READ", 'struct.unpack("?", receiver.getData())[0]') + f"    {line}\n"
    assert "messages" not in failure(check(BEGIN + loop)).remedy


def test_a_file_that_is_no_json_says_nothing_about_messages(check):
    loop = LOOP.replace("READ", "receiver.getBytes()") + '    json.loads(open("empty.json", "w+").read())\n'
    assert "messages" not in failure(check(BEGIN + loop)).remedy


def test_a_packet_of_later_steps_that_is_no_json_says_nothing_about_messages(check):
    loop = LOOP.replace("READ", "receiver.getString()") + "    robot.getTime() > 0.5 and json.loads('')\n"
    told = [finding for finding in check(BEGIN + loop).stages[5].findings if finding.level == "failure"]
    assert [finding.code for finding in told] == ["play.crash", "play.crash"]
    assert "messages" not in told[0].remedy


def test_text_of_the_teams_own_radio_says_nothing_about_messages(check):
    loop = LOOP.replace("READ", "receiver.getBytes()[0] == 1") + '    json.loads("")\n'
    assert "messages" not in failure(check(BEGIN + loop)).remedy


def test_a_place_that_nobody_could_look_up_is_no_reason_to_stumble(check):
    lines = "9" * 5000
    loop = (
        LOOP.replace("READ", "receiver.getData()") + f"    raise ValueError('a\\n  File \"robot.py\", line {lines}')\n"
    )
    assert failure(check(BEGIN + loop)).code == "start.crash"


def test_a_name_that_only_the_teams_own_controller_has_is_told_with_the_file_to_rename(check):
    found = failure(check("from controller import Robot, PIDController\n", controller="class PIDController: pass\n"))
    assert '"PIDController"' in found.remedy
    assert "rcj_soccer_team_blue/controller.py" in found.remedy


WAIT = """\
import asyncio
async def play():
    while robot.step(32) != -1:
        await asyncio.Event().wait()
asyncio.run(play())
"""


def test_a_wait_that_never_ends_is_told_as_a_wait_with_its_line(check):
    found = failure(check(BEGIN + WAIT))
    assert found.code == "start.step_timeout"
    assert "was waiting" in found.remedy
    assert f"line 12 of {ENTRY} (asyncio.run(play()))" in found.remedy
    assert "loop that never" not in found.remedy


def test_a_loop_without_step_is_told_with_its_line(check):
    found = failure(check(BEGIN + "robot.step(32)\nwhile robot.getTime() < 5:\n    x = ', '.join(['a'])\n"))
    assert "loop that never calls robot.step(32)" in found.remedy
    assert "was waiting" not in found.remedy
    assert f"line 9 of {ENTRY}" in found.remedy or f"line 10 of {ENTRY}" in found.remedy


def test_of_several_threads_no_line_is_blamed(check):
    threads = "import threading\nthreading.Thread(target=threading.Event().wait, daemon=True).start()\n"
    found = failure(check(BEGIN + threads + "robot.step(32)\nwhile True:\n    pass\n"))
    assert found.code == "start.step_timeout"
    assert "line" not in found.remedy


def test_a_line_without_end_is_looked_at_in_no_time(tmp_path):
    (tmp_path / "robot.py").write_text("x.wait(timeout=" * 200_000, encoding="utf-8")
    fault = {"kind": "step_timeout", "robot": "B1", "tick": 1, "detail": "", "traceback": ""}
    with open_team(tmp_path, *V21.scenario.entrants.values()) as team:
        began = time.perf_counter()
        hint = hint_on(V21.scenario, team, fault, 'It was here:\n  File "robot.py", line 1 in <module>\n')
        assert time.perf_counter() - began < 5
    assert len(hint.remedy) < 400


FAILS_AS_OPPONENT = "import struct\nfrom controller import Robot\nrobot = Robot()\nrobot.step(32)\n1 / 0\n"


def test_an_opponent_whose_programs_fail_is_told_and_is_no_fault_of_the_team(check, monkeypatch, tmp_path):
    sample = tmp_path / "sample"
    sample.mkdir()
    (sample / "robot.py").write_text(FAILS_AS_OPPONENT, encoding="utf-8")
    monkeypatch.setattr("rcj_challenges.checker.rehearsal.sample_team", lambda *_: sample)
    play = check(BYTE_PROGRAM).stages[5]
    told = [finding for finding in play.findings if finding.code == "play.opponent_failed"]
    assert [finding.level for finding in told] == ["passed", "passed"]
    assert told[0].message.startswith("as blue, programs of the opponent failed (sample: Y1;")
    assert "ZeroDivisionError" in told[0].message
    assert "not your fault" in told[0].remedy
    assert play.level != "failure"


def test_of_an_opponent_that_plays_nothing_is_said(check):
    codes = {finding.code for finding in check(BYTE_PROGRAM).stages[5].findings}
    assert "play.opponent_failed" not in codes


def test_sample_teams_play_as_opponents_with_either_messages(check):
    play = check(JSON_PROGRAM, V22, 3.0).stages[5]
    assert "play.opponent_failed" not in {finding.code for finding in play.findings}
