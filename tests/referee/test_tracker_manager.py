"""Looking closely only where something can change must not change what is judged."""

import random

import pytest

from rcj_challenges.expect.scripted_match import ScriptedMatch, half_of
from rcj_challenges.geometry.regions import NOWHERE
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.tracking import trackers

EVERYTHING = """
match: {half_s: 600}
zones:
  tilted: {shape: half_plane, through_m: [0.1, 0.1], normal: [1, 2]}
  kite: {shape: polygon, points_m: [[0, 0.3], [0.2, 0], [0, -0.5], [-0.2, 0]]}
  ring: {shape: circle, centre_m: [0.1, -0.2], radius_m: 0.3, inverted: true}
gates: {mouth: {from_m: [0.06, -0.1], to_m: [0.06, 0.1], anchor: B1}}
groups: {some: [kite, middle, left]}
sequences:
  way: {entity: ball, steps: [left, {any_of: [middle, halfway]}, right], cyclic: true, wrong_step: break}
  own: {per: robots, steps: [left, {any_of: [middle, halfway]}, right], cyclic: true, when_placed: goes_on}
phases: {pause: {lasts_s: 0.5, clock: stops}}
rules:
  zones:
    for_each: robots
    triggers:
      - {trigger: enters, entity: each, zone: some}
      - {trigger: leaves, entity: each, zone: tilted}
      - {trigger: leaves, entity: each, zone: ring}
      - {trigger: stays_in, entity: each, zone: kite, limit_s: 0.5, grace_s: 0.1}
      - {trigger: displaced, entity: each, distance_m: 0.15, axis: either}
      - {trigger: no_progress, entity: each, distance_m: 0.2, within_s: 1}
    actions: [{action: emit, event: ZONES, payload: {who: {word: entity_name}, measured: {word: measured}}}]
  way:
    triggers: [{trigger: sequence_completed, sequence: way}, {trigger: sequence_broken, sequence: way},
               {trigger: crosses, entity: ball, gate: [halfway, mouth]}]
    actions: [{action: emit, event: WAY}, {action: set_phase, phase: pause}]
  own:
    for_each: robots
    triggers: [{trigger: sequence_completed, sequence: own, entity: each}]
    actions: [{action: emit, event: OWN, payload: {who: {word: robot_name}, took: {word: measured}}}]
  away:
    for_each: robots
    phases: any
    triggers: [{trigger: no_progress, entity: each, distance_m: 0.1, within_s: 0.7}]
    actions: [{action: place, entity: each, at: {nearest_free: neutral_spots, choose_among: 3}}]
  aside:
    for_each: robots
    triggers: [{trigger: stays_in, entity: each, zone: tilted, limit_s: 2}]
    cooldown_s: 5
    actions: [{action: remove, entity: each, for_s: 1}]
"""


def wander(play: ScriptedMatch, seed: int, ticks: int) -> list[object]:
    """Let everything wander, with rests, and return all that the referee said."""
    rng = random.Random(seed)  # noqa: S311 - a reproducible walk
    for _ in range(ticks):
        for name in play.roster.entities:
            if rng.random() < 0.03:
                play.glide(name, (rng.uniform(-0.6, 0.6), rng.uniform(-0.7, 0.7)), rng.randrange(5, 80))
        play.play()
    return [*play.firings, *play.events, *play.placements]


@pytest.mark.parametrize("seed", range(2))
def test_it_judges_as_one_that_looks_at_everything_closely(small, monkeypatch, seed):
    scenario = small(EVERYTHING)
    said = wander(ScriptedMatch(scenario, Roster.of(scenario), half_of(scenario)), seed, 1200)
    monkeypatch.setattr(trackers, "common_cell", lambda _one, _other: NOWHERE)
    monkeypatch.setattr(trackers, "_stayed", lambda _cell, _entity, _substeps: False)
    assert wander(ScriptedMatch(scenario, Roster.of(scenario), half_of(scenario)), seed, 1200) == said
    rules = {firing.rule for firing in said if hasattr(firing, "rule")}
    assert rules >= {"zones", "way", "own", "away"}


def test_the_same_snapshots_give_the_same_verdicts(small):
    scenario = small(EVERYTHING)
    plays = [ScriptedMatch(scenario, Roster.of(scenario), half_of(scenario)) for _ in range(2)]
    assert wander(plays[0], 7, 600) == wander(plays[1], 7, 600)
