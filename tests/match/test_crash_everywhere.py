"""A crash of a program is shown with its line, and with the same time wherever it is shown."""

import io
import json
import re

import pytest
from rich.console import Console

from rcj_challenges.core.timing import s_from_ticks
from rcj_challenges.records.sensors import read_sensors
from rcj_challenges.scenario.load import load
from rcj_challenges.views.replay import write_replay
from rcj_challenges.views.scoreboard import PlainLines
from rcj_challenges.views.sentences import clock
from tests.match.playing import alone

CRASHES = """
from controller import Robot
robot = Robot()
tick = 0
while robot.step(32) != -1:
    tick += 1
    print("tick", tick)
    if tick == 35:
        print(1 / (tick - 35))
"""
TICK = 35
SENTENCE = "Y1 crashed: ZeroDivisionError: division by zero (robot1/robot1.py, line 9)"


@pytest.fixture(scope="module")
def crashed(shared_place):
    """Return the run and what the terminal showed."""
    terminal = io.StringIO()
    observer = PlainLines(Console(file=terminal, width=200), load("match").scenario)
    overrides = ["match.half_s=2", "match.swap_sides=false", *alone("yellow")]
    run = shared_place.play(*overrides, yellow=shared_place.team_folder(CRASHES), observer=observer)
    return run, terminal.getvalue()


@pytest.fixture(scope="module")
def facts(crashed):
    page = write_replay(crashed[0].folder).read_text("utf-8")
    return json.loads(re.search(r'id="facts">(.*?)</script>', page, re.DOTALL)[1])


def test_result_has_the_tick_in_which_the_program_failed(crashed):
    assert [(fault["robot"], fault["tick"]) for fault in crashed[0].result["faults"]] == [("Y1", TICK)]


def test_list_and_caption_have_its_time_and_line(facts):
    (event,) = [event for event in facts["events"] if event["name"] == "PROGRAM_FAULT"]
    assert event["tick"] == TICK
    assert event["about"] == SENTENCE
    assert SENTENCE in event["caption"]
    assert "print(1 / (tick - 35))" in event["says"]


def test_card_of_the_robot_has_its_time_and_the_whole_traceback(facts):
    ((fault,),) = [half["faults"] for half in facts["halves"]]
    assert fault["tick"] == TICK
    assert "print(1 / (tick - 35))" in fault["detail"]


def test_terminal_has_its_time_and_line(crashed):
    assert f"{clock(s_from_ticks(TICK)):>7}  {SENTENCE}" in crashed[1].splitlines()


def test_log_has_its_time_and_the_whole_traceback(crashed):
    log = crashed[0].log("Y1")
    assert f"[crash] Y1 at tick {TICK} ({s_from_ticks(TICK):.3f} s)" in log
    assert "print(1 / (tick - 35))" in log


def test_output_beside_the_replay_has_its_lines_with_their_ticks(crashed):
    output = read_sensors(crashed[0].folder)[1].robots["Y1"].output
    assert output[:2] == ((1, "tick 1\n"), (2, "tick 2\n"))
    assert output[TICK - 1][0] == TICK
    assert "ZeroDivisionError: division by zero" in "".join(text for tick, text in output if tick == TICK)
