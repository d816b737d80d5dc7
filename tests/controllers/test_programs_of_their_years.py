"""What programs of 2021 to 2023 do with Python and numpy, beyond the robot's own interface."""

from __future__ import annotations

from fake_match import FakeMatch

STEPS = """
from controller import Robot
robot = Robot()
"""


def test_a_log_with_times_shows_simulated_ones(match: FakeMatch) -> None:
    program = """
import logging, sys
logging.basicConfig(stream=sys.stdout, level=logging.DEBUG, format="%(asctime)s %(message)s")
robot.step(32)
logging.info("go")
robot.step(32)
"""
    said = match.play(STEPS + program, 2).said
    assert said == ["2024-01-01 00:00:00,032 go"]


def test_functions_of_the_time_module_stay_functions_in_a_class(match: FakeMatch) -> None:
    program = """
import time
class Clock:
    now, stamp, parts, text = time.time, time.strftime, time.localtime, time.asctime
print(Clock().now() > 0, Clock().stamp("%Y"), Clock().parts(0).tm_year, Clock().text())
robot.step(32)
"""
    assert match.play(STEPS + program, 1).said == ["True 2024 1970 Mon Jan  1 00:00:00 2024"]


def test_names_that_numpy_had_in_those_years_are_there(match: FakeMatch) -> None:
    program = """
import numpy as np
print(np.Inf, np.NINF, np.NaN, np.float(3), np.int(4.5), np.product([2, 3]), np.math.floor(2.5), np.cumproduct([2, 2]))
print([np.float64(1.5)])
robot.step(32)
"""
    assert match.play(STEPS + program, 1).said == ["inf -inf nan 3.0 4 6 2 [2 4]", "[1.5]"]


def test_an_array_of_one_number_is_a_number(match: FakeMatch) -> None:
    program = """
import math
import numpy as np
state = np.array([[0.5], [0.0]])
print(math.atan2(state[1], state[0]), float(state[0]))
robot.step(32)
"""
    said = match.play(STEPS + program, 1).said
    assert said[-1] == "0.0 0.5", said  # after warnings that it will not stay so


def test_a_thread_may_do_the_stepping_and_time_passes_for_it(match: FakeMatch) -> None:
    program = """
import threading, time
def drive():
    robot.step(32)
    began = time.time()
    time.sleep(0.1)
    while time.time() - began < 0.101:
        pass
    print("slept", round(time.time() - began, 2))
    robot.step(32)
    robot.step(32)
threading.Thread(target=drive).start()
"""
    played = match.play(STEPS + program, 3)
    assert played.said == ["slept 0.1"]
    assert [request.missed_ticks for _, request in played.requests][:2] == [0, 3]


def test_lines_that_ask_for_the_folder_of_webots_do_no_harm(match: FakeMatch) -> None:
    program = """
import os, sys
sys.path.append(os.path.join(os.environ["WEBOTS_HOME"], "lib", "controller", "python39"))
print("there")
robot.step(32)
"""
    assert match.play(STEPS + program, 1).said == ["there"]
