"""Who plays where: blue always defends +y, and scores follow the team."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.expect.scripted_match import half_of
from rcj_challenges.scenario.halves import by_seat, by_team, teams_by_seat
from rcj_challenges.scenario.load import load
from tests.made_up_runs import half_info, small_header, small_scenario


@pytest.fixture(scope="module")
def match():
    return load("match").scenario


def test_teams_change_seats_in_the_second_half(match):
    assert teams_by_seat(match, 2) == {"blue": "yellow", "yellow": "blue"}


@pytest.mark.parametrize("swap_sides", [True, False])
@pytest.mark.parametrize("half", [1, 2, 3])
def test_a_staged_half_and_a_made_up_record_are_played_in_the_seats_of_the_match(swap_sides, half):
    scenario = _small(swap_sides=swap_sides)
    reported = teams_by_seat(scenario, half)
    assert half_of(scenario, half).teams == reported
    assert half_info(scenario, half, 10, small_header(scenario)).teams == reported


@given(st.integers(0, 99), st.integers(0, 99), st.integers(1, 4))
def test_scores_follow_the_team(blue, yellow, half):
    teams = _teams(half)
    scores = {"blue": blue, "yellow": yellow}
    assert by_team(by_seat(scores, teams), teams) == scores


def _teams(half):
    return {"blue": "yellow", "yellow": "blue"} if half % 2 == 0 else {"blue": "blue", "yellow": "yellow"}


def _small(*, swap_sides):
    scenario = small_scenario()
    return scenario.model_copy(update={"match": scenario.match.model_copy(update={"swap_sides": swap_sides})})
