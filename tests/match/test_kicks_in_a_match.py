"""Kicked balls in a real match: they roll, the record keeps how, and the referee judges the record alone alike."""

import pytest

from tests.judging_again import judged_again, reflog_of

SHOTS = """schema_version: 2
id: shots
title: Shots
extends: match
match: {halves: 1, half_s: 4, swap_sides: false}
placements:
  shot:
    - entity: ball
      at: {on_line: [[-0.2, 0], [0.2, 0]]}
      kick: {towards: {on_line: [[-0.1, 0.75], [0.1, 0.75]]}, speed_mps: [0.9, 1.2]}
rules:
  shoot:
    phases: any
    triggers: [{trigger: time_reached, at_s: 0.5}, {trigger: time_reached, at_s: 2.5}]
    actions: [{action: remove, entity: robots}, {action: place, layout: shot}]
expect: {inherited: null}
"""


@pytest.fixture(scope="module")
def run(shared_place):
    return shared_place.play(scenario=SHOTS)


def kicks(run):
    """Return the placements with a velocity, each with its tick."""
    placed = run.trajectory.halves[0].placements
    return [(tick, one) for tick, ones in placed.items() for one in ones if one.vx_mps or one.vy_mps]


def test_a_kicked_ball_leaves_its_place_as_fast_as_it_was_kicked(run):
    ball = run.trajectory.entities.index("ball")
    assert len(kicks(run)) == 2
    for tick, kick in kicks(run):
        x, y, _ = run.trajectory.halves[0].substeps[tick + 4, -1, ball].tolist()
        assert x == pytest.approx(kick.x_m + 5 * 0.032 * kick.vx_mps, abs=0.003)
        assert y == pytest.approx(kick.y_m + 5 * 0.032 * kick.vy_mps, abs=0.003)
    assert len(run.events("GOAL")) >= 1


def test_the_same_seed_gives_the_same_digest_another_one_other_kicks(shared_place, run):
    assert shared_place.play(scenario=SHOTS).result["digest"] == run.result["digest"]
    assert [kick for _, kick in kicks(shared_place.play(scenario=SHOTS, seed=2))] != [kick for _, kick in kicks(run)]


def test_the_referee_judges_the_trajectory_alone_as_it_judged_the_match(run):
    assert judged_again(run.folder) == reflog_of(run.folder)
