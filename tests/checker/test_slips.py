"""Slips that every pupil makes once: a check says what to do, where Python's own words do not."""

from __future__ import annotations

import struct
import zipfile
from pathlib import PurePosixPath

import pytest

from rcj_challenges.checker.advice.slips import on_slip
from rcj_challenges.checker.check import CheckOptions, check_file
from rcj_challenges.scenario.load import load, load_text
from tests.checker.alone import ONE_EACH, alone
from tests.checker.small_team import write_team

pytestmark = pytest.mark.usefixtures("sources_read_here")

FOLDER = "rcj_soccer_team_blue/"
BEGIN = "from controller import Robot\nrobot = Robot()\n"
HERE_WITHOUT_ITS_NAME = (
    'leave out "robot1.": base lies beside robot1.py; the folder\'s name is for programs in other folders'
)
LOOP = "while robot.step(32) != -1:\n    pass\n"


@pytest.fixture
def failure(tmp_path):
    """Return the only failure of a program, and of its other files."""
    scenario = alone()

    def failed(program, **others):
        path = tmp_path / "team.zip"
        with zipfile.ZipFile(path, "w") as archive:
            archive.writestr(f"{FOLDER}rcj_soccer_team_blue.py", program)
            archive.writestr("team_name.txt", "Hanse")
            for name, text in others.items():
                archive.writestr(f"{FOLDER}{name}.py", text)
        report = check_file(path, scenario, CheckOptions(play_s=1.0))
        (found,) = [one for stage in report.stages for one in stage.findings if one.level == "failure"]
        return found

    return failed


def test_files_that_import_each_other_are_named(failure):
    found = failure(
        "from ball import Ball\n" + BEGIN + LOOP,
        ball="from player import Player\nclass Ball: pass\n",
        player="from ball import Ball\nclass Player: pass\n",
    )
    assert "circular import" in found.message
    assert found.remedy.startswith("ball.py and player.py import each other, in a circle: move what both need into a ")


def test_a_file_that_stands_before_the_folder_of_its_name_is_told(tmp_path):
    # As a team of 2021 wrote it: robot2 and robot3 find the folder robot1, and robot1 finds itself.
    path = tmp_path / "team.zip"
    begin = "import sys\nsys.path.append('..')\nfrom robot1.base import speed\n"
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("robot1/__init__.py", "")
        archive.writestr("robot1/base.py", "speed = 5\n")
        archive.writestr("team_name.txt", "Hanse")
        for number in (1, 2, 3):
            archive.writestr(f"robot{number}/robot{number}.py", begin + BEGIN + LOOP)
    report = check_file(path, load("match"), CheckOptions(play_s=1.0))
    (found,) = [one for stage in report.stages for one in stage.findings if one.level == "failure"]
    assert found.where == "B1, Y1"
    assert "'robot1' is not a package" in found.message
    assert found.remedy == HERE_WITHOUT_ITS_NAME


def test_of_a_package_that_is_none_nothing_is_guessed():
    detail = "ModuleNotFoundError: No module named 'math.utils'; 'math' is not a package (robot.py, line 1)"
    assert on_slip(detail, {PurePosixPath("robot.py"): b"import math.utils\n"}) == ""


@pytest.mark.parametrize(
    ("line", "told"),
    [
        ("from tools import speed", "tools.py imports itself: "),
        ("import tools\nprint(tools.speed)", "tools.py imports itself: "),
    ],
)
def test_a_file_that_imports_itself_is_named(failure, line, told):
    assert failure("import tools\n" + BEGIN + LOOP, tools=line + "\nspeed = 5\n").remedy.startswith(told)


@pytest.mark.parametrize("outside", ["count = 0", "count: int = 0", "count=0"])
def test_a_variable_that_is_meant_to_be_global_is_named(failure, outside):
    program = BEGIN + outside + "\ndef tick():\n    count += 1\nwhile robot.step(32) != -1:\n    tick()\n"
    assert 'write "global count" as its first line' in failure(program).remedy


