"""Kicker and dribbler as programs use them: as motors with limits of their own."""

import math

import pytest

from rcj_challenges.records.sensors import read_sensors
from tests.match.playing import Place

SCENARIO = """
schema_version: 2
id: tools
title: Tools
extends: soccersim_v2
match: {half_s: 3}
robots:
  B1:
    start: {x_m: 0.0, y_m: 0.0, yaw_rad: 0.0, noise_m: [0, 0]}
    devices: {kicker motor: {device: kicker}, dribbler motor: {device: dribbler}}
balls: {ball: {start_m: [0.059, 0.0]}}
"""
PROGRAM = """
from controller import Motor, Robot
robot = Robot()
dribbler, kicker = robot.getDevice("dribbler motor"), robot.getDevice("kicker motor")
print(dribbler.getMaxVelocity(), kicker.getMaxVelocity(), kicker.getType() == Motor.LINEAR)
dribbler.setPosition(float("inf"))
dribbler.setVelocity(40)
kicker.setVelocity(20)
while robot.step(32) != -1:
    kicker.setPosition(0.042 if robot.getTime() > 1 else 0)
"""


def test_program_shoots_with_its_kicker(tmp_path):
    place = Place(tmp_path)
    run = place.play("match.half_s=3", blue=place.team_folder(PROGRAM), scenario=SCENARIO, record_sensors=True)
    assert "50.0 0.8 True" in run.log("B1")
    assert "the velocity 20 is beyond the maximum of 0.8 m/s" in run.log("B1")
    ball_x = [snapshot.substeps[-1][6][0] for snapshot in run.trajectory.halves[0].snapshots()]
    assert ball_x[30] == pytest.approx(0.059, abs=0.002)
    assert ball_x[60] > 0.3
    track = read_sensors(run.folder)[1].robots["B1"]
    shots = track.motors[:, [motor.name for motor in track.robot.motors].index("kicker motor")]
    assert math.isnan(shots[25])
    assert shots[40] == 0.8
