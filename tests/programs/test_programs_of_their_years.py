"""What programs of 2021 to 2023 do with Python, numpy and scipy: what has been removed since works for them."""

from __future__ import annotations

import pytest
from fake_match import said_by_each

IMPORTS_OF_EDITORS = """
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

USES: dict[str, tuple[str, list[str]]] = {
    "the time of a log is simulated": (
        """
import logging, sys
logging.basicConfig(stream=sys.stdout, format="%(asctime)s %(message)s")
robot.step(32)
logging.warning("go")
""",
        ["2024-01-01 00:00:00,032 go"],
    ),
    "functions of the time module stay functions in a class": (
        """
import time
class Clock:
    now, stamp, parts, text = time.time, time.strftime, time.localtime, time.asctime
print(Clock().now() > 0, Clock().stamp("%Y"), Clock().parts(0).tm_year, Clock().text())
""",
        ["True 2024 1970 Mon Jan  1 00:00:00 2024"],
    ),
    "names that Python had": (
        """
import base64, collections, inspect, random, threading
print(isinstance([], collections.Sequence), issubclass(dict, collections.Mapping), collections.OrderedDict.__name__)
print(inspect.getargspec(lambda a, b=1: 0).args, base64.encodestring(b"x"), threading.Thread().isAlive())
""",
        ["True True OrderedDict", "['a', 'b'] b'eA==\\n' False"],
    ),
    "random draws from sets and keys": (
        """
import random
places = {"left": 1, "right": 2}
print(sorted(random.sample({1, 2, 3}, 3)), len(random.sample(range(9), 2)), random.Random(1).sample({"a": 1}.keys(), 1))
print(sorted(random.sample(places.keys(), 2)), random.sample({"a": 1}.items(), 1))
""",
        ["[1, 2, 3] 2 ['a']", "['left', 'right'] [('a', 1)]"],
    ),
    "random takes a seed of anything that has a hash": (
        """
import datetime, random
def drawn(seed):
    random.seed(seed)
    return random.random()
now = datetime.datetime.now()
print(drawn(now) == drawn(now), drawn((1, 2)) == drawn((1, 2)), drawn((1, 2)) != drawn((2, 1)), drawn(5) == drawn(5))
print(random.Random((1, 2)).random() == drawn((1, 2)), 0 <= drawn(None) < 1)
""",
        ["True True True True", "True True"],
    ),
    "random takes whole floats for integers": (
        """
import random
print(random.randint(2, 4 / 2), random.randrange(5.0) < 5, random.Random(1).randrange(0, 10.0, 5.0) in (0, 5))
try:
    random.randint(1, 2.5)
except (TypeError, ValueError):
    print("no half numbers")
""",
        ["2 True True", "no half numbers"],
    ),
    "the default of a dataclass is another dataclass or an array, but no list": (
        """
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
try:
    @dataclass
    class Seen:
        seen: list = []
except ValueError as error:
    print(error)
""",
        [
            "Ball(place=Point(x=1.0), speed=array([0., 0.]), seen=[]) Point(x=2.0) Point(x=3.0) Point(x=9.0) Point(x=1.0) True",
            "['place', 'speed', 'drawn', 'seen'] Point(x=4.0)",
            "mutable default <class 'list'> for field seen is not allowed: use default_factory",
        ],
    ),
    "json is read whatever encoding is named": (
        """
import io, json
print(json.loads('{"v": 3}', encoding="utf-8"), json.load(io.StringIO("[1]"), encoding="latin-1"), json.loads("2.5"))
try:
    json.loads("1", encodign="utf-8")
except TypeError as error:
    print("encodign" in str(error))
""",
        ["{'v': 3} [1] 2.5", "True"],
    ),
    "coroutines of generators, and loops as arguments": (
        """
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
    second = yield from asyncio.ensure_future(wait(3))
    word = yield from plain()
    print(first, second, word, inspect.iscoroutinefunction(wait))
async def modern():
    return await wait(1)
loop = asyncio.new_event_loop()
loop.run_until_complete(plan())
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
""",
        ["2 3 plain True", "1", "slept [1, 2] set()", "[1, 'plain'] False"],
    ),
    "a file of settings": (
        """
import configparser, io, warnings
warnings.simplefilter("ignore")
settings = configparser.SafeConfigParser()
settings.readfp(io.StringIO("[motor]\\nspeed = 6"))
print(settings.getint("motor", "speed"))
""",
        ["6"],
    ),
    "members of enumerations are formatted by value, and a StrEnum as today": (
        """
from enum import Enum, IntEnum, IntFlag, StrEnum
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
class New(StrEnum):
    STRIKER = "striker"
