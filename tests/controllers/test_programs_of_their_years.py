"""What programs of 2021 to 2023 do with Python and numpy, beyond the robot's own interface."""

from __future__ import annotations

import subprocess
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


def test_names_that_numpy_had_in_those_years_are_there(match: FakeMatch) -> None:
    program = """
import numpy as np
print(np.Inf, np.NINF, np.NaN, np.float(3), np.int(4.5), np.product([2, 3]), np.math.floor(2.5), np.cumproduct([2, 2]))
print([np.float64(1.5)])
robot.step(32)
"""
    assert match.play(STEPS + program, 1).said == ["inf -inf nan 3.0 4 6 2 [2 4]", "[1.5]"]


def test_warnings_are_silenced_by_numpys_own_name_of_the_module(match: FakeMatch) -> None:
    program = """
import numpy as np
np.warnings.filterwarnings("ignore", category=np.VisibleDeprecationWarning)
print(np.PZERO, np.NZERO)
print(np.alen([1, 2]), np.unicode(5), np.cast["int"]([2.7]), np.nbytes[np.int16], np.find_common_type([np.int8], [float]))
print(np.obj2sctype("f8").__name__, np.disp.__name__, np.ERR_WARN, np.MAXDIMS > 31, np.lib.pad([1], 1), np.compat.long(3))
print(hasattr(np, "no_such_name"), hasattr(np.lib, "no_such_name"), hasattr(np.lib.function_base, "no_such_name"))
robot.step(32)
"""
    assert match.play(STEPS + program, 1).said == [
        "0.0 -0.0", "2 5 [2] 2 float64", "float64 disp 1 True [0 1 0] 3", "False False False"
    ]  # fmt: skip


_IMPORTS_OF_EDITORS = """
from numpy import *
from numpy.compat import long, unicode
from numpy.compat.py3k import asbytes
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


def test_numpys_star_gives_the_old_names_and_leaves_pythons_own_alone(match: FakeMatch) -> None:
    program = """
import builtins, typing
from math import *
import math as pythons
from numpy import *
print(Inf, NaN, product([2, 3]), mat([[1, 2]]).T.shape, type(int(2.5)) is type(1), float is type(1.5))
print(max(3, 5), min(0.2, 0.5), round(2.567, 1), type(round(3.7)).__name__, abs(-3), max([], default=0), bool([]))
covered = set(dir(builtins)) & set(globals())
print(sorted(name for name in covered if name[0] != "_" and globals()[name] is not getattr(builtins, name)))
print(pow is pythons.pow, atan2 is pythons.atan2, math is pythons, typing.List.__name__, sqrt(array([4.0])))
robot.step(32)
"""
    said = match.play(STEPS + program, 1).said
    assert said[:2] == ["inf nan 6 (2, 1) True True", "5 0.2 2.6 int 3 0 False"]
    assert said[2] == "['all', 'any', 'divmod', 'pow', 'sum']"  # pow is that of math
    assert said[3] == "True True True List [2.]"


def test_packets_are_made_and_read_by_numpy_as_it_was_done_then(match: FakeMatch) -> None:
    program = """
import numpy as np
packet = np.array([0.5, 2.0], dtype=np.float32).tostring()
read = np.fromstring(packet, dtype=np.float32)
read[0] += 1  # what is read may be changed
print(len(packet), read, np.fromstring("1 2", sep=" "), np.array([3, 8]).ptp(), np.asfarray([1]), np.VisibleDeprecationWarning.__name__)
robot.step(32)
"""
    assert match.play(STEPS + program, 1).said == ["8 [1.5 2. ] [1. 2.] 5 [1.] VisibleDeprecationWarning"]


def test_methods_of_arrays_are_restored_where_python_has_looked_them_up_before() -> None:
    """Python remembers what it has looked up in a class: by its address, so a method that was freed ended the program."""
    program = """
import numpy
before = [getattr(numpy.ndarray, name, None) is None for name in ("ptp", "tostring") * 3]
del before
from rcj_challenges.controllers.pupil.controller._numpy import restore_old_names
restore_old_names(numpy)
other_things = [bytearray(72) for _ in range(10_000)]
print(numpy.array([3, 8]).ptp(), len(numpy.array([0.5, 2.0]).tostring()))
"""
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=60, check=False)
    assert (done.stdout, done.stderr, done.returncode) == ("5 16\n", "", 0)


def test_names_that_scipy_had_in_those_years_are_there(match: FakeMatch) -> None:
    program = """
