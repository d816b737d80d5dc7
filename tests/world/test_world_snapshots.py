"""What the referee gets of a tick."""

import math
import struct
from itertools import pairwise

import pytest

from rcj_challenges.core.play import Fault
from tests.world.physics_stage import FULL, Stage


def test_a_tick_has_four_substeps_of_8_ms():
    stage = Stage()
    stage.put("ball", 0.0, 0.0)
    stage.roll("ball", 0.25, 0.0)
    (snapshot,) = stage.play()
    assert snapshot.tick == 1
    assert [poses[6][0] for poses in snapshot.substeps] == pytest.approx([0.002, 0.004, 0.006, 0.008], abs=1e-5)


def test_the_last_substep_is_the_judged_pose_and_does_not_lag():
    stage = Stage()
    stage.put("B1", 0.0, 0.0, 0.3)
    stage.drive("B1", FULL, 4.0)
    (snapshot,) = stage.play()
    x, y, yaw = stage.world.data.qpos[:3].tolist()
    assert snapshot.substeps[-1][0] == pytest.approx((x, y, yaw), abs=1e-7)
    assert stage.world.judged().substeps[0][0] == snapshot.substeps[-1][0]


def test_all_numbers_have_the_precision_of_the_trajectory():
    stage = Stage()
    stage.put("B1", 0.123456789, 0.1, 0.777)
    stage.put("ball", -0.3, 1 / 3)
    stage.roll("ball", 0.3, 0.111)
    stage.drive("B1", FULL, 3.0)
    for snapshot in [*stage.play(0.2), stage.world.judged()]:
        numbers = [n for poses in snapshot.substeps for pose in poses for n in pose] + snapshot.heights
        assert all(type(number) is float for number in numbers)
        assert list(struct.unpack(f"{len(numbers)}f", struct.pack(f"{len(numbers)}f", *numbers))) == numbers


def test_poses_are_tuples_in_the_order_of_the_entities():
    stage = Stage()
    stage.world.reset()
    poses = stage.world.judged().substeps[0]
    assert all(type(pose) is tuple for pose in poses)
    assert poses[stage.index("Y1")][:2] == pytest.approx((-0.3, -0.3))
    assert poses[stage.index("B3")][:2] == pytest.approx((0.0, 0.3))


def test_yaws_stay_within_half_a_turn_however_long_a_robot_spins():
    stage = Stage()
    stage.put("B1", 0.0, 0.0)
    stage.drive("B1", -FULL, FULL)
    yaws = [snapshot.substeps[-1][0][2] for snapshot in stage.play(10)]
    assert max(yaws) <= math.pi + 1e-6
    assert min(yaws) >= -math.pi - 1e-6
    turned = sum(math.remainder(b - a, 2 * math.pi) for a, b in pairwise(yaws))
    assert turned == pytest.approx(4.444 * 10, rel=0.01)


def test_a_ball_has_no_yaw_and_its_own_height():
    stage = Stage()
    stage.put("ball", 0.0, 0.0)
    stage.roll("ball", 0.3, 0.3)
    for snapshot in stage.play(0.5):
        assert snapshot.substeps[-1][6][2] == 0.0
        assert snapshot.heights == pytest.approx([0.0375] * 6 + [0.0209], abs=1e-4)
        assert snapshot.uprights == [1.0] * 7


def test_faults_are_handed_on():
    stage = Stage()
    fault = Fault("B1", "crash", 3, 1, "it broke")
    assert stage.world.step(3, (fault,)).faults == (fault,)
    assert stage.world.step(4).faults == ()


def test_a_snapshot_does_not_change_when_the_next_one_is_made():
    stage = Stage()
    stage.put("ball", 0.0, 0.0)
    stage.roll("ball", 0.3, 0.0)
    (first,) = stage.play()
    before = [list(poses) for poses in first.substeps], list(first.heights), first.touches
    stage.play(1)
    assert ([list(poses) for poses in first.substeps], list(first.heights), first.touches) == before


# --- touches ----------------------------------------------------------------------------------------------------------


def test_a_ball_that_rolls_freely_touches_nothing():
    stage = Stage()
    stage.put("ball", 0.0, 0.0)
    stage.roll("ball", 0.3, 0.0)
    assert not stage.touched_in(1)


def test_robot_ball_walls_and_robots_are_distinguished():
    stage = Stage()
    stage.put("B1", 0.55, 0.0)
    stage.put("ball", 0.0, -0.7)
    stage.put("Y1", -0.3, 0.0)
    stage.put("Y2", -0.1, 0.0, math.pi)
    stage.put("Y3", -0.2, -0.7)
    for name in ("B1", "Y1", "Y2", "Y3"):
        stage.drive(name, FULL, FULL)
    touched = stage.touched_in(1.5)
    assert {("B1", "walls"), ("Y1", "Y2"), ("Y3", "ball")} <= touched
    assert not touched & {("B1", "ball"), ("Y1", "walls"), ("B1", "B1")}


def test_a_goal_is_a_wall():
    stage = Stage()
    stage.put("ball", 0.0, 0.8)
    stage.roll("ball", 0.5, 0.0)
    assert stage.touched_in(0.5) == {("ball", "walls")}


def test_a_touch_between_two_ticks_poses_has_its_substep():
    stage = Stage()
    stage.put("ball", 0.6, 0.0)
    stage.roll("ball", 0.8, 0.0)
    walls, ball = stage.index("walls"), stage.index("ball")
    when = [
        (snapshot.tick, substep)
        for snapshot in stage.play(0.5)
        for substep, pairs in enumerate(snapshot.touches)
        if (ball, walls) in pairs
    ]
    # 0.029 m at 0.8 m/s are 36.25 ms: seen in the sixth sub-step, tick 2.
    assert when[0] == (2, 1)
    assert len(when) < 8


def test_present_poses_touch_nothing_yet():
    stage = Stage()
    snapshot = stage.world.judged()
    assert snapshot.tick == 0
    assert snapshot.touches == ((), (), (), ())
