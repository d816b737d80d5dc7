"""Who wins: by the criteria of the scenario, a later one breaks ties."""

import pytest

from rcj_challenges.referee.ranking import Tally, ranking
from rcj_challenges.scenario.load import load

SIDES = {"blue": "blue", "yellow": "yellow"}
# In the second half the blue seat holds the yellow team.
SWAPPED = {"blue": "yellow", "yellow": "blue"}
ROBOTS = "counters.{}={{per: robots}}"


@pytest.mark.parametrize(
    ("overrides", "blue", "yellow", "halves", "ranked"),
    [
        ([], 1, 3, [Tally({}, SIDES, 600)], [(1, "yellow", [3]), (2, "blue", [1])]),
        ([], 2, 2, [Tally({}, SIDES, 600)], [(1, "blue", [2]), (1, "yellow", [2])]),
        pytest.param(
            ["result.rank=[{score: descending}, {counter: put_backs, order: ascending}]"], 1, 1,
            [Tally({"put_backs": {"B1": 0, "B2": 1, "B3": 0, "Y1": 3, "Y2": 0, "Y3": 0}}, SWAPPED, 600)],
            [(1, "yellow", [1, 1]), (2, "blue", [1, 3])],
            id="a counter per robot breaks the tie, for the team whose robots they are",
        ),
        pytest.param(
            ["result.rank=[{time: ascending, plus: [{counter: put_backs, weight: 5}]}]"], 0, 9,
            [Tally({"put_backs": {"B1": 2}}, SIDES, 40.0)],
            [(1, "yellow", [40.0]), (2, "blue", [50.0])],
            id="the shorter time wins, penalties are seconds",
        ),
        pytest.param(
            [
                "result.rank=[{time: ascending, plus: [{counter: put_backs, weight: 0.1}, {counter: fouls, weight: 0.3}]}]",
                ROBOTS.format("fouls"),
            ], 0, 0,
            [Tally({"put_backs": {"B1": 3}, "fouls": {"Y1": 1}}, SIDES, 0.0)],
            [(1, "blue", [0.3]), (1, "yellow", [0.3])],
            id="times equal on paper share a place, though as floats 3 * 0.1 > 0.3",
        ),
        pytest.param(
            ["result.rank=[{time: ascending, plus: [{counter: put_backs, weight: 10}]}, {counter: put_backs}]"], 0, 0,
            [Tally({"put_backs": {"B1": 7}}, SIDES, 5.0), Tally({"put_backs": {"Y1": 2, "B2": 1}}, SWAPPED, 20.0)],
            [(1, "yellow", [35.0, 1]), (2, "blue", [115.0, 9])],
            id="times and counters of all halves are added up for the team, not for the colour",
        ),
        pytest.param(
            ["result.rank=[{counter: put_backs}, {counter: laps}]", "counters.laps={keep: match}"], 0, 0,
            [
                Tally({"put_backs": {"B1": 7, "Y1": 0}, "laps": 2}, SIDES, 5.0),
                Tally(
                    {"put_backs": {"B1": 8, "Y1": 2}, "laps": 5}, SWAPPED, 5.0,
                    {"put_backs": {"B1": 7, "Y1": 0}, "laps": 2},
                ),
            ],
            [(1, "blue", [9, 5]), (2, "yellow", [1, 5])],
            id="a kept counter counts once, for the team that counted it",
        ),
    ],
)  # fmt: skip
def test_teams_are_ranked_by_the_criteria_in_their_order(overrides, blue, yellow, halves, ranked):
    entries = ranking(load("match", overrides).scenario, {"blue": blue, "yellow": yellow}, halves)
    assert [(entry["place"], entry["team"], entry["values"]) for entry in entries] == ranked


def test_the_result_of_a_match_holds_the_ranking(play):
    assert play("match.half_s=0.5").result["ranking"] == [
        {"place": 1, "team": "blue", "values": [0]},
        {"place": 1, "team": "yellow", "values": [0]},
    ]
