"""``rcj-challenge new team``, ``new robot`` and ``new challenge``."""

import json

import pytest

from rcj_challenges.checker.designs import check_designs
from rcj_challenges.cli.commands import load_app
from rcj_challenges.core.errors import RcjError
from rcj_challenges.programs.debugging import PORT
from rcj_challenges.scenario.designs import judge_designs
from rcj_challenges.scenario.load import load
from rcj_challenges.submissions.team import open_team
from tests.cli.conftest import ONE_ROBOT
from tests.cli.in_this_process import here
from tests.scenario.test_designs import documented_guideline


def new(*words):
    return load_app()(["new", *map(str, words)], standalone_mode=False)


@pytest.fixture
def team(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert new("team", "my_team") == 0
    return tmp_path / "my_team"


def test_a_new_team_plays_and_passes_the_check(team, monkeypatch):
    teams = ("--yellow", "my_team", "--blue", "my_team")
    match = ["run", "match", *teams, "--duration", "0.3", "--halves", "1", *ONE_ROBOT]
    assert here(monkeypatch, team.parent, *match, "--quiet", "--no-replay") == 0
    (result,) = team.parent.glob("runs/*/result.json")
    assert json.loads(result.read_bytes())["faults"] == []
    assert here(monkeypatch, team.parent, "check", "my_team", "--no-play") == 0


def test_it_has_what_vs_code_needs_to_run_debug_and_watch(team):
    launch = json.loads((team / ".vscode" / "launch.json").read_text("utf-8"))
    tasks = json.loads((team / ".vscode" / "tasks.json").read_text("utf-8"))
    names = {one["name"]: one for one in launch["configurations"]}
    assert list(names) == ["run", "debug Y1", "watch live"]
    assert names["debug Y1"]["connect"]["port"] == PORT
    assert names["debug Y1"]["preLaunchTask"] == tasks["tasks"][0]["label"]
    assert tasks["tasks"][0]["problemMatcher"]["background"]["endsPattern"] in f"Y1 waits for VS Code on port {PORT}"


def test_it_is_called_after_its_folder_and_reports_five_commands(team):
    assert (team / "team_name.txt").read_text("utf-8") == "My team\n"
    readme = (team / "README.md").read_text("utf-8")
    assert readme.startswith("# My team\n")
    assert readme.count("`rcj-challenge ") - readme.count("`rcj-challenge teams`") == 5
    assert "TEAM_" not in readme


def test_new_robots_of_a_team_are_within_the_guidelines_of_the_reference(team, monkeypatch):
    assert new("robot", "my_team") == 0
    verdict = judge_designs((team / "robot.yaml").read_bytes(), documented_guideline(), 3, 0.021, {})
    assert verdict.problems == verdict.warnings == []
    with pytest.raises(RcjError):
        new("robot", "my_team")


def test_a_new_team_with_a_design_finds_the_ball_with_the_robots_that_it_designed(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert new("team", "my_team", "--design") == 0
    loaded = load("workshop")
    team = open_team("my_team", *loaded.scenario.entrants.values())
    assert {one.code for one in check_designs(team, loaded).findings} == {"design.cost"}
    robots = ["--set", "robots.B2.idle=true", "--set", "robots.B3.idle=true"]
    match = ["run", "workshop", "--blue", "my_team", "--duration", "2", "--halves", "1", *robots, *ONE_ROBOT]
    assert here(monkeypatch, tmp_path, *match, "--quiet", "--no-replay") == 0
    (result,) = tmp_path.glob("runs/*/result.json")
    assert json.loads(result.read_bytes())["faults"] == []


def test_an_existing_folder_is_left_alone(team):
    (team / "robot.py").write_text("mine", encoding="utf-8")
    with pytest.raises(RcjError, match="exists already; nothing was written"):
        new("team", "my_team")
    assert (team / "robot.py").read_text("utf-8") == "mine"


def test_a_challenge_is_what_one_name_alone_makes(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    new("challenge", "slalom")
    (tmp_path / "slalom.yaml").rename(tmp_path / "first.yaml")
    (tmp_path / "slalom_team" / "robot.py").unlink()
    new("slalom")
    assert (tmp_path / "slalom.yaml").read_bytes() == (tmp_path / "first.yaml").read_bytes()


@pytest.mark.parametrize(
    "words",
    [
        ("team",),
        ("challenge",),
        ("robot",),
        ("car", "x"),
        ("team", "a", "b"),
        ("team", "x", "--from", "empty_field"),
        ("challenge", "x", "--design"),
        ("team", "CON"),
    ],
)
def test_what_makes_no_sense_is_refused_and_nothing_is_written(tmp_path, monkeypatch, words):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(RcjError):
        new(*words)
    assert list(tmp_path.iterdir()) == []
