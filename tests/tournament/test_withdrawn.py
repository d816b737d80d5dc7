"""Teams that leave in the middle of a tournament."""

import pytest

from rcj_challenges.tournament.season import Outcome, Ruled
from tests.tournament.seasons import by_strength, names, order, play, season, stage, teams_of

LEAGUE = "  league: {stage: round_robin}\n"
ANNULLED, LOST = "", "withdrawn: {lost: [0, 3]}\n"


def left_after(stages, head, count, team, rounds):
    """Return the season and outcomes after so many rounds have been played and a team has left."""
    before = season(stages, names(count), head)
    outcomes = {}
    for _ in range(rounds):
        state = before.state(outcomes)
        first = min(fixture.round for fixture in state.open_fixtures())
        outcomes |= {one.id: by_strength(one) for one in state.open_fixtures() if one.round == first}
    last_rounds = before.state(outcomes).last_rounds(team)
    return season(stages, names(count), head, {team: last_rounds}), outcomes


def test_all_matches_of_a_team_that_has_left_a_round_robin_are_annulled():
    one, outcomes = left_after(LEAGUE, ANNULLED, 4, "t01", 1)
    state = play(one, by_strength, outcomes)
    own = [state.outcomes[fixture.id] for fixture in state.stages[0].fixtures if "t01" in teams_of(fixture)]
    assert [outcome.ruled for outcome in own] == [Ruled.ANNULLED] * 3
    assert sorted(sum(outcome.scores) for outcome in own) == [0, 0, 3]  # what was played stays visible
    places = state.stages[0].places
    assert [(row.team, row.played) for row in places] == [("t02", 2), ("t03", 2), ("t04", 2)]


def test_unplayed_matches_of_a_withdrawn_team_are_lost_if_the_file_demands_it():
    one, outcomes = left_after(LEAGUE, LOST, 4, "t01", 1)
    state = play(one, by_strength, outcomes)
    own = {fixture: state.outcomes[fixture.id] for fixture in state.stages[0].fixtures if "t01" in teams_of(fixture)}
    assert sorted(outcome.ruled for outcome in own.values()) == ["played", "withdrawn", "withdrawn"]
    for fixture, outcome in own.items():
        if outcome.ruled is Ruled.WITHDRAWN:
            assert outcome.scores[teams_of(fixture).index("t01")] == 0
            assert sum(outcome.scores) == 3
    row = next(row for row in state.stages[0].places if row.team == "t01")
    assert (row.played, row.won, row.lost) == (3, 1, 2)


@pytest.mark.parametrize("head", [ANNULLED, LOST])
def test_matches_of_a_team_that_leaves_after_all_of_its_own_stand(head):
    one, outcomes = left_after(LEAGUE, head, 4, "t01", 3)
    state = one.state(outcomes)
    assert {outcome.ruled for outcome in state.outcomes.values()} == {Ruled.PLAYED}
    assert order(state.stages[0].places) == names(4)


def test_two_teams_that_have_left_do_not_play_each_other_for_a_score():
    one = season(LEAGUE, names(3), LOST, {"t01": {"league": 3}, "t02": {"league": 3}})
    state = one.state({})
    ruled = {
        teams_of(fixture): state.outcomes[fixture.id].ruled
        for fixture in state.stages[0].fixtures
        if fixture.id in state.outcomes
    }
    assert [ruled[pair] for pair in ruled if set(pair) == {"t01", "t02"}] == [Ruled.ANNULLED]
    assert state.open_fixtures() == ()


@pytest.mark.parametrize(("head", "points"), [(ANNULLED, [3, 0]), (LOST, [6, 3])])
def test_a_team_that_leaves_after_all_that_it_could_play_keeps_its_results(head, points):
    (fixture,) = [one for one in season(LEAGUE, names(3)).state({}).fixtures if "t03" not in teams_of(one)]
    one = season(LEAGUE, names(3), head, {"t03": {"league": 3}, "t02": {"league": 3}})
    places = one.state({fixture.id: by_strength(fixture)}).stages[0].places
    assert [(row.team, row.points) for row in places[:2]] == [("t01", points[0]), ("t02", points[1])]


