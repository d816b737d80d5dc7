"""Start poses are computed in one place, and all callers get the same ones."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

from rcj_challenges.expect.scripted_match import ScriptedMatch
from rcj_challenges.referee.bodies import Bodies
from rcj_challenges.scenario.shapes import start_noise_m, start_pose
from rcj_challenges.world.world import World
from tests.scenario.writing import loaded

BODY = """
robots: {Y1: {start: {x_m: -0.4, y_m: -0.5, yaw_rad: 1.2, noise_m: [0.1, 0]}}}
balls: {ball: {start_m: [0.1, -0.05]}}
obstacles:
  crate: {shape: box, size_m: [0.2, 0.05], centre_m: [0, 0.5], yaw_rad: 0.7, movable: true}
  post: {shape: cylinder, radius_m: 0.02, centre_m: [0.5, 0.1], movable: true}
  bar: {shape: box, size_m: [0.2, 0.02], centre_m: [-0.4, 0.1], yaw_rad: 0.5}
  wall: {shape: wall, from_m: [0.3, -0.05], to_m: [0.3, 0.05]}
"""
POSES = {
    "Y1": (-0.4, -0.5, 1.2),
    "ball": (0.1, -0.05, 0.0),
    "crate": (0.0, 0.5, 0.7),
    "post": (0.5, 0.1, 0.0),
    "bar": (-0.4, 0.1, 0.5),
    "wall": (0.3, 0.0, pi / 2),
}


@pytest.fixture(scope="module")
def found():
    return loaded(BODY)


@pytest.mark.parametrize("name", POSES)
def test_everything_has_a_start_pose(found, name):
    assert start_pose(found.scenario, name) == POSES[name]


def test_world_and_script_start_the_same(found):
    wanted = np.array([start_pose(found.scenario, name) for name in found.roster.entities], "<f4")
    world = World(found.scenario, found.roster)
    assert np.allclose(world.judged().substeps[-1], wanted, atol=1e-6)
    play = ScriptedMatch(found.scenario, found.roster)
    unmoved = [name for name in found.roster.entities if start_noise_m(found.scenario, name) == (0.0, 0.0)]
    assert [play.pose(name) for name in unmoved] == [
        tuple(map(float, wanted[found.roster.index[name]])) for name in unmoved
    ]


def test_a_turned_box_is_in_the_way_where_it_is_drawn(found):
    bodies = Bodies(found.scenario, found.roster)
    ball = found.roster.index["ball"]
    along = (-0.4 + 0.08 * np.cos(0.5), 0.1 + 0.08 * np.sin(0.5), 0.0)
    assert not bodies.fits(ball, along, {}, 0.0)
    assert bodies.fits(ball, (-0.32, 0.08, 0.0), {}, 0.0)  # where it would lie if it were not turned
