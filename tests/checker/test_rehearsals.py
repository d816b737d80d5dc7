"""Stages *start* and *play*: real programs in real short matches, reported so that a pupil can act on it."""

from __future__ import annotations

import io
import json
import zipfile
from dataclasses import replace

import pytest
from rich.console import Console

from rcj_challenges.checker import check as check_module
from rcj_challenges.checker import starting
from rcj_challenges.checker.check import CheckOptions, check_file
from rcj_challenges.checker.rehearsal import shortened
from rcj_challenges.checker.report import check_report
from rcj_challenges.checker.report_html import html_page
from rcj_challenges.checker.report_text import print_file
from rcj_challenges.scenario.load import load, load_text
from rcj_challenges.scenario.resources import TEAMS_FOLDER
from tests.checker.alone import ONE_EACH, alone

pytestmark = pytest.mark.usefixtures("sources_read_here")

ENTRY = "rcj_soccer_team_blue/rcj_soccer_team_blue.py"
MATCH = load("match", ["limits.start_s=10", "limits.step_s=1"])
SHORT = CheckOptions(play_s=1.0)
DUEL = load("match", ["limits.start_s=10", "limits.step_s=1", *ONE_EACH])
ALONE = alone("limits.start_s=10", "limits.step_s=1")

BEGIN = """\
from controller import Robot
robot = Robot()
name = robot.getName()
left = robot.getDevice("left wheel motor")
right = robot.getDevice("right wheel motor")
for motor in (left, right):
    motor.setPosition(float("inf"))
    motor.setVelocity(8)
"""
LOOP = "while robot.step(32) != -1:\n    pass\n"


@pytest.fixture
def pack(tmp_path):
    def packed(program, name="team.zip", entry=ENTRY):
        path = tmp_path / name
        with zipfile.ZipFile(path, "w") as archive:
            archive.writestr(entry, program)
            archive.writestr("team_name.txt", "Hanse")
        return path

    return packed


def stage(report, name):
    return next(stage for stage in report.stages if stage.name == name)


def findings(report, name, level=None):
    return [finding for finding in stage(report, name).findings if level in (None, finding.level)]


def test_sound_team_passes_and_every_robot_of_both_sides_is_in_the_report():
    report = check_file(TEAMS_FOLDER / "ball_chaser", MATCH, replace(SHORT, play_s=6.0))
    assert (report.level, report.team, report.file) == ("passed", "Ball Chaser", "ball_chaser")
    assert [stage.level for stage in report.stages] == ["passed"] * 7
    assert findings(report, "start")[0].where == "B1, B2, B3, Y1, Y2, Y3"
    assert [match.seats for match in report.matches] == [["blue"], ["yellow"]]
    assert [match.opponents for match in report.matches] == [{"yellow": "All Sensors"}, {"blue": "Roles and Radio"}]
    robots = [robot for match in report.matches for robot in match.robots]
    assert [robot.robot for robot in robots] == ["B1", "B2", "B3", "Y1", "Y2", "Y3"]
    assert all(robot.path_m > 0.1 and robot.steps == 188 and robot.start_s > 0 for robot in robots)
    assert all(sum(robot.ball_touches for robot in match.robots) > 0 for match in report.matches)


def test_two_checks_of_one_file_see_the_same_match(pack):
    path = pack(BEGIN + LOOP)
    first, second = (check_file(path, DUEL, SHORT) for _ in range(2))
    wall = {"wall_s", "start_s", "step_mean_ms", "step_slowest_ms"}
    assert without(wall, first) == without(wall, second)


def without(keys, report):
    def cleaned(value):
        if isinstance(value, dict):
            return {key: cleaned(inner) for key, inner in value.items() if key not in keys}
        return [cleaned(inner) for inner in value] if isinstance(value, list) else value

    data = cleaned(report.model_dump(mode="json"))
    for finding in data["stages"][-2]["findings"]:
        finding["message"] = finding["message"].partition(", the slowest after")[0]
    return data


