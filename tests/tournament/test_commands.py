"""``rcj-challenge tournament …``: exit codes, and what is printed for programs."""

import csv
import io
import json

import pytest

from rcj_challenges.checker.report import FileReport, StageReport
from rcj_challenges.cli.tournament import plan
from rcj_challenges.cli.tournament.status import status
from rcj_challenges.core.code import Code
from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.tournament import admission, executor
from rcj_challenges.tournament.fixtures import JobMaker
from rcj_challenges.tournament.jobs import MatchJob
from tests.cli.in_this_process import here
from tests.tournament.store_helpers import LEAGUE, FakeExecutor, Home, Silent, let_other_versions_have_played


def report(path, level):
    finding = Diagnostic(
        code=Code.named("start.crash"), level=level, message="it crashed", help="", where="", repair=False, details=""
    )
    stage = StageReport(name="start", about="", level=level, skipped="", findings=[finding])
    return FileReport(
        file=path.name, level=level, team="", digest="", repaired=[], stages=[stage], matches=[], wall_s=0.0
    )


class Desk:
    """A home whose commands run here, with matches and checks that are made up.

    Attributes:
        ends: of the jobs of the next command, as for `FakeExecutor`.
        failing: how many of the submissions fail the check.
        checked: how often a submission was checked.
    """

    def __init__(self, folder, monkeypatch, capsys):
        self.home = Home(folder)
        self.ends = {}
        self.failing = 0
        self.checked = 0
        self.executors = []
        self._monkeypatch, self._capsys = monkeypatch, capsys
        monkeypatch.setattr(executor, "LocalExecutor", self._executor)
        monkeypatch.setattr(admission, "check_many", self._check)

    def _executor(self, place, lanes):
        self.executors.append(FakeExecutor(place, self.ends, lanes))
        return self.executors[-1]

    def _check(self, paths, loaded, options, jobs, on_done):
        self.checked += len(paths)
        for number, path in enumerate(paths):
            on_done(report(path, "error" if number < self.failing else "passed"))

    def __call__(self, command, *arguments):
        """Run a command; returns exit code, output, and what it said on stderr."""
        code = here(
            self._monkeypatch, self.home.folder, "tournament", command, "league.yaml", "--data", "data", *arguments
        )
        said = self._capsys.readouterr()
        return code, said.out, said.err

    def json(self, command, *arguments):
        code, out, _ = self(command, *arguments, "--json")
        assert code == 0
        return json.loads(out)


@pytest.fixture
def desk(tmp_path, monkeypatch, capsys):
    return Desk(tmp_path, monkeypatch, capsys)


def test_run_checks_plays_and_prints_progress(desk):
    code, out, _ = desk("run", "--at-once", "1")
    assert code == 0
    lines = out.splitlines()
    assert [line.partition("  ")[0] for line in lines[:4]] == ["check 1/3", "check 2/3", "check 3/3", "1/4"]
    assert [line.split("  ")[1:] for line in lines[:3]] == [[team, "match", "passed"] for team in ("ada", "bee", "cid")]
    assert "about 3 s left" in lines[3]
    assert desk.checked == 3
    assert desk("run")[0] == 0
    assert desk.checked == 3, "a submission is checked once"
    assert desk.executors[1].jobs == []


def test_nothing_is_played_while_a_submission_fails_the_check_unless_it_is_accepted(desk):
    desk.failing = 1
    code, _, err = desk("run")
    assert code == 1
    assert "error[submission-fails]" in err
    assert "--accept ada" in err
    assert str(desk.home.data.name + "/checks") in err
    assert [job for executor in desk.executors for job in executor.jobs] == []
    assert desk("run", "--accept", "ada")[0] == 0
    assert desk("run", "--accept", "zoe")[0] == 2


def test_a_submission_that_fails_for_several_scenarios_is_reported_once_for_each_reason(desk):
    desk.home.file.write_text(
        LEAGUE + "  shots: {stage: challenge, scenarios: {one: {scenario: fast_shooter}, two: {scenario: slalom}}}\n",
        encoding="utf-8",
    )
    desk.failing = 2
    code, _, err = desk("run")
    assert code == 1
    assert err.count("error[submission-fails]") == 2
    assert [err.count(f"--accept {team}") for team in ("ada", "bee", "cid")] == [1, 1, 0]


