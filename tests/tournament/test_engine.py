"""The state of a season as a whole: it depends on the outcomes only, and never forgets what was played."""

import random
import time

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.tournament.seasons import by_chance, names, play, season, stage

SHAPES = {
    "groups": "  g: {stage: round_robin, groups: 2, legs: 2}\n  k: {stage: knock_out, from: g, places: 1-2, third_place: true}\n",
    "swiss": "  s: {stage: swiss, rounds: 3, play_off: true}\n  k: {stage: knock_out, from: s, places: 1-3, legs: 2}\n",
    "play_off": "  g: {stage: round_robin, play_off: true}\n  k: {stage: knock_out, from: g, places: 1-4, best_of: 3}\n",
    "challenges": (
        "  c: {stage: challenge, scenarios: {a: {scenario: shooter}, b: {scenario: slalom}}}\n"
        "  s: {stage: swiss, rounds: 2, from: c, places: 1-5}\n  t: {stage: super_team}\n"
    ),
}
HEADS = [
    "",
    "tie_breaks: [points]\n",
    "tie_breaks: [points, head_to_head, lot]\nwithdrawn: {lost: [0, 3]}\n",
    "drawn: {extra_time: {match.half_s: 60}, tie_scenario: {scenario: slalom}}\n",
]


@st.composite
def seasons(draw):
    """Draw the shape of a tournament, a number of teams, and a seed."""
    shape = SHAPES[draw(st.sampled_from(sorted(SHAPES)))]
    return shape, draw(st.sampled_from(HEADS)), draw(st.integers(6, 9)), draw(st.integers(0, 10**6))


def some_played(one, outcome, rng, most):
    """Play some of the open fixtures, again and again; return the outcomes."""
    outcomes = {}
    for _ in range(most):
        ready = one.state(outcomes).open_fixtures()
        if not ready:
            break
        outcomes |= {fixture.id: outcome(fixture) for fixture in rng.sample(ready, rng.randint(1, len(ready)))}
    return outcomes


@given(seasons())
def test_state_does_not_depend_on_the_order_in_which_matches_were_played(drawn):
    shape, head, count, seed = drawn
    outcome = by_chance(seed, most=1)
    rng = random.Random(seed)  # noqa: S311 - a test draws the same each time
    one = season(shape, names(count), head)
    slowly = some_played(one, outcome, rng, most=1000)
    at_once = play(season(shape, names(count), head), outcome)
    assert one.state(slowly) == at_once
    assert {str(found.status) for found in at_once.stages} == {"finished"}


@given(seasons(), st.integers(0, 12))
def test_nothing_that_was_played_is_lost_when_a_team_leaves_and_the_rest_is_played_to_the_end(drawn, steps):
    shape, head, count, seed = drawn
    outcome = by_chance(seed, most=1)
    rng = random.Random(seed)  # noqa: S311 - a test draws the same each time
    before = season(shape, names(count), head)
    outcomes = some_played(before, outcome, rng, steps)
    team = rng.choice(names(count))
    last_rounds = before.state(outcomes).last_rounds(team)
    after = season(shape, names(count), head, {team: last_rounds})
    assert set(outcomes) <= set(after.state(outcomes).outcomes)
    last = play(after, outcome, dict(outcomes))
    assert set(outcomes) <= set(last.outcomes)
    assert {str(found.status) for found in last.stages} == {"finished"}
    assert all(team not in found.teams for found in last.stages if found.name not in last_rounds)


@pytest.mark.parametrize("shape", sorted(SHAPES))
def test_expected_matches_are_known_before_anything_is_played(shape):
    one = season(SHAPES[shape], names(8), "tie_breaks: [points, goals, lot]\n")
    expected = [found.expected_matches for found in one.state({}).stages]
    played = play(one, by_chance(5, most=50)).stages
    for number, found in zip(expected, played, strict=True):
        # A best-of-three is counted with the two matches that are certain until the third is to be played.
        assert number <= found.expected_matches <= number * (1.5 if shape == "play_off" else 1)
        assert found.expected_matches == len(found.fixtures)


def test_a_later_correction_changes_the_advancing_team_and_drops_the_old_final():
    stages = "  g: {stage: round_robin}\n  k: {stage: knock_out, from: g, places: 1-2}\n"
    one = season(stages, names(3), "tie_breaks: [points, lot]\n")
    state = play(one)
    final = stage(state, "k").fixtures[0].id
    corrected = dict(state.outcomes)
    for fixture in stage(state, "g").fixtures:
        if "t03" in fixture.id:
            scores = (9.0, 0.0) if fixture.sides[0].teams == ("t03",) else (0.0, 9.0)
            corrected[fixture.id] = type(corrected[fixture.id])(scores)
    again = one.state(corrected)
    assert stage(again, "k").teams == ("t03", "t01")
    assert final not in again.outcomes
    assert len(again.open_fixtures()) == 1


def processor_s(work):
    """Return how much processor time a call takes: other processes do not count."""
    before = time.process_time()
    work()
    return time.process_time() - before


def test_nine_rounds_of_64_teams_are_paired_in_two_seconds():
    one = season("  s: {stage: swiss, rounds: 9}\n", names(64))
    assert processor_s(lambda: play(one, by_chance(1))) < 2


def test_ten_thousand_matches_are_planned_in_five_seconds():
    one = season("  g: {stage: round_robin}\n", [f"t{number}" for number in range(142)])
    assert processor_s(lambda: one.state({})) < 5
    assert len(one.state({}).open_fixtures()) == 10_011


def test_state_after_500_matches_takes_a_twentieth_of_a_second():
    one = season("  g: {stage: round_robin, groups: 16, legs: 2}\n  k: {stage: knock_out, from: g}\n", names(96))
    outcomes = play(one, by_chance(1)).outcomes
    assert len(outcomes) > 500
    assert min(processor_s(lambda: one.state(outcomes)) for _ in range(5)) < 0.05
