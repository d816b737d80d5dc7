"""What a human referee decides."""

import pytest

from rcj_challenges.core.diagnostics import DiagnosticError
from rcj_challenges.tournament.played import RulingKind, read_played
from rcj_challenges.tournament.rulings import decide, withdraw
from rcj_challenges.tournament.season import Ruled, Status
from tests.tournament.store_helpers import LEAGUE, Home, code_of

CHALLENGE = """
tournament_version: 1
title: Test challenge
seed: 7
teams_folder: teams
stages:
  shots: {stage: challenge, scenarios: {shooter: {scenario: fast_shooter}}}
"""

CUP = """
tournament_version: 1
title: Test cup
seed: 7
set: {match.half_s: 2, match.halves: 1}
teams_folder: teams
stages: {cup: {stage: knock_out}}
"""


def rule(home, number, kind, reason="as the referee saw it", **more):
    """Decide on a match of the league, by its number; returns its id."""
    fixture = home.state().stages[0].fixtures[number]
    with home.opened() as tournament:
        decide(tournament, fixture.id, kind, reason, **more)
    return fixture


def test_a_corrected_score_counts_and_shows_its_reason(tmp_path):
    home = Home(tmp_path)
    fixture = rule(home, 0, RulingKind.CORRECTED, scores=[9, 1])
    outcome = home.state().outcomes[fixture.id]
    assert (outcome.scores, outcome.ruled, outcome.reason) == ((9, 1), Ruled.CORRECTED, "as the referee saw it")
    assert len(home.play()[1].jobs) == 3, "what is decided is not played"


def test_who_forfeits_loses_by_three_goals(tmp_path):
    home = Home(tmp_path)
    loser = home.state().stages[0].fixtures[0].sides[1].teams[0]
    fixture = rule(home, 0, RulingKind.FORFEIT, losers=[loser])
    assert home.state().outcomes[fixture.id].scores == (3, 0)
    assert home.state().outcomes[fixture.id].ruled is Ruled.FORFEIT


def test_who_forfeits_what_is_played_alone_comes_last(tmp_path):
    home = Home(tmp_path, CHALLENGE)
    fixtures = home.state().stages[0].fixtures
    for number in range(1, len(fixtures)):
        rule(home, number, RulingKind.CORRECTED, scores=[0.0])
    rule(home, 0, RulingKind.FORFEIT, losers=[fixtures[0].sides[0].teams[0]])
    table = home.state().stages[0].tables[-1]
    assert table.rows[-1].team == fixtures[0].sides[0].teams[0]


def test_a_replay_is_played_with_another_seed_and_the_first_record_stays(tmp_path):
    home = Home(tmp_path)
    with pytest.raises(DiagnosticError) as error:
        rule(home, 0, RulingKind.REPLAY)
    assert code_of(error) == "not-played"
    first = home.play()[1].jobs[0]
    fixture = rule(home, 0, RulingKind.REPLAY, cascade=True)
    assert fixture.id not in home.state().outcomes
    again = home.play()[1].jobs[0]
    assert again.seats == first.seats
    assert again.seed != first.seed
    assert (home.data / "records" / first.id).is_dir()
    assert home.play()[1].jobs == []


def test_rulings_are_kept_for_ever_and_the_last_one_holds(tmp_path):
    home = Home(tmp_path)
    fixture = rule(home, 0, RulingKind.CORRECTED, scores=[9, 1])
    rule(home, 0, RulingKind.CORRECTED, "a second look", scores=[1, 9])
    with home.opened(writing=False) as tournament:
        match = read_played(tournament.store).matches[fixture.id]
    assert [(one.scores, one.reason) for one in match.rulings] == [
        ([9, 1], "as the referee saw it"), ([1, 9], "a second look"),
    ]  # fmt: skip
    assert (match.record, dict(match.result), match.played_at) == (None, {}, None)
    assert home.state().outcomes[fixture.id].scores == (1, 9)


def advancing(home):
    return set(home.state().stages[1].teams)


def ruling_that_changes_who_advances(home):
    """Return the number of a league match and scores by which another team advances."""
    before, league = advancing(home), home.state().stages[0]
    left_out = next(team for team in home.state().teams if team not in before)
    numbers = [n for n, one in enumerate(league.fixtures) if any(left_out in side.teams for side in one.sides)]
    scores = [[50, 0] if left_out in league.fixtures[n].sides[0].teams else [0, 50] for n in numbers]
    return list(zip(numbers, scores, strict=True))


