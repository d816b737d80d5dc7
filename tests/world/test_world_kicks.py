"""A ball that is set down with a velocity rolls off and keeps it."""

import math

import pytest

from rcj_challenges.core.play import Placement
from tests.world.physics_stage import Stage


def kicked(name: str, vx: float, vy: float) -> Stage:
    stage = Stage()
    stage.world.place([Placement(stage.index(name), 0.0, 0.0, 0.0, vx_mps=vx, vy_mps=vy)])
    return stage


@pytest.mark.parametrize(("speed", "way"), [(0.05, 0.7), (0.6, 0.0), (1.5, -2.6), (3.0, 2.2)])
def test_after_a_tenth_of_a_second_it_has_the_speed_and_the_way_of_its_kick(speed, way):
    stage = kicked("ball", speed * math.cos(way), speed * math.sin(way))
    stage.play()
    assert math.hypot(*stage.pose("ball")[:2]) == pytest.approx(speed * 0.032, rel=0.025, abs=5e-4)
    stage.play(0.064)
    vx, vy, vz = stage.velocity("ball")
    assert math.hypot(vx, vy) == pytest.approx(speed, rel=0.02)
    assert math.atan2(vy, vx) == pytest.approx(way, abs=0.01)
    assert vz == pytest.approx(0.0, abs=0.01)


def test_the_next_placement_without_a_kick_stops_it():
    stage = kicked("ball", 0.6, 0.0)
    stage.play(0.1)
    stage.put("ball", 0.0, 0.0)
    stage.play(0.5)
    assert stage.pose("ball") == pytest.approx((0, 0, 0), abs=1e-6)


def test_what_is_no_ball_does_not_roll():
    with pytest.raises(ValueError, match="only balls roll: 'B1'"):
        kicked("B1", 0.6, 0.0)
