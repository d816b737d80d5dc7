"""What was drawn is kept: other teams or another seed after play are an error, and can be taken on purpose."""

import shutil
from dataclasses import asdict

import pytest

from rcj_challenges.core.diagnostics import DiagnosticError
from rcj_challenges.tournament.played import RulingKind
from rcj_challenges.tournament.redrawing import add_teams, redraw
from rcj_challenges.tournament.rulings import decide
from rcj_challenges.tournament.season import Status
from tests.tournament.store_helpers import LEAGUE, Home, code_of
from tests.tournament.test_publish_command import publish  # noqa: F401 - a fixture

TEAMS = ("ada", "bee", "cid", "dan", "eve", "fay")
CUP = LEAGUE.replace("{stage: round_robin}", "{stage: round_robin, groups: 2}")
SWISS = LEAGUE.replace("{stage: round_robin}", "{stage: swiss, rounds: 2}")


def add_zoe(home):
    home.hand_in("zoe")


def remove_fay(home):
    shutil.rmtree(home.teams / "fay")


def change_seed(home):
    home.file.write_text(home.file.read_text("utf-8").replace("seed: 7", "seed: 8"), encoding="utf-8")


def change_a_pot(home):
    home.file.write_text(home.file.read_text("utf-8") + "teams: {bee: {pot: 1}}\n", encoding="utf-8")


CHANGES = (add_zoe, remove_fay, change_seed, change_a_pot)


@pytest.mark.parametrize("text", [CUP, SWISS])
@pytest.mark.parametrize("change", CHANGES)
def test_after_play_other_teams_or_another_seed_are_an_error_and_nothing_is_lost(tmp_path, text, change):
    home = Home(tmp_path, text, TEAMS)
    home.play()
    before = played(home)
    change(home)
    for command in (home.state, home.play):
        with pytest.raises(DiagnosticError) as error:
            command()
        assert code_of(error) == "drawn-before"
    assert played(home) == before


LISTED = "groups: {A: [ada, bee, cid], B: [dan, eve, fay]}"


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("groups: 1", "groups: 2"),
        ("groups: 2", "legs: 2, groups: 2"),
        ("legs: 2", "legs: 1"),
        (LISTED, LISTED.replace("cid", "X").replace("dan", "cid").replace("X", "dan")),
        (LISTED, LISTED.replace("A:", "C:")),
    ],
)
def test_after_play_other_groups_or_legs_are_an_error_until_they_are_drawn_again(tmp_path, before, after):
    home = Home(tmp_path, LEAGUE.replace("round_robin}", f"round_robin, {before}}}"), TEAMS)
    home.play()
    home.file.write_text(LEAGUE.replace("round_robin}", f"round_robin, {after}}}"), encoding="utf-8")
    with pytest.raises(DiagnosticError) as error:
        home.state()
    assert code_of(error) == "drawn-before"
    with home.opened() as tournament:
        redraw(tournament)
    assert home.play(cascade=True)[0].stages[0].status is Status.FINISHED


def test_a_late_team_is_added_to_the_group_that_lists_it(tmp_path):
    league = LEAGUE.replace("round_robin}", f"round_robin, {LISTED}}}")
    home = Home(tmp_path, league, TEAMS)
    with home.opened() as tournament:
        first = tournament.state().fixtures[0]
        decide(tournament, first.id, RulingKind.CORRECTED, "as seen", scores=[9, 1])
    home.hand_in("zoe")
    home.file.write_text(league.replace("fay", "fay, zoe"), encoding="utf-8")
    with home.opened() as tournament:
        assert add_teams(tournament, ["zoe"])
    groups = {table.name: {row.team for row in table.rows} for table in home.play()[0].stages[0].tables}
    assert groups == {"A": {"ada", "bee", "cid"}, "B": {"dan", "eve", "fay", "zoe"}}


def played(home):
    with home.opened(writing=False) as tournament:
        return tournament.store.played()


def test_before_anything_is_played_all_may_change(tmp_path):
    home = Home(tmp_path, CUP, TEAMS)
    with home.opened() as tournament:
        tournament.state()
        tournament.keep_drawn()
    for change in CHANGES:
        change(home)
    assert len(home.play()[0].teams) == 6


def test_draws_that_an_older_version_stored_are_read(tmp_path):
    home = Home(tmp_path, SWISS, TEAMS)
    home.play()
    with home.opened() as tournament:
        tournament.store.keep_drawn({**asdict(tournament.drawn), "by_exchanges": False})
    assert home.play()[1].jobs == []


def test_the_order_of_the_file_changes_nothing_after_the_draw(tmp_path):
    home = Home(tmp_path, CUP, TEAMS)
    home.play()
    before = home.tables()
    home.file.write_text(CUP + "teams: {fay: {}, cid: {}}\n", encoding="utf-8")
    assert home.tables() == before


def scores(state, name="league"):
    """Return the scores of a stage by the teams of a pair, the first seat first."""
    return {
        tuple(side.teams[0] for side in one.sides): state.outcomes[one.id]
        for one in state.fixtures
        if one.stage == name and one.id in state.outcomes
    }


