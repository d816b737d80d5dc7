"""The field stands where the reference (section 1) says; obstacles stand where the scenario says."""

import math

import pytest

from rcj_challenges.core.play import Placement
from rcj_challenges.world import contact
from tests.world.physics_stage import FULL, Stage

FIXTURES = contact.GROUP_FIXTURES


@pytest.fixture(scope="module")
def stage() -> Stage:
    return Stage()


@pytest.mark.parametrize(
    ("origin", "direction", "distance"),
    [
        ((0, 0.3), (1, 0), 0.65),
        ((0, 0.3), (-1, 0), 0.65),
        ((0.3, 0), (0, 1), 0.75),
        ((-0.3, 0), (0, -1), 0.75),
        ((0, 0), (0, 1), 0.85),
        ((0, 0), (0, -1), 0.85),
        ((0, 0.8), (1, 0), 0.2),
        ((0, -0.8), (-1, 0), 0.2),
        ((0.1999, 0), (0, 1), 0.85),
        ((0.2001, 0), (0, 1), 0.75),
        ((-0.1999, 0), (0, -1), 0.85),
        ((-0.2001, 0), (0, -1), 0.75),
        ((0, 0.75001), (1, 0), 0.2),
    ],
)
def test_inner_faces(stage, origin, direction, distance):
    assert stage.ray((*origin, 0.05), (*direction, 0), FIXTURES) == pytest.approx(distance, abs=1e-9)


@pytest.mark.parametrize(("way_x", "way_y"), [(1, 1), (1, -1), (-1, 1), (-1, -1)])
def test_corners_are_cut_at_45_degrees(stage, way_x, way_y):
    # From (0.5, 0.6), outwards along both axes, |x| + |y| = 1.34 is reached after 0.24 / sqrt(2).
    distance = stage.ray((way_x * 0.5, way_y * 0.6, 0.05), (way_x / math.sqrt(2), way_y / math.sqrt(2), 0), FIXTURES)
    assert distance == pytest.approx(0.24 / math.sqrt(2), abs=1e-9)
    assert stage.ray((way_x * 0.5, way_y * 0.72, 0.05), (way_x, 0, 0), FIXTURES) == pytest.approx(0.12, abs=1e-9)


def test_corners_may_be_square():
    square = Stage(field={"corner_cut_m": 0})
    assert square.ray((0.5, 0.72, 0.05), (1, 0, 0), FIXTURES) == pytest.approx(0.15)


def test_walls_and_goals_have_the_height_of_the_scenario(stage):
    assert stage.ray((0.3, 0, 0.0899), (0, 1, 0), FIXTURES) == pytest.approx(0.75)
    assert stage.ray((0.5, 0, 0.0901), (0, 1, 0), FIXTURES) == -1
    assert stage.ray((0, 0.8, 0.1209), (1, 0, 0), FIXTURES) == pytest.approx(0.2)
    assert stage.ray((0, 0, 0.1209), (0, 1, 0), FIXTURES) == pytest.approx(0.85)
    assert stage.ray((0, 0, 0.1211), (0, 1, 0), FIXTURES) == -1
    low = Stage(field={"wall_height_m": 0.05})
    assert low.ray((0.5, 0, 0.0501), (0, 1, 0), FIXTURES) == -1


def test_a_field_of_another_size_with_one_goal():
    small = Stage(
        field={
            "width_m": 1.0,
            "length_m": 1.2,
            "goals": {"blue_goal": {"width_m": 0.3, "depth_m": 0.2}, "yellow_goal": {"end": "positive_y"}},
        }
    )
    assert small.ray((0, 0, 0.05), (1, 0, 0), FIXTURES) == pytest.approx(0.5)
    assert small.ray((0, 0, 0.05), (0, 1, 0), FIXTURES) == pytest.approx(0.8)
    assert small.ray((0.1501, 0, 0.05), (0, 1, 0), FIXTURES) == pytest.approx(0.6)
    assert small.ray((0, 0, 0.05), (0, -1, 0), FIXTURES) == pytest.approx(0.6)