def test_the_report_of_each_check_is_kept_for_the_team(desk):
    desk("run")
    with desk.home.opened(writing=False) as tournament:
        folders = [
            tournament.store.place.report_folder(row.team, row.archive) for row in tournament.store.submissions()
        ]
    assert all({path.suffix for path in folder.iterdir()} == {".json", ".html"} for folder in folders)


def test_the_same_submission_of_two_teams_is_checked_once_and_both_get_the_report(desk):
    desk.home.file.write_text(
        LEAGUE + "teams: {dan: {sample: ball_chaser}, eva: {sample: ball_chaser}}\n", encoding="utf-8"
    )
    desk.failing = 5
    _, _, err = desk("run", "--sandbox", "off")
    assert desk.checked == 4
    for team in ("ada", "bee", "cid", "dan", "eva"):
        (page,) = (desk.home.data / "checks" / team).rglob("*.html")
        assert page.name in err
        assert json.loads(page.with_suffix(".json").read_text(encoding="utf-8"))["sandbox"] == "off"


def test_two_teams_with_files_of_one_name_both_get_their_report(tmp_path):
    program = "from controller import Robot\nRobot()\n"
    home = Home(tmp_path, LEAGUE + "teams: {ada: {path: a/robot.py}, bee: {path: b/robot.py}}\n", teams=())
    home.teams.mkdir()
    for folder in ("a", "b"):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / "robot.py").write_text(f"{program}# {folder}\n", encoding="utf-8")
    with home.opened() as tournament:
        handed = admission.take_submissions(tournament.loaded.entries.values(), tournament.store)
        tasks = JobMaker(tournament, handed, "off").check_tasks(handed)
        seen = Checked()
        failures = admission.check_submissions(tasks, tournament.store, jobs=2, sandbox="off", observer=seen)
    assert sorted(seen.teams) == ["ada", "bee"]
    assert {one.team: one.report.is_file() for one in failures} == {"ada": True, "bee": True}


class Checked:
    def __init__(self):
        self.teams = []

    def checked(self, team, scenario, level, done, total):
        self.teams.append(team)


def test_a_match_that_could_not_be_played_gives_exit_code_3_and_an_interruption_130(desk):
    desk.ends = {0: "died"}
    assert desk("run")[0] == 3
    assert len(desk.json("status")["failed"]) == 1
    desk.ends = {1: "stop"}
    code, _, err = desk("run")
    assert code == 130
    assert "1 match played" in err
    desk.ends = {}
    assert desk("run")[0] == 0
    assert desk.json("status")["failed"] == []


def test_a_second_run_on_one_file_is_refused_and_status_is_not(desk):
    with desk.home.opened():
        code, _, err = desk("run")
        assert (code, "error[store-in-use]" in err) == (2, True)
        assert desk.json("status")["is_running"]
    assert not desk.json("status")["is_running"]


def test_status_counts_matches_by_stage(desk):
    before = desk.json("status")
    assert [(one["status"], one["done"], one["expected"]) for one in before["stages"]] == [
        ("running", 0, 3), ("waiting", 0, 1),
    ]  # fmt: skip
    desk("run")
    after = desk.json("status")
    assert [(one["status"], one["done"]) for one in after["stages"]] == [("finished", 3), ("finished", 1)]


def test_results_are_the_same_as_json_and_as_csv(desk):
    desk("run")
    results = desk.json("results")
    rows = results["stages"][0]["tables"][0]["rows"]
    tables = list(csv.DictReader(io.StringIO(desk("results", "--csv", "tables")[1])))
    assert [(row["team"], row["points"]) for row in rows] == [(one["team"], float(one["points"])) for one in tables]
    matches = list(csv.DictReader(io.StringIO(desk("results", "--csv", "matches")[1])))
    assert {one["match"] for one in matches} == results["outcomes"].keys()
    assert all(one["digest"] for one in results["outcomes"].values())
    assert desk("results")[0] == 0