role, go = Role.STRIKER, Order.GO
print(f"{role}", "{}".format(role), str(role), "%s" % role, repr(role), Role(f"{role}") is role, f"{role:>9}|", f"{role!s}")
print(f"{go}", f"{go:03d}", str(go), "%s %d" % (go, go), go, repr(go), {"Order.GO": 1}[str(go)])
print(f"{Size.BALL:.2f}", f"{Seen.BALL}", str(Seen.BALL), f"{Own.ONE}", f"{State.SEARCH}", f"{New.STRIKER}", str(New.STRIKER))
import http, signal
print(str(signal.SIGTERM), f"{http.HTTPStatus.OK}", "%d" % http.HTTPStatus.OK)
""",
        [
            "striker striker Role.STRIKER Role.STRIKER <Role.STRIKER: 'striker'> True   striker| Role.STRIKER",
            "3 003 Order.GO Order.GO 3 Order.GO <Order.GO: 3> 1",
            "0.04 1 Seen.BALL own State.SEARCH striker striker",
            "Signals.SIGTERM 200 200",
        ],
    ),
    "an error is printed with etype": (
        """
import io, traceback
printed = io.StringIO()
try:
    1 / 0
except ZeroDivisionError as error:
    traceback.print_exception(etype=type(error), value=error, tb=error.__traceback__, file=printed)
    print(traceback.format_exception(etype=type(error), value=error, tb=None), len(traceback.format_exception(error)) > 1)
    print(traceback.format_exception_only(etype=type(error), value=error) == traceback.format_exception_only(error))
print(printed.getvalue().splitlines()[0], printed.getvalue().splitlines()[-1])
""",
        [
            "['ZeroDivisionError: division by zero\\n'] True",
            "True",
            "Traceback (most recent call last): ZeroDivisionError: division by zero",
        ],
    ),
    "help may be left in a program": (
        """
import contextlib, io
from controller import Motor
with contextlib.redirect_stdout(io.StringIO()) as shown:
    help(Motor.setVelocity)
print("Set the velocity in rad/s" in shown.getvalue())
""",
        ["True"],
    ),
    "a program has a user, a home and a folder of Webots": (
        """
import getpass, os, sys, tempfile
from pathlib import Path
print(getpass.getuser(), Path.home() == Path(os.environ["HOME"]), Path(tempfile.gettempdir()) == Path.home())
sys.path.append(os.path.join(os.environ["WEBOTS_HOME"], "lib", "controller", "python39"))
""",
        ["robot True True"],
    ),
    "names that numpy had": (
        """
import numpy as np
print(np.Inf, np.NINF, np.NaN, np.float(3), np.int(4.5), np.product([2, 3]), np.math.floor(2.5), np.cumproduct([2, 2]))
np.warnings.filterwarnings("ignore", category=np.VisibleDeprecationWarning)
print([np.float64(1.5)], np.unicode(5), np.lib.pad([1], 1))
print(hasattr(np, "no_such_name"), hasattr(np.lib, "no_such_name"), hasattr(np.lib.function_base, "no_such_name"))
""",
        ["inf -inf nan 3.0 4 6 2 [2 4]", "[1.5] 5 [0 1 0]", "False False False"],
    ),
    "numpy's star gives the old names and leaves Python's own alone": (
        """
import builtins, typing
from math import *
import math as pythons
from numpy import *
print(Inf, NaN, product([2, 3]), mat([[1, 2]]).T.shape, type(int(2.5)) is type(1), float is type(1.5))
print(max(3, 5), min(0.2, 0.5), round(2.567, 1), type(round(3.7)).__name__, abs(-3), max([], default=0), bool([]))
covered = set(dir(builtins)) & set(globals())
print(sorted(name for name in covered if name[0] != "_" and globals()[name] is not getattr(builtins, name)))
print(pow is pythons.pow, atan2 is pythons.atan2, math is pythons, typing.List.__name__, sqrt(array([4.0])))
""",
        [
            "inf nan 6 (2, 1) True True",
            "5 0.2 2.6 int 3 0 False",
            "['all', 'any', 'divmod', 'pow', 'sum']",  # pow is that of math
            "True True True List [2.]",
        ],
    ),
    "modules that editors imported are found where they are now": (
        f"""
import warnings
with warnings.catch_warnings():
    warnings.simplefilter("error")
    for line in {IMPORTS_OF_EDITORS.strip().splitlines()}:
        exec(line)
    for line in ("import numpy.lib.no_such_module", "from numpy.lib.function_base import no_such_name"):
        try:
            exec(line)
        except ImportError as error:
            print(error)
""",
        [
            "No module named 'numpy.lib.no_such_module'",
            "cannot import name 'no_such_name' from 'numpy.lib.function_base' (unknown location)",
        ],
    ),
    "packets are made and read by numpy": (
        """
import numpy as np
packet = np.array([0.5, 2.0], dtype=np.float32).tobytes()
read = np.fromstring(packet, dtype=np.float32)
read[0] += 1  # what is read may be changed
print(len(packet), read, np.fromstring("1 2", sep=" "))
""",
        ["8 [1.5 2. ] [1. 2.]"],
    ),
    "an array of one number is a number": (
        """
