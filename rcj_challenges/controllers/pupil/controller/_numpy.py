"""Names that numpy and scipy had in 2021 to 2023: programs were written for numpy 1.19 to 1.24, scipy 1.5 to 1.10."""

from __future__ import annotations

import functools
import math
import sys
from contextlib import suppress

from ._methods import restore_methods
from ._moved import OldNames

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

_SAME_AS = {
    "Inf": "inf", "Infinity": "inf", "PINF": "inf", "infty": "inf", "NaN": "nan", "NAN": "nan",
    "float_": "float64", "complex_": "complex128", "cfloat": "complex128", "singlecomplex": "complex64",
    "longfloat": "longdouble", "longcomplex": "clongdouble", "unicode_": "str_", "string_": "bytes_",
    "bool8": "bool_", "int0": "intp", "uint0": "uintp", "object0": "object_", "str0": "str_", "bytes0": "bytes_",
    "clongfloat": "clongdouble", "void0": "void",
    "product": "prod", "cumproduct": "cumprod", "sometrue": "any", "alltrue": "all", "round_": "round",
    "trapz": "trapezoid", "row_stack": "vstack", "in1d": "isin", "mat": "asmatrix",
}  # fmt: skip
_PYTHON_S_OWN = {
    "float": float, "int": int, "complex": complex, "object": object, "str": str, "unicode": str,
    "warnings": sys.modules["warnings"],
}  # fmt: skip
_EXPORTED_LATER = {
    "abs", "bool", "max", "min", "pow", "round",  # Python's own
    "acos", "acosh", "asin", "asinh", "atan", "atan2", "atanh",  # those of its module math
    "core", "dtypes", "exceptions", "f2py", "lib", "polynomial", "strings", "test", "testing", "typing",
    "astype", "bitwise_count", "bitwise_invert", "bitwise_left_shift", "bitwise_right_shift", "concat",
    "cumulative_prod", "cumulative_sum", "isdtype", "long", "matrix_transpose", "matvec", "permute_dims", "trapezoid",
    "ulong", "unique_all", "unique_counts", "unique_inverse", "unique_values", "unstack", "vecdot", "vecmat",
}  # fmt: skip
"""What ``from numpy import *`` did not give up to 1.24: a program means something else by these names."""
_WINDOWS = (
    *("barthann", "bartlett", "blackman", "blackmanharris", "bohman", "boxcar", "chebwin", "cosine", "exponential"),
    *("flattop", "gaussian", "general_gaussian", "hamming", "hann", "kaiser", "nuttall", "parzen", "triang", "tukey"),
)


def restore_old_names(numpy: Any) -> None:
    """Give numpy back what it called its things, and let numbers read as numbers: ``1.5``, not ``np.float64(1.5)``."""
    there = vars(numpy)
    old_names = {old: there[new] for old, new in _SAME_AS.items() if new in there}
    old_names |= {"NINF": -math.inf, "PZERO": 0.0, "NZERO": -0.0, "math": math, **_functions_of(numpy)}
    exceptions = vars(there["exceptions"]) if "exceptions" in there else {}
    old_names |= {name: kind for name, kind in exceptions.items() if isinstance(kind, type)}
    for name, thing in {**old_names, **_PYTHON_S_OWN}.items():
        there.setdefault(name, thing)
    with suppress(AttributeError, TypeError):
        # `from numpy import *` gave them too, but never Python's own under its names.
        numpy.__all__ = [name for name in {**dict.fromkeys(numpy.__all__), **old_names} if name not in _EXPORTED_LATER]
        there["fromstring"] = _reading_bytes(numpy)
    with suppress(AttributeError):
        OldNames(numpy).install()
    # Since 2.0 `ptp` only complains.
    ptp = lambda array, axis=None, out=None: numpy.ptp(array, axis, out)  # noqa: E731
    restored = {"tostring": numpy.ndarray.tobytes, "ptp": ptp, "itemset": _itemset, "newbyteorder": _newbyteorder}
    restore_methods(numpy.ndarray, restored)
    _stack_what_is_no_list(there)
    _put_anything_into_arrays(there)
    with suppress(AttributeError, TypeError, ValueError):  # a numpy that reads that way already, or not any more
        numpy.set_printoptions(legacy="1.25")


