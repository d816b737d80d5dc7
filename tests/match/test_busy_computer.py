"""How busy the computer is decides nothing, and a computer that is too busy gives no verdict."""

import json
import subprocess
import sys

import pytest

from rcj_challenges.core.errors import HostError
from rcj_challenges.programs import pool as program_pool
from tests.match.programs import AHEAD

ONE_EXPENSIVE_STEP = """
import hashlib, random
from controller import Robot
robot = Robot()
motors = [robot.getDevice(side + " wheel motor") for side in ("left", "right")]
for motor in motors:
    motor.setPosition(float("inf"))
block, step = bytes(1_000_000), 0
while robot.step(32) != -1:
    step += 1
    if step == 10:
        for _ in range(600):
            hashlib.sha256(block).digest()
    for motor in motors:
        motor.setVelocity(10 * random.random())
"""

REALLY_SLEEPS = """
import ctypes
from controller import Robot
robot = Robot()
while robot.step(32) != -1:
    ctypes.CDLL(None).usleep(300_000)
"""


@pytest.mark.nightly
@pytest.mark.skipif(sys.platform != "linux", reason="only Linux reports for how long a thread was ready")
def test_a_match_beside_thirty_busy_processes_has_the_same_digest_every_time(place):
    team = place.team_folder(ONE_EXPENSIVE_STEP)
    alone = place.play("match.half_s=4", yellow=team)
    others = [subprocess.Popen([sys.executable, "-S", "-c", "while True: pass"]) for _ in range(30)]
    try:
        beside = [place.play("match.half_s=4", yellow=team) for _ in range(10)]
    finally:
        for other in others:
            other.kill()
        for other in others:
            other.wait()
    assert alone.result["faults"] == []
    assert {run.result["digest"] for run in beside} == {alone.result["digest"]}


def test_a_fault_by_a_limit_of_time_is_marked_in_the_result_and_in_the_reflog(place):
    run = place.play("match.half_s=1", "limits.half_s=0.3", yellow=place.team_folder(REALLY_SLEEPS, AHEAD))
    assert [(fault["kind"], fault["timed"]) for fault in run.result["faults"]] == [("half_timeout", True)]
    assert [event["payload"]["timed"] for event in run.events("PROGRAM_FAULT")] == [True]


def test_a_fault_that_has_nothing_to_do_with_time_is_not_marked(place):
    run = place.play("match.half_s=1", yellow=place.team_folder("raise SystemExit(1)", AHEAD))
    assert [(fault["kind"], fault["timed"]) for fault in run.result["faults"]] == [("exit", False)]
    assert all("timed" not in event["payload"] for event in run.events("PROGRAM_FAULT"))


def test_a_computer_that_is_too_busy_gives_no_verdict(place, monkeypatch):
    monkeypatch.setattr(program_pool, "_MAX_HELD_UP", 0.0005)
    with pytest.raises(HostError) as raised:
        place.play("match.half_s=4", yellow=place.team_folder(REALLY_SLEEPS))
    assert (raised.value.code, raised.value.exit_code) == ("host-too-busy", 2)
    (file,) = (place.folder / "runs").glob("*/result.json")
    result = json.loads(file.read_text("utf-8"))
    assert (result["complete"], result["faults"]) == (False, [])
