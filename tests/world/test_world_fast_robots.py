"""Robots that grip cannot stop within a tick: faster chassis, or the usual one on slippery ground."""

import math

import pytest

from rcj_challenges.core.timing import SUBSTEP_S
from tests.world.physics_stage import FULL, Stage

G = 9.81
DRIVES, BRAKES = G / 3, G
"""At friction 1, in m/s²: pushed on by its wheels, and held by all that touches the floor."""


def robot_of(top_mps: float, **changes: object) -> Stage:
    field = {"goals": {}, "corner_cut_m": 0, "width_m": 10.0, "length_m": 10.0, **changes}
    stage = Stage(field=field, kits={"v2": {"chassis": {"max_wheel_radps": top_mps / 0.02}}})
    stage.put("B1", -4.0, 0.0)
    return stage


def at_speed(stage: Stage, radps: float) -> Stage:
    stage.drive("B1", radps, radps)
    stage.play(abs(radps) * 0.02 / stage.scenario.field.friction / 3 + 0.2)
    return stage


def seconds_until(stage: Stage, *, below_mps: float) -> float:
    for tick in range(1, 1000):
        stage.play()
        if stage.velocity("B1")[0] < below_mps:
            return tick * 0.032
    raise AssertionError("it never slowed down so much")


@pytest.mark.parametrize("top_mps", [0.4, 0.5, 0.7, 1.0, 2.0])
@pytest.mark.parametrize("less", [0.0, 0.03, 0.06])
def test_a_robot_that_reverses_starts_the_other_way_no_faster_than_from_rest(top_mps, less):
    stage = at_speed(robot_of(top_mps), top_mps / 0.02 * (1 - less))
    before = stage.speed("B1")
    stage.drive("B1", -top_mps / 0.02, -top_mps / 0.02)
    needed = before / BRAKES + 0.9 * top_mps / DRIVES
    assert needed - SUBSTEP_S < seconds_until(stage, below_mps=-0.9 * top_mps) < needed + 0.04


@pytest.mark.parametrize("top_mps", [0.5, 1.0, 2.0])
@pytest.mark.parametrize("share", [0.8, 0.5, 0.2])
def test_it_slows_down_as_hard_as_it_stops(top_mps, share):
    stage = at_speed(robot_of(top_mps), top_mps / 0.02)
    stage.drive("B1", share * top_mps / 0.02, share * top_mps / 0.02)
    needed = top_mps * (1 - share) / BRAKES
    assert seconds_until(stage, below_mps=share * top_mps + 0.001) < needed + 0.033
    stage.play(0.2)
    assert stage.velocity("B1")[0] == pytest.approx(share * top_mps, rel=0.01)


@pytest.mark.parametrize("friction", [0.05, 0.1, 0.3])
def test_on_slippery_ground_the_usual_robot_does_so_too(friction):
    drives, brakes = friction * G / (1 + 2 * friction), friction * G
    stage = robot_of(0.2, friction=friction)
    at_speed(stage, FULL)
    stage.play(1)
    stage.drive("B1", FULL / 2, FULL / 2)
    assert seconds_until(stage, below_mps=0.101) < 0.1 / brakes + 0.033
    stage.drive("B1", -FULL, -FULL)
    needed = 0.1 / brakes + 0.18 / drives
    assert needed - SUBSTEP_S < seconds_until(stage, below_mps=-0.18) < needed + 0.04


def test_two_that_push_each_other_come_to_rest_however_fast_their_wheels_turn():
    stage = robot_of(0.5)
    stage.put("B1", 0.0, 0.0)
    stage.put("B2", 0.2, 0.0, math.pi)
    stage.drive("B1", 0.5 / 0.02, 0.5 / 0.02)
    stage.drive("B2", 0.4 / 0.02, 0.4 / 0.02)
    stage.play(3)
    assert stage.speed("B1") < 0.01
    assert stage.speed("B2") < 0.01