def rule_all(home, changes, **more):
    for number, scores in changes:
        rule(home, number, RulingKind.CORRECTED, scores=scores, **more)


def test_a_ruling_that_changes_the_advancing_teams_is_refused_once_the_next_stage_began_unless_it_cascades(tmp_path):
    home = Home(tmp_path)
    home.play()
    before = home.tables()
    changes = ruling_that_changes_who_advances(home)
    with pytest.raises(DiagnosticError) as error:
        rule_all(home, changes)
    assert code_of(error) == "stage-closed"
    assert home.tables()[0][1] == before[0][1], "the final stands"
    rule_all(home, changes, cascade=True)
    assert home.state().stages[1].status is not Status.FINISHED
    assert len(home.play()[1].jobs) == 1, "the final alone is played again"
    assert home.state().stages[1].status is Status.FINISHED


@pytest.mark.parametrize("kind", [RulingKind.CORRECTED, RulingKind.REPLAY])
def test_a_ruling_that_changes_a_later_round_of_its_stage_is_refused_unless_it_cascades(tmp_path, kind):
    home = Home(tmp_path, CUP, ("ada", "bee", "cid", "dee"))
    home.play()
    (final,) = [one for one in home.state().stages[0].fixtures if one.round == 2]
    semi_final = home.state().stages[0].fixtures[0]
    was_first = semi_final.sides[0].teams[0] in {team for side in final.sides for team in side.teams}
    given = {"scores": [0, 50] if was_first else [50, 0]} if kind is RulingKind.CORRECTED else {}
    with home.opened() as tournament:
        with pytest.raises(DiagnosticError) as error:
            decide(tournament, semi_final.id, kind, "as seen", **given)
        assert code_of(error) == "stage-closed"
        assert tournament.store.rulings() == []
        assert decide(tournament, semi_final.id, kind, "as seen", cascade=True, **given) == [final.id]


def test_a_replay_of_a_forfeited_match_cascades_as_other_rulings_do(tmp_path):
    home = Home(tmp_path)
    first = home.state().stages[0].fixtures[0]
    rule(home, 0, RulingKind.FORFEIT, losers=[first.sides[0].teams[0]])
    home.play()
    (final,) = home.state().stages[1].fixtures
    with home.opened() as tournament:
        with pytest.raises(DiagnosticError) as error:
            decide(tournament, first.id, RulingKind.REPLAY, "both were late")
        assert code_of(error) == "stage-closed"
        assert decide(tournament, first.id, RulingKind.REPLAY, "both were late", cascade=True) == [final.id]
    home.play()
    assert home.state().outcomes[first.id].ruled is Ruled.PLAYED
    assert {stage.status for stage in home.state().stages} == {Status.FINISHED}


def test_a_ruling_that_changes_no_later_round_is_not_refused(tmp_path):
    home = Home(tmp_path, CUP, ("ada", "bee", "cid", "dee"))
    home.play()
    semi_final = home.state().stages[0].fixtures[0]
    scores = [9, 0] if home.state().stages[0].ties[0].winner == semi_final.sides[0].teams[0] else [0, 9]
    with home.opened() as tournament:
        assert decide(tournament, semi_final.id, RulingKind.CORRECTED, "as seen", scores=scores) == []


def test_a_team_that_withdraws_is_marked_and_plays_no_more(tmp_path):
    home = Home(tmp_path)
    with home.opened() as tournament:
        withdraw(tournament, "bee", "the robots are broken")
    assert home.state().teams["bee"].withdrawn
    _, executor = home.play()
    assert not any("Team bee" in job.names.values() for job in executor.jobs)
    with home.opened() as tournament, pytest.raises(DiagnosticError) as error:
        withdraw(tournament, "bee", "once more")
    assert code_of(error) == "withdrawn-twice"


@pytest.mark.parametrize(
    ("given", "code"),
    [
        ({"fixture_id": "league/round1/nobody", "kind": RulingKind.REPLAY}, "unknown-match"),
        ({"kind": RulingKind.FORFEIT, "losers": ["dee"]}, "unknown-team"),
        ({"kind": RulingKind.CORRECTED, "scores": [1]}, "ruling-score"),
        ({"kind": RulingKind.CORRECTED, "scores": [1, 2], "reason": "  "}, "ruling-reason"),
    ],
)
def test_a_ruling_that_cannot_be_made_changes_nothing(tmp_path, given, code):
    home = Home(tmp_path)
    fixture = home.state().stages[0].fixtures[0]
    with home.opened() as tournament, pytest.raises(DiagnosticError) as error:
        decide(tournament, **{"fixture_id": fixture.id, "reason": "because", **given})
    assert code_of(error) == code
    assert home.state().outcomes == {}


