"""A ball whose scenario says that it slows down does so evenly, whichever way it rolls, and then lies still."""

import math

import pytest

from rcj_challenges.core.play import Placement
from tests.world.physics_stage import FULL, Stage


@pytest.mark.parametrize(("slows_mps2", "way"), [(0.05, 0.0), (0.2, 0.5), (1.0, math.pi / 4)])
def test_a_rolling_ball_decelerates_as_the_scenario_states(slows_mps2, way):
    stage = Stage(balls={"ball": {"slows_mps2": slows_mps2}})
    vx, vy = 0.3 * math.cos(way), 0.3 * math.sin(way)
    stage.world.place([Placement(stage.index("ball"), -0.4, -0.4, 0.0, vx_mps=vx, vy_mps=vy)])
    half_way_s = 0.15 / slows_mps2
    stage.play(half_way_s)
    assert stage.speed("ball") == pytest.approx(0.15, abs=0.032 * slows_mps2 + 0.003)
    stage.play(half_way_s + 0.5)
    x, y, _ = stage.pose("ball")
    assert math.dist((x, y), (-0.4, -0.4)) == pytest.approx(0.3**2 / 2 / slows_mps2, rel=0.05, abs=0.002)
    assert math.atan2(y + 0.4, x + 0.4) == pytest.approx(way, abs=0.01)
    stage.play(1)
    assert stage.pose("ball") == pytest.approx((x, y, 0), abs=1e-4)


def test_one_that_lies_still_can_be_hit():
    stage = Stage(balls={"ball": {"slows_mps2": 0.1}})
    stage.put("ball", 0.2, 0.0)
    stage.put("B1", 0.0, 0.0)
    stage.play(0.5)
    assert stage.pose("ball")[:2] == pytest.approx((0.2, 0), abs=1e-6)
    stage.drive("B1", FULL, FULL)
    stage.play(0.9)
    assert 0.2 < stage.speed("ball") < 0.25


def test_one_of_two_may_slow_down():
    stage = Stage(balls={"second": {"start_m": [0.3, 0.0], "slows_mps2": 0.2}})
    stage.world.place(
        [
            Placement(stage.index(name), x, -0.3, 0.0, vx_mps=0.0, vy_mps=0.2)
            for name, x in (("ball", 0), ("second", 0.3))
        ]
    )
    stage.play(0.5)
    assert stage.speed("ball") == pytest.approx(0.2, rel=0.01)
    assert stage.speed("second") == pytest.approx(0.1, abs=0.01)
