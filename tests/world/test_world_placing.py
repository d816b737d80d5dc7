"""Lifting and setting down: what a placement does and what it leaves alone."""

import math

import pytest

from rcj_challenges.core.play import Placement
from rcj_challenges.world import contact
from tests.world.physics_stage import FULL, Stage

EVERYTHING = (contact.GROUP_FIXTURES, contact.GROUP_CHASSIS, contact.GROUP_WHEELS, contact.GROUP_BALLS)


def test_at_the_start_all_stand_at_their_start_poses_at_rest():
    stage = Stage()
    stage.world.reset()
    for name, robot in stage.scenario.robots.items():
        assert stage.pose(name) == pytest.approx((robot.start.x_m, robot.start.y_m, robot.start.yaw_rad), abs=1e-6)
    assert stage.pose("ball") == (0, 0, 0)
    assert not stage.world.data.qvel.any()
    assert not any(stage.world.parked)
    assert all(stage.wheel_angles(name) == [0, 0] for name in stage.scenario.robots)


def test_a_placed_robot_and_ball_are_at_rest():
    stage = Stage()
    stage.put("B1", 0.0, 0.0)
    stage.put("ball", 0.0, 0.4)
    stage.drive("B1", FULL, -FULL)
    stage.roll("ball", 0.5, 0.2)
    stage.play(0.5)
    stage.put("B1", -0.3, 0.2, 1.0)
    stage.put("ball", 0.1, -0.2)
    assert stage.velocity("B1") == (0, 0, 0)
    assert stage.velocity("ball") == (0, 0, 0)
    assert stage.pose("B1") == pytest.approx((-0.3, 0.2, 1.0), abs=1e-6)
    assert stage.pose("ball") == pytest.approx((0.1, -0.2, 0.0), abs=1e-6)
    stage.drive("B1", 0.0, 0.0)
    stage.play(1.0)
    assert stage.pose("B1") == pytest.approx((-0.3, 0.2, 1.0), abs=1e-6)
    assert stage.pose("ball") == pytest.approx((0.1, -0.2, 0.0), abs=1e-6)


def test_poses_for_the_devices_are_up_to_date_after_a_placement():
    stage = Stage()
    stage.put("B1", -0.3, 0.2, math.pi / 2)
    world = stage.world
    assert world.data.xpos[world.tables.bodies[0]] == pytest.approx([-0.3, 0.2, 0.0375])
    assert world.data.xmat[world.tables.bodies[0]][:2] == pytest.approx([0, -1], abs=1e-9)
    assert world.data.geom_xpos[world.tables.chassis[0][1]][:2] == pytest.approx([-0.345, 0.2])


def test_wheels_keep_their_speed_and_their_angle_when_a_robot_is_put_elsewhere():
    stage = Stage()
    stage.put("B1", 0.0, 0.0)
    stage.drive("B1", 8.0, 8.0)
    stage.play(0.32)
    angles = stage.wheel_angles("B1")
    stage.put("B1", 0.0, -0.4, math.pi / 2)
    assert stage.wheel_angles("B1") == angles
    stage.play(0.5)
    assert stage.velocity("B1")[1] == pytest.approx(0.16, rel=0.02)


def test_a_contact_is_forgotten_when_a_robot_is_put_elsewhere():
    stage = Stage()
    stage.put("B1", 0.6, 0.0)
    stage.drive("B1", FULL, FULL)
    stage.play(1.0)
    stage.drive("B1", 0.0, 0.0)
    stage.put("B1", 0.0, 0.0)
    assert not stage.touched_in(0.032)
    assert stage.pose("B1") == pytest.approx((0, 0, 0), abs=1e-9)


