"""Names that numpy and scipy had in 2021 to 2023: programs were written for numpy 1.19 to 1.24, scipy 1.5 to 1.10."""

from __future__ import annotations

import gc
import math
import sys
from contextlib import suppress

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

_SAME_AS = {
    "Inf": "inf", "Infinity": "inf", "PINF": "inf", "infty": "inf", "NaN": "nan", "NAN": "nan",
    "float_": "float64", "complex_": "complex128", "cfloat": "complex128", "singlecomplex": "complex64",
    "longfloat": "longdouble", "longcomplex": "clongdouble", "unicode_": "str_", "string_": "bytes_",
    "bool8": "bool_", "int0": "intp", "uint0": "uintp", "object0": "object_", "str0": "str_", "bytes0": "bytes_",
    "product": "prod", "cumproduct": "cumprod", "sometrue": "any", "alltrue": "all", "round_": "round",
    "trapz": "trapezoid", "row_stack": "vstack", "in1d": "isin", "mat": "asmatrix",
}  # fmt: skip
_PYTHON_S_OWN = {
    "float": float, "int": int, "complex": complex, "object": object, "str": str, "math": math,
    "warnings": sys.modules["warnings"],
}  # fmt: skip
_WINDOWS = ("gaussian", "hann", "hamming", "blackman", "bartlett", "boxcar", "triang", "kaiser", "tukey")


def restore_old_names(numpy: Any) -> None:
    """Give numpy back what it called its things, and let numbers read as numbers: ``1.5``, not ``np.float64(1.5)``."""
    there = vars(numpy)
    old_names = {old: there[new] for old, new in _SAME_AS.items() if new in there}
    old_names |= {"NINF": -math.inf, "PZERO": 0.0, "NZERO": -0.0, **_functions_of(numpy)}
    exceptions = vars(there["exceptions"]) if "exceptions" in there else {}
    old_names |= {name: kind for name, kind in exceptions.items() if isinstance(kind, type)}
    for name, thing in {**old_names, **_PYTHON_S_OWN}.items():
        there.setdefault(name, thing)
    with suppress(AttributeError, TypeError):
        # `from numpy import *` gave them too, but never Python's own under its names.
        numpy.__all__ = [*numpy.__all__, *(name for name in old_names if name not in numpy.__all__)]
        there["fromstring"] = _reading_bytes(numpy)
    _restore_methods(numpy)
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

    return {"asfarray": asfarray, "msort": msort, "asscalar": asscalar}


def _reading_bytes(numpy: Any) -> Any:
    """Return ``fromstring`` as it was: without a separator it read bytes."""
    real = numpy.fromstring

    def fromstring(string: Any, dtype: Any = float, count: int = -1, *, sep: str = "", **more: Any) -> Any:
        if sep:
            return real(string, dtype, count, sep=sep, **more)
        data = string.encode("latin-1") if isinstance(string, str) else string
        return numpy.frombuffer(data, dtype, count).copy()

    return fromstring


_replaced: list[Any] = []
"""What stood in numpy's dictionary before. Python may still know it by its address: it must not be freed."""


def _restore_methods(numpy: Any) -> None:
    """Give arrays back methods that they had. Their class takes none from Python, but the dictionary behind it does.

    Nobody tells Python that the class has changed, so it forgets what it has looked up in any class.
    """
    with suppress(Exception):  # without them only programs that use them suffer
        (methods,) = gc.get_referents(numpy.ndarray.__dict__)
        forget = getattr(sys, "_clear_internal_caches", None) or sys._clear_type_cache  # noqa: SLF001
        restored = {
            "tostring": numpy.ndarray.tobytes,
            "ptp": lambda array, axis=None, out=None: numpy.ptp(array, axis, out),  # since 2.0 it only complains
        }
        _replaced.extend(methods.get(name) for name in restored)
        methods.update(restored)
        forget()


def restore_names_of_numpy(scipy: Any) -> None:
    """Give ``scipy`` itself the names of numpy that it had up to 1.11: ``from scipy import array, pi``."""
    real = scipy.__getattr__

    def named(name: str) -> Any:
        try:
            return real(name)
        except AttributeError:
            numpy: Any = sys.modules["numpy"]  # scipy has imported it
            for place in (numpy.emath, numpy):  # its roots of negative numbers were complex ones
                if not name.startswith("_") and hasattr(place, name):
                    return getattr(place, name)
            raise

    scipy.__getattr__ = named


def restore_integrals(integrate: Any) -> None:
    """Give ``scipy.integrate`` back its short names."""
    there = vars(integrate)

    def simps(y: Any, x: Any = None, dx: float = 1.0, axis: int = -1, even: Any = None) -> Any:  # noqa: ARG001 - as it was
        return integrate.simpson(y, x=x, dx=dx, axis=axis)

    there.setdefault("simps", simps)
    for old, new in (("cumtrapz", "cumulative_trapezoid"), ("trapz", "trapezoid")):
        if new in there:
            there.setdefault(old, there[new])


def restore_windows(signal: Any) -> None:
    """Give ``scipy.signal`` back the names of its windows."""
    for name in _WINDOWS:
        if hasattr(signal.windows, name):
            vars(signal).setdefault(name, getattr(signal.windows, name))


def restore_derivative(misc: Any) -> None:
    """Give ``scipy.misc`` back its derivative: central differences over ``order`` points."""

    def derivative(func: Any, x0: Any, dx: float = 1.0, n: int = 1, args: Any = (), order: int = 3) -> Any:
        numpy: Any = sys.modules["numpy"]  # scipy has imported it
        steps = numpy.arange(order) - order // 2
        wanted = [math.factorial(n) if power == n else 0.0 for power in range(order)]
        weights = numpy.linalg.solve(numpy.vander(steps, increasing=True).T.astype(float), wanted)
        return sum(w * func(x0 + step * dx, *args) for w, step in zip(weights, steps, strict=True)) / dx**n

    vars(misc).setdefault("derivative", derivative)
