"""Names that numpy, scipy and Python had once: who had them last, and what to write instead."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import NamedTuple


class _Gone(NamedTuple):
    """A name that is gone.

    Attributes:
        had: what had it last.
        instead: what to write now.
    """

    had: str
    instead: str


_OLD_NUMPY = "numpy 1.x"
_ABSTRACT = ("Callable", "Container", "Hashable", "ItemsView", "Iterable", "Iterator", "KeysView", "Mapping",
             "MappingView", "MutableMapping", "MutableSequence", "MutableSet", "Sequence", "Set", "Sized",
             "ValuesView")  # fmt: skip
# The years in which programs were written for numpy 1.17 to 1.24, scipy 1.4 to 1.10 and Python 3.7 to 3.10.
_NAMES: dict[str, _Gone] = {
    "numpy.mat": _Gone(_OLD_NUMPY, "np.asmatrix(…)"),
    "numpy.asscalar": _Gone(_OLD_NUMPY, "a.item()"),
    "numpy.asfarray": _Gone(_OLD_NUMPY, "np.asarray(a, dtype=float)"),
    "numpy.bool": _Gone(_OLD_NUMPY, "bool"),
    "numpy.long": _Gone(_OLD_NUMPY, "int"),
    "numpy.float_": _Gone(_OLD_NUMPY, "np.float64"),
    "numpy.product": _Gone(_OLD_NUMPY, "np.prod(…)"),
    "numpy.alltrue": _Gone(_OLD_NUMPY, "np.all(…)"),
    "numpy.sometrue": _Gone(_OLD_NUMPY, "np.any(…)"),
    "numpy.trapz": _Gone("numpy 2.3", "np.trapezoid(…)"),
    "numpy.in1d": _Gone("numpy 2.3", "np.isin(…)"),
    "scipy.misc.derivative": _Gone("scipy 1.11", "(f(x + h) - f(x - h)) / (2 * h), with a small h"),
    "scipy.misc.factorial": _Gone("scipy 1.2", "scipy.special.factorial(…)"),
    "scipy.misc.comb": _Gone("scipy 1.2", "scipy.special.comb(…)"),
    "scipy.misc": _Gone("scipy 1.x", "what you need of it with numpy or another part of scipy"),
    "scipy.interpolate.interp2d": _Gone("scipy 1.13", "scipy.interpolate.RegularGridInterpolator(…)"),
    "scipy.integrate.simps": _Gone("scipy 1.13", "scipy.integrate.simpson(…)"),
    "scipy.integrate.trapz": _Gone("scipy 1.13", "scipy.integrate.trapezoid(…)"),
    "scipy.integrate.cumtrapz": _Gone("scipy 1.13", "scipy.integrate.cumulative_trapezoid(…)"),
    **{f"collections.{name}": _Gone("Python 3.9", f"collections.abc.{name}") for name in _ABSTRACT},
    "inspect.getargspec": _Gone("Python 3.10", "inspect.getfullargspec(…)"),
    "base64.encodestring": _Gone("Python 3.8", "base64.encodebytes(…)"),
    "base64.decodestring": _Gone("Python 3.8", "base64.decodebytes(…)"),
    "fractions.gcd": _Gone("Python 3.8", "math.gcd(…)"),
    "asyncio.coroutine": _Gone("Python 3.10", '"async def", and "await" for "yield from"'),
    "time.clock": _Gone("Python 3.7", "time.perf_counter()"),
}
_METHODS: dict[str, _Gone] = {
    "array.array.tostring": _Gone("Python 3.8", ".tobytes()"),
    "array.array.fromstring": _Gone("Python 3.8", ".frombytes(…)"),
    "tostring": _Gone("numpy 2.2", ".tobytes()"),
    "isAlive": _Gone("Python 3.8", ".is_alive()"),
    "iteritems": _Gone("Python 2", ".items()"),
    "has_key": _Gone("Python 2", '"key in dictionary"'),
}
_PYTHON_2: dict[str, _Gone] = {
    "xrange": _Gone("Python 2", "range(…)"),
    "unicode": _Gone("Python 2", "str(…)"),
}
# What is told without the name that is gone, or in words of its own.
_WORDS: tuple[tuple[re.Pattern[str], str, _Gone], ...] = (
    (
        re.compile(r"TypeError: Population must be a sequence"),
        "random.sample of a set",
        _Gone("Python 3.10", "random.sample(sorted(…), n)"),
    ),
    (
        re.compile(r"ValueError: The binary mode of fromstring is removed"),
        "np.fromstring of bytes",
        _Gone("numpy 2.2", "np.frombuffer(…)"),
    ),
    (
        re.compile(r"`interp2d` has been removed"),
        "scipy.interpolate.interp2d",
        _NAMES["scipy.interpolate.interp2d"],
    ),
    (
        re.compile(r"ValueError: invalid mode: '[rbt]*U"),
        'the mode "U" of open',
        _Gone("Python 3.10", '"r"'),
    ),
    (
        re.compile(r"OverflowError: Python integer -?[0-9]+ out of bounds for u?int[0-9]+"),
        "a wider result where a number does not fit the array's kind",
        _Gone(_OLD_NUMPY, "int(…) around what comes from the array"),
    ),
    (
        re.compile(r"ValueError: The truth value of an empty array is ambiguous"),
        "False for an array without numbers",
        _Gone("numpy 2.1", "if a.size > 0"),
    ),
    (
        re.compile(r"ValueError: .*inhomogeneous shape"),
        "np.array of parts of different lengths",
        _Gone("numpy 1.23", "np.array([…], dtype=object), or a list,"),
    ),
)
_LIBRARIES = ("numpy", "scipy")
_OF_NUMPY = re.compile(r"`np\.(?P<name>\w+)` was removed")
_OF_ARRAYS = re.compile(r"`\w+` was removed from the ndarray class")
_NO_ATTRIBUTE = re.compile(r"[Mm]odule '(?P<module>[\w.]+)' has no attribute '(?P<name>\w+)'")
_NO_IMPORT = re.compile(r"cannot import name '(?P<name>\w+)' from '(?P<module>[\w.]+)'")
_NO_MODULE = re.compile(r"No module named '(?P<module>[\w.]+)\.(?P<name>\w+)'")
_NO_METHOD = re.compile(r"AttributeError: '(?P<kind>[\w.]+)' object has no attribute '(?P<name>\w+)'")
_EMPTY_SHAPE = re.compile(r"ValueError: operands could not be broadcast together with shapes .*\(0,\)")
_NO_NAME = re.compile(r"NameError: name '(?P<name>\w+)' is not defined")
_STAR = re.compile(rb"^\s*from\s+numpy\s+import\s+\*", re.MULTILINE)
_COMPARED_WITH_NONE = re.compile(rb"[=!]=[ \t]*\[[ \t]*\]")


def on_old_name(detail: str, mentions: Callable[[re.Pattern[bytes]], bool]) -> str:
    """Return what to do about a crash over a name that is gone; nothing if that is not the reason.

    Args:
        detail: the last line of what the program told of its end.
        mentions: says whether any program of the team holds such words.
    """
    for words, what, gone in _WORDS:
        if words.search(detail):
            return _told(what, gone)
    if found := _NO_METHOD.search(detail):
        name = found["name"]
        method = _METHODS.get(f"{found['kind']}.{name}") or _METHODS.get(name)
        return _told(f".{name}()", method) if method is not None else ""
    if _EMPTY_SHAPE.search(detail):
        length = _Gone("numpy 1.24", "len(a) == 0")
        return _told('an answer to "a == []" of an array', length) if mentions(_COMPARED_WITH_NONE) else ""
    if found := _NO_NAME.search(detail):
        return _on_bare_name(found["name"], starred=mentions(_STAR))
    return _on_dotted_name(detail)


def _on_bare_name(name: str, *, starred: bool) -> str:
    if name in _PYTHON_2:
        return _told(name, _PYTHON_2[name])
    gone = _NAMES.get(f"numpy.{name}") if starred else None
    return _told(f'{name} of "from numpy import *"', gone) if gone is not None else ""


def _on_dotted_name(detail: str) -> str:
    if found := _OF_NUMPY.search(detail):
        module, name = "numpy", found["name"]
    elif found := _NO_ATTRIBUTE.search(detail) or _NO_IMPORT.search(detail) or _NO_MODULE.search(detail):
        module, name = found["module"], found["name"]
    else:
        return _successor("numpy") if _OF_ARRAYS.search(detail) else ""
    gone = _NAMES.get(f"{module}.{name}")
    if gone is not None:
        return _told(f"{module}.{name}", gone)
    library = module.partition(".")[0]
    return _successor(library) if library in _LIBRARIES else ""


def _told(what: str, gone: _Gone) -> str:
    return f"{gone.had} was the last that had {what}; write {gone.instead} instead"


def _successor(library: str) -> str:
    return (
        f"if the name is spelled right, an older {library} (1.x) had it and this one has not: look for its successor "
        f"in the documentation of {library}"
    )