@pytest.mark.parametrize("head", [ANNULLED, LOST])
def test_a_swiss_bye_against_a_team_that_left_stays_when_its_owner_leaves_too(head):
    stages = "  swiss: {stage: swiss, rounds: 2}\n"
    first = season(stages, names(4)).state({}).open_fixtures()[0]
    left, staying = teams_of(first)
    before = play(season(stages, names(4), head, {left: {"swiss": 1}}))
    after = play(season(stages, names(4), head, {left: {"swiss": 1}, staying: before.last_rounds(staying)}))
    assert [row.points for row in after.stages[0].places] == [row.points for row in before.stages[0].places]


@pytest.mark.parametrize(
    ("more", "places"), [("", [("t03", 1), ("t04", 1)]), (", third_place: true", [("t03", 1), ("t04", 2)])]
)
def test_a_final_that_both_teams_have_left_has_no_winner_and_places_below_move_up(more, places):
    one = season(f"  cup: {{stage: knock_out{more}}}\n", names(4), "", {"t01": {"cup": 2}, "t02": {"cup": 2}})
    cup = play(one).stages[0]
    assert (cup.ties[-1].teams, cup.ties[-1].winner, cup.ties[-1].decided_by) == (("t01", "t02"), "", "forfeit")
    assert [(row.team, row.place) for row in cup.places] == places


@pytest.mark.parametrize("more", ["", ", third_place: true", ", legs: 2", ", best_of: 3"])
@pytest.mark.parametrize("count", [1, 2, 3, 4])
def test_a_knock_out_ends_although_both_teams_of_ties_have_left(more, count):
    stages = f"  cup: {{stage: knock_out{more}}}\n"
    ties = season(stages, names(8)).state({}).stages[0].ties[:count]
    one = season(stages, names(8), "", {team: {"cup": 1} for tie in ties for team in tie.teams})
    cup = play(one).stages[0]
    assert cup.status == "finished"
    assert cup.expected_matches == len(cup.fixtures)
    staying = set(names(8)) - {team for tie in ties for team in tie.teams}
    assert {row.team for row in cup.places} == staying
    assert sorted(row.place for row in cup.places)[:1] == [1] * (count < 4)


def test_a_team_that_advanced_by_forfeit_and_then_left_stays_the_winner_of_that_tie():
    one = season("  cup: {stage: knock_out}\n", names(4), "", {"t04": {"cup": 1}, "t01": {"cup": 2}})
    cup = play(one).stages[0]
    assert [tie.winner for tie in cup.ties] == ["t01", "t02", "t02"]
    assert order(cup.places)[:2] == ["t02", "t01"]


def test_two_that_leave_before_their_play_off_share_the_place():
    stages = "  league: {stage: round_robin, play_off: true}\n  final: {stage: knock_out, from: league, places: 1-1}\n"
    one = season(stages, names(2), "tie_breaks: [points]\n")
    outcomes = {fixture.id: Outcome((1.0, 1.0)) for fixture in one.state({}).open_fixtures()}
    left = {team: one.state(outcomes).last_rounds(team) for team in names(2)}
    league = season(stages, names(2), "tie_breaks: [points]\n", left).state(outcomes).stages[0]
    assert (league.status, [row.place for row in league.places]) == ("finished", [1, 1])


@pytest.mark.parametrize("head", [ANNULLED, LOST])
def test_a_swiss_stage_goes_on_without_it_and_keeps_what_it_has_played(head):
    stages = "  swiss: {stage: swiss, rounds: 3}\n"
    one, outcomes = left_after(stages, head, 6, "t01", 1)
    state = play(one, by_strength, outcomes)
    swiss = state.stages[0]
    assert swiss.expected_matches == len(swiss.fixtures) == 3 + 3 + 2
    own = [fixture for fixture in swiss.fixtures if "t01" in teams_of(fixture)]
    # It had been drawn for the second round before it left.
    assert [fixture.round for fixture in own] == [1, 2]
    assert state.outcomes[own[0].id] == outcomes[own[0].id]
    opponent = next(team for team in teams_of(own[1]) if team != "t01")
    row = next(row for row in swiss.places if row.team == opponent)
    later = [fixture for fixture in swiss.fixtures if opponent in teams_of(fixture) and fixture.round != 2]
    assert row.points >= 3
    assert row.played == len(later) + (head == LOST)


