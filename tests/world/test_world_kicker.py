"""Kickers: a relative speed, recoil, and the time that they need to charge."""

import math

import pytest

from rcj_challenges.core.timing import TICK_S
from tests.world.physics_stage import BALL_R, HALF_CUBE, Stage

OUT, BACK = 0.04, 0.0
SLIDES = 5 / 7
"""Share of its speed that is left to a ball that slid when it rolls."""


def stage_with(speed_mps: float = 0.8, **changes) -> Stage:
    kicker = {"device": "kicker", "speed_mps": speed_mps}
    return Stage(robots={"B1": {"devices": {"kicker": kicker}}}, **changes)


def at_the_ball(stage: Stage, gap_m: float = 0.001, aside_m: float = 0.0, yaw: float = 0.0, ahead_m: float = HALF_CUBE):
    c, s, ahead = math.cos(yaw), math.sin(yaw), ahead_m + BALL_R + gap_m
    stage.put("B1", 0.0, 0.0, yaw)
    stage.put("ball", c * ahead - s * aside_m, s * ahead + c * aside_m)
    stage.play(0.1)


def kick(stage: Stage, speed_mps: float = 0.8) -> float:
    """Shoot; returns the speed of the ball once it rolls."""
    stage.world.set_tool(stage.index("B1"), "kicker", speed_mps, OUT)
    stage.play(0.4)
    return stage.speed("ball")


def rearm(stage: Stage, seconds: float) -> None:
    stage.world.set_tool(stage.index("B1"), "kicker", 0.8, BACK)
    stage.play(seconds)


@pytest.mark.parametrize("speed_mps", [0.4, 0.8, 1.5])
@pytest.mark.parametrize("yaw", [0.0, 2.0])
def test_ball_rolls_off_ahead_with_its_share_of_the_speed(speed_mps, yaw):
    stage = stage_with(speed_mps)
    at_the_ball(stage, yaw=yaw)
    ball, robot = stage.scenario.balls["ball"].mass_kg, stage.world.model.body("B1").subtreemass[0]
    assert kick(stage, speed_mps) == pytest.approx(SLIDES * speed_mps * robot / (robot + ball), rel=0.02)
    x, y, _ = stage.velocity("ball")
    assert math.remainder(math.atan2(y, x) - yaw, math.tau) == pytest.approx(0, abs=0.01)


def test_kick_changes_the_momentum_of_ball_and_robot_together_by_nothing():
    stage = stage_with()
    at_the_ball(stage)
    world, robot, ball = stage.world, stage.index("B1"), stage.index("ball")
    at = [world.tables.dofs[entity][:2] for entity in (robot, ball)]
    masses = float(world.model.body("B1").subtreemass[0]), stage.scenario.balls["ball"].mass_kg
    (kickers,) = [one for one in world._effects if type(one).__name__ == "Kickers"]

    def momentum() -> list[float]:
        return [
            sum(mass * world.data.qvel[dofs[axis]] for mass, dofs in zip(masses, at, strict=True)) for axis in (0, 1)
        ]

    before, resting = momentum(), world.data.qvel[at[1]].copy()
    world.set_tool(robot, "kicker", 0.8, OUT)
    kickers.before_substep(0)
    assert momentum() == pytest.approx(before, abs=1e-9)
    assert world.data.qvel[at[1][0]] - resting[0] > 0.5


@pytest.mark.parametrize(("gap_m", "aside_m", "hit"), [
    (0.005, 0.0, True), (0.008, 0.0, False), (0.001, 0.018, True), (0.001, -0.018, True), (0.001, 0.024, False),
])  # fmt: skip
def test_ball_is_hit_if_it_is_at_the_front(gap_m, aside_m, hit):
    stage = stage_with()
    at_the_ball(stage, gap_m, aside_m)
    assert (kick(stage) > 0.1) is hit


@pytest.mark.parametrize("shape", ["round", "flat_front"])
def test_front_is_that_of_the_body(shape):
    stage = stage_with(kits={"v2": {"chassis": {"shape": shape}}})
    front_m = stage.scenario.kits["v2"].chassis.front_m
    at_the_ball(stage, ahead_m=front_m)
    assert kick(stage) > 0.4


def test_kick_into_the_air_empties_it_and_charging_takes_its_time():
    stage = stage_with()
    stage.put("B1", 0, 0)
    kick(stage)
    rearm(stage, 0.5 - 0.4)
    at_the_ball(stage)
    assert kick(stage) == pytest.approx(0.46 * 0.6 / 2, abs=0.02)  # of the 2 s 0.4 + 0.1 + 0.1 have passed
    rearm(stage, 2.0)
    at_the_ball(stage)
    assert kick(stage) == pytest.approx(0.46, abs=0.01)


def test_plunger_that_stays_out_does_not_shoot_again():
    stage = stage_with()
    at_the_ball(stage)
    kick(stage)
    stage.play(2)
    at_the_ball(stage)
    assert kick(stage) < 0.01


@pytest.mark.parametrize("how", ["held", "parked"])
def test_held_robot_does_not_shoot_and_keeps_its_charge(how):
    stage = stage_with()
    at_the_ball(stage)
    (stage.hold if how == "held" else stage.park)("B1")
    assert kick(stage) < 0.01
    stage.hold()
    at_the_ball(stage)
    rearm(stage, TICK_S)
    assert kick(stage) == pytest.approx(0.46, abs=0.01)


def test_new_half_begins_charged():
    stage = stage_with()
    stage.put("B1", 0, 0)
    kick(stage)
    stage.world.reset()
    at_the_ball(stage)
    assert kick(stage) == pytest.approx(0.46, abs=0.01)


def test_kick_out_of_the_own_goal_does_not_come_back_into_it():
    """As the rule book tests kickers, on a carpet that slows balls; here nothing slows them unless a scenario says so."""
    stage = stage_with(field={"goals": {"yellow_goal": {"width_m": 0.2}}}, balls={"ball": {"slows_mps2": 0.05}})
    stage.put("B1", 0.0, 0.65, -math.pi / 2 + 0.12)
    c, s = math.cos(-math.pi / 2 + 0.12), math.sin(-math.pi / 2 + 0.12)
    stage.put("ball", c * 0.0595, 0.65 + s * 0.0595)
    kick(stage)
    path_m = [snapshot.substeps[-1][stage.index("ball")][1] for snapshot in stage.play(20)]
    assert min(path_m) == pytest.approx(-0.75 + BALL_R, abs=0.005)
    assert path_m[-1] == path_m[-30] < 0.0


def test_robot_recoils_by_millimetres():
    stage = stage_with(1.5)
    at_the_ball(stage)
    kick(stage, 1.5)
    assert stage.pose("B1")[0] == pytest.approx(-0.0032, abs=0.001)
