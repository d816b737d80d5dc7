"""A counter with ``keep: match`` goes on in the next half, and the result counts once what it had already."""

import pytest

from rcj_challenges.match.runner import MatchPlan, play_match
from rcj_challenges.scenario.load import load_text
from tests.judging_again import judged_again, reflog_of
from tests.match.playing import Run

# Nobody plays: the halves are short, and no program is started.
THREE_HALVES = """
schema_version: 1
id: three_halves
title: Three halves
extends: soccersim_v2
match: {{halves: 3, half_s: 0.32}}
robots: {{B1: null, B2: null, B3: null, Y1: null, Y2: null, Y3: null}}
entrants: {{blue: null, yellow: null}}
counters: {{laps: {{initial: 1{keep}}}}}
rules:
  lap: {{triggers: [{{trigger: time_reached, at_s: 0.064}}], actions: [{{action: count, counter: laps, by: 2}}]}}
  told: {{triggers: [{{trigger: half_ended}}], actions: [{{action: emit, event: LAPS, payload: {{laps: {{counter: laps}}}}}}]}}
"""


@pytest.mark.parametrize(("keep", "laps"), [(", keep: match", [3, 5, 7]), (", keep: half", [3, 3, 3]), ("", [3, 3, 3])])
def test_a_kept_counter_goes_on_and_another_begins_anew(tmp_path, keep, laps):
    outcome = play_match(MatchPlan(load_text(THREE_HALVES.format(keep=keep)), {}, {}, seed=1, out=tmp_path))
    run = Run(outcome.folder, outcome.result)
    assert [line["payload"]["laps"] for line in run.events("LAPS")] == laps
    assert judged_again(run.folder) == reflog_of(run.folder)
