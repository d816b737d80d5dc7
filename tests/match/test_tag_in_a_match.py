"""Tag between programs: the record names both, and the referee judges the record alone alike."""

import pytest

from rcj_challenges.records.referee_log import read_referee_log
from tests.judging_again import judged_again, reflog_of
from tests.match.programs import AHEAD, STAND

TAG = """schema_version: 2
id: tag
title: Tag
extends: soccersim_v2
match: {halves: 1, half_s: 4}
balls: {ball: null}
robots:
  Y1: {start: {x_m: -0.04, y_m: -0.4, yaw_rad: 1.5708, noise_m: [0, 0]}}
  Y2: {start: {x_m: 0.45, y_m: 0.1, yaw_rad: 1.5708, noise_m: [0, 0]}}
  Y3: {start: {x_m: 0.45, y_m: -0.6, yaw_rad: 1.5708, noise_m: [0, 0]}}
  B1: {start: {x_m: 0, y_m: 0, yaw_rad: -1.5708, noise_m: [0, 0]}}
  B2: null
  B3: null
entrants: {blue: {robots: {B2: null, B3: null}}}
rules:
  caught:
    for_each: robots
    triggers: [{trigger: touches, entity: each, other: [robots, walls]}]
    conditions: [{entity: each, looks: [0, 2], within_rad: 1}]
    actions: [{action: emit, event: CAUGHT, payload: {who: {word: robot_name}, other: {word: other_name}}}]
    says: '{entity} has come to {other}.'
  home:
    for_each: yellow
    triggers: [{trigger: touches, entity: each, other: blue}]
    actions: [{action: place, entity: other, at: {relative_to: each, offset_m: [0, 0.5]}}]
    says: '{other} is put elsewhere.'
"""


@pytest.fixture(scope="module")
def run(shared_place):
    yellow = shared_place.team_folder(AHEAD, STAND, AHEAD)
    return shared_place.play(scenario=TAG, yellow=yellow, blue=shared_place.team_folder(STAND))


def test_the_log_names_both_that_touched(run):
    firings = [firing for one in read_referee_log(run.folder).ticks for firing in one.firings]
    reported = [(firing.entity, firing.other, firing.says) for firing in firings if firing.rule == "caught"]
    assert {("Y1", "B1", "Y1 has come to B1."), ("Y3", "Y2", "Y3 has come to Y2.")} <= set(reported)
    payloads = [event["payload"] for event in run.events("CAUGHT")]
    assert [(payload["who"], payload["other"]) for payload in payloads] == [(who, other) for who, other, _ in reported]


def test_the_one_that_is_touched_is_put_elsewhere(run):
    entities = run.trajectory.entities
    placed = run.trajectory.halves[0].placements
    assert {entities[one.entity] for tick, ones in placed.items() if tick for one in ones} == {"B1"}


def test_the_referee_judges_the_trajectory_alone_as_it_judged_the_match(run):
    assert len(run.events("CAUGHT")) >= 2
    assert judged_again(run.folder) == reflog_of(run.folder)