def _functions_of(numpy: Any) -> dict[str, Any]:
    def asfarray(a: Any, dtype: Any = float) -> Any:
        wanted = numpy.dtype(dtype)
        return numpy.asarray(a, dtype=wanted if numpy.issubdtype(wanted, numpy.inexact) else float)

    def msort(a: Any) -> Any:
        return numpy.sort(a, axis=0)

    def asscalar(a: Any) -> Any:
        return a.item()

    def alen(a: Any) -> int:
        return len(numpy.array(a, ndmin=1))

    return {"asfarray": asfarray, "msort": msort, "asscalar": asscalar, "alen": alen}


def _itemset(array: Any, *given: Any) -> None:
    """Set one number of an array: of one that has no other, by its number, or by its place."""
    *place, item = given
    if len(place) == 1 and not isinstance(place[0], tuple):
        array.flat[place[0]] = item
    else:
        array[place[0] if len(place) == 1 else tuple(place) or (0,) * array.ndim] = item


def _newbyteorder(array: Any, new_order: str = "S") -> Any:
    return array.view(array.dtype.newbyteorder(new_order))


def _stack_what_is_no_list(there: dict[str, Any]) -> None:
    """Let what puts arrays together take them from what is gone through once: ``np.vstack(map(…))``."""

    def listing(real: Callable[..., Any]) -> Callable[..., Any]:
        @functools.wraps(real)
        def function(*given: Any, **named: Any) -> Any:
            if given and not hasattr(given[0], "__getitem__") and hasattr(given[0], "__iter__"):
                given = (list(given[0]), *given[1:])
            return real(*given, **named)

        return function

    for name in ("stack", "vstack", "hstack", "dstack", "column_stack", "row_stack"):
        if name in there:
            there[name] = listing(there[name])


def _put_anything_into_arrays(there: dict[str, Any]) -> None:
    """Let parts of different lengths, ``[[1, 2], 3]``, be an array of objects; ``copy=False`` copies what has to be."""
    kind = there["object_"]

    def taking(real: Callable[..., Any]) -> Callable[..., Any]:
        @functools.wraps(real)
        def function(*given: Any, **named: Any) -> Any:
            try:
                return real(*given, **named)
            except ValueError as error:
                said = str(error)
                if "Unable to avoid copy" in said and named.get("copy") is False and real.__name__ == "array":
                    named["copy"] = None
                elif "inhomogeneous" in said and len(given) == 1 and named.get("dtype") is None:
                    named["dtype"] = kind
                else:
                    raise
            return function(*given, **named)

        return function

    for name in ("array", "asarray"):
        if name in there:
            there[name] = taking(there[name])


def _reading_bytes(numpy: Any) -> Any:
    """Return ``fromstring`` as it was: without a separator it read bytes."""
    real = numpy.fromstring

    def fromstring(string: Any, dtype: Any = float, count: int = -1, *, sep: str = "", **more: Any) -> Any:
        if sep:
            return real(string, dtype, count, sep=sep, **more)
        data = string.encode("latin-1") if isinstance(string, str) else string
        return numpy.frombuffer(data, dtype, count).copy()

    return fromstring


def restore_names_of_numpy(scipy: Any) -> None:
    """Give ``scipy`` itself the names of numpy that it had up to 1.11: ``from scipy import array, pi``."""
    real = scipy.__getattr__
    numpy: Any = sys.modules["numpy"]  # scipy has imported it
    others = {"rand": numpy.random, "randn": numpy.random, "ifft": numpy.fft}

    def named(name: str) -> Any:
        try:
            return real(name)
        except AttributeError:
            # Its roots of negative numbers were complex ones.
            places = (others[name],) if name in others else (numpy.emath, numpy)
            for place in places:
                if not name.startswith("_") and hasattr(place, name):
                    return getattr(place, name)
            raise

    scipy.__getattr__ = named
    exported = (name for name in numpy.__all__ if not name.startswith("_"))
    scipy.__all__ = list(dict.fromkeys([*scipy.__all__, *exported, *others]))


