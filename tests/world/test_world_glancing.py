"""Balls that glance off movable obstacles: as off walls, and what is given to the ball is taken from the obstacle."""

import math
from functools import reduce
from itertools import product
from operator import add

import pytest

from tests.world.physics_stage import BALL_R, Stage, same_stage

OPEN = {"goals": {}, "corner_cut_m": 0, "width_m": 4.0, "length_m": 4.0}
BOX = {"shape": "box", "size_m": [0.1, 0.6]}
CYLINDER = {"shape": "cylinder", "radius_m": 0.05}
HALF_M = 0.05


def glance(
    shape: dict, degrees: float, speed: float, offset: float = 0.0, turn: float = 0.0, **how: object
) -> tuple[Stage, float, float]:
    """Roll a ball at an obstacle, so many degrees from its normal.

    Returns:
        The stage just after; the speed off the obstacle and the speed along it, each as a share of what it was.
    """
    stage = same_stage(obstacles={"crate": {**shape, "centre_m": [0, 0], "movable": True, **how}}, field=OPEN)
    angle, back = math.radians(degrees), 0.02 + offset * speed * 0.008
    out, along = (-math.cos(turn), -math.sin(turn)), (-math.sin(turn), math.cos(turn))
    away, aside = HALF_M + BALL_R + back * math.cos(angle), -back * math.sin(angle)
    stage.put("crate", 0, 0, turn)
    stage.put("ball", away * out[0] + aside * along[0], away * out[1] + aside * along[1])
    closing, sliding = speed * math.cos(angle), speed * math.sin(angle)
    stage.roll("ball", -closing * out[0] + sliding * along[0], -closing * out[1] + sliding * along[1])
    assert ("ball", "crate") in stage.touched_in(0.04 + back / speed)
    vx, vy, _ = stage.velocity("ball")
    return stage, (vx * out[0] + vy * out[1]) / closing, (vx * along[0] + vy * along[1]) / sliding


@pytest.mark.parametrize(("degrees", "most"), [(40, 0.6), (60, 0.6), (70, 0.65), (80, 0.7), (85, 1.2)])
@pytest.mark.parametrize("speed", [0.25, 1.0, 2.0])
@pytest.mark.parametrize("mass_kg", [0.2, 0.5, 50.0])
def test_a_ball_that_glances_off_a_movable_obstacle_leaves_it_no_faster_than_a_wall(degrees, most, speed, mass_kg):
    for offset, turn in product((0.0, 0.4, 0.8), (0.0, 0.4)):
        _, off, along = glance(BOX, degrees, speed, offset, turn, mass_kg=mass_kg)
        assert -0.1 < off < most
        assert 0.4 < along < 0.95


@pytest.mark.parametrize("mass_kg", [0.5, 50.0])
@pytest.mark.parametrize("degrees", [70, 80])
def test_so_does_one_that_glances_off_a_pole(degrees, mass_kg):
    for offset in (0.0, 0.4, 0.8):
        # The pole's normal turns by some degrees while the ball passes it.
        _, off, _ = glance(CYLINDER, degrees, 1.0, offset, mass_kg=mass_kg)
        assert -0.1 < off < 0.9


@pytest.mark.parametrize("degrees", [50, 70, 80])
@pytest.mark.parametrize("mass_kg", [0.05, 0.5])
def test_what_the_ball_does_not_get_the_obstacle_does_not_lose(degrees, mass_kg):
    """Ball and obstacle on smooth ground: together they go on as before."""
    speed, ball_kg = 1.0, 0.05
    angle = math.radians(degrees)
    stage, _, _ = glance(CYLINDER, degrees, speed, mass_kg=mass_kg)
    ball, crate = stage.velocity("ball"), stage.velocity("crate")
    slowed = 0.1 * 9.81 * mass_kg * 0.05
    for axis, before in enumerate((speed * math.cos(angle), speed * math.sin(angle))):
        after = ball_kg * ball[axis] + mass_kg * crate[axis]
        assert after == pytest.approx(ball_kg * before, abs=slowed + 0.1 * ball_kg * speed)


def test_a_heavy_obstacle_that_is_glanced_at_stays_where_it_is():
    stage, _, _ = glance(BOX, 80, 1.0, mass_kg=50.0)
    assert stage.pose("crate") == pytest.approx((0, 0, 0), abs=1e-5)


def test_a_glancing_ball_goes_the_same_way_to_the_last_bit_in_every_version_of_python(monkeypatch):
    def motion() -> list[bytes]:
        stages = (
            glance(BOX, degrees, speed, mass_kg=0.5)[0] for degrees in range(40, 80, 5) for speed in (0.3, 0.6, 1.0)
        )
        return [stage.world.data.qpos.tobytes() + stage.world.data.qvel.tobytes() for stage in stages]

    def left_to_right(values, start=0):  # as in Python 3.11
        return reduce(add, values, start)

    def compensated(values, start=0):  # as from Python 3.12 on
        terms = [start, *values]
        return math.fsum(terms) if any(isinstance(one, float) for one in terms) else left_to_right(terms)

    def motion_with(sum_: object) -> list[bytes]:
        with monkeypatch.context() as patch:
            patch.setattr("builtins.sum", sum_)
            return motion()

    assert motion_with(compensated) == motion_with(left_to_right)