def test_a_robots_outline_is_its_cube_and_both_wheels_10_cm_wide():
    stage = Stage()
    stage.put("B1", 0.0, 0.0)
    across = (0.0, 0.3, 0.02), (0.0, -1.0, 0.0)
    assert stage.ray(*across, contact.GROUP_CHASSIS) == pytest.approx(0.3 - 0.0375)
    assert stage.ray(*across, contact.GROUP_WHEELS) == pytest.approx(0.3 - 0.05)
    ahead = (0.3, 0.045, 0.02), (-1.0, 0.0, 0.0)
    assert stage.ray(*ahead, contact.GROUP_WHEELS) == pytest.approx(0.3 - 0.02, abs=1e-4)
    # The sonar's height passes over the wheels, the lidar's over the ball.
    assert stage.ray((0.0, 0.3, 0.0575), (0.0, -1.0, 0.0), contact.GROUP_WHEELS) == -1
    stage.put("ball", 0.3, 0.0)
    assert stage.ray((0.0, 0.0, 0.0425), (1.0, 0.0, 0.0), contact.GROUP_BALLS) == -1
    assert stage.ray((0.0, 0.0, 0.0209), (1.0, 0.0, 0.0), contact.GROUP_BALLS) == pytest.approx(0.279, abs=1e-4)


OBSTACLES = {
    "crate": {"shape": "box", "centre_m": [0.3, 0.0], "size_m": [0.1, 0.2], "yaw_rad": 0.0},
    "turned": {"shape": "box", "centre_m": [-0.3, 0.0], "size_m": [0.1, 0.2], "yaw_rad": math.pi / 2},
    "pillar": {"shape": "cylinder", "centre_m": [0.0, 0.4], "radius_m": 0.05, "height_m": 0.06},
    "fence": {"shape": "wall", "from_m": [-0.2, -0.4], "to_m": [0.2, -0.4], "thickness_m": 0.02},
}


def test_fixed_obstacles_of_every_shape_stand_where_they_should():
    stage = Stage(obstacles=OBSTACLES)
    rays = {
        (0, 0, 1, 0): 0.25,
        (0, 0, -1, 0): 0.2,
        (-0.3, 0.3, 0, -1): 0.25,
        (0, 0, 0, 1): 0.35,
        (0.19, 0, 0, -1): 0.39,
        (-0.21, -0.2, 0, -1): 0.55,
    }
    for (x, y, dx, dy), distance in rays.items():
        assert stage.ray((x, y, 0.05), (dx, dy, 0), FIXTURES) == pytest.approx(distance, abs=1e-6)
    assert stage.ray((0, 0, 0.061), (0, 1, 0), FIXTURES) == pytest.approx(0.85)


def test_a_fixed_obstacle_stops_ball_and_robot_and_is_a_thing_of_its_own():
    stage = Stage(obstacles=OBSTACLES)
    stage.put("ball", 0.1, 0.0)
    stage.roll("ball", 0.3, 0.0)
    stage.put("B1", -0.1, 0.0, math.pi)
    stage.drive("B1", FULL, FULL)
    assert {("ball", "crate"), ("B1", "turned")} <= stage.touched_in(2)
    assert stage.velocity("ball")[0] < 0
    assert stage.pose("B1")[0] == pytest.approx(-0.2 + 0.0375, abs=0.002)


def test_a_movable_obstacle_starts_at_its_own_pose_and_can_be_put_elsewhere():
    crate = {"shape": "box", "size_m": [0.1, 0.06], "centre_m": [0.2, 0.5], "yaw_rad": 0.4, "movable": True}
    stage = Stage(obstacles={"crate": crate})
    stage.world.reset()
    assert stage.pose("crate") == pytest.approx((0.2, 0.5, 0.4), abs=1e-6)
    stage.world.place([Placement(stage.index("crate"), -0.4, 0.1, 1.0)])
    assert stage.pose("crate") == pytest.approx((-0.4, 0.1, 1.0), abs=1e-6)


def test_names_of_a_scenario_cannot_clash_with_those_of_the_field():
    stage = Stage(obstacles={"floor": {**OBSTACLES["pillar"]}, "wall_left": {**OBSTACLES["crate"], "movable": True}})
    stage.put("ball", 0.0, 0.2)
    stage.roll("ball", 0.0, 0.3)
    assert ("ball", "floor") in stage.touched_in(1)
