"""A program that fails costs its own robot, and nobody else anything."""

import os
import subprocess
import sys

import numpy as np
import pytest

from tests.match.programs import AHEAD, DRIVE

CRASHES_AT_IMPORT = "import controller\nraise ValueError('no plan')\n"
LOOPS = DRIVE.format(speed=10).split("while")[0] + "for _ in range(50):\n    robot.step(32)\nwhile True:\n    pass\n"
EXITS = DRIVE.format(speed=10).split("while")[0] + "for _ in range(100):\n    robot.step(32)\n"
STOPS = (
    DRIVE.format(speed=10).split("while")[0]
    + "for _ in range({ticks}):\n    robot.step(32)\nfor motor in motors:\n    motor.setVelocity(0)\n"
    + "while robot.step(32) != -1:\n    pass\n"
)
LIMITS = ("limits.step_s=0.5", "limits.output_mb=1")


def poses(run):
    return np.array([snapshot.substeps for snapshot in run.trajectory.snapshots(1)])


@pytest.fixture(scope="module")
def stopped(shared_place):
    """Return a match in which Y2 sets speed 0 at tick 40."""
    return shared_place.play(*LIMITS, yellow=shared_place.team_folder(AHEAD, STOPS.format(ticks=40), AHEAD))


def test_a_team_whose_programs_all_fail_plays_to_the_end(play, team_folder):
    run = play("limits.step_s=0.5", yellow=team_folder(CRASHES_AT_IMPORT, LOOPS, EXITS))
    assert run.result["complete"]
    assert run.result["halves"][0]["ticks"] == 157
    told = {(fault["robot"], fault["kind"], fault["tick"]) for fault in run.result["faults"]}
    assert told == {("Y1", "crash", 0), ("Y2", "step_timeout", 50), ("Y3", "exit", 100)}
    faults = run.events("PROGRAM_FAULT")
    assert {line["payload"]["robot_name"] for line in faults} == {"Y1", "Y2", "Y3"}
    assert "no plan" in run.log("Y1")


@pytest.mark.parametrize(
    "failing",
    [
        pytest.param("raise RuntimeError('over')\n", id="crash"),
        pytest.param("import os\nos._exit(0)\n", id="exit"),
        pytest.param("while True:\n    pass\n", id="hang"),
        pytest.param("while True:\n    print('x' * 1000)\n", id="flood"),
        pytest.param("import os\nfor fd in range(3, 1000):\n    try:\n        os.write(fd, b'nonsense' * 9)\n"
                     "    except OSError:\n        pass\nrobot.step(32)\n", id="garbage"),
    ],
)  # fmt: skip
def test_the_poses_are_those_of_a_match_in_which_it_sets_speed_0(play, team_folder, stopped, failing):
    start = DRIVE.format(speed=10).split("while")[0] + "for _ in range(40):\n    robot.step(32)\n"
    failed = play(*LIMITS, yellow=team_folder(AHEAD, start + failing, AHEAD))
    assert [fault["robot"] for fault in failed.result["faults"]] == ["Y2"]
    assert [fault["tick"] for fault in failed.result["faults"]] == [40]
    np.testing.assert_array_equal(poses(failed), poses(stopped))


def test_no_process_survives_a_match(play, team_folder):
    run = play("limits.step_s=0.5", yellow=team_folder(LOOPS, EXITS, AHEAD))
    assert run.result["complete"]
    assert children() == []


def children():
    if sys.platform == "win32":
        return []
    listed = subprocess.run(["ps", "-o", "ppid=,args=", "-A"], capture_output=True, text=True, check=True).stdout
    return [line for line in listed.splitlines() if line.split()[0] == str(os.getpid()) and "_boot" in line]


def test_a_program_that_sleeps_misses_ticks_and_goes_on(play, team_folder):
    sleeps = DRIVE.format(speed=10).split("while")[0] + (
        "import time\nbefore = robot.getTime()\nrobot.step(32)\ntime.sleep(1)\nrobot.step(32)\n"
        "print('slept until', robot.getTime())\nwhile robot.step(32) != -1:\n    pass\n"
    )
    run = play(yellow=team_folder(sleeps))
    assert run.result["faults"] == []
    assert "slept until 1.0" in run.log("Y1")


def test_commands_given_before_a_sleep_act_after_it(play, team_folder):
    late = (
        "import time\n"
        + DRIVE.format(speed=0).split("while")[0]
        + (
            "robot.step(32)\nfor motor in motors:\n    motor.setVelocity(10)\ntime.sleep(1)\n"
            "while robot.step(32) != -1:\n    pass\n"
        )
    )
    run = play(yellow=team_folder(late))
    path = poses(run)[:, -1, run.trajectory.entities.index("Y1"), 1]
    moving = int(np.argmax(np.abs(np.diff(path)) > 1e-4))
    assert 31 <= moving <= 34