def test_all_are_lifted_first_so_two_robots_can_change_places():
    stage = Stage()
    stage.put("B1", 0.0, 0.0)
    stage.put("Y1", 0.2, 0.0)
    stage.world.place([Placement(0, 0.2, 0.0, 0.0), Placement(3, 0.0, 0.0, 0.0)])
    assert not stage.touched_in(0.5)
    assert stage.pose("B1")[:2] == pytest.approx((0.2, 0.0), abs=1e-6)
    assert stage.pose("Y1")[:2] == pytest.approx((0.0, 0.0), abs=1e-6)


def test_of_two_placements_of_one_robot_the_last_one_counts():
    stage = Stage()
    stage.world.place([Placement(0, 0.2, 0.0, 0.0), Placement(0, -0.2, 0.1, 0.0, parked=True)])
    assert stage.world.parked[0]
    stage.world.place([Placement(0, 0.2, 0.0, 0.0, parked=True), Placement(0, -0.2, 0.1, 0.0)])
    assert not stage.world.parked[0]
    assert stage.pose("B1")[:2] == pytest.approx((-0.2, 0.1))


def test_things_put_on_top_of_each_other_part_gently_and_stay_on_the_field():
    stage = Stage()
    for name in ("B1", "B2", "Y1"):
        stage.put(name, 0.0, 0.0, 0.1)
    stage.put("ball", 0.0, 0.0)
    fastest = 0.0
    for _ in range(60):
        stage.play()
        fastest = max(fastest, *(stage.speed(name) for name in ("B1", "B2", "Y1", "ball")))
    assert fastest < 1.5
    for name in ("B1", "B2", "Y1", "ball"):
        x, y, _ = stage.pose(name)
        assert abs(x) < 0.65
        assert abs(y) < 0.75


# --- parked -----------------------------------------------------------------------------------------------------------


@pytest.fixture
def parked() -> Stage:
    """A robot that was driving in the middle has just been taken off."""
    stage = Stage()
    stage.put("B1", 0.0, 0.0)
    stage.drive("B1", 5.0, 5.0)
    stage.play(0.1)
    stage.park("B1")
    return stage


def test_rays_do_not_see_a_parked_robot(parked):
    for origin, direction in (((-0.3, 0, 0.02), (1, 0, 0)), ((0, 0.3, 0.03), (0, -1, 0))):
        expected = parked.ray(origin, direction, contact.GROUP_FIXTURES)
        assert parked.ray(origin, direction, *EVERYTHING) == expected


def test_nothing_collides_with_a_parked_robot_or_ball(parked):
    parked.put("Y1", -0.2, 0.0)
    parked.drive("Y1", FULL, FULL)
    assert not parked.touched_in(2)
    assert parked.pose("Y1")[0] == pytest.approx(0.2, abs=0.01)


def test_a_command_given_meanwhile_does_not_move_a_parked_robot(parked):
    where, angles = parked.pose("B1"), parked.wheel_angles("B1")
    parked.drive("B1", FULL, -FULL)
    parked.play(0.5)
    assert parked.pose("B1") == where
    assert parked.wheel_angles("B1") == pytest.approx(angles, abs=1e-9)


def test_a_placement_brings_it_back_and_its_wheels_go_on(parked):
    assert parked.world.parked == [True] * 7
    parked.put("B1", -0.2, -0.2, 0.0)
    assert parked.world.parked == [False] + [True] * 6
    parked.play(1.0)
    assert parked.velocity("B1")[0] == pytest.approx(0.1, rel=0.02)
    assert parked.ray((0.4, -0.2, 0.05), (-1, 0, 0), contact.GROUP_CHASSIS) > 0


def test_several_parked_things_do_not_meet(parked):
    assert not parked.touched_in(1)
    places = [parked.pose(name)[:2] for name in parked.roster.entities]
    assert min(math.dist(a, b) for i, a in enumerate(places) for b in places[:i]) > 50


def test_a_reset_brings_back_what_was_parked(parked):
    parked.world.reset()
    assert not any(parked.world.parked)
    parked.play(0.5)
    assert parked.speed("B1") == pytest.approx(0, abs=1e-6)
