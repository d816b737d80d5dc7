"""What programs of 2021 to 2023 do with Python and numpy, beyond the robot's own interface."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from fake_match import FakeMatch

from rcj_challenges.controllers.team import open_team

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


_IMPORTS_OF_EDITORS = """
from numpy import *
from numpy.core import Infinity, numeric
from numpy.core.fromnumeric import mean, shape
from numpy.core.function_base import linspace
from numpy.core.multiarray import _reconstruct, array
from numpy.core.numeric import Inf, Infinity, NaN, True_
from numpy.core.records import array
from numpy.core.umath import pi
from numpy.fft.helper import fftfreq
from numpy.fft.pocketfft import fft
from numpy.lib import math, pad
from numpy.lib.arraypad import pad
from numpy.lib.arraysetops import isin, unique
from numpy.lib.function_base import *
from numpy.lib.function_base import angle, average, diff, interp, median, percentile
from numpy.lib.histograms import histogram
from numpy.lib.index_tricks import c_
from numpy.lib.nanfunctions import nanmean
from numpy.lib.npyio import load, save
from numpy.lib.polynomial import poly1d, polyfit
from numpy.lib.scimath import sqrt
from numpy.lib.shape_base import column_stack
from numpy.lib.stride_tricks import broadcast_to, sliding_window_view
from numpy.lib.twodim_base import diag, eye
from numpy.lib.type_check import imag, real
from numpy.lib.ufunclike import fix
from numpy.lib.utils import deprecate
from numpy.linalg.linalg import LinAlgError, norm
from numpy.matrixlib.defmatrix import mat, matrix
import numpy.core, numpy.core._multiarray_umath, numpy.core.numeric as _nx
assert _nx.NaN != _nx.NaN and _nx.dot is dot and max([1, 3]) == 3 and angle(1j) == pi / 2
"""


def test_imports_that_editors_wrote_are_found_where_their_modules_are_now(match: FakeMatch) -> None:
    program = f"""
import warnings
warnings.simplefilter("error")
for line in {_IMPORTS_OF_EDITORS.strip().splitlines()}:
    try:
        exec(line)
    except BaseException as error:
        print(line, type(error).__name__, error)
for line in ("import numpy.lib.no_such_module", "from numpy.lib.function_base import no_such_name"):
    try:
        exec(line)
    except ImportError as error:
        print(error)
robot.step(32)
"""
    said = match.play(STEPS + program, 1).said
    assert said == [
        "No module named 'numpy.lib.no_such_module'",
        "cannot import name 'no_such_name' from 'numpy.lib.function_base' (unknown location)",
    ]


def test_names_that_python_had_in_those_years_are_there(match: FakeMatch) -> None:
    program = """
import base64, collections, inspect, random, threading
print(isinstance([], collections.Sequence), issubclass(dict, collections.Mapping), collections.OrderedDict.__name__)
print(sorted(random.sample({1, 2, 3}, 3)), len(random.sample(range(9), 2)))
print(inspect.getargspec(lambda a, b=1: 0).args, base64.encodestring(b"x"), threading.Thread().isAlive())
robot.step(32)
"""
    said = match.play(STEPS + program, 1).said
    assert said == ["True True OrderedDict", "[1, 2, 3] 2", "['a', 'b'] b'eA==\\n' False"]


def test_help_may_be_left_in_a_program(match: FakeMatch) -> None:
    played = match.play(
        "from controller import Motor, Robot\nrobot = Robot()\nhelp(Motor.setVelocity)\nwhile robot.step(32) != -1:\n    pass\n",
        3,
    )
    assert played.fault is None
    assert any("Set the velocity in rad/s" in line for line in played.said)


def test_a_program_has_a_user_and_a_home(match: FakeMatch) -> None:
    program = """
import getpass, os, tempfile
from pathlib import Path
print(getpass.getuser(), Path.home() == Path(os.environ["HOME"]), Path(tempfile.gettempdir()) == Path.home())
robot.step(32)
"""
    assert match.play(STEPS + program, 1).said == ["robot True True"]


def test_a_file_of_the_team_may_be_called_like_a_module_that_the_match_itself_has_used(
    match: FakeMatch, tmp_path: Path
) -> None:
    (tmp_path / "t").mkdir()
    (tmp_path / "t" / "resource.py").write_text("SPEED = 5\n", encoding="utf-8")
    program = STEPS + "from resource import SPEED\nprint(SPEED)\nrobot.step(32)\n"
    (tmp_path / "t" / "robot.py").write_text(program, encoding="utf-8")
    assert match.play(open_team(tmp_path / "t"), 1).said == ["5"]


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


def test_the_default_of_a_dataclass_may_be_another_dataclass_or_an_array(match: FakeMatch) -> None:
    program = """
