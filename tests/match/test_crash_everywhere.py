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


def test_result_and_terminal_have_its_tick_and_line(crashed):
    run, terminal = crashed
    assert [(fault["robot"], fault["tick"]) for fault in run.result["faults"]] == [("Y1", TICK)]
    assert f"{clock(s_from_ticks(TICK)):>7}  {SENTENCE}" in terminal.splitlines()


def test_replay_has_its_time_and_line_in_list_caption_and_card(facts):
    (event,) = [event for event in facts["events"] if event["name"] == "PROGRAM_FAULT"]
    ((fault,),) = [half["faults"] for half in facts["halves"]]
    assert event["tick"] == fault["tick"] == TICK
    assert event["about"] == SENTENCE
    assert SENTENCE in event["caption"]
    for text in (event["says"], fault["detail"]):
        assert "print(1 / (tick - 35))" in text


def test_log_and_output_have_its_time_and_the_whole_traceback(crashed):
    run, _ = crashed
    assert f"[crash] Y1 at tick {TICK} ({s_from_ticks(TICK):.3f} s)" in run.log("Y1")
    assert "print(1 / (tick - 35))" in run.log("Y1")
    output = read_sensors(run.folder)[1].robots["Y1"].output
    assert output[:2] == ((1, "tick 1\n"), (2, "tick 2\n"))
    assert output[TICK - 1][0] == TICK
    assert "ZeroDivisionError: division by zero" in "".join(text for tick, text in output if tick == TICK)