def test_a_name_that_a_spreadsheet_would_take_for_a_formula_stays_text(desk):
    desk.home.hand_in("ada", name="=1+1")
    desk("run")
    rows = csv.DictReader(io.StringIO(desk("results", "--csv", "tables")[1]))
    assert {row["name"] for row in rows if row["team"] == "ada"} == {"'=1+1"}


def test_plan_lists_what_is_known_and_what_it_will_take(desk, monkeypatch):
    monkeypatch.setattr(plan, "_measured", lambda _: 4.0)
    planned = desk.json("plan")
    assert [(one["matches"], len(one["known"])) for one in planned["stages"]] == [(3, 3), (1, 0)]
    assert planned["cost"]["matches"] == 4
    assert planned["cost"]["simulated_s"] == 8
    desk("run")
    assert desk.json("plan")["cost"]["simulated_s"] == 0


def test_a_decision_is_recorded_and_shown(desk):
    match = desk.home.state().stages[0].fixtures[0].id
    assert desk("decide", match, "--score", "4:2", "--reason", "a goal was overlooked")[0] == 0
    results = desk.json("results")
    assert results["outcomes"][match]["scores"] == [4, 2]
    assert results["rulings"][0]["reason"] == "a goal was overlooked"
    assert "corrected" in desk("results")[1]


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        ([], "which-decision"),
        (["MATCH"], "which-decision"),
        (["MATCH", "--replay", "--score", "1:0"], "which-decision"),
        (["MATCH", "--withdraw", "ada"], "which-decision"),
        (["MATCH", "--undo", "--replay"], "which-decision"),
        (["--withdraw", "ada", "--replay"], "which-decision"),
        (["MATCH", "--undo", "--reason", "r"], "nothing-to-undo"),
        (["MATCH", "--score", "1:0", "--score", "0:1", "--reason", "r"], "option-given-twice"),
        (["MATCH", "--score", "one:two", "--reason", "r"], "ruling-score"),
        (["MATCH", "--score", "1:2"], "ruling-reason"),
        (["nowhere", "--score", "1:2", "--reason", "r"], "unknown-match"),
        (["--withdraw", "zoe", "--reason", "r"], "unknown-team"),
    ],
)
def test_a_decision_that_cannot_be_made_is_refused_with_a_code(desk, arguments, code):
    match = desk.home.state().stages[0].fixtures[0].id
    status, _, err = desk("decide", *(match if one == "MATCH" else one for one in arguments))
    assert (status, f"error[{code}]" in err) == (2, True)


def test_a_decision_prints_what_it_changes(desk):
    desk("run")
    state = desk.home.state()
    final, match = state.stages[1].ties[0], state.stages[1].fixtures[0].id
    loser = next(team for team in final.teams if team != final.winner)
    forfeit = ("decide", match, "--forfeit", final.winner, "--reason", "r")
    assert f"final: Team {loser} wins instead of Team {final.winner}\n" in desk(*forfeit)[1]
    assert "final: neither team wins instead of" in desk(*forfeit, "--forfeit", loser)[1]
    assert desk("decide", match, "--undo", "--reason", "r")[0] == 0
    assert (
        f"final: Team {final.winner} wins instead of Team {loser}\n"
        in desk("decide", match, "--undo", "--reason", "r")[1]
    )
    out = desk("decide", "--withdraw", loser, "--reason", "r")[1]
    assert out == "recorded: no result changes\n", "it has played all of its matches"
    assert desk.home.state().teams[loser].withdrawn
    assert desk("decide", "--withdraw", loser, "--undo", "--reason", "r")[:2] == (0, out)
    assert not desk.home.state().teams[loser].withdrawn


def test_a_decision_names_the_later_match_that_is_played_again(desk):
    desk("run")
    match, final = desk.home.state().stages[0].fixtures[0].id, desk.home.state().stages[1].fixtures[0].id
    out = desk("decide", match, "--replay", "--reason", "r", "--cascade")[1]
    assert f"{final} is played again by the next run\n" in out
    assert f"{match}: open instead of " in out


