"""Phases and rules that hold robots, in real matches: programs run, wheels stand, what was commanded acts afterwards.

Sentence 5.8 of ADR 1.
"""

import json

import numpy as np
import pytest

from rcj_challenges.core.timing import ticks_from_s
from tests.judging_again import judged_again, reflog_of
from tests.match.playing import alone

COUNTDOWN = """schema_version: 2
id: countdown
title: Countdown
extends: soccersim_v2
match: {halves: 1, half_s: 3, swap_sides: false}
phases:
  countdown: {lasts_s: 1, robots: held}
  stop: {lasts_s: 0.5, robots: held}
first_phase: countdown
rules:
  go:
    triggers: [{trigger: phase_entered, phase: play, from: countdown}]
    actions: [{action: emit, event: GO}]
    says: Go.
  stop:
    triggers: [{trigger: time_reached, at_s: 2}]
    actions: [{action: emit, event: STOP}, {action: set_phase, phase: stop}]
    says: Stop.
  one_alone:
    triggers: [{trigger: time_reached, at_s: 1.4}]
    actions: [{action: hold, entity: Y2, for_s: 0.32}]
  drives_again:
    triggers: [{trigger: holds, conditions: [{entity: Y2, held: true, negate: true}]}]
    actions: [{action: emit, event: DRIVES_AGAIN}]
  for_good:
    triggers: [{trigger: time_reached, at_s: 1.9}]
    actions: [{action: hold, entity: Y2}]
"""
DRIVES = """
from controller import Robot
robot = Robot()
motors = [robot.getDevice(side + " wheel motor") for side in ("left", "right")]
sensor = robot.getDevice("left wheel sensor")
sensor.enable(32)
for motor in motors:
    motor.setPosition(float("inf"))
    motor.setVelocity(10)
steps = 0
while robot.step(32) != -1:
    steps += 1
    if steps in (20, 60):
        print("held" if steps < 30 else "free", steps, round(sensor.getValue(), 3), motors[0].getVelocity())
"""
DRIVES_LATE = DRIVES.replace("motor.setVelocity(10)", "motor.setVelocity(0)").replace(
    "    steps += 1\n",
    "    steps += 1\n    if steps == 10:\n        for motor in motors:\n            motor.setVelocity(8)\n",
)
GO, STOP = ticks_from_s(1), ticks_from_s(2)


@pytest.fixture(scope="module")
def countdown(shared_place):
    """Return what plays the countdown, with these overrides."""
    team = shared_place.team_folder(DRIVES, DRIVES_LATE)
    return lambda *overrides: shared_place.play(*overrides, scenario=COUNTDOWN, yellow=team)


@pytest.fixture(scope="module")
def run(countdown):
    return countdown()


def ways(run, robot, half=0):
    """Return how far a robot has come in each tick, in m: [0] is that of tick 2."""
    entity = run.trajectory.entities.index(robot)
    path = run.trajectory.halves[half].substeps[:, -1, entity, :2].astype(float)
    return np.hypot(*np.diff(path, axis=0).T)


@pytest.mark.parametrize("robot", ["Y1", "Y2"])
def test_5_8_robots_stand_while_the_phase_lasts_and_drive_in_the_tick_after_it(run, robot):
    way = ways(run, robot)
    assert way[: GO - 1].max() < 1e-6
    assert way[GO : GO + 10].min() > 1e-4
    assert (way > 1e-5).argmax() + 2 == GO + 1  # the phase is over when tick GO is judged, and its physics came before
    (go,) = run.events("GO")
    assert go["matchtime"] == pytest.approx(GO * 0.032)


def test_a_robot_that_drives_when_the_phase_begins_is_braked_and_drives_on_afterwards(run):
    way, on = ways(run, "Y1"), STOP + ticks_from_s(0.5)
    assert way[STOP - 4 : STOP - 1].min() > 0.004  # up to tick STOP
    assert way[STOP + 6 : on - 1].max() < 1e-5
    assert way[on : on + 3].min() > 1e-4


def test_one_robot_that_a_rule_holds_stands_for_its_time_and_others_drive(run):
    held = ticks_from_s(1.4)
    way = ways(run, "Y2")[held - 2 :]  # [0] is that of tick `held`
    assert way[0] > 1e-3
    assert way[6:11].max() < 1e-5
    assert way[11:14].min() > 1e-4  # after ten ticks
    assert ways(run, "Y1")[held : held + 11].min() > 1e-3
    assert [event["matchtime"] for event in run.events("DRIVES_AGAIN")] == [pytest.approx((held + 10) * 0.032)]


def test_a_robot_held_by_a_rule_stands_on_when_a_phase_lets_all_go(run):
    on = STOP + ticks_from_s(0.5)
    assert ways(run, "Y2")[on:].max() < 1e-5
    assert ways(run, "Y1")[on : on + 3].min() > 1e-4


def test_the_record_lists_robots_held_by_rules_from_each_tick(run):
    lines = [json.loads(line) for line in (run.folder / "referee.jsonl").read_text("utf-8").splitlines()]
    first, last = ticks_from_s(1.4), ticks_from_s(1.9)
    assert [line for line in lines if line["kind"] == "held"] == [
        {"half": 1, "kind": "held", "tick": tick, "robots": robots}
        for tick, robots in ((first, ["Y2"]), (first + 10, []), (last, ["Y2"]))
    ]


def test_programs_of_held_robots_run_on_with_correct_sensor_values(run):
    assert "held 20 0.0 10.0" in run.log("Y1")  # the wheel has not turned; what the motor is commanded is 10 rad/s


def test_the_same_again_gives_the_same_digest_and_the_record_alone_the_same_events(countdown, run):
    assert countdown().result["digest"] == run.result["digest"]
    assert judged_again(run.folder) == reflog_of(run.folder)


def test_in_a_free_phase_they_drive(countdown):
    free = countdown("phases.countdown.robots=free")
    assert ways(free, "Y1")[10:20].min() > 1e-3


def test_a_second_half_begins_with_its_first_phase_and_no_robot_held_by_a_rule(countdown):
    # The first half ends within the phase that stops the robots.
    few = [*alone("blue"), "entrants.yellow.robots.Y3=null"]
    both = countdown("match.halves=2", "match.half_s=2.2", "first_phase=play", *few)
    assert ways(both, "Y1", 1)[:20].min() > 1e-5
    assert ways(both, "Y2", 0)[-3:].max() < 1e-5  # held by a rule, for good
    assert ways(both, "Y2", 1)[14:20].min() > 1e-3
    held = countdown("match.halves=2", "match.half_s=1.5", *few)
    assert ways(held, "Y1", 1)[: GO - 1].max() < 1e-6