def restore_integrals(integrate: Any) -> None:
    """Give ``scipy.integrate`` back its short names."""
    there = vars(integrate)

    def simps(y: Any, x: Any = None, dx: float = 1.0, axis: int = -1, even: Any = None) -> Any:  # noqa: ARG001 - as it was
        return integrate.simpson(y, x=x, dx=dx, axis=axis)

    there.setdefault("simps", simps)
    for old, new in (("cumtrapz", "cumulative_trapezoid"), ("trapz", "trapezoid")):
        if new in there:
            there.setdefault(old, there[new])


def restore_interpolation(interpolate: Any) -> None:
    """Give ``scipy.interpolate`` back what looks up numbers in a table of two axes."""
    from ._interp2d import interp2d  # noqa: PLC0415 - it needs what has just been imported

    interpolate.interp2d = interp2d


def restore_windows(signal: Any) -> None:
    """Give ``scipy.signal`` back the names of its windows."""
    for name in _WINDOWS:
        if hasattr(signal.windows, name):
            vars(signal).setdefault(name, getattr(signal.windows, name))


def restore_matrices(linalg: Any) -> None:
    """Give ``scipy.linalg`` back its other name for the pseudo-inverse, and what numpy has as well."""

    def pinv2(a: Any, cond: Any = None, rcond: Any = None, **more: Any) -> Any:
        return linalg.pinv(a, rtol=rcond if cond is None else cond, **more)

    numpy: Any = sys.modules["numpy"]  # scipy has imported it
    of_numpy = {name: getattr(numpy, name) for name in ("kron", "tri", "tril", "triu")}
    for name, thing in {"pinv2": pinv2, **of_numpy}.items():
        vars(linalg).setdefault(name, thing)


def restore_mode(stats: Any) -> None:
    """Let ``scipy.stats.mode`` answer with arrays, ``mode(x)[0][0]``, and know words too, as it did up to 1.10."""
    real = stats.mode

    def mode(a: Any, axis: Any = 0, nan_policy: str = "propagate", keepdims: Any = True) -> Any:
        numpy: Any = sys.modules["numpy"]
        given = numpy.asarray(a)
        given, axis = (given.ravel(), 0) if axis is None else (given, axis)
        keepdims = keepdims is None or keepdims
        if given.ndim != 1 or (given.size and numpy.issubdtype(given.dtype, numpy.number)):
            return real(given, axis=axis, nan_policy=nan_policy, keepdims=keepdims)
        kind, found = type(real([0])), dict.fromkeys(given.tolist(), 0)
        for thing in given.tolist():
            found[thing] += 1
        things = sorted(found) if given.dtype != object else list(found)
        most = max(things, key=found.__getitem__, default=None)
        values = numpy.array([most][: given.size], dtype=given.dtype)
        counts = numpy.array([found.get(most)][: given.size], dtype=int)
        return kind(values, counts) if keepdims or not given.size else kind(values[0], counts[0])

    stats.mode = mode
    with suppress(AttributeError):
        stats._stats_py.mode = mode  # noqa: SLF001 - it hands it to `scipy.stats.stats`, too


def restore_of_misc(misc: Any) -> None:
    """Give ``scipy.misc`` back its derivative, central differences over ``order`` points, and what counts choices."""

    def comb(*given: Any, **named: Any) -> Any:
        return sys.modules["scipy"].special.comb(*given, **named)

    def factorial(*given: Any, **named: Any) -> Any:
        return sys.modules["scipy"].special.factorial(*given, **named)

    def derivative(func: Any, x0: Any, dx: float = 1.0, n: int = 1, args: Any = (), order: int = 3) -> Any:
        numpy: Any = sys.modules["numpy"]  # scipy has imported it
        steps = numpy.arange(order) - order // 2
        wanted = [math.factorial(n) if power == n else 0.0 for power in range(order)]
        weights = numpy.linalg.solve(numpy.vander(steps, increasing=True).T.astype(float), wanted)
        return sum(w * func(x0 + step * dx, *args) for w, step in zip(weights, steps, strict=True)) / dx**n

    for function in (derivative, comb, factorial):
        vars(misc).setdefault(function.__name__, function)