@pytest.mark.parametrize("change", CHANGES)
@pytest.mark.parametrize("league", ["{stage: round_robin}", "{stage: round_robin, legs: 2}"])
def test_drawn_again_pairs_that_still_exist_keep_their_matches_and_rulings(tmp_path, change, league):
    home = Home(tmp_path, LEAGUE.replace("{stage: round_robin}", league), TEAMS)
    home.play()
    with home.opened() as tournament:
        ruled, replayed = [one for one in tournament.state().fixtures if one.stage == "league"][:2]
        decide(tournament, replayed.id, RulingKind.REPLAY, "a robot broke", cascade=True)
        decide(tournament, ruled.id, RulingKind.CORRECTED, "as seen", scores=[9, 1], cascade=True)
    before = scores(home.play(cascade=True)[0])
    change(home)
    with home.opened() as tournament:
        redraw(tournament)
    state, executor = home.play(cascade=True)
    after = scores(state)
    staying = {pair: one for pair, one in before.items() if "fay" not in pair or change is not remove_fay}
    assert {pair: after.get(pair) for pair in staying} == staying
    new = sum("zoe" in pair for pair in after)
    assert new == (len(TEAMS) * (2 if "legs" in league else 1) if change is add_zoe else 0)
    assert len(executor.jobs) <= new + 1, "the final may be another one"


def test_of_groups_drawn_again_pairs_that_are_still_in_one_group_keep_their_matches(tmp_path):
    home = Home(tmp_path, CUP, TEAMS)
    before = scores(home.play()[0])
    add_zoe(home)
    with home.opened() as tournament:
        redraw(tournament)
    after = scores(home.play()[0])
    pairs = {pair for pair in before if pair in after or pair[::-1] in after}
    assert pairs
    assert {pair: after[pair] for pair in pairs} == {pair: before[pair] for pair in pairs}


@pytest.mark.parametrize("teams", [TEAMS, TEAMS[:5]])
@pytest.mark.parametrize("league", ["{stage: round_robin}", "{stage: round_robin, legs: 2}"])
def test_a_late_team_meets_all_of_its_group_and_no_other_match_changes(tmp_path, teams, league):
    home = Home(tmp_path, LEAGUE.replace("{stage: round_robin}", league), teams)
    with home.opened() as tournament:
        first = tournament.state().fixtures[0]
        decide(tournament, first.id, RulingKind.CORRECTED, "as seen", scores=[9, 1])
        drawn = tournament.state().stages[0].fixtures
    add_zoe(home)
    with home.opened() as tournament:
        assert add_teams(tournament, ["zoe"]) == ["zoe plays from stage league on"]
        assert add_teams(tournament, ["zoe"]) == []
    state = home.play()[0]
    new = [one for one in state.stages[0].fixtures if one not in drawn]
    legs = 2 if "legs" in league else 1
    opponents = sorted(team for one in new for side in one.sides for team in side.teams if team != "zoe")
    assert opponents == sorted(teams * legs)
    assert set(drawn) < set(state.stages[0].fixtures)
    assert abs(sum(one.sides[0].teams == ("zoe",) for one in new) - len(new) / 2) <= 0.5
    for number in {one.round for one in state.stages[0].fixtures}:
        busy = [side.teams for one in state.stages[0].fixtures if one.round == number for side in one.sides]
        assert len(busy) == len(set(busy))


@pytest.mark.parametrize("late", ["{stage: swiss, rounds: 2}", "{stage: knock_out}", "{stage: round_robin}"])
def test_a_team_too_late_for_one_stage_plays_from_the_next_one_on(tmp_path, late):
    text = LEAGUE.partition("stages:")[0] + f"stages:\n  first: {late}\n  second: {{stage: round_robin}}\n"
    home = Home(tmp_path, text, TEAMS)
    home.play()
    with home.opened() as tournament:
        fixtures = {one.name: [fixture.id for fixture in one.fixtures] for one in tournament.state().stages}
        tournament.store.forget(fixtures["second"])
    before = scores(home.state(), "first")
    add_zoe(home)
    with home.opened() as tournament:
        (line,) = add_teams(tournament, ["zoe"])
    assert line == "zoe plays from stage second on; too late for first"
    state = home.play()[0]
    assert scores(state, "first") == before
    assert "zoe" in state.stages[1].teams
    assert state.stages[1].status is Status.FINISHED


def test_a_team_that_is_too_late_for_all_stages_is_refused(tmp_path):
    home = Home(tmp_path, SWISS, TEAMS)
    home.play()
    add_zoe(home)
    with home.opened() as tournament, pytest.raises(DiagnosticError) as error:
        add_teams(tournament, ["zoe"])
    assert code_of(error) == "added-too-late"


def test_a_fuller_site_is_replaced_by_an_emptier_one_only_on_purpose(tmp_path, publish):  # noqa: F811
    home = Home(tmp_path)
    state, _ = home.play()
    assert publish(home)[0] == 0
    with home.opened() as tournament:
        tournament.store.forget([state.fixtures[0].id])
    code, _, err = publish(home)
    assert (code, "error[fewer-matches]" in err) == (2, True)
    assert len([*(home.data / "site" / "matches").iterdir()]) == 4
    assert publish(home, "--fewer")[0] == 0
    assert publish(home)[0] == 0
