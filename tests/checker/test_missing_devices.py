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


def test_the_verdict_names_the_device_behind_a_crash(pack):
    report = check_file(pack(BEGIN + "robot.getDevice('ball reciever').enable(32)\n"), ALONE, LATE)
    assert 'getDevice("ball reciever") returned None: did you mean "ball receiver"?' in verdict(report)


def test_device_of_another_challenges_robots_names_that_challenge(tmp_path):
    """Two challenges of 2021 call their program alike."""
    with zipfile.ZipFile(tmp_path / "team.zip", "w") as archive:
        archive.writestr("score_goal/score_goal.py", BEGIN + "lidar = robot.getDevice('lidar')\nlidar.enable(64)\n")
        archive.writestr("team_name.txt", "Hanse")
    report = check_file(tmp_path / "team.zip", load("fast_shooter"), LATE)
    (missing,) = findings(report, "start", "start.no_device")
    assert "--scenario precision_lidar" in missing.help


def test_missing_device_that_is_requested_late_is_a_warning_too(pack):
    program = BEGIN + "robot.getDevice('led')\n" + LOOP + "robot.getDevice('left wheel moter')\n"
    report = check_file(pack(program), ALONE, LATE)
    (early,) = findings(report, "start", "start.no_device")
    (late,) = findings(report, "play", "play.no_device")
    assert ('"led"' in early.message, '"left wheel moter"' in late.message) == (True, True)
    assert (late.level, late.where, late.help) == ("warning", "B1", 'did you mean "left wheel motor"?')