import dataclasses
import numpy as np
from dataclasses import dataclass, field
from typing import ClassVar
@dataclass
class Point:
    x: float = 0.0
@dataclass
class Ball:
    home: ClassVar[Point] = Point(9.0)
    place: Point = Point(1.0)
    speed: np.ndarray = np.zeros(2)
    drawn: Point = field(default=Point(3.0), repr=False)
    seen: list = field(default_factory=list)
print(Ball(), Ball(Point(2.0)).place, Ball().drawn, Ball.home, Ball.place, Ball().place is Ball().place)
print([f.name for f in dataclasses.fields(Ball)], dataclasses.replace(Ball(), place=Point(4.0)).place)
robot.step(32)
"""
    assert match.play(STEPS + program, 1).said == [
        "Ball(place=Point(x=1.0), speed=array([0., 0.]), seen=[]) Point(x=2.0) Point(x=3.0) Point(x=9.0) Point(x=1.0) True",
        "['place', 'speed', 'drawn', 'seen'] Point(x=4.0)",
    ]


def test_a_list_as_the_default_of_a_dataclass_is_refused_as_it_was_then(match: FakeMatch) -> None:
    program = """
from dataclasses import dataclass
@dataclass
class Ball:
    seen: list = []
"""
    fault = match.play(STEPS + program, 1).fault
    assert fault is not None
    assert "mutable default <class 'list'> for field seen is not allowed: use default_factory" in fault.detail


def test_chance_takes_its_seed_from_whatever_has_a_hash(match: FakeMatch) -> None:
    program = """
import datetime, random
def drawn(seed):
    random.seed(seed)
    return random.random()
now = datetime.datetime.now()
print(drawn(now) == drawn(now), drawn((1, 2)) == drawn((1, 2)), drawn((1, 2)) != drawn((2, 1)), drawn(5) == drawn(5))
print(random.Random((1, 2)).random() == drawn((1, 2)), 0 <= drawn(None) < 1)
robot.step(32)
"""
    assert match.play(STEPS + program, 1).said == ["True True True True", "True True"]


def test_a_seed_of_the_time_is_the_same_in_every_match(match: FakeMatch) -> None:
    program = """
import datetime, random
robot.step(32)
random.seed(datetime.datetime.now().replace(microsecond=0))
print(random.random())
robot.step(32)
"""
    first, again = (match.play(STEPS + program, 2).said for _ in range(2))
    assert len(first) == 1
    assert first[0].startswith("0.")
    assert again[-1] == first[0]


def test_random_takes_whole_floats_for_integers(match: FakeMatch) -> None:
    program = """
import random
print(random.randint(2, 4 / 2), random.randrange(5.0) < 5, random.Random(1).randrange(0, 10.0, 5.0) in (0, 5))
try:
    random.randint(1, 2.5)
except (TypeError, ValueError):
    print("no half numbers")
robot.step(32)
"""
    assert match.play(STEPS + program, 1).said == ["2 True True", "no half numbers"]


def test_json_is_read_whatever_encoding_is_named(match: FakeMatch) -> None:
    program = """
import io, json
print(json.loads('{"v": 3}', encoding="utf-8"), json.load(io.StringIO("[1]"), encoding="latin-1"), json.loads("2.5"))
try:
    json.loads("1", encodign="utf-8")
except TypeError as error:
    print(error)
robot.step(32)
"""
    said = match.play(STEPS + program, 1).said
    assert said[0] == "{'v': 3} [1] 2.5"
    assert "encodign" in said[1]


def test_coroutines_of_generators_run_beside_those_of_today(match: FakeMatch) -> None:
    program = """
import asyncio, inspect
@asyncio.coroutine
def wait(ticks):
    for _ in range(ticks):
        yield from asyncio.sleep(0)
    return ticks
@asyncio.coroutine
def plain():
    return "plain"
@asyncio.coroutine
def plan():
    first = yield from wait(2)
    task = asyncio.ensure_future(wait(3))
    second = yield from task
    word = yield from plain()
    print(first, second, word, inspect.iscoroutinefunction(wait))
async def modern():
    return await wait(1)
