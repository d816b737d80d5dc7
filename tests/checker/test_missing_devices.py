"""Programs that ask for devices that their robots do not have, in a whole check."""

from __future__ import annotations

import zipfile

import pytest

from rcj_challenges.checker.check import CheckOptions, check_file
from rcj_challenges.checker.report import verdict
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


def test_who_uses_a_missing_device_in_the_middle_of_the_match_is_told_which(pack):
    program = BEGIN + "imu = robot.getDevice('imu')\nlamp = robot.getDevice('led')\n" + LOOP + "imu.getRollPitchYaw()\n"
    (crash,) = findings(check_file(pack(program), ALONE, LATE), "play", "play.crash")
    assert crash.remedy.startswith('getDevice("imu") returned None: these robots have: left wheel motor')


def test_the_verdict_names_the_device_behind_a_crash_as_the_first_cause(pack):
    report = check_file(pack(BEGIN + "robot.getDevice('ball reciever').enable(32)\n"), ALONE, LATE)
    assert report.cause == 'B1: asks for a device "ball reciever"; did you mean "ball receiver"?'
    assert report.cause in verdict(report)


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
    assert crash.remedy.startswith("getFromDef returned None: only a referee knows where things are")


def test_a_device_that_is_asked_for_late_in_vain_is_a_warning_too(pack):
    program = BEGIN + "robot.getDevice('led')\n" + LOOP + "robot.getDevice('left wheel moter')\n"
    report = check_file(pack(program), ALONE, LATE)
    (early,) = findings(report, "start", "start.no_device")
    (late,) = findings(report, "play", "play.no_device")
    assert early.message == 'asks for a device "led"; there is none'
    assert late.message == 'asks for a device "left wheel moter"; there is none'
    assert (late.level, late.where, late.remedy) == ("warning", "B1", 'did you mean "left wheel motor"?')
