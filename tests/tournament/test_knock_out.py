"""Knock-outs: brackets, byes, ties and what decides them."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rcj_challenges.tournament.formats.bracket import fold
from rcj_challenges.tournament.season import FixtureKind, Outcome, Ruled
from tests.tournament.seasons import FOLDER, alone, by_chance, by_strength, names, order, play, season, stage, teams_of

CUP = "  cup: {{stage: knock_out{}}}\n"


def cup(count=4, more="", head=""):
    return season(CUP.format(more), names(count), head)


def drawn(fixture):
    return Outcome((1.0, 1.0))


@settings(max_examples=63)  # all numbers of teams
@given(st.integers(2, 64), st.integers(0, 1000))
def test_every_team_but_one_loses_one_tie(count, seed):
    state = play(cup(count), by_chance(seed)).stages[0]
    ties = [tie for tie in state.ties if tie.decided_by != "bye"]
    losers = [team for tie in ties for team in tie.teams if team != tie.winner]
    assert len(losers) == len(set(losers)) == count - 1 == state.expected_matches
    assert {*losers, state.ties[-1].winner} == set(names(count))
    assert sorted(order(state.places)) == names(count)


@given(st.integers(2, 64))
def test_the_stronger_team_always_meets_the_weakest_left_and_has_the_byes(count):
    state = play(cup(count)).stages[0]
    byes = [tie.winner for tie in state.ties if tie.decided_by == "bye"]
    assert sorted(byes) == names(count)[: len(byes)]
    by_round = dict.fromkeys(tie.round for tie in state.ties)
    for name in by_round:
        ties = [tie for tie in state.ties if tie.round == name]
        size = 2 * len(ties)
        met = [sorted(int(team[1:]) for team in tie.teams if team) for tie in ties]
        assert all(sum(pair) == size + 1 for pair in met if len(pair) == 2)


@pytest.mark.parametrize("size", [2, 4, 8, 16, 32, 64])
def test_bracket_keeps_the_best_apart_as_long_as_it_can(size):
    seeds = fold(size)
    assert sorted(seeds) == list(range(size))
    while len(seeds) > 1:
        seeds = [min(pair) for pair in zip(seeds[::2], seeds[1::2], strict=True)]
        assert sorted(seeds) == list(range(len(seeds)))


def test_rounds_and_ties_are_named():
    state = play(cup(16, ", third_place: true")).stages[0]
    counted = {
        name: sum(tie.round == name for tie in state.ties) for name in dict.fromkeys(t.round for t in state.ties)
    }
    assert counted == {"round_of_16": 8, "quarter_finals": 4, "semi_finals": 2, "third_place": 1, "final": 1}
    quarter = state.ties[8]
    assert (quarter.id, quarter.title, quarter.round_title) == (
        "cup/quarter_finals/1", "quarter-final 1", "Quarter-finals",
    )  # fmt: skip
    assert quarter.sources == ("winner of match 1 of the round of 16", "winner of match 2 of the round of 16")
    assert state.fixtures[7].title == "Cup, match 8 of the round of 16"
    assert quarter.fixtures == ("cup/quarter_finals/1/leg1/t08-t01",)


def test_places_of_a_knock_out_are_shared_by_the_losers_of_a_round():
    places = play(cup(8)).stages[0].places
    assert [row.place for row in places] == [1, 2, 3, 3, 5, 5, 5, 5]
    assert [row.shared for row in places] == [False, False, True, True, True, True, True, True]
    third = play(cup(8, ", third_place: true")).stages[0]
    assert [row.place for row in third.places] == [1, 2, 3, 4, 5, 5, 5, 5]
    assert order(third.places)[:4] == ["t01", "t02", "t03", "t04"]
    assert third.expected_matches == 8


def test_a_waiting_knock_out_shows_where_its_teams_come_from():
    stages = "  groups: {stage: round_robin, groups: 2}\n  cup: {stage: knock_out, from: groups, places: 1-2}\n"
    state = season(stages, names(6)).state({})
    waiting = stage(state, "cup")
    assert (waiting.status, waiting.teams, waiting.fixtures) == ("waiting", (), ())
    assert [tie.sources for tie in waiting.ties][:2] == [("A1", "B2"), ("B1", "A2")]
    assert {tie.teams for tie in waiting.ties} == {("", "")}


def test_a_waiting_knock_out_names_the_team_with_a_bye():
    stages = "  s: {stage: swiss, rounds: 2}\n  cup: {stage: knock_out, from: s, places: 1-3}\n"
    first, second, final = stage(season(stages, names(4)).state({}), "cup").ties
    assert first.sources == ("place 1 of s", "bye")
    assert second.sources == ("place 2 of s", "place 3 of s")
    assert final.sources == ("place 1 of s", "winner of semi-final 2")


@pytest.mark.parametrize(("groups", "places"), [(2, "1-2"), (3, "1-2"), (4, "1-2"), (3, "1-3"), (4, "1-4"), (6, "1-2")])
def test_teams_of_one_group_do_not_meet_in_the_first_round(groups, places):
    stages = f"  groups: {{stage: round_robin, groups: {groups}}}\n  cup: {{stage: knock_out, from: groups, places: {places}}}\n"
    waiting = stage(season(stages, names(24)).state({}), "cup")
    first = [tie.sources for tie in waiting.ties if tie.round == waiting.ties[0].round and "bye" not in tie.sources]
    assert first
    assert all(one[0] != other[0] for one, other in first)


def test_teams_of_one_group_are_kept_apart_by_exchanging_teams_with_the_same_place():
    stages = "  groups: {stage: round_robin, groups: 5}\n  cup: {stage: knock_out, from: groups, places: 1-3}\n"
    waiting = stage(season(stages, names(15)).state({}), "cup")
    opponent = {one: other for tie in waiting.ties[:8] for one, other in (tie.sources, tie.sources[::-1])}
    # By its seed, the second of group A would meet the third of group A.
    assert opponent["A2"][1] == "3"
    assert (opponent["C2"], opponent["B2"], opponent["A1"]) == ("D2", "E2", "bye")


def test_pots_seed_a_knock_out_without_a_stage_before():
    teams = {"t01": 2, "t02": 0, "t03": 1, "t04": 1}
    ties = season(CUP.format(""), teams).state({}).stages[0].ties
    assert [tie.teams for tie in ties[:2]] == [("t03", "t02"), ("t04", "t01")]


def test_drawn_seeding_depends_on_the_seed_only():
    first = cup(8, ", seeding: drawn").state({}).stages[0].ties
    assert first == cup(8, ", seeding: drawn").state({}).stages[0].ties
    assert [tie.teams for tie in first] != [tie.teams for tie in cup(8).state({}).stages[0].ties]


# --- what decides a tie ------------------------------------------------------------------------------------------------


def tie_of_two(outcome, more="", head=""):
    """Return the only tie of a final between t01 and t02, and the fixtures that were played."""
    state = play(cup(2, more, head), outcome)
    return state.stages[0].ties[0], state.stages[0].fixtures


def test_a_drawn_match_is_decided_by_lot_if_nothing_else_is_listed():
    tie, fixtures = tie_of_two(drawn)
    assert (tie.scores, tie.decided_by, len(fixtures)) == ((1, 1), "lot", 1)
    assert tie.winner == tie_of_two(drawn)[0].winner


def test_extra_time_has_its_own_settings_and_seats_and_is_added_to_the_score():
    def outcome(fixture):
        return Outcome((0.0, 1.0)) if fixture.kind is FixtureKind.EXTRA_TIME else drawn(fixture)

    tie, fixtures = tie_of_two(outcome, head="set: {match.half_s: 600}\ndrawn: {extra_time: {match.half_s: 60}}\n")
    assert [(one.kind.value, one.overrides[-1]) for one in fixtures] == [
        ("match", "match.half_s=600"),
        ("extra_time", "match.half_s=60"),
    ]
    assert teams_of(fixtures[1]) == teams_of(fixtures[0])[::-1] == ("t02", "t01")
    assert (tie.scores, tie.winner, tie.decided_by) == ((2, 1), "t01", "extra_time")


def test_extra_time_counts_as_an_expected_match_once_it_is_to_be_played():
    def outcome(fixture):
        return by_strength(fixture) if fixture.kind is FixtureKind.EXTRA_TIME else drawn(fixture)

    one = cup(4, ", third_place: true", "drawn: {extra_time: {match.half_s: 60}}\n")
    assert one.state({}).stages[0].expected_matches == 4
    outcomes = {fixture.id: drawn(fixture) for fixture in one.state({}).open_fixtures()}
    assert one.state(outcomes).stages[0].expected_matches == 6
    state = play(one, outcome).stages[0]
    assert state.expected_matches == len(state.fixtures) == 8


def test_a_tie_scenario_for_two_comes_after_extra_time():
    def outcome(fixture):
        return Outcome((2.0, 3.0)) if fixture.kind is FixtureKind.TIE_SCENARIO else drawn(fixture)

    head = "drawn: {extra_time: {match.half_s: 60}, tie_scenario: {scenario: golden_goal, set: {a: 1}}}\n"
    tie, fixtures = tie_of_two(outcome, head=head)
    assert [one.kind.value for one in fixtures] == ["match", "extra_time", "tie_scenario"]
    assert (fixtures[2].scenario, fixtures[2].overrides) == (str(FOLDER / "golden_goal"), ("a=1",))
    assert (tie.scores, tie.winner, tie.decided_by) == ((2, 2), "t02", "tie_scenario")


def test_a_tie_scenario_with_one_seat_is_played_by_each_with_the_same_seed():
    def outcome(fixture):
        if fixture.kind is FixtureKind.TIE_SCENARIO:
            return alone(1, 20 if teams_of(fixture) == ("t01",) else 12)
        return drawn(fixture)

    tie, fixtures = tie_of_two(outcome, head="drawn: {tie_scenario: {scenario: slalom}}\n")
    assert [teams_of(one) for one in fixtures[1:]] == [("t01",), ("t02",)]
    assert fixtures[1].seed == fixtures[2].seed
    assert (tie.winner, tie.decided_by) == ("t02", "tie_scenario")  # less time is better


def test_a_level_tie_scenario_leaves_it_to_the_lot():
    def outcome(fixture):
        return alone(1, 20) if fixture.kind is FixtureKind.TIE_SCENARIO else drawn(fixture)

    tie, _ = tie_of_two(outcome, head="drawn: {tie_scenario: {scenario: slalom}}\n")
    assert tie.decided_by == "lot"


def test_two_legs_change_seats_and_are_added_up():
    scores = {"t01-t02": (1.0, 0.0), "t02-t01": (3.0, 1.0)}
    tie, fixtures = tie_of_two(lambda one: Outcome(scores[one.id.rpartition("/")[2]]), ", legs: 2")
    assert [(one.leg, teams_of(one)) for one in fixtures] == [(1, ("t01", "t02")), (2, ("t02", "t01"))]
    assert (tie.scores, tie.winner, tie.decided_by) == ((2, 3), "t02", "match")


def test_both_legs_can_be_played_at_the_same_time():
    assert len(cup(2, ", legs: 2").state({}).open_fixtures()) == 2


def test_best_of_five_is_over_after_three_wins():
    tie, fixtures = tie_of_two(by_strength, ", best_of: 5")
    assert (tie.scores, len(fixtures)) == ((3, 0), 3)


def test_best_of_three_plays_the_third_match_only_if_it_is_needed():
    one = cup(2, ", best_of: 3")
    first, second = one.state({}).open_fixtures()
    outcomes = {first.id: Outcome((1.0, 0.0)), second.id: Outcome((1.0, 0.0))}
    (third,) = one.state(outcomes).open_fixtures()
    tie = one.state(outcomes | {third.id: Outcome((0.0, 2.0))}).stages[0].ties[0]
    assert (tie.scores, tie.winner) == ((1, 2), "t02")


def test_drawn_matches_of_a_best_of_three_lead_to_a_lot():
    tie, fixtures = tie_of_two(drawn, ", best_of: 3")
    assert (tie.scores, tie.decided_by, len(fixtures)) == ((0, 0), "lot", 3)


def test_extra_time_of_a_best_of_three_counts_as_one_win():
    def outcome(fixture):
        return Outcome((5.0, 2.0)) if fixture.kind is FixtureKind.EXTRA_TIME else drawn(fixture)

    tie, _ = tie_of_two(outcome, ", best_of: 3", "drawn: {extra_time: {match.half_s: 60}}\n")
    assert (tie.scores, tie.winner, tie.decided_by) == ((1, 0), "t01", "extra_time")


def test_a_forfeit_is_named_as_what_decided():
    tie, _ = tie_of_two(lambda _: Outcome((0.0, 3.0), Ruled.FORFEIT, "no robots"))
    assert (tie.winner, tie.decided_by) == ("t02", "forfeit")


def test_another_pairing_of_a_tie_has_other_fixtures():
    one = cup(4)
    first, second = one.state({}).open_fixtures()
    finals = [
        one.state({first.id: Outcome(scores), second.id: Outcome((1.0, 0.0))}).open_fixtures()[0]
        for scores in ((1.0, 0.0), (0.0, 1.0))
    ]
    assert finals[0].id != finals[1].id
    assert finals[0].tie == finals[1].tie == "cup/final/1"
