"""A rule that ends the match when a half is over: no half follows, and the record says why."""

import pytest

from rcj_challenges.match.runner import MatchPlan, play_match
from rcj_challenges.scenario.load import load_text
from tests.judging_again import judged_again, reflog_of
from tests.match.playing import Run

# Nobody plays: the halves are short, and no program is started.
TWO_HALVES = """
schema_version: 1
id: two_halves
title: Two halves
extends: soccersim_v2
match: {halves: 2, half_s: 0.32}
robots: {B1: null, B2: null, B3: null, Y1: null, Y2: null, Y3: null}
entrants: {blue: null, yellow: null}
rules:
  told:
    phases: any
    triggers: [{trigger: half_ended}]
    actions: [{action: emit, event: OVER, payload: {half: {word: halftime}}}]
"""
EARLY = "  early: {triggers: [{trigger: time_reached, at_s: 0.16}], actions: [{action: end, reason: early}]}\n"


def at_the_end(action):
    return f"  over: {{phases: any, triggers: [{{trigger: half_ended}}], actions: [{action}]}}\n"


MATCH_OVER = at_the_end("{action: end, what: match, reason: decided}")


@pytest.fixture
def played(tmp_path):
    def play(*rules):
        outcome = play_match(MatchPlan(load_text(TWO_HALVES + "".join(rules)), {}, {}, out=tmp_path))
        return Run(outcome.folder, outcome.result)

    return play


def ends(run):
    return [(half["half"], half["ticks"], half["ended"]) for half in run.result["halves"]]


def test_a_rule_can_end_the_match_when_a_half_is_over(played):
    run = played(MATCH_OVER)
    assert ends(run) == [(1, 10, "decided")]
    assert (run.result["complete"], len(run.trajectory.halves)) == (True, 1)


def test_it_can_too_when_another_rule_ended_the_half_early(played):
    assert ends(played(EARLY, MATCH_OVER)) == [(1, 5, "decided")]


def test_to_end_the_half_when_it_is_over_changes_nothing(played):
    assert ends(played(at_the_end("{action: end, reason: late}"))) == [(1, 10, None), (2, 10, None)]
    assert ends(played(EARLY, at_the_end("{action: end, reason: late}"))) == [(1, 5, "early"), (2, 5, "early")]


def test_the_referee_judges_the_trajectory_alone_as_it_judged_the_match(played):
    run = played(EARLY, MATCH_OVER)
    assert [line["payload"] for line in run.events("OVER")] == [{"half": 1}]
    assert judged_again(run.folder) == reflog_of(run.folder)
