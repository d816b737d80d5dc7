"""A program that fails costs its own robot; that it changes nothing for others is shown by `tests/hostile`."""

import os
import subprocess
import sys

import numpy as np

from tests.match.programs import DRIVE

CRASHES_AT_IMPORT = "import controller\nraise ValueError('no plan')\n"
LOOPS = DRIVE.format(speed=10).split("while")[0] + "for _ in range(50):\n    robot.step(32)\nwhile True:\n    pass\n"
EXITS = DRIVE.format(speed=10).split("while")[0] + "for _ in range(100):\n    robot.step(32)\n"


def poses(run):
    return np.array([snapshot.substeps for snapshot in run.trajectory.halves[0].snapshots()])


def test_a_team_whose_programs_all_fail_plays_to_the_end(play, team_folder):
    run = play("limits.step_s=0.5", yellow=team_folder(CRASHES_AT_IMPORT, LOOPS, EXITS))
    assert run.result["complete"]
    assert run.result["halves"][0]["ticks"] == 157
    reported = {(fault["robot"], fault["kind"], fault["tick"]) for fault in run.result["faults"]}
    assert reported == {("Y1", "crash", 0), ("Y2", "step_timeout", 50), ("Y3", "exit", 100)}
    faults = run.events("PROGRAM_FAULT")
    assert {line["payload"]["robot_name"] for line in faults} == {"Y1", "Y2", "Y3"}
    assert "no plan" in run.log("Y1")
    assert children() == []  # no process survives


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