import warnings
warnings.simplefilter("ignore")
from scipy.misc import derivative
from scipy.integrate import cumtrapz, simps
from scipy.signal import gaussian
print(round(derivative(lambda x: x**3, 2.0, dx=1e-3), 3), round(derivative(lambda x: x**4, 1.0, dx=1e-2, n=2, order=5), 3))
print(simps([0, 1, 4]), cumtrapz([0, 2, 4]), gaussian(3, 1.0).round(3))
from scipy.linalg import pinv2
from scipy.misc import comb, factorial
print(pinv2([[2.0]]), comb(4, 2), factorial(3))
from scipy import stats
from scipy.stats.stats import mode
import numpy as np
print(stats.mode([3, 1, 3])[0][0], mode([3, 1, 3]).count[0], stats.mode([3, 3], keepdims=False).mode)
print(*(tuple(map(list, stats.mode(x))) for x in (["l", "r", "r"], [True, False, True], [], np.array([2, "a", 2], object))))
print(stats.mode([[1, 2], [1, 3]])[0][0], stats.mode([[1, 2], [2, 3]], axis=None)[0], stats.mode([[1, 1, 2]], axis=1)[0])
robot.step(32)
"""
    said = match.play(STEPS + program, 1).said
    assert said[:2] == ["12.0 12.0", "2.6666666666666665 [1. 4.] [0.607 1.    0.607]"]
    assert said[2:4] == ["[[0.5]] 6.0 6.0", "3 2 3"]
    assert said[4:] == ["(['r'], [2]) ([True], [2]) ([], []) ([2], [2])", "[1 2] [2] [[1]]"]


def test_names_that_python_had_in_those_years_are_there(match: FakeMatch) -> None:
    program = """
import base64, collections, fractions, inspect, random, threading
print(isinstance([], collections.Sequence), issubclass(dict, collections.Mapping), collections.OrderedDict.__name__)
print(sorted(random.sample({1, 2, 3}, 3)), len(random.sample(range(9), 2)), fractions.gcd(12, 18))
print(inspect.getargspec(lambda a, b=1: 0).args, base64.encodestring(b"x"), threading.Thread().isAlive())
import array, math
from math import *
from xml.etree import ElementTree
numbers = array.array("h")
numbers.fromstring(bytes([1, 0, 2, 0]))
root = ElementTree.fromstring("<a><b/><c><b/></c></a>")
print(numbers.tostring(), [one.tag for one in root.getchildren()], len(list(root.getiterator("b"))))
print(math.factorial(3.0), factorial(4), type(factorial(3.0)).__name__)
try:
    factorial(2.5)
except (TypeError, ValueError):
    print("no half numbers")
robot.step(32)
"""
    said = match.play(STEPS + program, 1).said
    assert said[:3] == ["True True OrderedDict", "[1, 2, 3] 2 6", "['a', 'b'] b'eA==\\n' False"]
    assert said[3:] == ["b'\\x01\\x00\\x02\\x00' ['b', 'c'] 2", "6 24 int", "no half numbers"]


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


def test_chance_shuffles_and_draws_as_it_did_then(match: FakeMatch) -> None:
    program = """
import random
moves = list(range(9))
random.shuffle(moves, random.random)
print(sorted(moves) == list(range(9)), random.shuffle(moves), random.shuffle([1, 2, 3], lambda: 0.0))
fixed = [1, 2, 3]
random.shuffle(fixed, lambda: 0.0)
print(fixed, random.randint(2, 4 / 2), random.randrange(5.0) < 5, random.Random(1).randrange(0, 10.0, 5.0) in (0, 5))
try:
    random.randint(1, 2.5)
except (TypeError, ValueError):
    print("no half numbers")
robot.step(32)
"""
    assert match.play(STEPS + program, 1).said == ["True None None", "[2, 3, 1] 2 True True", "no half numbers"]


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
    told = asyncio.Task.all_tasks(), asyncio.Task.current_task()
    print(queue.get_nowait(), sorted(one.result() for one in done), pending, told[0] == {told[1]})
    print(await asyncio.gather(wait(1), plain(), loop=loop), asyncio.Event(loop=loop).is_set())
loop.run_until_complete(old())
loop.close()
robot.step(32)
"""
    said = match.play(STEPS + program, 1).said
    assert said == ["2 3 plain True", "1", "1", "slept [1, 2] set() True", "[1, 'plain'] False"]


def test_a_file_of_settings_is_read_as_it_was_then(match: FakeMatch) -> None:
    program = """
import configparser, io
settings = configparser.SafeConfigParser()
settings.readfp(io.StringIO("[motor]\\nspeed = 6"))
print(settings.getint("motor", "speed"))
robot.step(32)
"""
    assert match.play(STEPS + program, 1).said[-1] == "6"


def test_scipy_gives_the_names_of_numpy_that_it_had(match: FakeMatch) -> None:
    program = """
import scipy
from scipy import array, dot, pi
import scipy as sp
print(round(pi, 2), dot(array([1, 2]), array([3, 4])), scipy.sqrt(-4), sp.mean([1, 2]), sp.inf)
try:
    scipy.no_such_name
except AttributeError as error:
    print(type(error).__name__)
print(scipy.linalg.norm([3, 4]))
from scipy import ifft, rand, randn
print(rand(2).shape, randn(3).shape, ifft([4.0]))
from scipy import *
print(array([1, 2]).mean(), sqrt(-4), linalg is scipy.linalg, max(3, 5))
robot.step(32)
"""
    said = match.play(STEPS + program, 1).said
    assert said == ["3.14 11 2j 1.5 inf", "AttributeError", "5.0", "(2,) (3,) [4.+0.j]", "1.5 2j True 5"]


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


