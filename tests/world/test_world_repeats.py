"""Same inputs, same bits; nothing escapes a crowd; a failure of the physics is reported."""

import math

import pytest

from rcj_challenges.core.errors import RcjError
from rcj_challenges.devices.base import FixedRay
from rcj_challenges.world.errors import PhysicsFault
from rcj_challenges.world.world import World
from tests.world.physics_stage import Crowd, Stage


def crowded(stage: Stage, ticks: int) -> list[bytes]:
    """Play with everybody on the field; returns the state after each tick."""
    stage.tick, stage.snapshot = 0, None
    stage.world.reset()
    crowd = Crowd(stage, seed=5, chasers=4)
    states = []
    for _ in range(ticks):
        crowd.command()
        stage.play()
        states.append(stage.world.state_bytes())
    return states


def test_two_worlds_play_the_same_bits():
    assert crowded(Stage(), 400) == crowded(Stage(), 400)


def test_a_reset_world_plays_the_same_bits_again():
    stage = Stage()
    first = crowded(stage, 300)
    stage.park("B2")
    stage.drive("Y1", 3.0, 3.0)
    stage.play(1)
    assert crowded(stage, 300) == first


def test_rays_fixed_to_a_robot_change_nothing():
    plain, extended = Stage(), Stage()
    extended.world = World(extended.scenario, extended.roster, [FixedRay("B1", "eye", 0.0, 0.03, 0.02)])
    assert extended.world.model.nsite == 1
    assert crowded(extended, 100) == crowded(plain, 100)


def test_the_state_is_all_positions_and_velocities():
    stage = Stage()
    model = stage.world.model
    assert len(stage.world.state_bytes()) == 8 * (model.nq + model.nv)


# --- crowding ---------------------------------------------------------------------------------------------------------


def soak(seconds: float, seed: int, chasers: int) -> None:
    """Play a crowd; the ball is put back to the centre every 20 s, for there is no referee."""
    stage = Stage()
    stage.world.reset()
    crowd = Crowd(stage, seed, chasers)
    highest = 0.0
    while stage.tick * 0.032 < seconds:
        crowd.command()
        if stage.tick % 625 == 0:
            stage.put("ball", 0.0, 0.0)
        (snapshot,) = stage.play()
        highest = max(highest, snapshot.heights[6])
        for name, (x, y, _) in zip(stage.roster.entities, snapshot.substeps[-1], strict=True):
            within_goal = abs(x) < 0.2 and abs(y) < 0.85
            assert (abs(x) < 0.655 and abs(y) < 0.755) or within_goal, f"{name} left at {stage.tick}: {x}, {y}"
    for upright, height in zip(snapshot.uprights[:6], snapshot.heights[:6], strict=True):
        assert upright == 1.0
        assert height == pytest.approx(0.0375)
    assert highest < 0.09


def test_nothing_leaves_the_field_in_half_a_minute_of_crowding():
    soak(30, seed=1, chasers=6)


@pytest.mark.nightly
@pytest.mark.parametrize("chasers", [6, 4, 0])
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_nothing_leaves_the_field_and_all_robots_stand_after_600_s_of_crowding(chasers, seed):
    soak(600, seed, chasers)


# --- failure ----------------------------------------------------------------------------------------------------------


def test_physics_that_become_unstable_end_in_a_clear_message(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    stage = Stage()
    stage.world.data.qpos[stage.world.tables.qpos_at[6]] = math.nan
    with pytest.raises(PhysicsFault, match=r"unstable in tick 7 .*ball") as raised:
        stage.world.step(7)
    assert isinstance(raised.value, RcjError)
    assert raised.value.exit_code == 3
    assert not list(tmp_path.iterdir()), "MuJoCo left a log file in the current folder"


def test_a_huge_velocity_is_a_fault_as_well():
    stage = Stage()
    stage.world.data.qvel[0] = 1e12
    with pytest.raises(PhysicsFault, match="unstable"):
        stage.world.step(1)
