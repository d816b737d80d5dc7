"""Matches of several short halves: their lengths, what passes from one to the next, and their end."""

import pytest

from rcj_challenges.match.runner import MatchPlan, play_match
from rcj_challenges.scenario.load import load_text
from rcj_challenges.views.live.encoder import live_facts
from tests.judging_again import judged_again, reflog_of
from tests.match.playing import Run

# Without robots no program is started.
HALVES = """schema_version: 2
id: halves
title: Halves
extends: soccersim_v2
robots: {B1: null, B2: null, B3: null, Y1: null, Y2: null, Y3: null}
entrants: {blue: null, yellow: null}
"""
LONG_AND_SHORT = "match: {halves: 3, half_s: [1, 0.5, 0.32]}"
TWO_SHORT = "match: {halves: 2, half_s: 0.32}"
EARLY = "early: {triggers: [{trigger: time_reached, at_s: 0.16}], actions: [{action: end, reason: early}]}"


def scenario(match, *rules, **sections):
    lines = [match, *(f"{name}: {value}" for name, value in sections.items()), *(["rules:"] if rules else [])]
    return load_text(HALVES + "\n".join([*lines, *(f"  {rule}" for rule in rules)]))


def emit(trigger, payload):
    return f"emit: {{triggers: [{{trigger: {trigger}}}], actions: [{{action: emit, event: SAID, payload: {payload}}}]}}"


def at_the_end(action):
    return f"over: {{phases: any, triggers: [{{trigger: half_ended}}], actions: [{action}]}}"


@pytest.fixture
def play(tmp_path):
    """Return what plays such a match; the referee must judge its record alone as it judged the match."""

    def play(*parts, seed=1, **sections):
        outcome = play_match(MatchPlan(scenario(*parts, **sections), {}, {}, seed=seed, out=tmp_path))
        assert judged_again(outcome.folder) == reflog_of(outcome.folder)
        return Run(outcome.folder, outcome.result)

    return play


def payloads(run):
    return [line["payload"] for line in run.events("SAID")]


def ends(run):
    return [(half["half"], half["ticks"], half["ended"]) for half in run.result["halves"]]


def test_each_half_lasts_as_long_as_its_own_length(play):
    words = "{half: {word: halftime}, lasts_s: {word: total_match_time_s}, left_s: {word: time_left_s}}"
    run = play(LONG_AND_SHORT, emit("half_started", words), result="{rank: [{word: time_s, better: less, says: T}]}")
    assert ends(run) == [(1, 32, None), (2, 16, None), (3, 10, None)]
    assert run.result["simulated_s"] == 58 * 0.032
    assert payloads(run) == [
        {"half": 1, "lasts_s": 1, "left_s": 1.024},
        {"half": 2, "lasts_s": 0.5, "left_s": 0.512},
        {"half": 3, "lasts_s": 0.32, "left_s": 0.32},
    ]
    assert [half.info.ticks for half in run.trajectory.halves] == [32, 16, 10]


def test_the_live_page_has_the_length_of_each_half():
    facts = live_facts(scenario(LONG_AND_SHORT).scenario, {}, 1)
    assert (facts["halves_planned"], facts["half_ticks_planned"]) == (3, [32, 16, 10])


@pytest.mark.parametrize(("keep", "laps"), [(", keep: match", [3, 5, 7]), (", keep: half", [3, 3, 3]), ("", [3, 3, 3])])
def test_a_kept_counter_goes_on_and_another_starts_again(play, keep, laps):
    counted = "{triggers: [{trigger: time_reached, at_s: 0.064}], actions: [{action: count, counter: laps, by: 2}]}"
    over = emit("half_ended", "{laps: {counter: laps}}")
    run = play("match: {halves: 3, half_s: 0.32}", f"lap: {counted}", over, counters=f"{{laps: {{initial: 1{keep}}}}}")
    assert [payload["laps"] for payload in payloads(run)] == laps


@pytest.mark.parametrize("seed", [1, 2])
def test_what_is_drawn_without_repetition_comes_once_in_three_halves(play, seed):
    draws = "{side: {values: [west, middle, east], not_again: match}}"
    drawn = emit("half_started", "{side: {draw: side}}")
    run = play("match: {halves: 6, half_s: 0.032}", drawn, draws=draws, seed=seed)
    sides = [payload["side"] for payload in payloads(run)]
    assert sorted(sides[:3]) == sorted(sides[3:]) == ["east", "middle", "west"]


@pytest.mark.parametrize(
    ("rules", "halves"),
    [
        (["{action: end, what: match, reason: decided}"], [(1, 10, "decided")]),
        (["{action: end, what: match, reason: decided}", EARLY], [(1, 5, "decided")]),
        (["{action: end, reason: late}"], [(1, 10, None), (2, 10, None)]),
        (["{action: end, reason: late}", EARLY], [(1, 5, "early"), (2, 5, "early")]),
    ],
)
def test_a_rule_can_end_the_match_when_a_half_is_over_and_then_no_half_follows(play, rules, halves):
    action, *early = rules
    run = play(TWO_SHORT, emit("half_ended", "{half: {word: halftime}}"), *early, at_the_end(action))
    assert ends(run) == halves
    assert run.result["complete"]
    assert [payload["half"] for payload in payloads(run)] == [half for half, _, _ in halves]


@pytest.mark.parametrize(
    ("overrides", "teams"),
    [
        # `keep: match` means the seat; lint warns of it (tests/scenario/test_lint_sides.py).
        ([], 1),
        (["draws.first_kickoff.keep=half", "draws.first_kickoff.not_again=match"], 2),
    ],
)
def test_without_change_of_sides_the_file_decides_the_kick_off_of_the_second_half(place, overrides, teams):
    sides_kept = ("match.halves=2", "match.half_s=0.032", "match.swap_sides=false")
    kickoffs = place.play(*sides_kept, *overrides).events("KICKOFF")
    assert len(kickoffs) == 2
    assert len({event["payload"]["robot_name"][0] for event in kickoffs}) == teams