def test_a_program_that_fails_at_its_start_is_reported_with_its_traceback_and_is_not_played(pack):
    report = check_file(pack(BEGIN + "if name[0] == 'Y':\n    [][0]\n" + LOOP), MATCH, SHORT)
    (found,) = findings(report, "start", "error")
    assert (found.code, found.where) == ("start.crash", "Y1, Y2, Y3")
    assert "IndexError" in found.message
    assert f'File "{ENTRY}", line 10' in found.details
    assert found.help
    assert "must pass first" in stage(report, "play").skipped
    assert report.matches == []


def test_a_program_that_never_steps_is_reported(pack):
    slow = alone("limits.start_s=1")
    (found,) = findings(check_file(pack("while True:\n    pass\n"), slow, SHORT), "start", "error")
    assert (found.code, found.where) == ("start.start_timeout", "B1")
    assert "robot.step" in found.help


def test_a_device_that_no_robot_has_is_reported_with_the_nearest_name(pack):
    report = check_file(pack(BEGIN + "robot.getDevice('ball \\x1b[31mreciever')\n" + LOOP), ALONE, SHORT)
    (found,) = findings(report, "start", "warning")
    assert found.code == "start.no_device"
    assert "\\x1b[31mreciever" in found.message
    assert "ball receiver" in found.help
    assert report.level == "warning"


def test_a_robot_that_fails_in_play_is_reported_with_side_time_and_traceback(pack):
    program = BEGIN + "while robot.step(32) != -1:\n    if robot.getTime() > 0.5 and name == 'B2':\n        1 / 0\n"
    report = check_file(pack(program), MATCH, SHORT)
    (found,) = findings(report, "play", "error")
    assert (found.code, found.where) == ("play.crash", "B2")
    assert found.message.startswith("as blue, after 0.5 s: ZeroDivisionError")
    assert "line 11" in found.details
    assert [robot.fault for match in report.matches for robot in match.robots] == ["", "crash", "", "", "", ""]
    assert len(report.matches) == 2


def test_a_hang_costs_its_limit_once(pack):
    program = BEGIN + "while robot.step(32) != -1:\n    while robot.getTime() > 0.4:\n        pass\n"
    report = check_file(pack(program), load("match", ["limits.step_s=0.3", *ONE_EACH]), SHORT)
    failures = findings(report, "play", "error")
    assert [(found.code, found.where) for found in failures] == [
        ("play.step_timeout", "B1"),
        ("play.step_timeout", "Y1"),
    ]
    assert all("0.3 s" in found.message for found in failures)
    assert all(f'File "{ENTRY}", line 10' in found.details for found in failures)


def test_program_that_is_slow_on_every_step_fails(pack):
    slow = alone("limits.step_s=5", "limits.half_s=10")
    work = "    x = 0\n    while x < 120_000:\n        x += 1\n"
    report = check_file(pack(BEGIN + "while robot.step(32) != -1:\n" + work), slow, SHORT)
    found = findings(report, "play", "error")
    assert {finding.code for finding in found} <= {"play.slow", "play.half_timeout"}
    assert {finding.where for finding in found} == {"B1"}


def test_robots_that_stand_still_and_touch_no_ball_are_a_warning(pack):
    report = check_file(pack(BEGIN.replace("setVelocity(8)", "setVelocity(0)") + LOOP), MATCH, SHORT)
    warnings = findings(report, "play", "warning")
    assert [finding.code for finding in warnings] == ["play.stands", "play.no_touch"] * 2
    assert warnings[0].where == "B1, B2, B3"
    assert report.level == "warning"


def test_robot_that_sleeps_through_the_match_is_reported_without_advice_about_motors(pack):
    program = BEGIN.replace("8)", "0)") + "import time\nrobot.step(32)\ntime.sleep(500)\n" + LOOP
    report = check_file(pack(program), ALONE, replace(SHORT, play_s=3.0))
    warnings = [finding for finding in findings(report, "play", "warning") if finding.code != "play.no_touch"]
    assert [(finding.code, finding.where) for finding in warnings] == [("play.absent", "B1")]
    assert "took part in 2 of 94 ticks; it slept or waited through the rest" in warnings[0].message
    assert "sleep" in warnings[0].help
    assert "setPosition" not in warnings[0].help