def test_numpy_stacks_what_is_no_list(match: FakeMatch) -> None:
    program = """
import numpy as np
from numpy import hstack
rows = {"a": [1, 2], "b": [3, 4]}
print(np.vstack(rows.values()).tolist(), np.stack(row for row in rows.values()).tolist(), hstack(map(list, [[1], [2]])))
print(np.column_stack(zip([1, 2], [3, 4])).tolist(), np.dstack(iter([[1], [2]])).shape, np.row_stack(map(list, [[1], [2]])).shape)
print(np.vstack(([1], [2])).shape, np.stack(np.eye(2), axis=1).shape, np.vstack(tup=[[1]]), np.stack(arrays=[[1]]))
try:
    np.vstack(5)
except TypeError as error:
    print("not a number")
robot.step(32)
"""
    assert match.play(STEPS + program, 1).said == [
        "[[1, 2], [3, 4]] [[1, 2], [3, 4]] [1 2]", "[[1, 2], [3, 4]] (1, 1, 2) (2, 1)", "(2, 1) (2, 2) [[1]] [[1]]",
        "not a number",
    ]  # fmt: skip


def test_a_number_of_an_array_is_set_by_itemset(match: FakeMatch) -> None:
    program = """
import numpy as np
table, flat = np.zeros((2, 2)), np.zeros(3)
table.itemset((0, 1), 5)
table.itemset(1, 0, 7)
table.itemset(3, 9)
flat.itemset(2, 4)
one = np.array(1)
one.itemset(6)
print(table.tolist(), flat, one, np.array([1, 2]).newbyteorder().dtype.byteorder in "<>")
robot.step(32)
"""
    assert match.play(STEPS + program, 1).said == ["[[0.0, 5.0], [7.0, 9.0]] [0. 0. 4.] 6 True"]


def test_arrays_take_parts_of_different_lengths_and_copy_what_has_to_be(match: FakeMatch) -> None:
    program = """
import numpy as np
from numpy import array
ragged = np.array([[1, 2], [3]])
print(ragged.dtype, ragged.shape, ragged[0], array([[0, 1], None]).tolist(), np.asarray([(1, 2), 3]).dtype)
print(np.array([1, 2], copy=False), np.array((1, 2), float, copy=False).dtype, np.array(object=[1], ndmin=2).shape)
print(np.array([[1, 2], [3, 4]]).dtype, np.array([1, "a"]).dtype, np.array([1], "f").dtype, np.array(3).ndim)
for wrong in (lambda: np.array([[1], [2, 3]], dtype=float), lambda: np.array(["x"], float)):
    try:
        wrong()
    except ValueError as error:
        print(str(error)[:30])
try:
    np.array()
except TypeError as error:
    print(error)
robot.step(32)
"""
    assert match.play(STEPS + program, 1).said == [
        "object (2,) [1, 2] [[0, 1], None] object",
        "[1 2] float64 (1, 1)",
        "int64 <U21 float32 0",
        "setting an array element with ",
        "could not convert string to fl",
        "array() missing required argument 'object' (pos 0)",
    ]


def test_a_table_of_two_axes_is_looked_up(match: FakeMatch) -> None:
    """As in the documentation of scipy 1.9: a row for each y, at all pairs."""
    program = """
import numpy as np
from scipy.interpolate import interp2d
from scipy import interpolate
table = interp2d([0, 1, 2], [0, 10], [[0, 1, 2], [10, 11, 12]])
print(table(0.5, 5), table([0, 2], 10), table([1, 0], [10, 0]).tolist(), table(9, 99), interpolate.interp2d is interp2d)
print(interp2d([2, 0, 1], [10, 0], [[12, 10, 11], [2, 0, 1]])(0.5, 5), interp2d([0, 1], [0, 1], [0, 1, 2, 3])(1, 0))
print(interp2d([0, 1], [0, 1], [0, 1, 2, 3], fill_value=-1)([0, 5], 0), end=" ")
axis = np.arange(5.0)
print(interp2d(axis, axis, np.outer(axis**2, axis), kind="cubic")(1.5, 2.5).round(6))
__import__("warnings").simplefilter("ignore")  # fitpack says that it has found no room to be more exact
scattered = interp2d([0, 1, 0, 1, 0.5], [0, 0, 1, 1, 0.5], [0, 1, 2, 3, 1.5])
print(scattered(0.25, 0.25).round(6))
for wrong in (lambda: interp2d([0, 1], [0, 1], [1, 2, 3]), lambda: interp2d([0, 1], [0, 1], [0, 1, 2, 3], bounds_error=True)(3, 0)):
    try:
        wrong()
    except ValueError as error:
        print(error)
robot.step(32)
"""
    assert match.play(STEPS + program, 1).said == [
        "[5.5] [10. 12.] [[0.0, 1.0], [10.0, 11.0]] [12.] True",
        "[5.5] [1.]",
        "[ 0. -1.] [9.375]",
        "[0.75]",
        "x, y, and z must have equal lengths for non rectangular grid",
        "Values out of range; x must be in (0, 1), y in (0, 1)",
    ]
