"""Whether two versions of a team differ, by more than chance."""

from fractions import Fraction
from math import comb

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.match.comparison import gains, sign_test, tally
from rcj_challenges.scenario.models.scenario import Result

COUNTS = st.integers(0, 30)
BY_SCORE = Result.model_validate({"rank": ({"score": "each", "better": "more"},)}).rank
RACE = Result.model_validate({"rank": ({"score": "each", "better": "more"}, {"word": "time_s", "better": "less"})}).rank


def result(faults=(), **values):
    """Return a result of teams with values as of `RACE`; the first of them is best."""
    ranking = [{"place": place, "team": team, "values": own} for place, (team, own) in enumerate(values.items(), 1)]
    score = {team: own[0] for team, own in values.items()}
    return {"ranking": ranking, "score": score, "faults": [{"team": team} for team in faults]}


@given(COUNTS, COUNTS, COUNTS)
def test_the_p_value_is_that_of_as_many_throws_of_a_coin(better, worse, equal):
    found = sign_test(better, worse, equal)
    throws = better + worse
    tail = sum(comb(throws, heads) for heads in range(max(better, worse), throws + 1))
    assert found["p_value"] == pytest.approx(float(min(Fraction(2 * tail, 2**throws), 1)))
    low, high = found["interval"]
    assert 0 <= low <= better / max(throws, 1) <= high <= 1
    assert sign_test(worse, better, equal)["interval"] == pytest.approx([1 - high, 1 - low])


@pytest.mark.parametrize(
    ("better", "worse", "equal", "verdict", "needed"),
    [
        (16, 4, 0, "better", None),
        (4, 16, 0, "worse", None),
        (14, 6, 0, "unclear", 40),
        (6, 14, 0, "unclear", 40),
        (10, 10, 0, "unclear", None),
        (7, 3, 10, "unclear", 80),  # half of the seeds show nothing, so twice as many are needed
        (0, 0, 20, "equal", None),
        (6, 0, 14, "better", None),
        (5, 0, 15, "unclear", 25),
    ],
)
def test_a_verdict_takes_less_than_one_chance_in_twenty(better, worse, equal, verdict, needed):
    found = sign_test(better, worse, equal)
    assert (found["verdict"], found["needed_seeds"]) == (verdict, needed)
    assert sum(found[count] for count in ("better", "worse", "equal")) == better + worse + equal


def test_the_interval_is_that_of_clopper_and_pearson():
    assert sign_test(16, 4, 7)["interval"] == pytest.approx([0.5634, 0.9427], abs=1e-4)  # as in printed tables
    assert sign_test(0, 0, 3)["interval"] == [0, 1]


def test_scores_are_compared_by_the_lead_over_the_best_opponent():
    old = result(blue=[3], yellow=[2], green=[0])
    new = result(yellow=[5], blue=[4], green=[4])
    assert gains(new, old, "yellow", BY_SCORE) == (2,)
    assert gains(old, new, "yellow", BY_SCORE) == (-2,)
    assert gains(result(blue=[0.3]), result(blue=[0.1]), "blue", BY_SCORE) == (0.2,)


def test_a_shorter_time_is_better_where_the_shortest_is_best():
    assert gains(result(yellow=[1, 9.5]), result(yellow=[1, 11]), "yellow", RACE) == (0, 1.5)


def test_a_tally_counts_places_goals_and_matches_with_a_fault():
    drawn = result(yellow=[1], blue=[1])
    drawn["ranking"][1]["place"] = 1
    played = [result(yellow=[2], blue=[0], faults=["yellow", "yellow", "blue"]), result(blue=[3], yellow=[1]), drawn]
    assert tally(played, "yellow") == {
        "matches": 3, "won": 1, "drawn": 1, "lost": 1, "scored": 4, "conceded": 4, "faults": 1,
    }  # fmt: skip
    assert tally([result(yellow=[2])], "yellow") == {"matches": 1, "scored": 2, "faults": 0}
