"""Robots that are held: braked wheels, whatever is commanded, until they are let go."""

import math

import pytest

from tests.world.physics_stage import FULL, Stage


@pytest.fixture
def stage():
    made = Stage()
    made.put("Y1", 0.0, 0.0)
    made.put("B1", 0.0, 0.4)
    return made


def test_held_wheels_do_not_turn_and_a_command_given_meanwhile_acts_afterwards(stage):
    stage.hold("Y1", "B1")
    stage.drive("Y1", FULL, FULL)
    stage.play(0.5)
    assert stage.pose("Y1") == pytest.approx((0.0, 0.0, 0.0), abs=1e-6)
    assert stage.wheel_angles("Y1") == [0.0, 0.0]
    stage.hold()
    stage.play(0.5)
    assert stage.pose("Y1")[0] > 0.05
    assert stage.pose("B1") == pytest.approx((0.0, 0.4, 0.0), abs=1e-6)  # without a command


def test_only_held_robots_are_braked_and_they_drive_on_afterwards(stage):
    for robot in ("Y1", "B1"):
        stage.drive(robot, FULL, FULL)
    stage.play(0.5)
    stage.hold("Y1")
    stage.play(0.5)
    assert stage.speed("Y1") < 1e-6
    assert stage.speed("B1") > 0.15
    stage.hold("B1")
    stage.play(0.5)
    assert stage.speed("Y1") > 0.15
    assert stage.speed("B1") < 1e-6


def test_a_wheel_on_its_way_to_an_angle_waits_and_goes_there_afterwards(stage):
    robot = stage.index("Y1")
    stage.hold("Y1", "B1")
    for wheel in (0, 1):
        stage.world.set_wheel(robot, wheel, FULL, 2.0)
    stage.play(0.3)
    assert stage.wheel_angles("Y1") == [0.0, 0.0]
    stage.hold()
    stage.play(3)
    assert stage.wheel_angles("Y1") == pytest.approx([2.0, 2.0], abs=1e-5)


@pytest.mark.parametrize("parked", [False, True])
def test_a_held_robot_stands_where_it_is_put_until_it_is_let_go(stage, parked):
    stage.drive("Y1", FULL, FULL)
    stage.hold("Y1")
    if parked:
        stage.park("Y1")
    stage.put("Y1", 0.2, -0.3, math.pi / 2)
    stage.play(0.5)
    assert stage.pose("Y1") == pytest.approx((0.2, -0.3, math.pi / 2), abs=1e-6)
    stage.hold()
    stage.play(0.5)
    assert stage.pose("Y1")[1] > -0.25


def test_a_robot_off_the_field_stays_stopped_when_the_others_are_let_go(stage):
    stage.drive("Y1", FULL, FULL)
    stage.park("Y1")
    stage.hold("Y1", "B1")
    stage.hold()
    stage.play(0.3)
    assert stage.wheel_angles("Y1") == [0.0, 0.0]
    stage.put("Y1", 0.0, 0.0)
    stage.play(0.5)
    assert stage.pose("Y1")[0] > 0.05


def test_a_new_half_starts_free(stage):
    stage.hold("Y1", "B1")
    stage.world.reset()
    stage.drive("Y1", FULL, FULL)
    start = stage.pose("Y1")
    stage.play(0.5)
    assert math.dist(stage.pose("Y1")[:2], start[:2]) > 0.05