def complaints(report):
    return [finding for finding in findings(report, "play", "warning") if finding.code == "play.complaint"]


def test_a_thread_that_ends_by_an_error_is_a_warning_with_its_last_line(pack):
    program = BEGIN + (
        "import threading\ndef think():\n    raise ValueError('no ball')\nthreading.Thread(target=think).start()\n"
    )
    report = check_file(pack(program + LOOP), DUEL, SHORT)
    warnings = [finding for finding in findings(report, "play", "warning") if finding.code == "play.thread"]
    assert [(finding.message, finding.where) for finding in warnings] == [
        ("as blue, a thread of the program ended by an error: ValueError: no ball", "B1"),
        ("as yellow, a thread of the program ended by an error: ValueError: no ball", "Y1"),
    ]
    assert "in think" in warnings[0].details


def test_calls_that_the_controller_module_refuses_are_warnings(pack):
    program = BEGIN.replace("import Robot", "import Robot, Supervisor") + (
        "second = Robot()\nleft.setVelocity(float('nan'))\n"
        'emitter = robot.getDevice("team emitter")\nemitter.send("")\nemitter.send(bytes(9_000_000))\n'
        'compass = robot.getDevice("compass")\n'
    )
    program += LOOP.replace("pass", "compass.getValues()")
    warnings = complaints(check_file(pack(program), ALONE, SHORT))
    about = ("only one Robot", "setVelocity(NaN)", "it is empty", "9000000 bytes", "not enabled")
    assert [part for part in about if not any(part in finding.message for finding in warnings)] == []
    assert all(finding.help and finding.where == "B1" for finding in warnings)


def test_what_a_program_itself_prints_about_warnings_is_its_own_business(pack):
    program = BEGIN + 'print("Warning: the goalie is asleep: wake him")\nprint("Warning: not enabled")\n'
    program += 'print("Error: no ball")\nprint("Error: goalie: asleep")\n'
    program += "print(\"Error: 'gps': setVelocity(NaN) is refused.\")\n"
    program += "print('Warning: \"kicker\" device not found. This robot has: gps.')\n" + LOOP
    report = check_file(pack(program), ALONE, SHORT)
    assert complaints(report) == []
    assert "play.no_device" not in {finding.code for stage in report.stages for finding in stage.findings}


def test_output_and_replay_are_there_on_request_and_safe(pack, tmp_path):
    program = BEGIN + "print('\\x1b[2J schön', name)\n" + LOOP
    options = replace(SHORT, replays=tmp_path / "replays", show_output=True)
    report = check_file(pack(program), DUEL, options)
    assert report.started == {}
    assert "\\x1b[2J schön Y1" in report.matches[1].robots[0].output
    assert sorted(path.name for path in (tmp_path / "replays").iterdir()) == ["team-blue.html", "team-yellow.html"]


def test_output_of_a_program_that_fails_at_its_start_is_shown_on_request(pack, tmp_path):
    report = check_file(pack("print('no <ball>')\n" + BEGIN), ALONE, replace(SHORT, show_output=True))
    assert report.matches == []
    assert "no <ball>\n" in report.started["B1"]
    console = Console(file=io.StringIO(), width=200)
    print_file(console, report)
    assert "B1 | no <ball>\n" in console.file.getvalue()
    assert "no &lt;ball&gt;" in html_page(check_report("alone", "Alone", "auto", [report]), tmp_path)


def test_output_is_not_quoted_by_default_and_no_files_remain(pack, tmp_path):
    path = pack(BEGIN + "print('secret')\n" + LOOP)
    report = check_file(path, ALONE, SHORT)
    assert "secret" not in json.dumps(report.model_dump(mode="json"))
    assert list(tmp_path.iterdir()) == [path]


