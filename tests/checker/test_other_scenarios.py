"""A submission for another scenario than it is checked for: its files and devices show which one fits."""

from __future__ import annotations

import pytest

from rcj_challenges.checker.archives import inspect
from rcj_challenges.checker.check import CheckOptions, check_file
from rcj_challenges.scenario.load import load, load_text
from tests.checker.alone import ONE_EACH

BLUE = "rcj_soccer_team_blue/rcj_soccer_team_blue.py"
PROGRAM = "x = 1\n"
MATCH = load("match")
QUICK = load("match", ["limits.start_s=10", "limits.step_s=2", *ONE_EACH])


@pytest.fixture
def submission(tmp_path):
    def written(*paths, program=PROGRAM, **files):
        for name, text in {**dict.fromkeys(paths, program), **files, "team_name.txt": "Hanse"}.items():
            path = tmp_path / "team" / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        return tmp_path / "team"

    return written


def layout(path, scenario=MATCH):
    return inspect(path, scenario.scenario).stages[1].findings


def test_programs_for_a_shipped_challenge_get_its_name_before_any_renaming(submission):
    (found,) = layout(submission("pass_ball_yellow/pass_ball_yellow.py", "pass_ball_blue/pass_ball_blue.py"))
    assert (found.code, found.level) == ("layout.missing", "error")
    assert found.help.startswith("it looks like one for pass_the_ball: rcj-challenge check ")
    assert found.help.index("--scenario pass_the_ball") < found.help.index("add or rename")


def test_where_several_fit_all_are_named(submission):
    (found,) = layout(submission("score_goal/score_goal.py"))
    assert "it looks like one for fast_shooter or precision_lidar: " in found.help
    assert "--scenario fast_shooter" in found.help


def test_programs_that_fit_no_shipped_scenario_get_only_the_names_that_they_need(submission):
    (found,) = layout(submission("players/everything.py"))
    assert "looks like one for" not in found.help
    assert found.help.startswith("add or rename the program")


OWN = """\
schema_version: 2
id: match
title: A match of another kind
extends: soccersim_v2
entrants:
  blue: {robots: {B1: player.py, B2: player.py, B3: player.py}}
  yellow: {robots: {Y1: player.py, Y2: player.py, Y3: player.py}}
"""


def test_the_scenario_that_was_asked_for_is_not_proposed_once_more(submission):
    (found,) = layout(submission(BLUE), load_text(OWN))
    assert "for match:" not in found.help
    assert "for match or" not in found.help


FOR_2021 = """\
from controller import Robot
robot = Robot()
receiver = robot.getReceiver("receiver")
receiver.enable(64)
while robot.step(64) != -1:
    pass
"""


def test_program_of_2021_gets_the_scenario_of_its_robots_as_the_first_help(submission):
    paths = [f"robot{number}/robot{number}.py" for number in (1, 2, 3)]
    findings = check_file(submission(*paths, program=FOR_2021), QUICK, CheckOptions()).stages[-2].findings
    assert [finding.code for finding in findings] == ["start.no_device", *["start.crash"] * (len(findings) - 1)]
    assert "--scenario match_2021" in findings[0].help
    assert all('getDevice("receiver")' in crash.help for crash in findings[1:])


YELLOW = "rcj_soccer_team_yellow/rcj_soccer_team_yellow.py"


def never_started(path, scenario=MATCH):
    return [finding for finding in layout(path, scenario) if finding.code == "layout.never_started"]


def test_a_folder_for_the_other_colour_is_reported_as_never_started(submission):
    (found,) = never_started(submission(BLUE, **{YELLOW: "x = 2\n"}))
    assert (found.level, found.where) == ("warning", YELLOW)
    assert BLUE in found.message


def test_one_that_is_the_same_for_both_colours_does_no_harm(submission):
    same = submission(BLUE, YELLOW)
    assert never_started(same) == []
    assert [(found.level, found.where) for found in layout(same) if found.code == "layout.same_program"] == [
        ("passed", YELLOW)
    ]


def test_what_differs_beside_the_program_counts_too(submission):
    (found,) = never_started(submission(BLUE, YELLOW, **{"rcj_soccer_team_yellow/utils.py": "y = 1\n"}))
    assert found.level == "warning"


def test_programs_that_are_started_once_an_empty_one_is_deleted_are_in_use(submission):
    files = {f"robot{number}/robot{number}.py": PROGRAM for number in (1, 2, 3)}
    found = [one for one in layout(submission(**{BLUE: "", **files})) if one.level != "passed"]
    assert [(one.code, one.help) for one in found] == [("layout.empty_entry", "delete it")]


def test_the_other_layout_beside_the_one_that_is_taken_is_never_started(submission):
    others = {f"robot{number}/robot{number}.py": f"x = {number + 1}\n" for number in (1, 2, 3)}
    assert [found.where for found in never_started(submission(BLUE, **others))] == list(others)


@pytest.mark.parametrize(
    "program", ["import sys\nsys.path.append('../rcj_soccer_team_yellow')\n", "from rcj_soccer_team_yellow import x\n"]
)
def test_a_folder_that_a_program_mentions_is_in_use(submission, program):
    assert never_started(submission(BLUE, program=program, **{YELLOW: "x = 2\n"})) == []


@pytest.mark.parametrize("other", ["utils/utils.py", "rcj_soccer_team_yellow/main.py", "shared/helper.py"])
def test_a_library_is_no_program_of_its_own(submission, other):
    assert never_started(submission(BLUE, **{other: "x = 2\n"})) == []


def test_where_both_programs_are_asked_for_none_is_left_over(submission):
    both = submission("pass_ball_yellow/pass_ball_yellow.py", **{"pass_ball_blue/pass_ball_blue.py": "x = 2\n"})
    assert never_started(both, load("pass_the_ball")) == []