def test_verify_distinguishes_same_different_and_not_comparable(desk):
    desk("run")
    assert {one["verdict"] for one in desk.json("verify")} == {"same"}
    desk.ends = {0: "other"}
    code, out, _ = desk("verify", "--json")
    assert code == 1
    assert [one["verdict"] for one in json.loads(out)].count("differs") == 1
    let_other_versions_have_played(desk.home, python="CPython 3.12.1")
    code, out, _ = desk("verify", "--json")
    verified = json.loads(out)
    assert code == 1
    assert sorted(one["verdict"] for one in verified) == ["differs", "same", "same", "same"]
    assert all("CPython 3.12.1" in one["reason"] for one in verified)
    let_other_versions_have_played(desk.home, machine="riscv64")
    verdicts = {one["name"]: one["verdict"] for one in desk.json("verify")}
    assert sorted(verdicts.values()) == ["not_comparable", "same", "same", "same"]


def test_verify_plays_a_sample_or_the_matches_that_are_named(desk):
    desk("run")
    assert len(desk.json("verify", "--sample", "2")) == 2
    match = desk.home.state().stages[0].fixtures[1].id
    assert [one["name"] for one in desk.json("verify", match)] == [match]
    assert desk("verify", "nowhere")[0] == 2


def test_rerun_makes_the_record_again_and_leaves_the_result(desk):
    desk("run")
    before = desk.home.tables()
    fixture = desk.home.state().stages[0].fixtures[0].id
    assert desk("rerun", fixture)[0] == 0
    job = desk.executors[1].jobs[0]
    assert isinstance(job, MatchJob)
    assert job.records == "full"
    assert (desk.home.data / "records" / job.id / "result.json").is_file()
    assert desk.home.tables() == before
    assert desk("run")[0] == 0
    assert desk.executors[2].jobs == [], "the record is whole"


def test_a_rerun_with_another_digest_replaces_nothing(desk):
    desk("run")
    desk.ends = {0: "other"}
    fixture = desk.home.state().stages[0].fixtures[0].id
    assert desk("rerun", fixture)[0] == 1
    desk.ends = {}
    desk("run")
    assert desk.executors[-1].jobs == []


def test_status_shows_from_a_second_terminal_what_is_in_play_and_how_long_the_rest_takes(desk, capsys):
    seen = []

    class Second(Silent):
        def played(self, fixture, outcome, progress, *, is_doubtful):
            status(str(desk.home.file), desk.home.data, json_=True)
            seen.append((fixture.id, json.loads(capsys.readouterr().out)))

    desk.home.play(observer=Second())
    first, second = seen[0], seen[1]
    assert (first[1]["is_running"], len(first[1]["in_play"])) == (True, 2)
    assert first[0] in first[1]["in_play"], "it ended a moment ago"
    assert second[1]["left_s"] == 1.5, "three matches of a second, two at a time"
    assert second[1]["latest"][0]["match"] in (first[0], second[0])
    after = desk.json("status")
    assert (after["is_running"], after["in_play"], after["left_s"]) == (False, [], None)
    assert len(after["latest"]) == 4


def test_status_names_submissions_that_fail_the_check(desk):
    desk.failing = 1
    desk("run")
    assert desk.json("status")["failed_submissions"] == {"ada": "it crashed"}
    desk.home.hand_in("ada", "mended")
    desk.failing = 0
    assert desk("run")[0] == 0
    assert desk.json("status")["failed_submissions"] == {}


def test_plan_counts_extra_time_as_a_range(desk):
    text = LEAGUE.replace(
        "stages:", "drawn: {extra_time: {match.half_s: 2}, tie_scenario: {scenario: slalom}}\nstages:"
    )
    desk.home.file.write_text(text, encoding="utf-8")
    cost = desk.json("plan")["cost"]
    assert (cost["matches"], cost["most_matches"]) == (4, 7), "the final, extra time, and each team by itself"
    assert desk("run")[0] == 0
    cost = desk.json("plan")["cost"]
    assert cost["most_matches"] == cost["matches"]
    assert cost["simulated_s"] == cost["most_simulated_s"] == 0