@pytest.mark.parametrize("outside", ["counter = 0", "count == 0", "  count = 0", ""])
def test_a_variable_that_is_set_nowhere_else_is_none(outside):
    path = PurePosixPath("robot.py")
    detail = "UnboundLocalError: cannot access local variable 'count' where it is not associated with a value"
    assert on_slip(f"{detail} (robot.py, line 3)", {path: outside.encode()}) == ""


def test_a_function_that_calls_itself_for_ever_is_told_so(failure):
    assert "while loop" in failure(BEGIN + "def run():\n    run()\nrun()\n").remedy


def test_a_number_that_is_none_before_the_first_sample_is_told_so(failure):
    program = BEGIN + "gps = robot.getDevice('gps')\ngps.enable(32)\nx = int(gps.getValues()[0])\n" + LOOP
    assert "before its first sample" in failure(program).remedy


@pytest.mark.parametrize(
    ("lines", "told"),
    [
        ("if gps.getName > 0: pass\n", "a call needs brackets"),
        ("if 0 < gps.getName: pass\n", "a call needs brackets"),
        ("x = gps.getValues[0]\n", "a call needs brackets"),
        ("x, y, z = gps.getValues\n", "a call needs brackets"),
        ("x = [].append[0]\n", "a call needs brackets"),
        ("class Bot:\n    def run(): pass\nBot().run()\n", "def run(self):"),
        ("Robot.getName()\n", "robot = Robot()"),
        ("open('data.txt', 'wb').write(b'\\xfc'); open('data.txt').read()\n", "save the file as UTF-8"),
        ("import pickle; pickle.dumps(1).decode()\n", "get a packet that is no text by receiver.getBytes()"),
        ("b'1,2'.split(',')\n", "data.decode() makes text"),
        ("b'x: ' + 'y'\n", "data.decode() makes text"),
        ("'1,2'.decode()\n", "data.decode() makes text"),
        ("b'1,2'.encode()\n", "data.decode() makes text"),
        ("import struct; struct.unpack('dd', b'xy')\n", "struct.calcsize(format)"),
        ("ball = None; ball[0]\n", "if ball is not None"),
        ("ball = None; x = 1.0 - ball\n", "if ball is not None"),
        ("ball = None\nif ball < 1: pass\n", "if ball is not None"),
        ("ball = None; x, y = ball\n", "if ball is not None"),
        ("ball = None\nfor x in ball: pass\n", "if ball is not None"),
        ("c = robot.getDevice('compass').enable(32)\nc.getValues()\n", 'enable() gives nothing back, so "c" is None'),
        (
            "m = robot.getDevice('left wheel motor').setPosition(float('inf'))  # go\nm.setVelocity(1)\n",
            'so "m" is None',
        ),
        ("x = math.atan2(1, 2)\n", 'write "import math" at the top of rcj_soccer_team_blue.py'),
        ("x = np.array([1])\n", 'write "import numpy as np" at the top of rcj_soccer_team_blue.py'),
        ("x = sqrt(2)\n", 'write "from math import sqrt" at the top of rcj_soccer_team_blue.py'),
        ("x, y = gps.getValues()\n", "three numbers: x, y, z = gps.getValues()"),
        ("d = gps.getValues() - [0, 0, 0]\n", "numpy.array"),
        ("v = 0.5 * gps.getValues()\n", "numpy.array"),
        ("v = gps.getValues() / 2\n", "numpy.array"),
        ("print('x: ' + 1.5)\n", "print('x:', x)"),
        ("for n in range(10 / 2): pass\n", "10 // 2"),
        ("speeds = [1, 2, 3]; speeds[4 / 2]\n", "10 // 2"),
        ("n = int('B1')\n", "robot.getName()[1]"),
        ("breakpoint()\n", "leave out breakpoint()"),
        ("import pdb; pdb.set_trace()\n", "leave out breakpoint()"),
        ("breakpoint()\n", "--debug and the robot's name"),
        ("import math; math.acos(1.0000001)\n", "math.acos(max(-1, min(1, x)))"),
        ("speed = robot.getName()[1] * 2.5\n", "float(x) makes a number of a text"),
        ("print(1.5 + ' m')\n", "str(x) makes text of a number"),
        ("class Bot:\n    def go(speed): pass\nBot().go(5)\n", "def go(self, …):"),
        ("class Bot:\n    def go(): pass\nBot().go(5)\n", "a method has self as its first argument"),
        ("ball = robot.getDevice('ball receiver')\nint(ball.getSignalStrength())\n", "ask getQueueLength() first"),
    ],
)
def test_small_things_that_are_left_out_are_told(failure, lines, told):
    assert told in failure(BEGIN + "gps = robot.getDevice('gps')\n" + lines + LOOP).remedy


