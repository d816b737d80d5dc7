"""Names that numpy, scipy and Python had once: a crash over one is told with what to write instead."""

from __future__ import annotations

import pytest

from rcj_challenges.checker.advice.hints import hint_on
from rcj_challenges.controllers.team import open_team
from rcj_challenges.scenario.load import load

SCENARIO = load("match").scenario


@pytest.fixture
def remedy(tmp_path):
    def told(detail, program="x = 1\n"):
        (tmp_path / "robot.py").write_text(program, encoding="utf-8")
        fault = {"kind": "crash", "robot": "B1", "tick": 0, "detail": detail, "traceback": ""}
        with open_team(tmp_path, *SCENARIO.entrants.values()) as team:
            hint = hint_on(SCENARIO, team, fault, "")
        return hint.remedy if hint is not None else ""

    return told


GONE = {
    "AttributeError: `np.mat` was removed in the NumPy 2.0 release. Use `np.asmatrix` instead.": ("1.x", "np.asmatrix"),
    "AttributeError: module 'numpy' has no attribute 'mat'": ("1.x", "np.asmatrix"),
    "ImportError: cannot import name 'mat' from 'numpy' (site-packages/numpy/__init__.py)": ("1.x", "np.asmatrix"),
    "AttributeError: 'numpy.ndarray' object has no attribute 'tostring'": ("numpy", "tobytes"),
    "ValueError: The binary mode of fromstring is removed, use frombuffer instead": ("numpy", "frombuffer"),
    "ImportError: cannot import name 'derivative' from 'scipy.misc' (site-packages)": ("scipy 1.11", "h"),
    "ModuleNotFoundError: No module named 'scipy.misc'": ("scipy", "scipy"),
    "NotImplementedError: `interp2d` has been removed in SciPy 1.14.0. For legacy": (
        "scipy",
        "RegularGridInterpolator",
    ),
    "ImportError: cannot import name 'simps' from 'scipy.integrate' (site-packages)": ("scipy", "simpson"),
    "AttributeError: module 'collections' has no attribute 'Mapping'": ("Python 3.9", "collections.abc.Mapping"),
    "ImportError: cannot import name 'Iterable' from 'collections' (x)": ("Python 3.9", "collections.abc.Iterable"),
    "AttributeError: module 'inspect' has no attribute 'getargspec'": ("Python 3.10", "getfullargspec"),
    "TypeError: Population must be a sequence. For dicts or sets, use sorted(d).": ("Python 3.10", "sorted("),
    "AttributeError: 'array.array' object has no attribute 'tostring'": ("Python 3.8", ".tobytes()"),
    "AttributeError: 'array.array' object has no attribute 'fromstring'": ("Python 3.8", ".frombytes("),
    "OverflowError: Python integer 300 out of bounds for uint8": ("numpy 1.x", "int("),
    "ValueError: The truth value of an empty array is ambiguous. Use `array.size > 0` to check that an array is not "
    "empty.": ("numpy 2.1", ".size > 0"),
    "ValueError: invalid mode: 'rU'": ("Python 3.10", '"r"'),
    "ValueError: setting an array element with a sequence. The requested array has an inhomogeneous shape after 1 "
    "dimensions. The detected shape was (2,) + inhomogeneous part.": ("numpy 1.23", "dtype=object"),
    "AttributeError: 'Driver' object has no attribute 'isAlive'": ("Python 3.8", "is_alive()"),
    "AttributeError: module 'base64' has no attribute 'encodestring'": ("Python 3.8", "encodebytes"),
    "ImportError: cannot import name 'gcd' from 'fractions' (python/fractions.py)": ("Python 3.8", "math.gcd"),
    "AttributeError: module 'asyncio' has no attribute 'coroutine'": ("Python 3.10", "async def"),
    "AttributeError: module 'time' has no attribute 'clock'": ("Python 3.7", "time.perf_counter"),
}


@pytest.mark.parametrize(("detail", "parts"), GONE.items(), ids=range(len(GONE)))
def test_a_name_that_is_gone_is_told_with_who_had_it_and_what_to_write(remedy, detail, parts):
    told = remedy(f"{detail} (robot.py, line 3)")
    assert all(part in told for part in parts), told


def test_a_name_that_came_with_the_star_is_told_too(remedy):
    told = remedy("NameError: name 'mat' is not defined (robot.py, line 2)", "from numpy import *\nmat('1 0')\n")
    assert "asmatrix" in told
    assert remedy("NameError: name 'mat' is not defined (robot.py, line 2)") == ""


def test_an_array_that_is_compared_with_an_empty_list_is_told(remedy):
    detail = "ValueError: operands could not be broadcast together with shapes (2,) (0,)  (robot.py, line 5)"
    told = remedy(detail, "if ball != []:\n    chase()\n")
    assert "numpy 1.24" in told
    assert "len(" in told
    assert remedy(detail) == "", "sums of such arrays were always an error"


@pytest.mark.parametrize(
    "detail",
    [
        "AttributeError: module 'numpy' has no attribute 'asscalars'",
        "AttributeError: `np.cast` was removed in the NumPy 2.0 release. Use `np.asarray(arr, dtype=dtype)` instead.",
        "AttributeError: module 'scipy.signal' has no attribute 'wiener2'",
        "ImportError: cannot import name 'source' from 'numpy' (site-packages/numpy/__init__.py)",
        "ModuleNotFoundError: No module named 'numpy.rec'",
    ],
)
def test_of_other_names_of_numpy_and_scipy_a_successor_is_to_be_looked_for(remedy, detail):
    told = remedy(f"{detail} (robot.py, line 3)")
    assert "older" in told
    assert "successor" in told


@pytest.mark.parametrize(
    "detail",
    [
        "AttributeError: module 'utils' has no attribute 'Mapping'",
        "AttributeError: module 'math' has no attribute 'cube'",
        "AttributeError: 'Robot' object has no attribute 'tostrings'",
        "TypeError: 'numpy.float64' object is not callable",
        "ValueError: invalid mode: 'read'",
        "ValueError: setting an array element with a sequence.",
        "KeyError: 'mat'",
    ],
)
def test_other_crashes_say_nothing_about_versions(remedy, detail):
    assert remedy(f"{detail} (robot.py, line 3)") == ""


def test_who_waits_for_somebody_to_type_is_told_that_nobody_does(remedy):
    program = "speed = input('speed? ')\n"
    assert "nobody types in a match" in remedy("EOFError: EOF when reading a line (robot.py, line 1)", program)
    assert "types" not in remedy("EOFError: Ran out of input (robot.py, line 1)", "import pickle\n")
