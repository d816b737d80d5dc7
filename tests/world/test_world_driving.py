"""How a robot drives: what its program can notice."""

import math
from itertools import pairwise

import pytest

from tests.world.physics_stage import FULL, Stage

G = 9.81


def lone_robot(yaw: float = 0.0, **changes) -> Stage:
    stage = Stage(**changes)
    stage.put("B1", -0.4, 0.0, yaw)
    return stage


@pytest.mark.parametrize("way", [1, -1])
@pytest.mark.parametrize("yaw", [0.0, 0.7, 1.57, -2.4])
def test_top_speed_is_20_cm_a_second_straight_ahead_and_back(yaw, way):
    stage = lone_robot()
    stage.put("B1", 0.0, 0.0, yaw)
    stage.drive("B1", way * FULL, way * FULL)
    stage.play(1.0)
    x, y, turning = stage.velocity("B1")
    assert math.hypot(x, y) == pytest.approx(0.20, rel=0.02)
    assert math.remainder(math.atan2(way * y, way * x) - yaw, 2 * math.pi) == pytest.approx(0, abs=1e-3)
    assert turning == pytest.approx(0, abs=1e-3)


def test_wheels_against_each_other_spin_it_at_4_44_rad_a_second_on_the_spot():
    stage = lone_robot()
    stage.drive("B1", -FULL, FULL)
    stage.play(2.0)
    assert stage.velocity("B1")[2] == pytest.approx(4.44, rel=0.03)
    assert stage.pose("B1")[:2] == pytest.approx((-0.4, 0.0), abs=1e-3)


def test_the_left_wheel_is_on_the_side_of_plus_y():
    stage = lone_robot()
    stage.drive("B1", FULL, 0.0)
    stage.play(0.3)
    assert stage.velocity("B1")[2] < -1.0


def test_it_reaches_95_percent_of_top_speed_within_a_tenth_of_a_second():
    stage = lone_robot()
    stage.drive("B1", FULL, FULL)
    stage.play(0.096)
    assert stage.speed("B1") >= 0.95 * 0.20


def test_grip_lets_it_accelerate_with_a_third_of_gravity():
    stage = lone_robot()
    stage.drive("B1", FULL, FULL)
    stage.play(0.032)
    assert stage.speed("B1") / 0.032 == pytest.approx(G / 3, rel=0.05)


def test_it_stops_faster_than_it_starts():
    stage = lone_robot()
    stage.drive("B1", FULL, FULL)
    stage.play(0.5)
    stage.drive("B1", 0.0, 0.0)
    stage.play(0.032)
    assert stage.speed("B1") < 0.005


def test_reversing_brakes_first_and_never_overshoots():
    stage = lone_robot()
    stage.drive("B1", FULL, FULL)
    stage.play(0.5)
    stage.drive("B1", -FULL, -FULL)
    speeds = []
    for _ in range(10):
        stage.play()
        speeds.append(stage.velocity("B1")[0])
    assert min(speeds) >= -0.2001
    assert all(later <= earlier + 1e-6 for earlier, later in pairwise(speeds))
    # Had it reversed with the grip to drive alone, it would need 0.122 s.
    assert speeds[2] == pytest.approx(-0.2, abs=0.005)


def test_slower_wheels_drive_slower_and_a_difference_drives_a_circle():
    stage = lone_robot()
    stage.drive("B1", 4.0, 6.0)
    stage.play(1.0)
    assert stage.speed("B1") == pytest.approx(5.0 * 0.02, rel=0.02)
    assert stage.velocity("B1")[2] == pytest.approx(2.0 * 0.02 / 0.09, rel=0.02)


def test_another_chassis_drives_by_its_own_wheels():
    chassis = {"wheel_radius_m": 0.03, "size_m": 0.1, "wheel_track_m": 0.12, "mass_kg": 0.4}
    stage = lone_robot(kits={"v2": {"chassis": chassis}})
    assert stage.world.judged().heights[0] == pytest.approx(0.05)
    stage.drive("B1", FULL, FULL)
    stage.play(0.5)
    assert stage.speed("B1") == pytest.approx(0.3, rel=0.02)
    stage.drive("B1", -FULL, FULL)
    stage.play(0.5)
    assert stage.velocity("B1")[2] == pytest.approx(0.3 / 0.06, rel=0.03)


def test_without_friction_nothing_drives():
    stage = lone_robot(field={"friction": 0.0})
    stage.drive("B1", FULL, FULL)
    stage.play(0.5)
    assert stage.speed("B1") == pytest.approx(0, abs=1e-6)
    stage.put("ball", -0.3, 0.0)
    stage.roll("ball", -0.5, 0.0)
    stage.play(0.5)
    assert stage.velocity("B1")[0] < -0.01


def test_it_does_not_tilt_while_it_drives():
    stage = lone_robot()
    body = stage.world.tables.bodies[0]
    for left, right in ((FULL, FULL), (-FULL, -FULL), (FULL, -FULL), (0, 0)):
        stage.drive("B1", left, right)
        for snapshot in stage.play(0.3):
            assert snapshot.uprights[0] == 1.0
            assert stage.world.data.xmat[body, 8] == pytest.approx(1.0, abs=1e-12)


# --- wheels -----------------------------------------------------------------------------------------------------------


