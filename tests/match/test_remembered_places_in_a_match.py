"""A remembered place and a way in a real match: how far a ball came; the referee judges the record alone alike."""

import numpy as np
import pytest

from tests.judging_again import judged_again, reflog_of

SHOT = """schema_version: 2
id: shot
title: Shot
extends: match
match: {halves: 2, half_s: 2}
spots: {kicked_from: {x_m: 0.1, y_m: 0.1}}
rules:
  before:
    phases: any
    triggers: [{trigger: time_reached, at_s: 0.1}]
    actions: [{action: emit, event: BEFORE, payload: {far: {distance: [centre, kicked_from]}}}]
  shoot:
    phases: any
    triggers: [{trigger: time_reached, at_s: 0.3}]
    actions:
      - {action: remove, entity: robots}
      - {action: place, entity: ball, at: {point: [0.2, -0.4]}, kick: {towards: {point: [0.2, 0.4]}, speed_mps: 0.5}}
  remember:
    phases: any
    triggers: [{trigger: time_reached, at_s: 0.5}]
    actions: [{action: set_spot, spot: kicked_from, to: ball}]
  told:
    phases: any
    triggers: [{trigger: time_reached, at_s: 1.5}]
    actions:
      - {action: emit, event: FAR, payload: {far: {distance: [ball, kicked_from]}, way: {way: ball}, robot: {way: Y1}}}
      - {action: place, entity: ball, at: {spot: kicked_from}}
expect: {inherited: null}
"""


@pytest.fixture(scope="module")
def run(shared_place):
    # The halves of the file, not the one half of a short match.
    return shared_place.play("match.halves=2", scenario=SHOT)


def test_the_distance_of_the_ball_is_reported_and_the_ball_is_brought_back(run):
    ball = run.trajectory.entities.index("ball")
    for line, half in zip(run.events("FAR"), run.trajectory.halves, strict=True):
        assert line["payload"]["far"] == pytest.approx(0.5, abs=0.02)
        there = half.substeps[15, -1, ball, :2].tolist()
        assert half.substeps[48, -1, ball, :2].tolist() == pytest.approx(there, abs=0.001)


def test_the_way_of_the_ball_excludes_the_jump_to_where_it_was_kicked(run):
    ball = run.trajectory.entities.index("ball")
    for line, half in zip(run.events("FAR"), run.trajectory.halves, strict=True):
        told_at = 47  # 1.5 s
        before, kicked = (half.substeps[ticks, -1, ball, :2] for ticks in (slice(0, 10), slice(10, told_at)))
        pieces = [np.hypot(*np.diff(places, axis=0).T).sum() for places in (before, kicked)]
        first = np.hypot(*(kicked[0] - (0.2, -0.4)))
        assert line["payload"]["way"] == pytest.approx(sum(pieces) + first, abs=0.0011)
        assert line["payload"]["robot"] == 0


def test_each_half_begins_with_the_place_of_the_file(run):
    assert [line["payload"]["far"] for line in run.events("BEFORE")] == [0.141, 0.141]


def test_the_referee_judges_the_trajectory_alone_as_it_judged_the_match(run):
    assert judged_again(run.folder) == reflog_of(run.folder)
