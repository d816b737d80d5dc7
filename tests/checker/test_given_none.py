"""A program that goes on with the None that it was given for a device, or for a call of the referee's."""

from __future__ import annotations

import time
import zipfile

import pytest

from rcj_challenges.checker.advice.no_device import behind_none, ignored_calls
from rcj_challenges.checker.check import CheckOptions, check_file
from rcj_challenges.controllers.team import open_team
from rcj_challenges.scenario.load import load
from tests.checker.alone import alone

pytestmark = pytest.mark.usefixtures("sources_read_here")

ALONE = alone("limits.start_s=10", "limits.step_s=1")
LATE = CheckOptions(play_s=1.0)
BEGIN = "from controller import Robot\nrobot = Robot()\n"
LOOP = "while robot.step(32) != -1:\n    if robot.getTime() > 0.5:\n        "


@pytest.fixture
def pack(tmp_path):
    def packed(program):
        path = tmp_path / "team.zip"
        with zipfile.ZipFile(path, "w") as archive:
            archive.writestr("rcj_soccer_team_blue/rcj_soccer_team_blue.py", program)
            archive.writestr("team_name.txt", "Hanse")
        return path

    return packed


def findings(report, stage, code):
    (wanted,) = [one for one in report.stages if one.name == stage]
    return [finding for finding in wanted.findings if finding.code == code]


@pytest.fixture
def behind(tmp_path):
    def of(program, asked, calls=()):
        (tmp_path / "robot.py").write_text(program, encoding="utf-8")
        detail = "AttributeError: 'NoneType' object has no attribute 'getValues' (robot.py, line 1)"
        with open_team(tmp_path / "robot.py") as team:
            return behind_none(detail, team, asked, calls)

    return of


@pytest.mark.parametrize(
    ("program", "told"),
    [
        ("imu.getValues()\nimu = robot.getDevice('imu')\nled = robot.getDevice('led')\n", 'getDevice("imu") gave None'),
        ("me.imu.getValues()\nclass A:\n  me.imu = me.r.getDevice(\n'imu')\n", 'getDevice("imu") or getDevice("led")'),
        ("robot.getDevice('imu').getValues()\nrobot.getDevice('led')\n", 'getDevice("imu") gave None'),
        ("sensors['a'].getValues()\n", 'this None comes from getDevice("imu") or getDevice("led")'),
        ("one.getValues()\nfor one in map(robot.getDevice, NAMES): pass\n", 'getDevice("imu") or getDevice("led")'),
        ("imu.getValues()\nimu = robot.getDevice('i' + 'mu')\n", 'getDevice("imu") or getDevice("led")'),
        ("imu.getValues()\nimu = robot.getDevice(NAME)\n", 'getDevice("imu") or getDevice("led")'),
    ],
)
def test_of_several_devices_asked_for_in_vain_the_one_is_named_that_was_used(behind, program, told):
    assert told in behind(program, ["imu", "led"]).told


def test_a_device_that_is_there_was_not_given_none_for_another_that_is_missing(behind):
    assert behind("gps.getValues()\ngps = robot.getDevice('gps')\ngps = fix(gps)\n", ["led"]) is None


@pytest.mark.nightly
def test_programs_and_logs_without_end_are_looked_at_in_no_time(behind):
    program = "x.getValues()\n" + "x=" * 2_000_000 + "1\n"
    calls = ignored_calls("".join(f"Warning: get{n} is ignored and gives None\n" for n in range(3000)))
    began_s = time.process_time()  # what else the machine does is not counted
    assert behind(program, [f"led {n}" for n in range(3000)], calls) is not None
    assert behind(program, [], calls) is not None
    assert time.process_time() - began_s < 5


def test_very_many_devices_are_not_all_named(behind):
    told = behind("one.getValues()\n", [f"led {number}" for number in range(50)]).told
    assert 'getDevice("led 0")' in told
    assert len(told) < 200


def test_a_call_of_the_referees_is_blamed_where_what_it_gave_was_used_and_no_device(behind):
    program = "ball.getValues()\nball = robot.getFromDef('BALL')\n"
    given = behind(program, ["led"], ["getFromDef", "getSelf"])
    assert (given.told, given.devices) == ("getFromDef gave None", ())
    assert behind("led.getValues()\nled = robot.getDevice('led')\n", ["led"], ["getSelf"]).devices == ("led",)
    assert behind("one.getValues()\n", [], ["getSelf", "setLabel"]).told == "getSelf gave None"
    told = behind("one.getValues()\n", [], ["getSelf", "getFromDef", "getSelf"]).told
    assert told == "this None comes from getSelf or getFromDef"


def test_who_uses_a_missing_device_in_the_middle_of_the_match_is_told_which(pack):
    program = BEGIN + "imu = robot.getDevice('imu')\nlamp = robot.getDevice('led')\n" + LOOP + "imu.getRollPitchYaw()\n"
    (crash,) = findings(check_file(pack(program), ALONE, LATE), "play", "play.crash")
    assert crash.remedy.startswith('getDevice("imu") gave None: these robots have: left wheel motor')


def test_who_asks_for_what_robots_of_another_challenge_have_is_told_of_that_one(tmp_path):
    """Two challenges of 2021 call their program alike."""
    with zipfile.ZipFile(tmp_path / "team.zip", "w") as archive:
        archive.writestr("score_goal/score_goal.py", BEGIN + "lidar = robot.getDevice('lidar')\nlidar.enable(64)\n")
        archive.writestr("team_name.txt", "Hanse")
    report = check_file(tmp_path / "team.zip", load("fast_shooter"), LATE)
    (missing,) = findings(report, "start", "start.no_device")
    assert missing.remedy.startswith(
        "it looks like one for precision_lidar: rcj-challenge check … --scenario precision_lidar; these robots have: "
    )


def test_who_goes_on_with_what_only_a_referee_gets_is_told_so_in_the_middle_of_the_match_too(pack):
    program = BEGIN.replace("Robot", "Supervisor") + "ball = robot.getFromDef('BALL')\n" + LOOP + "ball.getPosition()\n"
    (crash,) = findings(check_file(pack(program), ALONE, LATE), "play", "play.crash")
    assert crash.remedy.startswith("getFromDef gave None: only a referee is told where things are")


def test_a_device_that_is_asked_for_late_in_vain_is_a_warning_too(pack):
    program = BEGIN + "robot.getDevice('led')\n" + LOOP + "robot.getDevice('left wheel moter')\n"
    report = check_file(pack(program), ALONE, LATE)
    (early,) = findings(report, "start", "start.no_device")
    (late,) = findings(report, "play", "play.no_device")
    assert early.message == 'asks for a device "led"; there is none'
    assert late.message == 'asks for a device "left wheel moter"; there is none'
    assert (late.level, late.where, late.remedy) == ("warning", "B1", 'did you mean "left wheel motor"?')
