"""Dribblers: back spin, what it holds, and what it does not."""

import math
from collections.abc import Callable

import pytest

from tests.world.physics_stage import BALL_R, FULL, HALF_CUBE, Stage

OPEN = {"goals": {}, "corner_cut_m": 0, "width_m": 4.0, "length_m": 4.0}
WAYS: dict[str, Callable[[float], tuple[float, float]]] = {
    "back at once": lambda _: (-FULL, -FULL),
    "back in half a second": lambda t: (-FULL * min(1, 2 * t), -FULL * min(1, 2 * t)),
    "slowly back": lambda _: (-FULL / 2, -FULL / 2),
    "slow spin": lambda _: (-FULL / 4, FULL / 4),
    "spin": lambda _: (-FULL / 2, FULL / 2),
    "fast spin": lambda _: (-FULL, FULL),
    "curve": lambda _: (3, 8),
}


def stage_with(*forces_n: float, **changes) -> Stage:
    devices = [{"devices": {"dribbler": {"device": "dribbler", "force_n": force_n}}} for force_n in forces_n]
    return Stage(robots=dict(zip(("B1", "B2"), devices, strict=False)), field=OPEN, **changes)


def spin_up(stage: Stage, name: str, radps: float = 50.0) -> None:
    stage.world.set_tool(stage.index(name), "dribbler", radps, math.inf)


def at_the_ball(stage: Stage) -> None:
    stage.put("B1", 0.0, 0.0)
    stage.put("ball", HALF_CUBE + BALL_R + 0.0005, 0.0)


def has_ball(stage: Stage, name: str = "B1") -> bool:
    (x, y, yaw), (ball_x, ball_y, _) = stage.pose(name), stage.pose("ball")
    c, s, dx, dy = math.cos(yaw), math.sin(yaw), ball_x - x, ball_y - y
    return c * dx + s * dy - HALF_CUBE - BALL_R < 0.02 and abs(c * dy - s * dx) < 0.035


def keeps(way: str, *forces_n: float) -> bool:
    stage = stage_with(*forces_n)
    at_the_ball(stage)
    if forces_n:
        spin_up(stage, "B1")
    stage.play(0.5)
    for tick in range(94):
        stage.drive("B1", *WAYS[way](tick * 0.032))
        stage.play()
        if not has_ball(stage):
            return False
    return True


@pytest.mark.parametrize(("force_n", "kept"), [
    ((), set()),
    ((0.06,), {"back in half a second", "slow spin", "curve"}),
    ((0.12,), {"back in half a second", "slowly back", "slow spin", "spin", "curve"}),
    ((0.25,), {*WAYS} - {"fast spin"}),
], ids=["none", "weak", "usual", "strong"])  # fmt: skip
def test_ball_follows_what_its_force_allows(force_n, kept):
    assert {way for way in WAYS if keeps(way, *force_n)} == kept


@pytest.mark.parametrize("radps", [20.0, -20.0])
def test_on_a_smooth_floor_the_ball_turns_nearly_as_fast_as_the_rim_and_no_faster(radps):
    stage = Stage(
        robots={"B1": {"devices": {"dribbler": {"device": "dribbler", "force_n": 0.2}}}}, field={"friction": 0.1}
    )
    at_the_ball(stage)
    spin_up(stage, "B1", radps)
    fastest = []
    for _ in range(60):
        stage.play()
        spin = stage.world.data.qvel[stage.world.tables.dofs[stage.index("ball")]][3:]
        fastest.append(math.hypot(*spin))
    rim_radps = 20 * 0.01 / BALL_R
    assert 0.8 * rim_radps < max(fastest) <= rim_radps


@pytest.mark.parametrize("force_n", [0.06, 0.12, 0.25])
@pytest.mark.parametrize("jaws_m", [None, (0.006, 0.05)], ids=["without jaws", "with jaws"])
def test_attacker_from_the_side_takes_the_ball_within_a_second(force_n, jaws_m):
    stage = stage_with(force_n, kits={"v2": {"chassis": {"jaws_m": jaws_m}}})
    at_the_ball(stage)
    spin_up(stage, "B1")
    stage.play(0.5)
    stage.put("B2", HALF_CUBE + BALL_R + 0.03, 0.075, -math.pi / 2)
    stage.drive("B2", FULL, FULL)
    stage.play(1)
    assert not has_ball(stage)


def test_stronger_of_two_dribblers_takes_the_ball_on_either_side():
    for first, second in ((0.06, 0.25), (0.25, 0.06)):
        stage = stage_with(first, second)
        at_the_ball(stage)
        stage.put("B2", 2 * (HALF_CUBE + BALL_R + 0.0005), 0.0, math.pi)
        for name in ("B1", "B2"):
            spin_up(stage, name)
        stage.play(0.3)
        for name in ("B1", "B2"):
            stage.drive(name, -2, -2)
        stage.play(1)
        assert (has_ball(stage, "B1"), has_ball(stage, "B2")) == (first > second, second > first)


def test_two_equal_dribblers_change_places_and_nothing_else_changes():
    """A tug of war: what becomes of the ball does not depend on which robot is on which side."""
    paths = []
    for first, second in (("B1", "B2"), ("B2", "B1")):
        stage = stage_with(0.12, 0.12)
        stage.put(first, 0.0, 0.0)
        stage.put("ball", HALF_CUBE + BALL_R + 0.0005, 0.0)
        stage.put(second, 2 * (HALF_CUBE + BALL_R + 0.001), 0.002, math.pi)
        for name in (first, second):
            spin_up(stage, name)
        stage.play(0.3)
        for name in (first, second):
            stage.drive(name, -2, -2)
        path = []
        for _ in range(30):
            stage.play()
            path.append(stage.pose("ball")[:2])
        paths.append((path, has_ball(stage, first), has_ball(stage, second)))
    (one, *kept), (other, *kept_too) = paths
    assert kept == kept_too
    assert max(math.dist(a, b) for a, b in zip(one, other, strict=True)) < 0.001


@pytest.mark.parametrize("how", ["off", "angle", "held"])
def test_roller_that_stands_does_nothing(how):
    stage = stage_with(0.25)
    at_the_ball(stage)
    stage.world.set_tool(
        stage.index("B1"), "dribbler", 0.0 if how == "off" else 50.0, 1.0 if how == "angle" else math.inf
    )
    if how == "held":
        stage.hold("B1")
    stage.play(1)
    spin = stage.world.data.qvel[stage.world.tables.dofs[stage.index("ball")]][3:]
    assert math.hypot(*spin) < 0.01
