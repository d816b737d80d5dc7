"""Round robins: pairings, groups, pots."""

from collections import Counter
from itertools import combinations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rcj_challenges.tournament.formats.groups import pairings
from tests.tournament.seasons import FOLDER, by_strength, names, order, play, season, stage


@settings(max_examples=63)  # all numbers of teams
@given(st.integers(2, 64))
def test_all_meet_once_in_as_few_rounds_as_can_be_with_even_sides(count):
    rounds = pairings(count)
    assert len(rounds) == count - 1 + count % 2
    for pairs in rounds:
        players = [player for pair in pairs for player in pair]
        assert len(players) == len(set(players)) == count - count % 2
    assert Counter(frozenset(pair) for pairs in rounds for pair in pairs) == Counter(
        map(frozenset, combinations(range(count), 2))
    )
    firsts = Counter(first for pairs in rounds for first, _ in pairs)
    assert all(abs(2 * firsts[player] - (count - 1)) <= 1 for player in range(count))


@pytest.mark.parametrize("count", [2, 5, 8])
def test_two_legs_give_each_pair_both_sides(count):
    met = Counter(pair for pairs in pairings(count, legs=2) for pair in pairs)
    assert set(met.values()) == {1}
    assert len(met) == count * (count - 1)


def test_fixtures_are_named_by_group_round_and_teams():
    state = season("  groups: {stage: round_robin, groups: {A: [t01, t02], B: [t03, t04]}}\n", names(4)).state({})
    assert sorted(one.id for one in state.open_fixtures()) == ["groups/A/round1/t01-t02", "groups/B/round1/t03-t04"]
    first = next(one for one in state.open_fixtures() if one.group == "A")
    assert [side.seat for side in first.sides] == ["blue", "yellow"]
    assert (first.stage, first.round, first.scenario, first.title) == ("groups", 1, "match", "Group A, round 1")


def test_each_fixture_has_a_seed_of_its_own_that_depends_on_the_tournaments_seed():
    def seeds(seed):
        one = season("  league: {stage: round_robin}\n", names(6))
        object.__setattr__(one.loaded, "tournament", one.loaded.tournament.model_copy(update={"seed": seed}))
        return [fixture.seed for fixture in type(one)(one.loaded).state({}).open_fixtures()]

    assert len(set(seeds(1))) == 15
    assert not set(seeds(1)) & set(seeds("2 and a text"))


def test_settings_of_a_stage_are_added_to_those_of_the_tournament():
    stages = "  a: {stage: round_robin, set: {match.half_s: 5}}\n  b: {stage: round_robin, scenario: other.yaml}\n"
    state = season(stages, names(2), "set: {match.half_s: 10, title: x}\n").state({})
    first, second = state.open_fixtures()
    assert (first.scenario, first.overrides) == ("match", ("match.half_s=5", 'title="x"'))
    assert (second.scenario, second.overrides) == (str(FOLDER / "other.yaml"), ())


@given(st.integers(1, 6), st.lists(st.integers(0, 4), min_size=12, max_size=40))
def test_drawn_groups_are_even_in_size_and_in_each_pot(groups, pots):
    teams = dict(zip(names(len(pots)), pots, strict=True))
    found = season(f"  g: {{stage: round_robin, groups: {groups}}}\n", teams).state({}).stages[0].tables
    assert sorted(team for table in found for team in order(table.rows)) == sorted(teams)
    assert spread([len(table.rows) for table in found]) <= 1
    for pot in set(pots):
        assert spread([sum(teams[team] == pot for team in order(table.rows)) for table in found]) <= 1


def spread(numbers):
    return max(numbers) - min(numbers)


def test_places_of_each_group_lead_on():
    stages = (
        "  groups: {stage: round_robin, groups: {A: [t01, t02, t03], B: [t04, t05, t06]}}\n"
        "  best: {stage: round_robin, from: groups, places: 1-2}\n  last: {stage: round_robin, from: groups, places: 3}\n"
    )
    one = season(stages, names(6))
    waiting = stage(one.state({}), "best")
    assert (waiting.status, waiting.teams, waiting.fixtures, waiting.expected_matches) == ("waiting", (), (), 6)
    state = play(one, by_strength)
    assert stage(state, "best").teams == ("t01", "t04", "t02", "t05")
    assert stage(state, "last").teams == ("t03", "t06")
    assert [len(one.fixtures) for one in state.stages] == [one.expected_matches for one in state.stages] == [6, 6, 1]


def test_an_outcome_of_a_fixture_that_does_not_exist_is_left_out():
    one = season("  league: {stage: round_robin}\n", names(2))
    fixture = one.state({}).open_fixtures()[0]
    assert one.state({"league/round1/x-y": by_strength(fixture)}).outcomes == {}


def test_groups_of_a_later_stage_are_drawn_evenly_from_each_place():
    stages = "  first: {stage: round_robin, groups: 4}\n  second: {stage: round_robin, groups: 2, from: first, places: 1-2}\n"
    state = play(season(stages, names(12)), by_strength)
    best = {order(table.rows)[0] for table in stage(state, "first").tables}
    assert [len(best & set(order(table.rows))) for table in stage(state, "second").tables] == [2, 2]
