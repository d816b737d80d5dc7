"""A ball that is set down with a velocity rolls off and keeps it."""

from __future__ import annotations

import math

import pytest

from rcj_challenges.core.play import Placement
from tests.world.physics_stage import Stage


def kicked(name: str, x: float, y: float, vx: float, vy: float, **changes) -> Stage:
    stage = Stage(**changes)
    stage.world.place([Placement(stage.index(name), x, y, 0.0, vx_mps=vx, vy_mps=vy)])
    return stage


@pytest.mark.parametrize("speed", [0.05, 0.6, 1.5, 3.0])
@pytest.mark.parametrize("way", [0.0, 0.7, 2.2, -2.6])
def test_after_a_tenth_of_a_second_it_has_the_speed_and_the_way_of_its_kick(speed, way):
    stage = kicked("ball", 0.0, 0.0, speed * math.cos(way), speed * math.sin(way))
    stage.play(0.1)
    vx, vy, vz = stage.velocity("ball")
    assert math.hypot(vx, vy) == pytest.approx(speed, rel=0.02)
    assert math.atan2(vy, vx) == pytest.approx(way, abs=0.01)
    assert vz == pytest.approx(0.0, abs=0.01)


def test_it_has_moved_by_its_speed_in_the_first_tick():
    stage = kicked("ball", 0.1, -0.2, 0.0, 0.6)
    stage.play()
    assert stage.pose("ball")[:2] == pytest.approx((0.1, -0.2 + 0.6 * 0.032), abs=5e-4)


def test_a_ball_of_another_size_and_mass_rolls_as_well():
    stage = kicked("ball", 0.0, -0.4, 0.0, 0.6, balls={"ball": {"radius_m": 0.05, "mass_kg": 0.4}})
    stage.play(0.1)
    assert stage.speed("ball") == pytest.approx(0.6, rel=0.02)


def test_the_fastest_kick_does_not_pass_a_wall():
    stage = kicked("ball", 0.0, 0.0, 3.0, 0.0)
    assert all(abs(snapshot.substeps[-1][stage.index("ball")][0]) < 0.79 for snapshot in stage.play(2.0))


def test_the_next_placement_without_a_kick_stops_it():
    stage = kicked("ball", 0.0, 0.0, 0.6, 0.0)
    stage.play(0.1)
    stage.put("ball", 0.0, 0.0)
    stage.play(0.5)
    assert stage.pose("ball") == pytest.approx((0, 0, 0), abs=1e-6)


def test_what_is_no_ball_does_not_roll():
    with pytest.raises(ValueError, match="only balls roll: 'B1'"):
        kicked("B1", 0.0, 0.0, 0.6, 0.0)
