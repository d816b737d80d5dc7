"""What is done of a tick before the robots are commanded for it may never change what happens."""

from __future__ import annotations

import math
from functools import cache

import mujoco
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rcj_challenges.facts.play import Placement, Snapshot
from rcj_challenges.world.errors import PhysicsFault
from tests.world.physics_stage import Crowd, Stage

GROUNDS = {
    "the match": {},
    "ice": {"field": {"friction": 0.0}},
    "slippery ground": {"field": {"friction": 0.2}},
    "fast robots": {"kits": {"v2": {"chassis": {"max_wheel_radps": 40.0}}}},
    "things that are pushed, and a pole": {
        "obstacles": {
            "crate": {"shape": "box", "centre_m": [0.1, 0.1], "size_m": [0.2, 0.05], "height_m": 0.1, "movable": True,
                      "mass_kg": 0.2},
            "pole": {"shape": "cylinder", "centre_m": [-0.2, -0.2], "radius_m": 0.03, "height_m": 0.1},
        }
    },
}  # fmt: skip


@cache
def twins(ground: str) -> tuple[Stage, Stage]:
    """Two equal worlds: one will prepare its ticks."""
    return Stage(**GROUNDS[ground]), Stage(**GROUNDS[ground])


def reset(*stages: Stage) -> None:
    for stage in stages:
        stage.world.reset()
        stage.tick, stage.snapshot = 0, None


def played(stage: Stage) -> tuple[Snapshot, bytes]:
    (snapshot,) = stage.play()
    return snapshot, stage.world.state_bytes()


@pytest.mark.parametrize("ground", GROUNDS)
def test_a_crowd_plays_the_same_bits(ground):
    plain, prepared = twins(ground)
    reset(plain, prepared)
    crowds = [Crowd(stage, seed=3, chasers=4) for stage in (plain, prepared)]
    for _ in range(300):
        prepared.world.prepare()
        for crowd in crowds:
            crowd.command()
        assert played(prepared) == played(plain)


def test_a_crowd_plays_the_same_bits_where_it_is_not_split_into_islands():
    stages = plain, prepared = Stage(), Stage()
    for stage in stages:
        stage.world.model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_ISLAND
    crowds = [Crowd(stage, seed=5, chasers=4) for stage in stages]
    for _ in range(60):
        prepared.world.prepare()
        for crowd in crowds:
            crowd.command()
        assert played(prepared) == played(plain)
    assert not plain.world.data.nisland


SPEEDS = st.sampled_from([-10.0, -0.01, 0.0, 3.0, 10.0])
COMMANDS = st.lists(
    st.tuples(
        st.sampled_from([f"{colour}{number}" for colour in "BY" for number in (1, 2, 3)]),
        st.sampled_from(["left", "right"]),
        SPEEDS,
        st.sampled_from([math.inf, math.inf, math.inf, 0.0, 1.0, -30.0]),
    ),
    max_size=8,
)


HOLDS_BEFORE, HOLDS_AFTER = {0: ("B1", "Y2"), 1: ()}, {2: ("B1", "B3"), 3: ()}
PUTS, UNPREPARED = 4, 5
"""What else happens in a tick, by a number; most have none of that."""


@settings(max_examples=60, deadline=None)
@given(ground=st.sampled_from(sorted(GROUNDS)), ticks=st.lists(st.tuples(COMMANDS, st.integers(0, 9)), max_size=25))
def test_whatever_is_commanded_braked_and_placed_the_same_bits_are_played(ground, ticks):
    plain, prepared = twins(ground)
    reset(plain, prepared)
    for commands, what in ticks:
        for stage in (plain, prepared):
            if what in HOLDS_BEFORE:
                stage.hold(*HOLDS_BEFORE[what])
            elif what == PUTS:
                stage.put("B2", 0.1, 0.02)
        if what != UNPREPARED:
            prepared.world.prepare()
        for stage in (plain, prepared):
            for robot, side, velocity_radps, position_rad in commands:
                stage.world.set_wheel(stage.index(robot), side, velocity_radps, position_rad)
            if what in HOLDS_AFTER:
                stage.hold(*HOLDS_AFTER[what])
        assert played(prepared) == played(plain)


@pytest.fixture
def whole(monkeypatch) -> list[None]:
    """One for each sub-step that is made as a whole."""
    made: list[None] = []
    monkeypatch.setattr(mujoco, "mj_step", lambda *of, step=mujoco.mj_step: made.append(step(*of)))
    return made


def test_less_is_left_to_do_than_a_whole_sub_step(whole):
    _, prepared = twins("the match")
    reset(prepared)
    for speed in (10.0, -10.0, 5.0, 0.0, 1.0):
        prepared.world.prepare()
        prepared.drive("B1", speed, 5.0)
        prepared.play()
    assert len(whole) == 5 * 3


def test_where_a_wheel_goes_to_an_angle_after_all_the_sub_step_is_made_as_a_whole(whole):
    """It may be set on its angle at the beginning of the sub-step, and then it stands otherwise than it was prepared."""
    _, prepared = twins("the match")
    reset(prepared)
    prepared.world.prepare()
    prepared.world.set_wheel(0, "left", 10.0, 1.0)
    prepared.play()
    assert len(whole) == 4


def test_to_prepare_twice_is_to_prepare_once():
    plain, prepared = twins("the match")
    reset(plain, prepared)
    for speed in (10.0, -10.0, 0.0):
        prepared.world.prepare()
        for stage in (plain, prepared):
            stage.drive("Y1", speed, speed)
        prepared.world.prepare()
        assert played(prepared) == played(plain)


def test_nothing_is_placed_into_a_tick_that_is_prepared():
    _, prepared = twins("the match")
    reset(prepared)
    prepared.world.prepare()
    prepared.world.place([])
    with pytest.raises(RuntimeError, match="between"):
        prepared.world.place([Placement(0, 0.0, 0.0, 0.0)])
    prepared.play()
    prepared.put("B1", 0.3, 0.0)
    assert prepared.pose("B1")[0] == pytest.approx(0.3)


def test_a_world_that_is_reset_forgets_what_was_prepared():
    plain, prepared = twins("the match")
    reset(plain, prepared)
    for _ in range(5):
        prepared.drive("B1", 10.0, -10.0)
        prepared.play()
    prepared.world.prepare()
    reset(prepared)
    for stage in (plain, prepared):
        stage.drive("B1", 10.0, 9.0)
    assert played(prepared) == played(plain)


@pytest.mark.parametrize("number", [math.nan, 1e12])
def test_what_becomes_unstable_is_told_all_the_same(number):
    _, prepared = twins("the match")
    reset(prepared)
    prepared.world.data.qvel[0] = number
    prepared.world.prepare()
    with pytest.raises(PhysicsFault, match="unstable"):
        prepared.play()
    reset(prepared)
    prepared.play()