def undo(home, fixture, **more):
    with home.opened() as tournament:
        return decide(tournament, fixture.id, RulingKind.UNDONE, "it was another match", **more)


def test_after_a_ruling_is_taken_back_the_played_result_counts_and_both_stay_in_the_history(tmp_path):
    home = Home(tmp_path)
    home.play()
    before = home.tables()
    fixture = rule(home, 0, RulingKind.CORRECTED, scores=before[1][home.state().fixtures[0].id].scores)
    rule(home, 0, RulingKind.CORRECTED, scores=[50, 50], cascade=True)
    undo(home, fixture, cascade=True)
    assert home.state().outcomes[fixture.id].ruled is Ruled.CORRECTED, "the first of two"
    undo(home, fixture)
    with pytest.raises(DiagnosticError) as error:
        undo(home, fixture)
    assert code_of(error) == "nothing-to-undo"
    assert home.play()[1].jobs == []
    assert home.tables() == before
    with home.opened(writing=False) as tournament:
        kinds = [one.kind for one in read_played(tournament.store).matches[fixture.id].rulings]
    assert kinds == ["corrected", "corrected", "undone", "undone"]


@pytest.mark.parametrize("was_played", [False, True])
def test_after_a_replay_is_taken_back_the_first_result_counts_and_is_not_played_again(tmp_path, was_played):
    home = Home(tmp_path)
    home.play()
    before = home.tables()
    fixture = rule(home, 0, RulingKind.REPLAY, cascade=True)
    if was_played:
        home.play()
    undo(home, fixture, cascade=True)
    assert home.play()[1].jobs == []
    assert home.tables() == before


def test_after_a_withdrawal_is_taken_back_all_that_was_played_counts_again(tmp_path):
    home = Home(tmp_path)
    home.play()
    before = home.tables()
    with home.opened() as tournament:
        with pytest.raises(DiagnosticError) as error:
            withdraw(tournament, "bee", "it was not there", undo=True)
        assert code_of(error) == "nothing-to-undo"
        withdraw(tournament, "bee", "the wrong team", cascade=True)
        assert home.state().teams["bee"].withdrawn
        assert withdraw(tournament, "bee", "it is still here", undo=True, cascade=True) == []
        told = [(one.kind, one.reason) for one in read_played(tournament.store).withdrawals["bee"]]
    assert told == [("withdrawn", "the wrong team"), ("undone", "it is still here")]
    assert home.tables() == before


def test_a_match_that_both_forfeit_is_lost_by_both(tmp_path):
    home = Home(tmp_path)
    teams = [side.teams[0] for side in home.state().stages[0].fixtures[0].sides]
    fixture = rule(home, 0, RulingKind.FORFEIT, losers=teams)
    assert home.state().outcomes[fixture.id].ruled is Ruled.DOUBLE_FORFEIT
    rows = {row.team: row for row in home.state().stages[0].tables[0].rows}
    assert [(rows[team].lost, rows[team].drawn, rows[team].points) for team in teams] == [(1, 0, 0)] * 2


def test_a_final_that_both_forfeit_has_no_winner(tmp_path):
    home = Home(tmp_path, CUP, ("ada", "bee", "cid", "dee"))
    home.play()
    number = next(number for number, one in enumerate(home.state().fixtures) if one.round == 2)
    teams = [side.teams[0] for side in home.state().fixtures[number].sides]
    rule(home, number, RulingKind.FORFEIT, losers=teams)
    (cup,) = home.state().stages
    assert (cup.status, cup.ties[-1].winner, cup.ties[-1].decided_by) == (Status.FINISHED, "", "forfeit")
    assert [row.place for row in cup.places] == [1, 1]
    assert {row.team for row in cup.places}.isdisjoint(teams)


@pytest.mark.parametrize("withdrawn", ["", "withdrawn: {lost: [0, 3]}\n"])
def test_a_match_of_a_team_that_has_left_is_not_ruled_on(tmp_path, withdrawn):
    home = Home(tmp_path, LEAGUE + withdrawn)
    fixture = next(one for one in home.state().fixtures if any("bee" in side.teams for side in one.sides))
    with home.opened() as tournament:
        withdraw(tournament, "bee", "the robots are broken")
        with pytest.raises(DiagnosticError) as error:
            decide(tournament, fixture.id, RulingKind.CORRECTED, "a goal", scores=[1, 0])
    assert code_of(error) == "ruling-annulled"