@pytest.mark.parametrize(
    ("lines", "told"),
    [
        ("math.atan2(ball, 1)", "is None"),
        ("-ball", "is None"),
        ("float(ball)", "is None"),
        ("int(ball)", "is None"),
        ("abs(ball)", "is None"),
        ("len(ball)", "is None"),
        ("1 in ball", "is None"),
        ("round(ball)", "is None"),
        ("[1, 2][ball]", "is None"),
        ("'x: ' + ball", "is None"),
        ("f'{ball:.2f}'", "is None"),
        ("'%d' % ball", "is None"),
        ("ball[0] = 1", "is None"),
        ("ball()", "is None"),
        ("struct.pack('ff', 1.5, ball)", "None fits no letter"),
        ("struct.pack('i', 'B1')", 'whole numbers for "i"'),
        ("struct.pack('i', 2.5)", 'whole numbers for "i"'),
        ("struct.pack('f', 'B1')", 'whole numbers for "i"'),
        ("int(math.inf)", "beyond its range"),
        ("round(math.inf)", "beyond its range"),
    ],
)
def test_python_s_many_words_for_what_is_not_there_are_all_told(lines, told):
    code = f"import math, struct\nball = None\n{lines}\n"
    with pytest.raises((TypeError, OverflowError, struct.error)) as caught:
        exec(code, {})  # noqa: S102 - the words are those of the Python that runs here
    kind = "struct.error" if caught.type is struct.error else caught.typename
    detail = f"{kind}: {caught.value} (robot.py, line 3)"
    assert told in on_slip(detail, {PurePosixPath("robot.py"): code.encode()})


@pytest.mark.parametrize("words", ["expected 2", "expected 2, got 3"])  # the latter from Python 3.14 on
def test_that_a_position_has_three_numbers_is_told(words):
    detail = f"ValueError: too many values to unpack ({words}) (robot.py, line 1)"
    assert "x, y, z = " in on_slip(detail, {PurePosixPath("robot.py"): b"x, y = gps.getValues()"})


@pytest.mark.parametrize("code", ["x, y = gps.values", "place = gps.getValues()\nx, y = place"])
def test_it_is_told_wherever_the_position_comes_from(code):
    detail = f"ValueError: too many values to unpack (expected 2) (robot.py, line {len(code.splitlines())})"
    assert "x, y, z = " in on_slip(detail, {PurePosixPath("robot.py"): code.encode()})


@pytest.mark.parametrize(
    "code",
    [
        "left, right = speeds.values()",
        "values = [1, 2, 3]\na, b = values",
        "place = gps.getValues()\na, b = places",
        "place = [gps.getValues()[0], 2, 3]\na, b = place",
    ],
)
def test_what_is_no_position_is_not_taken_for_one(code):
    detail = f"ValueError: too many values to unpack (expected 2) (robot.py, line {len(code.splitlines())})"
    assert on_slip(detail, {PurePosixPath("robot.py"): code.encode()}) == ""


def test_that_a_match_has_no_screen_is_told():
    assert "no screen" in on_slip("_tkinter.TclError: no display name and no $DISPLAY (robot.py, line 2)", {})


@pytest.mark.parametrize(
    ("line", "detail"),
    [
        ("speed = signal + 1", "NameError: name 'signal' is not defined"),
        ("speed = spede", "NameError: name 'spede' is not defined. Did you mean: 'speed'?"),
        ("a, b = mates", "ValueError: too many values to unpack (expected 2)"),
    ],
)
def test_of_what_is_no_module_and_no_sensor_nothing_is_said_of_them(line, detail):
    assert on_slip(f"{detail} (robot.py, line 1)", {PurePosixPath("robot.py"): line.encode()}) == ""


