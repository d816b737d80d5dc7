"""Kicked balls in a real match: they roll, the record keeps how, and the referee judges the record alone alike."""

import json

import pytest

from rcj_challenges.referee.engine import Referee
from rcj_challenges.scenario.load import load_resolved
from tests.judging_again import judged_again, reflog_of
from tests.match.playing import Place

SHOTS = """schema_version: 1
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
def shots(tmp_path_factory):
    """Return what plays the shots with a seed."""
    place = Place(tmp_path_factory.mktemp("shots"))
    scenario = place.folder / "shots.yaml"
    scenario.write_text(SHOTS, encoding="utf-8")
    return lambda seed=1: place.play(scenario=str(scenario), seed=seed)


@pytest.fixture(scope="module")
def run(shots):
    return shots()


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


def test_the_same_seed_gives_the_same_digest_another_one_other_kicks(shots, run):
    assert shots().result["digest"] == run.result["digest"]
    assert [kick for _, kick in kicks(shots(2))] != [kick for _, kick in kicks(run)]


def test_the_referee_judges_the_trajectory_alone_as_it_judged_the_match(run):
    assert judged_again(run.folder) == reflog_of(run.folder)


def test_it_asks_for_the_same_kicks_again(run):
    loaded = load_resolved(json.loads((run.folder / "scenario.json").read_text("utf-8")))
    half = run.trajectory.halves[0]
    referee = Referee(loaded.scenario, loaded.roster, half.info)
    referee.start(half.start)
    again = {snapshot.tick: referee.judge(snapshot).placements for snapshot in half.snapshots()}
    assert [(tick, one) for tick, ones in again.items() for one in ones if one.vx_mps or one.vy_mps] == kicks(run)
