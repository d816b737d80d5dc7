"""Super teams: their composition and their table."""

from collections import Counter

import pytest

from tests.tournament.seasons import by_strength, names, order, play, season

DRAWN = "  super: {stage: super_team}\n"


@pytest.mark.parametrize(("count", "sides"), [(6, 2), (9, 3), (18, 6)])
def test_each_team_is_drawn_into_one_super_team(count, sides):
    state = play(season(DRAWN, names(count))).stages[0]
    members = [row.team.split("+") for row in state.places]
    assert len(members) == sides
    assert sorted(team for own in members for team in own) == names(count)
    assert len(state.fixtures) == state.expected_matches == sides * (sides - 1) // 2


@pytest.mark.parametrize("count", [4, 5, 7, 17])
def test_last_super_team_is_filled_with_teams_that_play_in_two(count):
    state = play(season(DRAWN, names(count))).stages[0]
    members = [row.team.split("+") for row in state.places]
    assert all(len(set(own)) == 3 for own in members)
    played = Counter(team for own in members for team in own)
    assert set(played) == set(names(count))
    assert max(played.values()) <= 2


def test_a_side_names_the_team_of_each_of_its_robots():
    stages = "  super: {stage: super_team, super_teams: {red: [t01, t02, t03], white: [t04, t05, t06]}, legs: 2}\n"
    state = play(season(stages, names(6)), by_strength).stages[0]
    assert [one.id for one in state.fixtures] == ["super/round1/red-white", "super/round2/white-red"]
    assert [(side.seat, side.teams) for side in state.fixtures[1].sides] == [
        ("blue", ("t04", "t05", "t06")),
        ("yellow", ("t01", "t02", "t03")),
    ]
    assert order(state.places) == ["t01+t02+t03", "t04+t05+t06"]
    assert [(row.played, row.won, row.points) for row in state.places] == [(2, 2, 6), (2, 0, 0)]