def test_its_opponent_in_a_knock_out_advances():
    stages = "  cup: {stage: knock_out}\n"
    one = season(stages, names(4), "", {"t01": {"cup": 1}})
    cup = play(one).stages[0]
    assert (cup.ties[0].winner, cup.ties[0].decided_by, cup.ties[0].fixtures) == ("t04", "forfeit", ())
    assert cup.ties[-1].winner == "t02"


def test_the_next_one_advances_in_place_of_a_team_that_left_before_the_stage_began():
    stages = "  groups: {stage: round_robin}\n  final: {stage: knock_out, from: groups, places: 1-2}\n"
    one = season(stages, names(4), "", {"t01": {"groups": 3}})
    outcomes = {}
    before = season(stages, names(4))
    while before.state(outcomes).stages[0].status != "finished":
        outcomes |= {fixture.id: by_strength(fixture) for fixture in before.state(outcomes).open_fixtures()}
    assert stage(before.state(outcomes), "final").teams == ("t01", "t02")
    assert stage(one.state(outcomes), "final").teams == ("t02", "t03")


def test_open_runs_of_a_challenge_are_annulled_and_the_team_is_not_ranked():
    stages = "  c: {stage: challenge, scenarios: {goals: {scenario: shooter}}, seeds: 2}\n"
    one = season(stages, names(3), "", {"t03": {"c": 1}})
    state = play(one, by_strength, {"c/goals/seed1/t03": Outcome((9.0,), values=(9.0,))})
    assert order(state.stages[0].places) == ["t02", "t01"]


def test_last_rounds_are_those_for_which_a_team_was_drawn():
    stages = "  swiss: {stage: swiss, rounds: 2}\n  cup: {stage: knock_out, from: swiss, places: 1-2}\n"
    one = season(stages, names(4))
    outcomes = {fixture.id: by_strength(fixture) for fixture in one.state({}).open_fixtures()}
    assert one.state(outcomes).last_rounds("t01") == {"swiss": 2}
    assert play(one).last_rounds("t01") == {"swiss": 2, "cup": 1}


def test_a_play_off_that_was_played_stands_when_one_of_its_teams_leaves():
    stages = "  league: {stage: round_robin, play_off: true}\n  final: {stage: knock_out, from: league, places: 1-2}\n"
    head = "tie_breaks: [points]\n"

    def outcome(fixture):
        return by_strength(fixture) if "play_off" in fixture.id else Outcome((0.0, 0.0))

    before = play(season(stages, names(3), head), outcome)
    after = season(stages, names(3), head, {"t01": before.last_rounds("t01")}).state(before.outcomes)
    assert stage(after, "final").teams == stage(before, "final").teams == ("t01", "t02")
    assert after.outcomes == before.outcomes


STAGES = {
    "round_robin": LEAGUE,
    "swiss": "  swiss: {stage: swiss, rounds: 2}\n",
    "knock_out": "  cup: {stage: knock_out, legs: 2}\n",
    "challenge": "  c: {stage: challenge, scenarios: {goals: {scenario: shooter}}}\n",
}


@pytest.mark.parametrize("head", [ANNULLED, LOST])
@pytest.mark.parametrize("stages", STAGES.values(), ids=STAGES)
def test_hidden_matches_of_a_team_that_has_left_stay_open(stages, head):
    before = season(stages, names(4), head)
    first = [one for one in before.state({}).open_fixtures() if one.round == 1]
    outcomes = {one.id: by_strength(one) for one in first}
    after = season(stages, names(4), head, {"t01": before.state(outcomes).last_rounds("t01")})
    hidden = {one.id for one in first if "t01" in teams_of(one)}
    shown = {fixture: outcome for fixture, outcome in outcomes.items() if fixture not in hidden}
    state = after.state(shown, hidden)
    assert not hidden & state.outcomes.keys()
    assert hidden <= {one.id for one in state.open_fixtures()}
