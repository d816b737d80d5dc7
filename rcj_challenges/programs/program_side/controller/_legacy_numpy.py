"""What numpy 1.19 to 1.24 and scipy 1.5 to 1.10 had, where numpy or scipy is used at all."""

from __future__ import annotations

import functools
import math
import sys
from contextlib import suppress

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

_ALIASES = {
    "Inf": "inf", "Infinity": "inf", "PINF": "inf", "infty": "inf", "NaN": "nan", "NAN": "nan",
    "float_": "float64", "complex_": "complex128", "unicode_": "str_", "string_": "bytes_", "bool8": "bool_",
    "product": "prod", "cumproduct": "cumprod", "sometrue": "any", "alltrue": "all", "round_": "round",
    "trapz": "trapezoid", "row_stack": "vstack", "in1d": "isin", "mat": "asmatrix",
}  # fmt: skip
_PYTHONS_OWN = {
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

_CORE = (
    "arrayprint einsumfunc fromnumeric function_base getlimits multiarray numeric numerictypes records shape_base umath"
)
_LIB = (
    "arraypad arraysetops function_base histograms index_tricks nanfunctions npyio polynomial scimath shape_base "
    "stride_tricks twodim_base type_check ufunclike utils"
)
_MODULES = {
    "numpy.core": "numpy._core",
    **{f"numpy.core.{name}": f"numpy._core.{name}" for name in _CORE.split()},
    **{f"numpy.lib.{name}": f"numpy.lib._{name}_impl" for name in _LIB.split()},
    "numpy.fft.pocketfft": "numpy.fft._pocketfft",
    "numpy.fft.helper": "numpy.fft._helper",
    "numpy.linalg.linalg": "numpy.linalg._linalg",
    "numpy.matrixlib": "numpy",
    "numpy.matrixlib.defmatrix": "numpy",
}
"""Modules whose imports editors wrote into programs, by their old name. What is not there, numpy itself may have."""


def patch_numpy(numpy: Any) -> None:
    """Bring back old names, and let numbers read as numbers: ``1.5``, not ``np.float64(1.5)``."""
    there = vars(numpy)
    old_names = {old: there[new] for old, new in _ALIASES.items() if new in there}
    old_names |= {"NINF": -math.inf, "math": math}
    exceptions = vars(there["exceptions"]) if "exceptions" in there else {}
    old_names |= {name: kind for name, kind in exceptions.items() if isinstance(kind, type)}
    for name, thing in {**old_names, **_PYTHONS_OWN}.items():
        there.setdefault(name, thing)
    with suppress(AttributeError, TypeError):
        # `from numpy import *` gave them too, but never Python's own under its names.
        numpy.__all__ = [name for name in {**dict.fromkeys(numpy.__all__), **old_names} if name not in _EXPORTED_LATER]
        there["fromstring"] = _reading_bytes(numpy.fromstring, numpy)
    with suppress(AttributeError):
        _OldModules(numpy).install()
    for name in ("stack", "vstack", "hstack", "dstack", "column_stack", "row_stack"):
        if name in there:
            there[name] = _taking_iterators(there[name])
    for name in ("array", "asarray"):
        there[name] = _taking_ragged(there[name], there["object_"])
    with suppress(AttributeError, TypeError, ValueError):  # a numpy that reads that way already, or not any more
        numpy.set_printoptions(legacy="1.25")


def _taking_iterators(real: Callable[..., Any]) -> Callable[..., Any]:
    """Let what puts arrays together take them from what is gone through once: ``np.vstack(map(…))``."""

    @functools.wraps(real)
    def function(*given: Any, **named: Any) -> Any:
        if given and not hasattr(given[0], "__getitem__") and hasattr(given[0], "__iter__"):
            given = (list(given[0]), *given[1:])
        return real(*given, **named)

    return function


def _taking_ragged(real: Callable[..., Any], kind: Any) -> Callable[..., Any]:
    """Let parts of different lengths, ``[[1, 2], 3]``, be an array of objects; ``copy=False`` copies what has to be."""

    @functools.wraps(real)
    def function(*given: Any, **named: Any) -> Any:
        try:
            return real(*given, **named)
        except ValueError as error:
            text = str(error)
            if "Unable to avoid copy" in text and named.get("copy") is False and real.__name__ == "array":
                named["copy"] = None
            elif "inhomogeneous" in text and len(given) == 1 and named.get("dtype") is None:
                named["dtype"] = kind
            else:
                raise
        return function(*given, **named)

    return function


def _reading_bytes(real: Callable[..., Any], numpy: Any) -> Any:
    """Return ``fromstring`` as it was: without a separator it read bytes."""

    def fromstring(string: Any, dtype: Any = float, count: int = -1, *, sep: str = "", **more: Any) -> Any:
        if sep:
            return real(string, dtype, count, sep=sep, **more)
        data = string.encode("latin-1") if isinstance(string, str) else string
        return numpy.frombuffer(data, dtype, count).copy()

    return fromstring


class _OldModules:
    """A finder and loader of modules under their old names: what is behind one is looked up name by name."""

    def __init__(self, numpy: Any) -> None:
        self._numpy = numpy
        self._kind_of_spec = type(numpy.__spec__)

    def install(self) -> None:
        """Go before the other finders: some of these names still exist, with less behind them, and complain."""
        sys.meta_path.insert(0, self)
        _with_fallback(self._numpy.lib, self._of_lib)
        vars(self._numpy.lib)["math"] = math  # without its complaint
        for name in [name for name in _MODULES if name in sys.modules]:  # numpy imports some of them itself
            vars(sys.modules[name])["__getattr__"] = self._behind(name)

    def find_spec(self, name: str, _path: Any = None, _target: Any = None) -> Any:
        if name not in _MODULES:
            return None
        spec = self._kind_of_spec(name, self, is_package=name == "numpy.core")
        if name == "numpy.core":  # there is still one, and compiled modules look for what it holds
            spec.submodule_search_locations = [f"{folder}/core" for folder in self._numpy.__path__]
        return spec

    def create_module(self, _spec: Any) -> None:
        pass

    def exec_module(self, module: Any) -> None:
        named = vars(module)["__getattr__"] = self._behind(module.__name__)
        hidden = set(vars(self._numpy)).difference(self._numpy.__all__)
        module.__all__ = [name for name in named("__all__") if name not in hidden]

    def _behind(self, old: str) -> Callable[[str], Any]:
        def named(name: str) -> Any:
            for place in (_module(_MODULES[old]), self._numpy):
                if hasattr(place, name):
                    return getattr(place, name)
            raise AttributeError(f"module {old!r} has no attribute {name!r}", name=name, obj=sys.modules.get(old))

        return named

    def _of_lib(self, name: str) -> Any:
        """Return a module of ``numpy.lib``, or a function: it had all of its modules' for itself, too."""
        if f"numpy.lib.{name}" in _MODULES:
            return _module(f"numpy.lib.{name}")
        return _public(name, self._numpy)


def _module(name: str) -> Any:
    __import__(name)
    return sys.modules[name]


def _public(name: str, place: Any) -> Any:
    if name.startswith("_"):
        raise AttributeError
    return getattr(place, name)


def _with_fallback(module: Any, find: Callable[[str], Any]) -> None:
    """Let a module look elsewhere for what it has not; ``find`` raises `AttributeError` if it is not there either."""
    first = vars(module)["__getattr__"]

    def named(name: str) -> Any:
        try:
            return first(name)
        except AttributeError:
            with suppress(AttributeError):
                return find(name)
            raise

    module.__getattr__ = named


def patch_scipy(scipy: Any) -> None:
    """Give ``scipy`` itself the names of numpy that it had up to 1.11: ``from scipy import array, pi``."""
    numpy: Any = sys.modules["numpy"]  # scipy has imported it

    # Its roots of negative numbers were complex ones.
    _with_fallback(scipy, lambda name: _public(name, numpy.emath if hasattr(numpy.emath, name) else numpy))
    exported = (name for name in numpy.__all__ if not name.startswith("_"))
    scipy.__all__ = list(dict.fromkeys([*scipy.__all__, *exported]))


def patch_integrate(integrate: Any) -> None:
    """Give ``scipy.integrate`` back its short names."""

    def simps(y: Any, x: Any = None, dx: float = 1.0, axis: int = -1, even: Any = None) -> Any:  # noqa: ARG001 - as it was
        return integrate.simpson(y, x=x, dx=dx, axis=axis)

    old_names = {"simps": simps, "cumtrapz": integrate.cumulative_trapezoid, "trapz": integrate.trapezoid}
    for name, function in old_names.items():
        vars(integrate).setdefault(name, function)


def patch_interpolate(interpolate: Any) -> None:
    """Give ``scipy.interpolate`` back what looks up numbers in a table of two axes."""
    numpy: Any = sys.modules["numpy"]

    class interp2d:  # noqa: N801 - as it was called
        """A surface through the points of a grid. Outside of it, it goes on with the value at the edge."""

        def __init__(self, x: Any, y: Any, z: Any, kind: str = "linear", **_: Any) -> None:
            x, y = numpy.ravel(x), numpy.ravel(y)
            by_x, by_y = numpy.argsort(x, kind="stable"), numpy.argsort(y, kind="stable")
            table = numpy.reshape(z, (len(y), len(x)))[by_y][:, by_x]
            degree = {"linear": 1, "cubic": 3, "quintic": 5}[kind]
            self._spline = interpolate.RectBivariateSpline(x[by_x], y[by_y], table.T, kx=degree, ky=degree, s=0)

        def __call__(self, x: Any, y: Any) -> Any:
            """Return the numbers at all pairs of ``x`` and ``y``: a row for each ``y``; of one ``y`` its row alone."""
            z = self._spline(numpy.sort(numpy.atleast_1d(x)), numpy.sort(numpy.atleast_1d(y))).T
            return z[0] if len(z) == 1 else z

    interpolate.interp2d = interp2d


def patch_misc(misc: Any) -> None:
    """Give ``scipy.misc`` back its derivative: central differences over ``order`` points."""

    def derivative(func: Any, x0: Any, dx: float = 1.0, n: int = 1, args: Any = (), order: int = 3) -> Any:
        numpy: Any = sys.modules["numpy"]
        steps = numpy.arange(order) - order // 2
        wanted = [math.factorial(n) if power == n else 0.0 for power in range(order)]
        weights = numpy.linalg.solve(numpy.vander(steps, increasing=True).T.astype(float), wanted)
        return sum(w * func(x0 + step * dx, *args) for w, step in zip(weights, steps, strict=True)) / dx**n

    vars(misc).setdefault("derivative", derivative)


def patch_stats(stats: Any) -> None:
    """Let ``scipy.stats.mode`` answer with arrays, ``mode(x)[0][0]``, as it did up to 1.10."""
    real = stats.mode

    def mode(a: Any, axis: Any = 0, nan_policy: str = "propagate", keepdims: Any = True) -> Any:
        given = sys.modules["numpy"].asarray(a)
        given, axis = (given.ravel(), 0) if axis is None else (given, axis)
        return real(given, axis=axis, nan_policy=nan_policy, keepdims=keepdims is None or keepdims)

    stats.mode = mode
    with suppress(AttributeError):
        stats._stats_py.mode = mode  # noqa: SLF001 - it hands it to `scipy.stats.stats`, too