import math, warnings
import numpy as np
warnings.simplefilter("ignore")  # it will not stay so
state = np.array([[0.5], [0.0]])
print(math.atan2(state[1], state[0]), float(state[0]))
""",
        ["0.0 0.5"],
    ),
    "numpy stacks what is no list": (
        """
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
""",
        [
            "[[1, 2], [3, 4]] [[1, 2], [3, 4]] [1 2]",
            "[[1, 2], [3, 4]] (1, 1, 2) (2, 1)",
            "(2, 1) (2, 2) [[1]] [[1]]",
            "not a number",
        ],
    ),
    "arrays take parts of different lengths and copy what has to be": (
        """
import numpy as np
from numpy import array
ragged = np.array([[1, 2], [3]])
print(ragged.dtype, ragged.shape, ragged[0], array([[0, 1], None]).tolist(), np.asarray([(1, 2), 3]).dtype)
print(np.array([1, 2], copy=False), np.array((1, 2), float, copy=False).dtype, np.array(object=[1], ndmin=2).shape)
print(np.array([[1, 2], [3, 4]]).dtype, np.array([1, "a"]).dtype, np.array([1], "f").dtype, np.array(3).ndim)
for wrong in (lambda: np.array([[1], [2, 3]], dtype=float), lambda: np.array(["x"], float), np.array):
    try:
        wrong()
    except (TypeError, ValueError) as error:
        print(str(error)[:30])
""",
        [
            "object (2,) [1, 2] [[0, 1], None] object",
            "[1 2] float64 (1, 1)",
            "int64 <U21 float32 0",
            "setting an array element with ",
            "could not convert string to fl",
            "array() missing required argum",
        ],
    ),
    # Before all others that need scipy: it imports nothing but scipy itself.
    "scipy gives the names of numpy": (
        """
import scipy
from scipy import array, dot, pi
import scipy as sp
print(round(pi, 2), dot(array([1, 2]), array([3, 4])), scipy.sqrt(-4), sp.mean([1, 2]), sp.inf)
try:
    scipy.no_such_name
except AttributeError as error:
    print(type(error).__name__)
print(scipy.linalg.norm([3, 4]))
from scipy import *
print(array([1, 2]).mean(), sqrt(-4), linalg is scipy.linalg, max(3, 5))
""",
        ["3.14 11 2j 1.5 inf", "AttributeError", "5.0", "1.5 2j True 5"],
    ),
    "names that scipy had": (
        """
import warnings
warnings.simplefilter("ignore")
from scipy.misc import derivative
from scipy.integrate import cumtrapz, simps
print(round(derivative(lambda x: x**3, 2.0, dx=1e-3), 3), round(derivative(lambda x: x**4, 1.0, dx=1e-2, n=2, order=5), 3))
print(simps([0, 1, 4]), cumtrapz([0, 2, 4]))
from scipy import stats
from scipy.stats.stats import mode
print(stats.mode([3, 1, 3])[0][0], mode([3, 1, 3]).count[0], stats.mode([3, 3], keepdims=False).mode)
print(stats.mode([[1, 2], [1, 3]])[0][0], stats.mode([[1, 2], [2, 3]], axis=None)[0])
""",
        ["12.0 12.0", "2.6666666666666665 [1. 4.]", "3 2 3", "[1 2] [2]"],
    ),
    # As in the documentation of scipy 1.9: a row for each y, at all pairs.
    "a table of two axes is looked up": (
        """
import numpy as np
from scipy.interpolate import interp2d
from scipy import interpolate
table = interp2d([0, 1, 2], [0, 10], [[0, 1, 2], [10, 11, 12]])
print(table(0.5, 5), table([0, 2], 10), table([1, 0], [10, 0]).tolist(), table(9, 99), interpolate.interp2d is interp2d)
print(interp2d([2, 0, 1], [10, 0], [[12, 10, 11], [2, 0, 1]])(0.5, 5), interp2d([0, 1], [0, 1], [0, 1, 2, 3])(1, 0))
axis = np.arange(5.0)
print(interp2d(axis, axis, np.outer(axis**2, axis), kind="cubic")(1.5, 2.5).round(6))
""",
        ["[5.5] [10. 12.] [[0.0, 1.0], [10.0, 11.0]] [12.] True", "[5.5] [1.]", "[9.375]"],
    ),
}


@pytest.fixture(scope="module")
def said(tmp_path_factory: pytest.TempPathFactory) -> dict[str, list[str]]:
    """What each use prints, all in one process: to import scipy takes a second."""
    return said_by_each(tmp_path_factory.mktemp("years"), {name: program for name, (program, _) in USES.items()})


@pytest.mark.parametrize("use", USES)
def test_programs_of_earlier_years_run_unchanged(said: dict[str, list[str]], use: str) -> None:
    assert said[use] == USES[use][1]
