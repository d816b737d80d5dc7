"""Submissions, versions and files that change while a tournament goes on."""

import json

import pytest

from rcj_challenges.core.diagnostics import DiagnosticError
from rcj_challenges.records.result import versions
from rcj_challenges.tournament.jobs import MatchJob
from rcj_challenges.tournament.played import RulingKind
from rcj_challenges.tournament.reconcile import other_pythons
from rcj_challenges.tournament.rulings import decide
from rcj_challenges.tournament.season import Ruled
from tests.tournament.store_helpers import (
    LEAGUE,
    SUPER_TEAMS,
    FakeExecutor,
    Home,
    code_of,
    let_other_versions_have_played,
)

GROUP_ONLY = LEAGUE.replace("  finals: {stage: knock_out, from: league, places: 1-2}\n", "")


def test_a_replaced_team_plays_only_its_own_matches_again(tmp_path):
    home = Home(tmp_path, GROUP_ONLY)
    home.play()
    home.hand_in("ada", "better")
    _, executor = home.play()
    assert len(executor.jobs) == 2
    assert all("Team ada" in job.names.values() for job in executor.jobs)


def test_each_match_names_its_submission_and_both_are_kept_with_their_times(tmp_path):
    home = Home(tmp_path, GROUP_ONLY)
    home.play()
    home.hand_in("ada", "better")
    home.play()
    with home.opened(writing=False) as tournament:
        came = [row for row in tournament.store.submissions() if row.team == "ada"]
        played = {row.submissions["ada"] for row, _ in tournament.store.played_rows() if "ada" in row.submissions}
        assert len(came) == 2
        assert came[0].received_at < came[1].received_at
        assert played == {came[1].archive}
        assert all((tournament.store.place.submissions / row.file).is_file() for row in came)


def test_the_former_submission_that_comes_back_plays_nothing_twice(tmp_path):
    home = Home(tmp_path, GROUP_ONLY)
    home.play()
    before = home.tables()
    home.hand_in("ada", "better")
    home.play()
    home.hand_in("ada")
    assert home.play()[1].jobs == []
    assert home.tables() == before


def test_a_team_cannot_be_replaced_after_the_next_stage_has_begun(tmp_path):
    home = Home(tmp_path)
    home.play()
    before = home.tables()
    home.hand_in("ada", "better")
    with pytest.raises(DiagnosticError) as error:
        home.play()
    assert code_of(error) == "stage-closed"
    assert home.tables() == before


def test_with_cascade_what_depends_on_a_replaced_team_is_played_again(tmp_path):
    home, fresh = Home(tmp_path / "home"), Home(tmp_path / "fresh")
    home.play()
    for one in (home, fresh):
        one.hand_in("ada", "better")
    home.play(cascade=True)
    fresh.play()
    assert home.tables() == fresh.tables()


def test_a_final_of_before_does_not_count_when_its_pair_comes_back_with_another_program(tmp_path, monkeypatch):
    monkeypatch.setattr(
        "tests.tournament.store_helpers.goals_of",
        lambda job, _: {seat: int(name[-1]) for seat, name in job.names.items()},
    )
    home = Home(tmp_path, teams=())
    for strengths in ({"ada": 3, "bee": 2, "cid": 1}, {"cid": 5}, {"ada": 6, "cid": 1}):
        for team, strength in strengths.items():
            home.hand_in(team, str(strength), f"{team} {strength}")
        state, _ = home.play(cascade=True)
    (final,) = state.stages[1].fixtures
    assert {team for side in final.sides for team in side.teams} == {"ada", "bee"}
    assert sorted(state.outcomes[final.id].scores) == [2, 6]


def test_a_new_name_alone_plays_nothing_again(tmp_path):
    home = Home(tmp_path, GROUP_ONLY)
    home.play()
    home.file.write_text(GROUP_ONLY + "teams: {ada: {name: Countess}}\n", encoding="utf-8")
    assert home.play()[1].jobs == []
    assert home.state().teams["ada"].name == "Countess"


def test_matches_of_other_versions_are_neither_mixed_nor_thrown_away(tmp_path):
    home = Home(tmp_path, GROUP_ONLY)
    home.play()
    let_other_versions_have_played(home, mujoco="3.9.9")
    home.hand_in("ada", "better")
    with pytest.raises(DiagnosticError) as error:
        home.play()
    assert code_of(error) == "other-versions"
    assert len(home.state().outcomes) == 3