def test_without_play_no_program_is_run(pack):
    report = check_file(pack("1 / 0\n"), MATCH, CheckOptions(play=False))
    assert report.level == "passed"
    assert [bool(stage.skipped) for stage in report.stages] == [False] * 5 + [True] * 2


@pytest.mark.parametrize(
    ("scenario", "team", "robots"),
    [
        ("pass_the_ball", "pass_the_ball", ["Y1", "Y2", "B1", "B2"]),
        ("scenarios/examples/slalom.yaml", "slalom", ["Y3"]),
    ],
)
def test_challenges_of_one_entrant_are_played_once_with_all_their_robots(scenario, team, robots):
    report = check_file(TEAMS_FOLDER / team, load(scenario), SHORT)
    assert report.level != "error"
    assert [finding.code for finding in findings(report, "play", "warning")].count("play.no_touch") <= (
        team != "slalom"
    )
    (match,) = report.matches
    assert match.opponents == {}
    assert [robot.robot for robot in match.robots] == robots
    assert stage(report, "start").findings[-1].where == ", ".join(robots)


TWO_SEATS = """\
schema_version: 2
id: keep_away
title: Keep away
extends: soccersim_v2
match: {half_s: 30}
robots: {B3: null, Y3: null, B2: null, Y2: null}
entrants:
  blue: {robots: {B1: keeper.py, B2: null, B3: null}}
  yellow: {robots: {Y1: chaser.py, Y2: null, Y3: null}}
"""


def test_where_teams_keep_their_sides_a_program_for_one_of_them_is_enough(pack):
    report = check_file(pack(BEGIN + LOOP, entry="chaser.py"), load_text(TWO_SEATS), SHORT)
    (match,) = report.matches
    assert (match.seats, [robot.robot for robot in match.robots]) == (["yellow"], ["Y1"])
    assert match.opponents == {"blue": "robots that stand still"}
    assert report.level != "error"


def test_where_no_sample_team_fits_the_team_plays_against_itself(pack):
    both = TWO_SEATS.replace("keeper.py", "chaser.py")
    report = check_file(pack(BEGIN + LOOP, entry="chaser.py"), load_text(both), SHORT)
    assert [match.opponents for match in report.matches] == [{"yellow": "your own team"}, {"blue": "your own team"}]


def test_a_short_match_has_one_half_and_less_patience():
    short = shortened(MATCH, 10.0).scenario
    assert (short.match.halves, short.match.half_s) == (1, 10.0)
    assert short.limits.half_s == 4 * MATCH.scenario.limits.half_s / 60
    assert shortened(load("fast_shooter"), 500.0).scenario.match.half_s == 120


def test_a_fault_of_ours_is_reported_and_is_no_verdict_on_the_team(pack, monkeypatch):
    def stumble(*_):
        raise KeyError("\x1b[2J")

    monkeypatch.setattr(starting, "check_start", stumble)
    report = check_file(pack(BEGIN + LOOP), MATCH, SHORT)
    (found,) = findings(report, "start")
    assert (found.code, found.level, report.level) == ("check.broken", "unchecked", "unchecked")
    assert report.blocked_by == found.message
    assert "\x1b" not in found.message
    assert report.stages[-1].skipped.endswith("could not be checked")
    monkeypatch.setattr(check_module, "inspect", stumble)
    report = check_file(pack(BEGIN + LOOP), MATCH, SHORT)
    assert (report.stages[0].findings[0].code, report.level) == ("check.broken", "unchecked")


def test_an_interruption_that_a_library_made_an_error_of_ends_the_check(pack, monkeypatch):
    def imported(*_):
        try:
            raise KeyboardInterrupt
        except KeyboardInterrupt:
            raise ImportError("physics")  # noqa: B904 - as imports do that are broken off

    monkeypatch.setattr(check_module, "check_sources", imported)
    with pytest.raises(KeyboardInterrupt):
        check_file(pack(BEGIN + LOOP), MATCH, SHORT)
