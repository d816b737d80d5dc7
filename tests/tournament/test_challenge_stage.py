"""Stages of challenges: what counts of several runs, and of several challenges."""

from dataclasses import replace
from pathlib import Path

import pytest

from rcj_challenges.tournament.engine import Season
from rcj_challenges.tournament.season import Outcome, Ruled
from tests.tournament.seasons import FOLDER, alone, loaded, names, order, play, season, teams_of

ONE = "  c: {stage: challenge, scenarios: {goals: {scenario: shooter}}, seeds: 3%s}\n"
TWO = "  c: {stage: challenge, scenarios: {goals: {scenario: shooter}, poles: {scenario: slalom}}%s}\n"


def run(fixture):
    return int(fixture.id.split("/")[2].removeprefix("seed"))


def played(stages, values, head="", count=2):
    """Return the state of a stage in which ``values`` gives each team's values by challenge, run by run."""

    def outcome(fixture):
        (team,) = teams_of(fixture)
        return alone(*values[fixture.group][team][run(fixture) - 1])

    return play(season(stages, names(count), head), outcome).stages[0]


def test_all_teams_play_a_challenge_with_the_same_seeds():
    fixtures = season(ONE % "", names(2)).state({}).open_fixtures()
    assert [one.id for one in fixtures] == [f"c/goals/seed{n}/t0{t}" for n in (1, 2, 3) for t in (1, 2)]
    seeds = {run(one): one.seed for one in fixtures}
    assert all(one.seed == seeds[run(one)] for one in fixtures)
    assert len(set(seeds.values())) == 3
    assert [(side.seat, side.teams) for side in fixtures[0].sides] == [("yellow", ("t01",))]


@pytest.mark.parametrize(
    ("rule", "values"),
    [("sum", {"t01": 6, "t02": 7}), ("median", {"t01": 2, "t02": 0}), ("best", {"t01": 3, "t02": 7})],
)
def test_runs_are_ranked_by_sum_median_or_best(rule, values):
    table = played(ONE % f", rank_by: {rule}", {"goals": {"t01": [[1], [2], [3]], "t02": [[0], [0], [7]]}}).tables[0]
    assert {row.team: row.values[0] for row in table.rows} == values
    assert order(table.rows)[0] == max(values, key=values.get)
    assert (table.columns, table.complete, table.rows[0].played) == (("score",), True, 3)


def test_a_criterion_of_which_less_is_better_breaks_a_tie():
    stages = "  c: {stage: challenge, scenarios: {poles: {scenario: slalom}}}\n"
    table = played(stages, {"poles": {"t01": [[4, 30]], "t02": [[4, 25]]}}).tables[0]
    assert order(table.rows) == ["t02", "t01"]
    assert table.rows[0].values == (4, 25)


def test_best_run_is_one_run_and_not_the_best_of_each_criterion():
    stages = "  c: {stage: challenge, scenarios: {poles: {scenario: slalom}}, seeds: 2, rank_by: best}\n"
    table = played(stages, {"poles": {"t01": [[4, 30], [3, 10]], "t02": [[4, 25], [1, 99]]}}).tables[0]
    assert [(row.team, row.values) for row in table.rows] == [("t02", (4, 25)), ("t01", (4, 30))]


BOTH = {
    "goals": {"t01": [[10]], "t02": [[5]], "t03": [[5]]},
    "poles": {"t01": [[1, 40]], "t02": [[2, 40]], "t03": [[0, 40]]},
}


def test_challenges_are_combined_by_points_for_places_that_can_be_shared():
    stage = played(TWO % ", combine: places", BOTH, count=3)
    assert [table.name for table in stage.tables] == ["goals", "poles", "total"]
    total = stage.tables[-1]
    assert total.columns == ("goals", "poles")
    assert [(row.team, row.place, row.points, row.values) for row in total.rows] == [
        ("t01", 1, 5, (3, 2)),
        ("t02", 1, 5, (2, 3)),
        ("t03", 3, 3, (2, 1)),
    ]
    assert [row.shared for row in total.rows] == [True, True, False]
    assert stage.places == total.rows


def test_points_for_places_can_be_listed():
    total = played(TWO % ", place_points: [25, 10]", BOTH, count=3).tables[-1]
    assert {row.team: row.points for row in total.rows} == {"t01": 35, "t02": 35, "t03": 10}


def test_challenges_are_combined_by_the_share_of_the_best():
    total = played(TWO % ", combine: share", BOTH, count=3).tables[-1]
    assert {row.team: row.values for row in total.rows} == {"t01": (100, 50), "t02": (50, 100), "t03": (50, 0)}
    assert order(total.rows) == ["t01", "t02", "t03"]


