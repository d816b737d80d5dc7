"""Same scenario, seed, programs and versions: same digest; and the record alone gives the same reflog."""

import pytest

from tests.judging_again import judged_again, reflog_of
from tests.match.playing import alone
from tests.match.programs import AHEAD

RANDOM = """
import random
import numpy as np
from controller import Robot
robot = Robot()
motors = [robot.getDevice(side + " wheel motor") for side in ("left", "right")]
for motor in motors:
    motor.setPosition(float("inf"))
sonar = robot.getDevice("distancesensor front")
sonar.enable(32)
while robot.step(32) != -1:
    turn = random.uniform(-4, 4) + np.random.default_rng().normal()
    motors[0].setVelocity(6 + turn - sonar.getValue() / 1000)
    motors[1].setVelocity(6 - turn)
"""


DICE = RANDOM.replace("import numpy as np\n", "").replace("np.random.default_rng().normal()", "random.gauss(0, 1)")
"""The same without numpy, which takes longer to import than the match to play."""


def wild_at(place):
    """Return what plays matches of teams that throw dice."""
    blue = place.team_folder(RANDOM, DICE, name="Wild")
    yellow = place.team_folder(DICE, AHEAD, RANDOM, name="Wilder")
    return lambda *overrides, **plan: place.play("robot_progress_s=2", *overrides, blue=blue, yellow=yellow, **plan)


@pytest.fixture
def wild(place):
    return wild_at(place)


@pytest.fixture(scope="module")
def digest(shared_place):
    """Return the digest of the match to which the others are compared."""
    return wild_at(shared_place)().result["digest"]


def test_the_same_match_has_the_same_digest(wild, digest):
    assert wild().result["digest"] == digest


def test_another_seed_or_another_limit_is_another_digest(wild):
    two = ("match.half_s=1", *alone("blue", "yellow"))
    played = [wild(*two), wild(*two, seed=2), wild("penalty_area_s=14", *two)]
    assert len({run.result["digest"] for run in played}) == 3


def test_real_time_only_delays(wild):
    two = ("match.half_s=1.5", *alone("blue", "yellow"))
    fast, slow = wild(*two), wild(*two, real_time=True)
    assert fast.result["digest"] == slow.result["digest"]
    assert slow.result["wall_s"] > 1.5


def test_the_referee_judges_the_trajectory_alone_as_it_judged_the_match(play):
    run = play("robot_progress_s=2", "match.halves=2", "match.half_s=3")
    assert run.events("LACK_OF_PROGRESS")
    assert judged_again(run.folder) == reflog_of(run.folder)


def test_a_program_fails_at_the_same_tick_when_the_match_is_judged_again(place):
    broken = "from controller import Robot\nrobot = Robot()\nfor _ in range(9):\n    robot.step(32)\n1 / 0\n"
    blue, yellow = (
        place.team_folder(broken, AHEAD, name="Broken"),
        place.team_folder("nonsense", AHEAD, name="Nonsense"),
    )
    run = place.play("match.half_s=1", blue=blue, yellow=yellow)
    failed = [line["payload"]["robot_name"] for line in run.reflog if line["event"] == "PROGRAM_FAULT"]
    assert {"B1", "Y1"} <= set(failed)
    assert judged_again(run.folder) == reflog_of(run.folder)
