"""Who wins: by the criteria of the scenario, a later one breaks ties."""

from rcj_challenges.referee.ranking import Tally, ranking
from rcj_challenges.scenario.load import load

SIDES = {"blue": "blue", "yellow": "yellow"}


def places(told):
    return [(entry["place"], entry["team"]) for entry in told]


def test_more_goals_win():
    assert places(ranking(load("match").scenario, {"blue": 1, "yellow": 3}, [Tally({}, SIDES, 600)])) == [
        (1, "yellow"),
        (2, "blue"),
    ]


def test_equal_scores_share_the_first_place():
    assert places(ranking(load("match").scenario, {"blue": 2, "yellow": 2}, [Tally({}, SIDES, 600)])) == [
        (1, "blue"),
        (1, "yellow"),
    ]


def test_a_counter_kept_per_robot_breaks_the_tie_for_the_team_whose_robots_they_are():
    scenario = load("match", ["result.rank=[{score: descending}, {counter: put_backs, order: ascending}]"]).scenario
    put_backs = {"B1": 0, "B2": 1, "B3": 0, "Y1": 3, "Y2": 0, "Y3": 0}
    swapped = {"blue": "yellow", "yellow": "blue"}  # in the second half the blue seat holds the yellow team
    told = ranking(scenario, {"blue": 1, "yellow": 1}, [Tally({"put_backs": put_backs}, swapped, 600)])
    assert [(entry["place"], entry["team"], entry["values"]) for entry in told] == [
        (1, "yellow", [1, 1]),
        (2, "blue", [1, 3]),
    ]


def test_a_shorter_time_wins_and_penalties_are_seconds():
    scenario = load("match", ["result.rank=[{time: ascending, plus: [{counter: put_backs, weight: 5}]}]"]).scenario
    told = ranking(scenario, {"blue": 0, "yellow": 9}, [Tally({"put_backs": {"B1": 2}}, SIDES, 40.0)])
    assert [(entry["team"], entry["values"]) for entry in told] == [("yellow", [40.0]), ("blue", [50.0])]


def test_times_that_are_equal_on_paper_share_a_place():
    rank = "result.rank=[{time: ascending, plus: [{counter: put_backs, weight: 0.1}, {counter: fouls, weight: 0.3}]}]"
    scenario = load("match", [rank, "counters.fouls={per: robots}"]).scenario
    told = ranking(
        scenario, {"blue": 0, "yellow": 0}, [Tally({"put_backs": {"B1": 3}, "fouls": {"Y1": 1}}, SIDES, 0.0)]
    )
    assert [(entry["place"], entry["values"]) for entry in told] == [(1, [0.3]), (1, [0.3])]  # floats: 3 * 0.1 > 0.3


def test_times_and_counters_of_all_halves_are_added_up_for_the_team_and_not_for_the_colour():
    rank = "result.rank=[{time: ascending, plus: [{counter: put_backs, weight: 10}]}, {counter: put_backs}]"
    swapped = {"blue": "yellow", "yellow": "blue"}
    halves = [Tally({"put_backs": {"B1": 7}}, SIDES, 5.0), Tally({"put_backs": {"Y1": 2, "B2": 1}}, swapped, 20.0)]
    told = ranking(load("match", [rank]).scenario, {"blue": 0, "yellow": 0}, halves)
    # The blue team drove B1 in the first half and Y1 in the second.
    assert [(entry["team"], entry["values"]) for entry in told] == [("yellow", [35.0, 1]), ("blue", [115.0, 9])]


def test_what_a_kept_counter_had_already_counts_once_and_for_the_team_that_counted_it():
    overrides = ["result.rank=[{counter: put_backs}, {counter: laps}]", "counters.laps={keep: match}"]
    swapped = {"blue": "yellow", "yellow": "blue"}
    halves = [
        Tally({"put_backs": {"B1": 7, "Y1": 0}, "laps": 2}, SIDES, 5.0),
        Tally({"put_backs": {"B1": 8, "Y1": 2}, "laps": 5}, swapped, 5.0, {"put_backs": {"B1": 7, "Y1": 0}, "laps": 2}),
    ]
    told = ranking(load("match", overrides).scenario, {"blue": 0, "yellow": 0}, halves)
    # The blue team drove B1 in the first half and Y1 in the second; 5 laps in all are 5, not 2 and 5.
    assert [(entry["team"], entry["values"]) for entry in told] == [("blue", [9, 5]), ("yellow", [1, 5])]


def test_the_result_of_a_match_holds_the_ranking(play):
    assert play("match.half_s=0.5").result["ranking"] == [
        {"place": 1, "team": "blue", "values": [0]},
        {"place": 1, "team": "yellow", "values": [0]},
    ]
