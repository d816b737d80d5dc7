"""Every body at posts, in corners and in crowds, as the usual robots were tried (ADR 2)."""

from __future__ import annotations

import math
import random
from collections.abc import Iterator
from functools import cache
from typing import NamedTuple

import pytest

from rcj_challenges.chassis.base import Chassis
from rcj_challenges.chassis.differential import DifferentialChassis
from rcj_challenges.chassis.omni import OmniChassis
from rcj_challenges.core.play import Pose2
from tests.chassis.test_omni import motion, order
from tests.world.physics_stage import BALL_R, Stage, same_stage

ROBOTS = ("B1", "B2", "B3", "Y1", "Y2", "Y3")
LONE = ROBOTS[:4]
FREE_M = 0.57, 0.67
"""Within this no robot touches a wall, whichever way it looks."""
TOP_MPS = 0.2
AHEAD_TICKS, BACK_TICKS = 47, 31
CASES = 2100
BODIES = [
    pytest.param(drive, shape, jaws_m, id=f"{drive}, {shape}{', jaws' if jaws_m else ''}")
    for drive in ("differential", "omni")
    for shape in ("box", "round", "flat_front")
    for jaws_m in (None, (0.006, 0.05))
]


@cache
def body(drive: str, shape: str, jaws_m: tuple[float, float] | None) -> Chassis:
    kind = OmniChassis if drive == "omni" else DifferentialChassis
    return kind(drive=drive, shape=shape, jaws_m=jaws_m)


def stage_of(chassis: Chassis) -> Stage:
    return same_stage(kits={"v2": {"chassis": chassis}})


def drive(stage: Stage, chassis: Chassis, name: str, ahead_mps: float) -> None:
    if isinstance(chassis, OmniChassis):
        order(stage, chassis, name, ahead_mps, 0.0, 0.0)
    else:
        stage.drive(name, ahead_mps / chassis.wheel_radius_m, ahead_mps / chassis.wheel_radius_m)