def test_wheel_angles_grow_with_the_way_along_plus_x():
    stage = lone_robot()
    stage.drive("B1", 5.0, -2.5)
    stage.play(0.64)
    left, right = stage.wheel_angles("B1")
    assert left == pytest.approx(5.0 * 0.64, rel=1e-3)
    assert right == pytest.approx(-2.5 * 0.64, rel=1e-3)


@pytest.mark.parametrize("target", [1.3, -0.8])
def test_a_wheel_goes_to_an_angle_at_the_set_speed_at_most_and_holds_it(target):
    stage = lone_robot()
    for wheel in (0, 1):
        stage.world.set_wheel(0, wheel, 2.0, target)
    fastest = 0.0
    for _ in range(60):
        stage.play()
        fastest = max(fastest, stage.speed("B1"))
    assert fastest == pytest.approx(2.0 * 0.02, rel=0.02)
    assert stage.wheel_angles("B1") == pytest.approx([target, target], abs=1e-5)
    assert stage.speed("B1") == pytest.approx(0, abs=1e-6)
    assert stage.pose("B1")[0] == pytest.approx(-0.4 + target * 0.02, abs=5e-4)


def test_an_angle_is_left_as_soon_as_a_velocity_is_commanded():
    stage = lone_robot()
    stage.world.set_wheel(0, 0, 5.0, 1.0)
    stage.world.set_wheel(0, 1, 5.0, 1.0)
    stage.play(0.1)
    stage.drive("B1", -5.0, -5.0)
    stage.play(0.5)
    assert stage.velocity("B1")[0] == pytest.approx(-0.1, rel=0.02)


# --- standing ---------------------------------------------------------------------------------------------------------


def test_an_idle_robot_does_not_roll():
    stage = lone_robot(0.3)
    before = stage.pose("B1")
    stage.play(20)
    assert stage.pose("B1") == pytest.approx(before, abs=1e-6)


@pytest.mark.parametrize("yaw", [0.0, math.pi / 2, math.pi / 4])
def test_a_braked_robot_is_not_pushed_away_by_another(yaw):
    stage = Stage()
    stage.put("B1", 0.0, 0.0, yaw)
    stage.put("Y1", -0.3, 0.01, 0.0)
    stage.drive("Y1", FULL, FULL)
    stage.play(10)
    x, y, _ = stage.pose("B1")
    assert math.hypot(x, y) < 0.005
    assert stage.pose("Y1")[0] > -0.12


def test_the_ball_does_not_move_a_braked_robot():
    stage = lone_robot()
    stage.put("ball", 0.0, 0.0)
    stage.roll("ball", -0.5, 0.0)
    stage.play(2)
    # Twice as fast as a ball that was hit at rest: its blow is more than grip can hold within one sub-step.
    assert stage.pose("B1")[0] == pytest.approx(-0.4, abs=1.5e-3)


def test_of_two_robots_head_on_neither_wins():
    stage = Stage()
    stage.put("B1", 0.2, 0.0, math.pi)
    stage.put("Y1", -0.2, 0.0, 0.0)
    stage.drive("B1", FULL, FULL)
    stage.drive("Y1", FULL, FULL)
    stage.play(5)
    assert stage.pose("B1")[0] == pytest.approx(0.0375, abs=0.005)
    assert stage.pose("Y1")[0] == pytest.approx(-0.0375, abs=0.005)


def test_two_robots_push_a_third_that_drives_against_them():
    stage = Stage()
    stage.put("B1", 0.0, 0.0, math.pi)
    stage.put("Y1", -0.1, 0.055, 0.0)
    stage.put("Y2", -0.1, -0.055, 0.0)
    for name in ("B1", "Y1", "Y2"):
        stage.drive(name, FULL, FULL)
    stage.play(3)
    # It is pushed back slowly if at all: a robot that is pushed resists with all its grip.
    assert -0.05 < stage.pose("B1")[0] < 0.2


def test_two_robots_that_touch_with_turning_wheels_are_not_driven_apart():
    """One drives backwards beside the other; their wheels come together as slowly as a centimetre a second."""
    stage = Stage()
    stage.put("B1", 0.2, 0.079, -3.083)
    stage.put("B2", 0.16, -0.0175, -0.05)
    stage.drive("B1", FULL, FULL)
    stage.drive("B2", -FULL, -FULL)
    touched, fastest_mps, fastest_turn_radps = False, 0.0, 0.0
    for _ in range(60):
        touched = ("B1", "B2") in stage.touched_in(0.032) or touched
        fastest_mps = max(fastest_mps, stage.speed("B1"), stage.speed("B2"))
        fastest_turn_radps = max(fastest_turn_radps, *(abs(stage.velocity(name)[2]) for name in ("B1", "B2")))
    assert touched
    assert fastest_mps < 0.21
    assert fastest_turn_radps < 2.0


@pytest.mark.parametrize("angle_rad", [0.05, 0.1, 0.2])
def test_a_robot_with_a_wheel_rubbing_along_a_wall_is_not_faster_than_its_motors(angle_rad):
    stage = Stage()
    stage.put("B1", 0.55, -0.5, math.pi / 2 - angle_rad)
    stage.drive("B1", FULL, FULL)
    fastest_mps = 0.0
    for _ in range(150):
        stage.play(0.032)
        fastest_mps = max(fastest_mps, stage.speed("B1"))
    assert fastest_mps < 0.21

    # It slides off along the wall.
    x, y, yaw = stage.pose("B1")
    assert y > 0.0
    assert x < 0.65 - 0.0375
    assert yaw == pytest.approx(math.pi / 2, abs=0.25)