def test_another_version_of_python_plays_nothing_again_and_is_named(tmp_path, monkeypatch):
    home = Home(tmp_path, GROUP_ONLY)
    older = versions().model_copy(update={"python": "CPython 3.12.1"})
    with monkeypatch.context() as patch:
        patch.setattr("rcj_challenges.tournament.fixtures.versions", lambda: older)
        home.play()
    assert home.play()[1].jobs == []
    home.hand_in("ada", "better")
    assert len(home.play()[1].jobs) == 2
    with home.opened(writing=False) as tournament:
        assert other_pythons(tournament.store) == ["CPython 3.12.1"]


def test_another_implementation_of_python_is_another_version(tmp_path, monkeypatch):
    home = Home(tmp_path, GROUP_ONLY)
    other = versions().model_copy(update={"python": "PyPy 3.11.13"})
    with monkeypatch.context() as patch:
        patch.setattr("rcj_challenges.tournament.fixtures.versions", lambda: other)
        home.play()
    with pytest.raises(DiagnosticError) as error:
        home.play()
    assert code_of(error) == "other-versions"


def test_a_file_of_the_data_that_is_damaged_is_named(tmp_path):
    home = Home(tmp_path, GROUP_ONLY)
    _, executor = home.play()
    path = home.data / "scenarios" / f"{executor.jobs[0].scenario}.json"
    scenario = json.loads(path.read_bytes())
    path.write_text(json.dumps({**scenario, "title": "Another game"}), encoding="utf-8")
    with home.opened(writing=False) as tournament, pytest.raises(DiagnosticError) as error:
        tournament.store.place.load_scenario(executor.jobs[0].scenario)
    assert code_of(error) == "data-file-missing"


def test_a_scenario_of_version_1_in_the_data_is_read(tmp_path):
    home = Home(tmp_path, GROUP_ONLY)
    _, executor = home.play()
    path = home.data / "scenarios" / f"{executor.jobs[0].scenario}.json"
    scenario = json.loads(path.read_bytes())
    rank = [{"score": "descending"}, {"time": "ascending"}]
    path.write_text(json.dumps({**scenario, "schema_version": 1, "result": {"rank": rank}}), encoding="utf-8")
    with home.opened(writing=False) as tournament:
        loaded = tournament.store.place.load_scenario(executor.jobs[0].scenario)
    assert [one.better for one in loaded.scenario.result.rank] == ["more", "less"]


def test_teams_with_one_name_are_distinguished_and_hostile_names_are_escaped(tmp_path):
    home = Home(tmp_path, GROUP_ONLY, teams=())
    for team, name in {"ada": "Robo", "bee": "ROBO", "cid": "\u202egnp\u202c \x1b[2J🤖", "dee": "מתמטיקה"}.items():
        home.hand_in(team, name=name)
    home.play()
    names = {team: one.name for team, one in home.state().teams.items()}
    assert names == {"ada": "Robo (ada)", "bee": "ROBO (bee)", "cid": "gnp [2J🤖", "dee": "מתמטיקה"}


def test_the_address_of_a_job_does_not_depend_on_names_and_records(tmp_path):
    home = Home(tmp_path, GROUP_ONLY)
    _, executor = home.play(executor=FakeExecutor(None))
    job = executor.jobs[0]
    data = job.to_json()
    assert MatchJob.from_json(json.loads(json.dumps(data))).id == job.id
    assert MatchJob.from_json({**data, "names": {"blue": "x", "yellow": "y"}, "records": "full"}).id == job.id
    assert MatchJob.from_json({**data, "seed": job.seed + 1}).id != job.id


class FewJobs(FakeExecutor):
    def submit(self, job):
        assert len(self.jobs) < 3, "it is played again and again"
        super().submit(job)


def test_a_ruling_on_other_super_teams_does_not_hold_for_those_of_now(tmp_path):
    home = Home(tmp_path, SUPER_TEAMS, ("ada", "bee", "cid", "dee", "eva", "fay"))
    state, _ = home.play()
    (fixture,) = state.stages[0].fixtures
    with home.opened() as tournament:
        decide(tournament, fixture.id, RulingKind.CORRECTED, "as seen", scores=[9, 1])
    home.file.write_text(SUPER_TEAMS.replace("cid]", "dee]").replace("[dee,", "[cid,"), encoding="utf-8")
    state, executor = home.play(executor=FewJobs(None))
    assert len(executor.jobs) == 1
    assert state.outcomes[fixture.id].ruled is Ruled.PLAYED
