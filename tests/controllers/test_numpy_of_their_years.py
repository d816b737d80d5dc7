"""numpy and scipy as programs of 2021 to 2023 use them: what has been removed or renamed since works for them."""

from __future__ import annotations

import subprocess
import sys

import pytest
from fake_match import FakeMatch

STEPS = """
from controller import Robot
robot = Robot()
"""


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
print(np.unicode(5), np.lib.pad([1], 1))
print(hasattr(np, "no_such_name"), hasattr(np.lib, "no_such_name"), hasattr(np.lib.function_base, "no_such_name"))
robot.step(32)
"""
    assert match.play(STEPS + program, 1).said == ["5 [0 1 0]", "False False False"]


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
print(len(packet), read, np.fromstring("1 2", sep=" "), np.array([3, 8]).ptp())
robot.step(32)
"""
    assert match.play(STEPS + program, 1).said == ["8 [1.5 2. ] [1. 2.] 5"]


def test_methods_of_arrays_are_restored_where_python_has_looked_them_up_before() -> None:
    """Python remembers what it has looked up in a class: by its address, so a method that was freed ended the program."""
    program = """
import numpy
before = [getattr(numpy.ndarray, name, None) is None for name in ("ptp", "tostring") * 3]
del before
from rcj_challenges.controllers.pupil.controller._legacy_numpy import patch_numpy
patch_numpy(numpy)
other_things = [bytearray(72) for _ in range(10_000)]
print(numpy.array([3, 8]).ptp(), len(numpy.array([0.5, 2.0]).tostring()))
"""
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=300, check=False)
    assert (done.stdout, done.stderr, done.returncode) == ("5 16\n", "", 0)


OLD_NAMES = """
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
"""

NAMES_OF_NUMPY = """
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
"""

TABLES = """
import numpy as np
from scipy.interpolate import interp2d
from scipy import interpolate
table = interp2d([0, 1, 2], [0, 10], [[0, 1, 2], [10, 11, 12]])
print(table(0.5, 5), table([0, 2], 10), table([1, 0], [10, 0]).tolist(), table(9, 99), interpolate.interp2d is interp2d)
print(interp2d([2, 0, 1], [10, 0], [[12, 10, 11], [2, 0, 1]])(0.5, 5), interp2d([0, 1], [0, 1], [0, 1, 2, 3])(1, 0))
axis = np.arange(5.0)
print(interp2d(axis, axis, np.outer(axis**2, axis), kind="cubic")(1.5, 2.5).round(6))
"""


@pytest.fixture(scope="module")
def said_with_scipy(tmp_path_factory: pytest.TempPathFactory) -> dict[str, list[str]]:
    """What each of the programs that need scipy prints, of one process: to import scipy takes a second."""
    programs = (NAMES_OF_NUMPY, OLD_NAMES, TABLES)  # the first one imports nothing but scipy itself
    next_one = "print('the next one', flush=True)\n"
    played = FakeMatch(tmp_path_factory.mktemp("scipy")).play(STEPS + next_one.join(programs) + "robot.step(32)\n", 1)
    parts = "\n".join(played.said).split("the next one\n")
    assert len(parts) == len(programs), played.log
    return {program: part.splitlines() for program, part in zip(programs, parts, strict=True)}


def test_names_that_scipy_had_in_those_years_are_there(said_with_scipy: dict[str, list[str]]) -> None:
    said = said_with_scipy[OLD_NAMES]
    assert said == ["12.0 12.0", "2.6666666666666665 [1. 4.]", "3 2 3", "[1 2] [2]"]


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


def test_scipy_gives_the_names_of_numpy_that_it_had(said_with_scipy: dict[str, list[str]]) -> None:
    said = said_with_scipy[NAMES_OF_NUMPY]
    assert said == ["3.14 11 2j 1.5 inf", "AttributeError", "5.0", "1.5 2j True 5"]


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


def test_a_table_of_two_axes_is_looked_up(said_with_scipy: dict[str, list[str]]) -> None:
    """As in the documentation of scipy 1.9: a row for each y, at all pairs."""
    assert said_with_scipy[TABLES] == [
        "[5.5] [10. 12.] [[0.0, 1.0], [10.0, 11.0]] [12.] True",
        "[5.5] [1.]",
        "[9.375]",
    ]
