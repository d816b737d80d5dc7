"""Who plays where: blue always defends +y, and scores follow the team."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.match.seats import by_seat, by_team, teams_by_seat
from rcj_challenges.scenario.load import load


@pytest.fixture(scope="module")
def match():
    return load("match").scenario


def test_teams_keep_their_seats_in_the_first_half(match):
    assert teams_by_seat(match, 1) == {"blue": "blue", "yellow": "yellow"}


def test_teams_change_seats_in_the_second_half(match):
    assert teams_by_seat(match, 2) == {"blue": "yellow", "yellow": "blue"}


def test_a_challenge_with_one_entrant_has_one_seat():
    assert teams_by_seat(load("fast_shooter").scenario, 1) == {"yellow": "yellow"}


@given(st.integers(0, 99), st.integers(0, 99), st.integers(1, 4))
def test_scores_follow_the_team(blue, yellow, half):
    teams = _teams(half)
    scores = {"blue": blue, "yellow": yellow}
    assert by_team(by_seat(scores, teams), teams) == scores


def _teams(half):
    return {"blue": "yellow", "yellow": "blue"} if half % 2 == 0 else {"blue": "blue", "yellow": "yellow"}
