"""A match whose halves have lengths of their own: clock, score, result, and what is judged again from the record."""

from rcj_challenges.match.runner import MatchPlan, play_match
from rcj_challenges.records.trajectory import Trajectory
from rcj_challenges.scenario.load import load_text
from rcj_challenges.views.live.telling import live_facts
from tests.judging_again import judged_again, reflog_of
from tests.match.playing import Run

# Nobody plays: the halves are short, and no program is started.
LONG_AND_SHORT = """
schema_version: 1
id: long_and_short
title: A long half and a short one
extends: soccersim_v2
match: {halves: 3, half_s: [1, 0.5, 0.32]}
robots: {B1: null, B2: null, B3: null, Y1: null, Y2: null, Y3: null}
entrants: {blue: null, yellow: null}
result: {rank: [{time: ascending}]}
rules:
  begun:
    triggers: [{trigger: half_started}]
    actions: [{action: emit, event: BEGUN, payload: {half: {word: halftime}, lasts_s: {word: total_match_time_s}, left_s: {word: time_left_s}}}]
"""


def test_each_half_lasts_as_long_as_it_says(tmp_path):
    loaded = load_text(LONG_AND_SHORT)
    outcome = play_match(MatchPlan(loaded, {}, {}, seed=1, out=tmp_path))
    run = Run(outcome.folder, outcome.result)
    assert [half["ticks"] for half in outcome.result["halves"]] == [32, 16, 10]
    assert outcome.result["simulated_s"] == 58 * 0.032
    assert [line["payload"] for line in run.events("BEGUN")] == [
        {"half": 1, "lasts_s": 1, "left_s": 1.024},
        {"half": 2, "lasts_s": 0.5, "left_s": 0.512},
        {"half": 3, "lasts_s": 0.32, "left_s": 0.32},
    ]
    assert [half.info.ticks for half in Trajectory.open(outcome.folder).halves] == [32, 16, 10]
    assert judged_again(run.folder) == reflog_of(run.folder)


def test_the_live_page_knows_how_long_those_to_come_are():
    facts = live_facts(load_text(LONG_AND_SHORT).scenario, {}, 1)
    assert (facts["halves_planned"], facts["half_ticks_planned"]) == (3, [32, 16, 10])