def approaches(cases: int) -> Iterator[list[Pose2]]:
    """Yield poses near two corners and two posts, which look more or less at them, and are far from each other."""
    draw = random.Random(7)  # noqa: S311 - the same cases each time
    for _ in range(cases // len(LONE)):
        side, poses = draw.choice((-1, 1)), []
        for end in (-1, 1):
            corner_x, y = side * end * 0.65, end * 0.75
            for x, way in ((corner_x, math.atan2(y, corner_x)), (-side * end * 0.2, end * math.pi / 2)):
                towards, far_m = way + draw.uniform(-0.8, 0.8), draw.uniform(0.13, 0.18)
                at = x - far_m * math.cos(towards), y - far_m * math.sin(towards)
                free = (max(-limit, min(limit, along)) for limit, along in zip(FREE_M, at, strict=True))
                poses.append((*free, towards + draw.uniform(-0.5, 0.5)))
        yield poses


class Tried(NamedTuple):
    """What came of driving at posts and corners, and back: all over all cases.

    Attributes:
        deepest_m: how far anything sank into anything.
        fastest_mps: how fast a robot was.
        caught: robots that did not get away.
    """

    deepest_m: float
    fastest_mps: float
    caught: int


def tried(chassis: Chassis, cases: int) -> Tried:
    stage, deepest_m, fastest_mps, caught = stage_of(chassis), 0.0, 0.0, 0
    for poses in approaches(cases):
        for name, pose in zip(LONE, poses, strict=True):
            stage.put(name, *pose)
        met: list[Pose2] = []
        for ahead_mps, ticks in ((TOP_MPS, AHEAD_TICKS), (-TOP_MPS, BACK_TICKS)):
            met = [stage.pose(name) for name in LONE]
            for name in LONE:
                drive(stage, chassis, name, ahead_mps)
            for _ in range(ticks):
                stage.play()
                deepest_m = max(deepest_m, -min(stage.world.data.contact.dist.tolist(), default=0.0))
                fastest_mps = max(fastest_mps, *map(stage.speed, LONE))
        caught += sum(math.dist(then[:2], stage.pose(name)[:2]) < 0.02 for then, name in zip(met, LONE, strict=True))
    return Tried(deepest_m, fastest_mps, caught)


def check_approaches(chassis: Chassis, cases: int) -> None:
    found = tried(chassis, cases)
    print(found)
    assert found.deepest_m < 0.002
    assert found.fastest_mps < 1.02 * TOP_MPS
    assert found.caught == 0


@pytest.mark.parametrize(("drive", "shape", "jaws_m"), BODIES)
def test_robots_at_posts_and_corners_do_not_jump_and_get_away(drive, shape, jaws_m):
    check_approaches(body(drive, shape, jaws_m), 24)


@pytest.mark.nightly
@pytest.mark.parametrize(("drive", "shape", "jaws_m"), BODIES)
def test_robots_at_posts_and_corners_do_not_jump_and_get_away_in_2100_cases(drive, shape, jaws_m):
    check_approaches(body(drive, shape, jaws_m), CASES)


@pytest.mark.parametrize(("drive_kind", "shape", "jaws_m"), BODIES)
@pytest.mark.parametrize(("aside_m", "at_most_m"), [(0.0, 0.001), (0.012, 0.002)], ids=["amid", "aside"])
def test_ball_that_is_pushed_at_a_wall_does_not_sink_into_it(drive_kind, shape, jaws_m, aside_m, at_most_m):
    chassis = body(drive_kind, shape, jaws_m)
    stage = stage_of(chassis)
    stage.put("ball", 0.65 - BALL_R, 0)
    stage.put("B1", 0.5, aside_m)
    drive(stage, chassis, "B1", TOP_MPS)
    ball = stage.index("ball")
    furthest_m = max(snapshot.substeps[-1][ball][0] for snapshot in stage.play(3))
    assert furthest_m < 0.65 - BALL_R + at_most_m


# --- omni wheels in a crowd -------------------------------------------------------------------------------------------


def crowd(chassis: OmniChassis, seconds: float, seed: int, chasers: int) -> None:
    """Let robots chase the ball or drive at random; the ball is put back to the centre every 20 s."""
    draw, stage = random.Random(seed), stage_of(chassis)  # noqa: S311 - a reproducible load
    for number, name in enumerate(ROBOTS):
        stage.put(name, -0.4 + 0.16 * number, 0.3 if number % 2 else -0.3)
    highest_m = 0.0
    while stage.tick * 0.032 < seconds:
        if stage.tick % 625 == 0:
            stage.put("ball", 0.0, 0.0)
        ball_x, ball_y, _ = stage.pose("ball")
        for number, name in enumerate(ROBOTS):
            x, y, yaw = stage.pose(name)
            if number < chasers:
                way = math.atan2(ball_y - y, ball_x - x) - yaw
                order(stage, chassis, name, 0.2 * math.cos(way), 0.2 * math.sin(way), 3 * math.sin(way))
            elif stage.tick % 8 == 0:
                for wheel in range(len(chassis.wheels())):
                    stage.world.set_wheel(stage.index(name), wheel, draw.uniform(-12.5, 12.5), math.inf)
        (snapshot,) = stage.play()
        highest_m = max(highest_m, snapshot.heights[6])
        for name, (x, y, _) in zip(stage.roster.entities, snapshot.substeps[-1], strict=True):
            within_goal = abs(x) < 0.2 and abs(y) < 0.85
            assert (abs(x) < 0.655 and abs(y) < 0.755) or within_goal, f"{name} left at {stage.tick}: {x}, {y}"
    assert highest_m < 0.09


@pytest.mark.parametrize("shape", ["round", "flat_front"])
def test_nothing_leaves_the_field_in_a_quarter_of_a_minute_of_crowding(shape):
    crowd(body("omni", shape, (0.006, 0.05)), 15, seed=1, chasers=6)


@pytest.mark.nightly
@pytest.mark.parametrize("chasers", [6, 4, 0])
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_nothing_leaves_the_field_in_600_s_of_crowding(chasers, seed):
    crowd(body("omni", "flat_front", (0.006, 0.05)), 600, seed, chasers)


# --- a blocked wheel --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("blocked", range(4))
def test_robot_with_a_blocked_wheel_drives_a_curve_and_slower(blocked):
    chassis = OmniChassis(drive="omni", wheels_at_rad=tuple(math.pi / 4 + math.pi / 2 * wheel for wheel in range(4)))
    stage = stage_of(chassis)
    stage.put("B1", 0, 0)
    order(stage, chassis, "B1", 0.2, 0.0, 0.0)
    stage.world.set_wheel(stage.index("B1"), blocked, 0.0, math.inf)
    stage.play(0.5)
    ahead_mps, _, spin_radps = motion(stage, "B1")
    # Wheels 0 and 1 sit on the left: with one of them blocked it turns left.
    assert math.copysign(1, spin_radps) == (1 if blocked < 2 else -1)
    assert 0.09 < ahead_mps < 0.19
    assert 0.5 < abs(spin_radps) < 4