def test_a_lot_leaves_no_place_of_a_challenge_shared():
    stage = played(TWO % "", BOTH, "tie_breaks: [points, lot]\n", count=3)
    assert [row.place for row in stage.places] == [1, 2, 3]
    assert [row.by_lot for row in stage.places] == [True, True, False]


def test_a_team_without_a_submission_for_a_challenge_does_not_play_it():
    one = loaded(TWO % "", names(2))
    entries = dict(one.entries)
    entries["t01"] = replace(entries["t01"], challenges={("c", "goals"): None, ("c", "poles"): Path("poles.zip")})
    one = replace(one, entries=entries)
    state = play(Season(one), lambda _: alone(0, 30))
    assert [fixture.id for fixture in state.stages[0].fixtures] == [
        "c/goals/seed1/t02",
        "c/poles/seed1/t01",
        "c/poles/seed1/t02",
    ]
    goals, _, total = state.stages[0].tables
    assert [(row.team, row.place, row.played) for row in goals.rows] == [("t02", 1, 1), ("t01", 2, 0)]
    assert {row.team: row.values for row in total.rows} == {"t01": (0, 2), "t02": (2, 2)}
    assert [entries[team].submission("c", "poles") for team in names(2)] == [Path("poles.zip"), FOLDER / "t02"]


def test_an_annulled_run_does_not_count():
    one = season(ONE % "", names(2))
    outcomes = {fixture.id: alone(run(fixture)) for fixture in one.state({}).open_fixtures()}
    outcomes["c/goals/seed3/t01"] = Outcome((3.0,), Ruled.ANNULLED, "wrong field")
    rows = one.state(outcomes).stages[0].tables[0].rows
    assert [(row.team, row.values, row.played) for row in rows] == [("t02", (6,), 3), ("t01", (3,), 2)]


POLES = "  c: {stage: challenge, scenarios: {poles: {scenario: slalom}}, seeds: 2, rank_by: %s}\n"


@pytest.mark.parametrize("rule", ["sum", "median", "best"])
def test_a_corrected_run_has_the_worst_time_of_the_others(rule):
    one = season(POLES % rule, names(2))
    outcomes = {fixture.id: alone(4, 20 + run(fixture)) for fixture in one.state({}).open_fixtures()}
    outcomes["c/poles/seed1/t02"] = Outcome((4.0,), Ruled.CORRECTED, "the goal counts")
    table = one.state(outcomes).stages[0].tables[0]
    values = {row.team: row.values for row in table.rows}
    assert (
        values
        == {
            "sum": {"t01": (8, 43), "t02": (8, 44)},
            "median": {"t01": (4, 21.5), "t02": (4, 22)},
            "best": {"t01": (4, 21), "t02": (4, 22)},
        }[rule]
    )


def test_corrected_runs_alone_are_level_in_criteria_that_no_ruling_sets():
    one = season(POLES % "sum", names(1))
    outcomes = {fixture.id: Outcome((4.0,), Ruled.CORRECTED) for fixture in one.state({}).open_fixtures()}
    assert one.state(outcomes).stages[0].tables[0].rows[0].values == (8, 0)


@pytest.mark.parametrize("rule", ["sum", "median", "best"])
def test_a_forfeited_run_does_not_improve_the_place(rule):
    one = season(ONE % f", rank_by: {rule}", names(3))
    outcomes = {fixture.id: alone(-run(fixture)) for fixture in one.state({}).open_fixtures()}
    outcomes["c/goals/seed3/t01"] = Outcome((0.0,), Ruled.FORFEIT, "the program was not its own")
    rows = one.state(outcomes).stages[0].tables[0].rows
    assert [(row.team, row.place, row.played) for row in rows] == [("t02", 1, 3), ("t03", 1, 3), ("t01", 3, 2)]


@pytest.mark.parametrize("rule", ["sum", "median", "best"])
def test_a_forfeited_run_does_not_improve_the_share_of_the_best(rule):
    one = season(TWO % f", seeds: 3, rank_by: {rule}, combine: share", names(3))
    values = {"t01": 9, "t02": 4, "t03": 2}
    outcomes = {fixture.id: alone(values[teams_of(fixture)[0]], 30) for fixture in one.state({}).open_fixtures()}
    outcomes["c/goals/seed3/t01"] = Outcome((0.0,), Ruled.FORFEIT, "the program was not its own")
    goals, _, total = one.state(outcomes).stages[0].tables
    assert order(goals.rows) == ["t02", "t03", "t01"]
    assert {row.team: row.values[0] for row in total.rows} == {"t01": 50, "t02": 100, "t03": 50}
