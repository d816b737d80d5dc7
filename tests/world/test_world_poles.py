"""Robots and poles: round obstacles, fixed and movable."""

import math

import pytest

from tests.world.physics_stage import FULL, Stage

OPEN = {"goals": {}, "corner_cut_m": 0, "width_m": 4.0, "length_m": 4.0}


def with_pole(radius_m: float, **how: object) -> Stage:
    return Stage(obstacles={"pole": {"shape": "cylinder", "radius_m": radius_m, "centre_m": [0, 0], **how}}, field=OPEN)


def deepest_m(stage: Stage, seconds: float) -> float:
    """Play, and return by how much any two things overlapped at most."""
    deepest = 0.0
    for _ in range(math.ceil(seconds / 0.032)):
        stage.play()
        deepest = max(deepest, -min(stage.world.data.contact.dist.tolist(), default=0.0))
    return deepest


@pytest.mark.parametrize("radius_m", [0.01, 0.03, 0.06])
@pytest.mark.parametrize("caught_m", [0.004, 0.009])
@pytest.mark.parametrize("way", [1, -1])
def test_a_pole_stops_the_wheel_that_meets_it(radius_m, caught_m, way):
    """Half a wheel's width, or nearly the whole of it, is in the pole's way; the cube is not."""
    stage = with_pole(radius_m)
    stage.put("B1", -way * (radius_m + 0.06), radius_m + 0.05 - caught_m)
    stage.drive("B1", way * FULL, way * FULL)
    assert deepest_m(stage, 2) < 0.002
    if caught_m > radius_m / 5:  # else it glances off
        assert way * stage.pose("B1")[0] < 0.0


@pytest.mark.parametrize("mass_kg", [0.05, 0.5, 2.0])
@pytest.mark.parametrize("yaw", [0.0, 0.3, 1.2])
def test_a_wheel_does_not_sink_into_a_movable_pole(mass_kg, yaw):
    stage = with_pole(0.03, movable=True, mass_kg=mass_kg)
    stage.put("pole", 0.0, 0.0)
    back, aside = 0.15, 0.07
    stage.put(
        "B1",
        -back * math.cos(yaw) - aside * math.sin(yaw),
        -back * math.sin(yaw) + aside * math.cos(yaw),
        yaw,
    )
    stage.drive("B1", FULL, FULL)
    assert deepest_m(stage, 2) < 0.002


@pytest.mark.parametrize(("yaw_deg", "aside_m"), [(75, 0.035), (90, 0.02), (90, -0.01)])
def test_where_there_are_poles_a_braked_robot_still_stays_when_it_is_pushed_at_a_wheel(yaw_deg, aside_m):
    stage = Stage(obstacles={"pole": {"shape": "cylinder", "radius_m": 0.03, "centre_m": [1, 1]}}, field=OPEN)
    stage.put("B2", 0.0, 0.0, math.radians(yaw_deg))
    stage.put("B1", -0.22, aside_m)
    stage.drive("B1", FULL, FULL)
    stage.play(8)
    assert math.hypot(*stage.pose("B2")[:2]) < 0.003
