"""A SuperTeam: one side, three submissions."""

import hashlib

import pytest

from rcj_challenges.match.runner import MatchPlan, play_match
from rcj_challenges.scenario.load import load
from rcj_challenges.submissions.team import SuperTeam, open_team
from tests.match.playing import Place, Run
from tests.match.programs import STAND

PRINTING = "from pathlib import Path\nprint(Path('word.txt').read_text())\n" + STAND


@pytest.fixture(scope="module")
def played(tmp_path_factory):
    """Play blue, a SuperTeam of three that print a word of their own, against a team that stands."""
    loaded = load("match", ["match.halves=2", "match.half_s=0.5"])
    seats = tuple(loaded.scenario.entrants.values())
    place = Place(tmp_path_factory.mktemp("super_team"))
    members = []
    for name in ("Ada", "Bee", "Cid"):
        path = place.team_folder(PRINTING, name=name)
        for number in (1, 2, 3):
            (path / f"robot{number}" / "word.txt").write_text(f"I am {name} {number}", encoding="utf-8")
        members.append(open_team(path, *seats))
    teams = {"blue": SuperTeam(tuple(members)), "yellow": open_team(place.team_folder(STAND), *seats)}
    played = play_match(MatchPlan(loaded, teams, {}, out=place.folder / "runs"))
    return Run(played.folder, played.result), members


def test_each_robot_of_a_super_team_runs_with_the_files_and_the_log_of_its_own_team(played):
    run, _ = played
    assert run.result["faults"] == []
    said = {
        robot: [line for line in run.log(robot).splitlines() if line.startswith("I am")] for robot in ("B1", "B2", "B3")
    }
    assert said == {"B1": ["I am Ada 1"], "B2": ["I am Bee 2"], "B3": ["I am Cid 3"]}


def test_the_result_names_the_members_and_their_programs_and_of_other_teams_none(played):
    run, members = played
    blue, yellow = run.result["entrants"]["blue"], run.result["entrants"]["yellow"]
    assert blue["name"] == "Ada + Bee + Cid"
    assert blue["members"] == [{"name": member.name, "programs": member.digest} for member in members]
    assert blue["programs"] == hashlib.sha256("\n".join(member.digest for member in members).encode()).hexdigest()
    assert yellow["members"] == []


def test_the_members_keep_their_robot_number_when_sides_are_changed(played):
    run, _ = played
    last = {robot: run.log(robot).split("--- half 2")[1] for robot in ("Y1", "Y2", "Y3")}
    assert [name for robot, name in zip(last, ("Ada 1", "Bee 2", "Cid 3"), strict=True) if name in last[robot]] == [
        "Ada 1", "Bee 2", "Cid 3",
    ]  # fmt: skip
