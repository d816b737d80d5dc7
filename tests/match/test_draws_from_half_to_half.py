"""What a draw without repetition has drawn is known in the next half, and to who judges the record."""

import pytest

from rcj_challenges.match.runner import MatchPlan, play_match
from rcj_challenges.scenario.load import load_text
from tests.judging_again import judged_again, reflog_of
from tests.match.playing import Run

# Nobody plays: the halves are short, and no program is started.
SIX_HALVES = """
schema_version: 1
id: six_halves
title: Six halves
extends: soccersim_v2
match: {halves: 6, half_s: 0.032}
robots: {B1: null, B2: null, B3: null, Y1: null, Y2: null, Y3: null}
entrants: {blue: null, yellow: null}
draws: {side: {values: [west, middle, east], not_again: match}}
rules:
  told: {triggers: [{trigger: half_started}], actions: [{action: emit, event: SIDE, payload: {side: {draw: side}}}]}
"""


@pytest.mark.parametrize("seed", [1, 2])
def test_three_halves_draw_three_sides_and_the_next_three_again(tmp_path, seed):
    outcome = play_match(MatchPlan(load_text(SIX_HALVES), {}, {}, seed=seed, out=tmp_path))
    run = Run(outcome.folder, outcome.result)
    sides = [line["payload"]["side"] for line in run.events("SIDE")]
    assert sorted(sides[:3]) == sorted(sides[3:]) == ["east", "middle", "west"]
    assert judged_again(run.folder) == reflog_of(run.folder)
