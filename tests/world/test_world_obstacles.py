"""Movable obstacles glide as Coulomb's friction lets them, the same in all directions."""

import math

import pytest

from rcj_challenges.world.effects.friction import mean_distance_m
from tests.world.physics_stage import FULL, Stage

OPEN = {"goals": {}, "corner_cut_m": 0, "width_m": 4.0, "length_m": 4.0}
CYLINDER = {"shape": "cylinder", "radius_m": 0.03}
BOX = {"shape": "box", "size_m": [0.06, 0.06]}


def with_obstacle(shape: dict, mass_kg: float = 0.5, **field: float) -> Stage:
    crate = {**shape, "centre_m": [0, 0], "movable": True, "mass_kg": mass_kg}
    return Stage(obstacles={"crate": crate}, field={**OPEN, **field})


@pytest.mark.parametrize("shape", [CYLINDER, BOX])
@pytest.mark.parametrize("mass_kg", [0.02, 0.2, 0.5])
def test_a_pushed_obstacle_goes_straight_on_and_equally_far_in_all_directions(shape, mass_kg):
    ways = []
    for degrees in (0, 22.5, 45, 70, -100):
        yaw = math.radians(degrees)
        stage = with_obstacle(shape, mass_kg)
        stage.put("crate", 0, 0, yaw)
        stage.put("B1", -0.15 * math.cos(yaw), -0.15 * math.sin(yaw), yaw)
        stage.drive("B1", FULL, FULL)
        stage.play(2)
        x, y, _ = stage.pose("crate")
        ways.append(math.hypot(x, y))
        assert math.remainder(math.atan2(y, x) - yaw, math.tau) == pytest.approx(0, abs=0.01)
    assert max(ways) < 1.02 * min(ways)


@pytest.mark.parametrize("degrees", [0, 10, 22.5, 45, 100])
def test_one_that_glides_comes_to_rest_in_a_straight_line_after_the_way_that_friction_leaves_it(degrees):
    stage, angle = with_obstacle(CYLINDER), math.radians(degrees)
    stage.put("crate", 0, 0)
    stage.world.data.qvel[stage.world.tables.dofs[stage.index("crate")]] = [math.cos(angle), math.sin(angle), 0]
    stage.play(2)
    x, y, _ = stage.pose("crate")
    assert math.hypot(x, y) == pytest.approx(1 / (2 * 0.1 * 9.81), rel=0.02)
    assert math.atan2(y, x) == pytest.approx(angle, abs=0.002)
    assert stage.speed("crate") == pytest.approx(0, abs=1e-4)


def test_one_on_ice_glides_on():
    stage = with_obstacle(BOX, friction=0.0)
    stage.put("crate", 0, 0)
    stage.world.data.qvel[stage.world.tables.dofs[stage.index("crate")]] = [0.2, 0.1, 0]
    stage.play(2)
    assert stage.speed("crate") == pytest.approx(math.hypot(0.2, 0.1))


@pytest.mark.parametrize("size_m", [(0.06, 0.06), (0.3, 0.02), (0.05, 0.1)])
def test_a_box_resists_turning_as_its_even_pressure_does(size_m):
    spin_radps = 10.0
    stage = with_obstacle({"shape": "box", "size_m": list(size_m)})
    stage.put("crate", 0, 0)
    turning = stage.world.tables.dofs[stage.index("crate")][2]
    stage.world.data.qvel[turning] = spin_radps
    stage.play(0.032)
    middles = [(k + 0.5) / 100 - 0.5 for k in range(100)]
    arm_m = sum(math.hypot(size_m[0] * x, size_m[1] * y) for x in middles for y in middles) / 100**2
    assert mean_distance_m(*size_m) == pytest.approx(arm_m, rel=1e-3)
    slowing = 0.1 * 9.81 * arm_m * 12 / (size_m[0] ** 2 + size_m[1] ** 2)
    assert spin_radps - stage.velocity("crate")[2] == pytest.approx(slowing * 0.032, rel=0.02)
