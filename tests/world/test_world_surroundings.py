"""Robots far from all walls and fixed obstacles are not looked at: that may never change what happens."""

from __future__ import annotations

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rcj_challenges.world import contact
from tests.world.physics_stage import FULL, Crowd, Stage

OBSTACLES = {
    "crate": {"shape": "box", "centre_m": [0.1, 0.3], "size_m": [0.2, 0.05], "height_m": 0.1, "yaw_rad": 0.5},
    "pole": {"shape": "cylinder", "centre_m": [-0.2, -0.2], "radius_m": 0.03, "height_m": 0.1},
    "fence": {"shape": "wall", "from_m": [0.2, -0.4], "to_m": [0.4, -0.2]},
}


class _LooksAtAll:
    def before_substep(self) -> None:
        """Leave it as it was compiled: everything meets everything."""


def played(stage: Stage, ticks: int) -> list[bytes]:
    stage.world.reset()
    crowd, states = Crowd(stage, seed=8, chasers=3), []
    for _ in range(ticks):
        crowd.command()
        stage.play()
        states.append(stage.world.state_bytes())
    return states


def collides_with_fixtures(stage: Stage, robot: str) -> bool:
    tables, model = stage.world.tables, stage.world.model
    index = stage.index(robot)
    bits = {int(model.geom_conaffinity[geom]) & contact.FIXED for geom in (tables.cubes[index], *tables.wheels[index])}
    assert len(bits) == 1
    return bits != {0}


def test_a_crowd_among_obstacles_plays_the_same_bits_as_if_all_were_looked_at():
    some, everything = Stage(obstacles=OBSTACLES), Stage(obstacles=OBSTACLES)
    everything.world._surroundings = _LooksAtAll()
    assert played(some, 500) == played(everything, 500)


def test_in_the_middle_of_an_empty_field_a_robot_meets_no_fixture_and_at_a_wall_it_does():
    stage = Stage()
    stage.put("B1", 0.0, 0.0)
    stage.put("B2", 0.4, -0.7)
    stage.play()
    assert not collides_with_fixtures(stage, "B1")
    assert collides_with_fixtures(stage, "B2")
    stage.put("B1", 0.58, 0.2)
    stage.play()
    assert collides_with_fixtures(stage, "B1")
    stage.put("B1", 3.0, 0.2)
    stage.play()
    assert not collides_with_fixtures(stage, "B1")


def rammed(surroundings: object | None, speed: float) -> list[bytes]:
    """Return what happens when a robot rams another, a little before a wall; the seam of the far and the near."""
    stage = Stage()
    if surroundings is not None:
        stage.world._surroundings = surroundings
    states = []
    for room in range(12):
        stage.put("B1", 0.65 - 0.25 - 0.01 * room, 0.1)
        stage.put("B2", 0.65 - 0.12 - 0.01 * room, 0.1)
        stage.world.data.qvel[stage.world.tables.dofs[stage.index("B1")][0]] = speed
        for _ in range(4):
            stage.play()
            states.append(stage.world.state_bytes())
    return states


@pytest.mark.parametrize("speed", [0.2, 4.0, 12.0])
def test_a_robot_that_is_struck_within_a_tick_meets_the_wall_behind_it_all_the_same(speed):
    assert rammed(None, speed) == rammed(_LooksAtAll(), speed)


def test_robots_in_each_other_on_ice_fly_apart_and_meet_the_walls():
    def flown(surroundings: object | None) -> list[bytes]:
        stage = Stage(field={"friction": 0.02})
        if surroundings is not None:
            stage.world._surroundings = surroundings
        for index, name in enumerate(("B1", "B2", "B3", "Y1", "Y2", "Y3")):
            stage.put(name, 0.5 + 0.01 * index, 0.01 * (index % 3), 0.3 * index)
        states = []
        for _ in range(60):
            stage.play()
            states.append(stage.world.state_bytes())
        return states

    assert flown(None) == flown(_LooksAtAll())


@settings(max_examples=40, deadline=None)
@given(st.floats(-0.5, 0.5), st.floats(-0.65, 0.65), st.floats(-math.pi, math.pi))
def test_whoever_can_touch_a_fixture_within_a_tick_is_looked_at(x, y, yaw):
    stage = Stage(obstacles=OBSTACLES)
    stage.put("B1", x, y, yaw)
    stage.drive("B1", FULL, FULL)
    (snapshot,) = stage.play()
    touched = {thing for pairs in snapshot.touches for pair in pairs for thing in pair} - {stage.index("B1")}
    assert not touched or collides_with_fixtures(stage, "B1")
    everything = Stage(obstacles=OBSTACLES)
    everything.world._surroundings = _LooksAtAll()
    everything.put("B1", x, y, yaw)
    everything.drive("B1", FULL, FULL)
    assert everything.play() == [snapshot]
    assert everything.world.state_bytes() == stage.world.state_bytes()


@settings(max_examples=40, deadline=None)
@given(st.floats(-1.0, 1.0), st.floats(-1.1, 1.1), st.floats(-math.pi, math.pi), st.floats(0.001, 0.02))
def test_where_a_robot_came_from_does_not_decide_whether_it_is_looked_at(x, y, way, step_m):
    """It walks over the field and beyond; another one comes from afar to each of the same places."""
    walks, appears = Stage(obstacles=OBSTACLES), Stage(obstacles=OBSTACLES)
    for _ in range(200):
        walks.put("B1", x, y)
        walks.world._surroundings.before_substep()
        for place in (3.0, 3.0), (x, y):
            appears.put("B1", *place)
            appears.world._surroundings.before_substep()
        assert collides_with_fixtures(walks, "B1") is collides_with_fixtures(appears, "B1"), (x, y)
        x, y = x + step_m * math.cos(way), y + step_m * math.sin(way)