@pytest.mark.parametrize(
    "method",
    [
        *("def go(self): pass", "@staticmethod\n    def go(speed): pass", "def come(speed): pass", "pass"),
        "def go(this): this.speed = 3",
    ],
)
def test_a_method_that_is_given_too_much_and_has_self_is_told_nothing_of_it(method):
    detail = "TypeError: Bot.go() takes 1 positional argument but 2 were given (robot.py, line 4)"
    assert on_slip(detail, {PurePosixPath("robot.py"): f"class Bot:\n    {method}\n".encode()}) == ""


@pytest.mark.parametrize(
    ("detail", "told"),
    [
        (
            "TypeError: 'int' object is not callable",
            "what stands before the brackets is no function: is there a variable",
        ),
        (
            "TypeError: 'list' object is not callable",
            "what stands before the brackets is no function: is there a variable",
        ),
        ("AttributeError: type object 'State' has no attribute 'ATTACK'", "the class has no such name"),
        ("RuntimeError: can't start new thread", "start a thread once, before the loop, and not in every step"),
    ],
)
def test_words_of_python_that_do_not_tell_what_is_meant_are_explained(detail, told):
    assert on_slip(f"{detail} (robot.py, line 3)", {PurePosixPath("robot.py"): b""}).startswith(told)


@pytest.mark.parametrize(
    ("key", "told"),
    [
        (
            "robot.getName()",
            '"Y1" is this robot\'s own name: the same program plays for both colours, write an entry for ',
        ),
        (
            "robot.getName()[0]",
            '"Y" is the first letter of "Y1", this robot\'s own name: the same program plays for both',
        ),
    ],
)
def test_a_program_that_knows_the_robots_of_one_colour_only_is_told_of_the_other(tmp_path, key, told):
    lookup = f"{{'B1': 'goalie', 'B2': 'left', 'B3': 'right', 'B': 1}}[{key}]\n"
    path = write_team(tmp_path / "teams" / "team.zip", BEGIN + lookup + LOOP)
    report = check_file(path, load("match", ONE_EACH), CheckOptions(play_s=0.5))
    remedies = {one.remedy for stage in report.stages for one in stage.findings if one.level == "failure"}
    assert [remedy for remedy in remedies if remedy.startswith(told)], remedies


HUNTER_AND_HARE = """\
schema_version: 1
id: hunter
title: Hunter and hare
extends: soccersim_v2
robots: {B2: null, B3: null, Y2: null, Y3: null}
entrants:
  blue: {robots: {B1: hunter.py, B2: null, B3: null}}
  yellow: {robots: {Y1: hare.py, Y2: null, Y3: null}}
"""


@pytest.mark.parametrize(
    ("key", "remedy"),
    [
        ("robot.getName()", '"B1" is this robot\'s own name: write an entry for it'),
        ("robot.getName()[0]", '"B" is the first letter of "B1", this robot\'s own name: write an entry for it'),
    ],
)
def test_a_program_that_drives_one_robot_only_needs_no_entry_for_another(tmp_path, key, remedy):
    path = tmp_path / "team.zip"
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("hunter.py", BEGIN + f"{{'Y1': 1}}[{key}]\n" + LOOP)
        archive.writestr("hare.py", BEGIN + LOOP)
    report = check_file(path, load_text(HUNTER_AND_HARE, []), CheckOptions(play_s=0.5))
    assert [one.remedy for stage in report.stages for one in stage.findings if one.level == "failure"] == [remedy]


@pytest.mark.parametrize("key", ["'ball'", "'Y2'", "'Y'"])
def test_of_any_other_key_that_is_missing_nothing_is_guessed(failure, key):
    assert "own name" not in failure(BEGIN + f"{{}}[{key}]\n" + LOOP).remedy


def test_of_other_crashes_nothing_is_said():
    for detail in (
        *("ZeroDivisionError: division by zero (robot.py, line 3)", "RuntimeError: no ball", ""),
        *("TypeError: '>' not supported between instances of 'str' and 'int'", "TypeError: f() takes 0 positional"),
    ):
        assert on_slip(detail, {}) == ""