loop = asyncio.new_event_loop()
loop.run_until_complete(plan())
print(loop.run_until_complete(modern()))
loop.close()
loop = asyncio.get_event_loop()
print(loop.run_until_complete(modern()))
async def old():
    queue, lock = asyncio.Queue(3, loop=loop), asyncio.Lock(loop=loop)
    async with lock:
        await queue.put(await asyncio.wait_for(asyncio.sleep(0, "slept", loop=loop), 1, loop=loop))
    done, pending = await asyncio.wait([wait(1), wait(2)], loop=loop)
    print(queue.get_nowait(), sorted(one.result() for one in done), pending)
    print(await asyncio.gather(wait(1), plain(), loop=loop), asyncio.Event(loop=loop).is_set())
loop.run_until_complete(old())
loop.close()
robot.step(32)
"""
    said = match.play(STEPS + program, 1).said
    assert said == ["2 3 plain True", "1", "1", "slept [1, 2] set()", "[1, 'plain'] False"]


def test_a_file_of_settings_is_read_as_it_was_then(match: FakeMatch) -> None:
    program = """
import configparser, io
settings = configparser.SafeConfigParser()
settings.readfp(io.StringIO("[motor]\\nspeed = 6"))
print(settings.getint("motor", "speed"))
robot.step(32)
"""
    assert match.play(STEPS + program, 1).said[-1] == "6"


def test_members_that_are_texts_or_numbers_read_in_texts_as_they_did_then(match: FakeMatch) -> None:
    program = """
from enum import Enum, Flag, IntEnum, IntFlag
class Role(str, Enum):
    STRIKER = "striker"
class Size(float, Enum):
    BALL = 0.042
class Order(IntEnum):
    GO = 3
class Seen(IntFlag):
    BALL = 1
class Own(IntEnum):
    ONE = 1
    def __str__(self):
        return "own"
class State(Enum):
    SEARCH = 1
role, go = Role.STRIKER, Order.GO
print(f"{role}", "{}".format(role), str(role), "%s" % role, repr(role), Role(f"{role}") is role, f"{role:>9}|", f"{role!s}")
print(f"{go}", f"{go:03d}", str(go), "%s %d" % (go, go), go, repr(go), {"Order.GO": 1}[str(go)])
print(f"{Size.BALL:.2f}", f"{Seen.BALL}", str(Seen.BALL), f"{Own.ONE}", f"{State.SEARCH}", str(State.SEARCH))
import http, signal
print(str(signal.SIGTERM), f"{http.HTTPStatus.OK}", "%d" % http.HTTPStatus.OK)
robot.step(32)
"""
    assert match.play(STEPS + program, 1).said == [
        "striker striker Role.STRIKER Role.STRIKER <Role.STRIKER: 'striker'> True   striker| Role.STRIKER",
        "3 003 Order.GO Order.GO 3 Order.GO <Order.GO: 3> 1",
        "0.04 1 Seen.BALL own State.SEARCH State.SEARCH",
        "Signals.SIGTERM 200 200",
    ]


@pytest.mark.skipif(sys.version_info < (3, 11), reason="there is no StrEnum yet")
def test_a_str_enum_of_today_reads_as_it_does_today(match: FakeMatch) -> None:
    program = """
from enum import StrEnum
class Role(StrEnum):
    STRIKER = "striker"
print(f"{Role.STRIKER}", str(Role.STRIKER))
robot.step(32)
"""
    assert match.play(STEPS + program, 1).said == ["striker striker"]


def test_chance_draws_from_the_keys_of_a_dict(match: FakeMatch) -> None:
    program = """
import random
places = {"left": 1, "right": 2}
print(sorted(random.sample(places.keys(), 2)), random.sample({"a": 1}.items(), 1), random.Random(1).sample({"a": 1}.keys(), 1))
robot.step(32)
"""
    assert match.play(STEPS + program, 1).said == ["['left', 'right'] [('a', 1)] ['a']"]


def test_an_error_is_printed_by_the_names_that_its_parts_had_then(match: FakeMatch) -> None:
    program = """
import sys, traceback
try:
    1 / 0
except ZeroDivisionError as error:
    traceback.print_exception(etype=type(error), value=error, tb=error.__traceback__, file=sys.stdout)
    print(traceback.format_exception(etype=type(error), value=error, tb=None), traceback.format_exception(error))
    print(traceback.format_exception_only(etype=type(error), value=error), traceback.format_exception_only(error))
robot.step(32)
"""
    said = match.play(STEPS + program, 1).said
    assert said[0] == "Traceback (most recent call last):"
    assert "ZeroDivisionError: division by zero" in said
    assert said[-2].startswith("['ZeroDivisionError: division by zero\\n'] ['Traceback")
    assert said[-1] == "['ZeroDivisionError: division by zero\\n'] ['ZeroDivisionError: division by zero\\n']"
