"""Modules that numpy had under other names: editors of those years wrote their imports into programs by themselves."""

from __future__ import annotations

import math
import sys
from contextlib import suppress

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from importlib.machinery import ModuleSpec
    from types import ModuleType
    from typing import Any

_CORE = (
    *("arrayprint", "defchararray", "einsumfunc", "fromnumeric", "function_base", "getlimits", "multiarray"),
    *("numeric", "numerictypes", "overrides", "records", "shape_base", "umath"),
)
_LIB = (
    *("arraypad", "arraysetops", "arrayterator", "function_base", "histograms", "index_tricks", "nanfunctions"),
    *("npyio", "polynomial", "scimath", "shape_base", "stride_tricks", "twodim_base", "type_check", "ufunclike"),
    "utils",
)
_PLACES = {
    "numpy.core": "numpy._core",
    **{f"numpy.core.{name}": f"numpy._core.{name}" for name in _CORE},
    **{f"numpy.lib.{name}": f"numpy.lib._{name}_impl" for name in _LIB},
    "numpy.fft.pocketfft": "numpy.fft._pocketfft",
    "numpy.fft.helper": "numpy.fft._helper",
    "numpy.linalg.linalg": "numpy.linalg._linalg",
    "numpy.matrixlib": "numpy",
    "numpy.matrixlib.defmatrix": "numpy",
    "numpy.compat": "numpy",
    "numpy.compat.py3k": "numpy",
}
"""By the name of those years: where its content is now. What is not there, numpy itself may have."""

_STRAY = {
    "_core.multiarray": (
        *("ALLOW_THREADS", "BUFSIZE", "CLIP", "FLOATING_POINT_SUPPORT", "FPE_DIVIDEBYZERO", "FPE_INVALID"),
        *("FPE_OVERFLOW", "FPE_UNDERFLOW", "MAXDIMS", "MAY_SHARE_BOUNDS", "MAY_SHARE_EXACT", "RAISE", "WRAP"),
        *("UFUNC_BUFSIZE_DEFAULT", "UFUNC_PYVALS_NAME", "add_docstring", "compare_chararrays", "tracemalloc_domain"),
    ),
    "_core.numerictypes": (
        *("issctype", "issubclass_", "issubsctype", "maximum_sctype", "obj2sctype", "sctype2char", "sctypes"),
    ),
    "_core.records": ("format_parser",),
    "lib._array_utils_impl": ("byte_bounds",),
    "lib._function_base_impl": ("disp",),
    "lib._npyio_impl": ("DataSource", "recfromcsv", "recfromtxt"),
    "lib._utils_impl": ("deprecate", "deprecate_with_doc", "safe_eval"),
}
"""By where they are now: names of numpy itself that editors liked to import and nobody used."""

_ERRORS = ("IGNORE", "WARN", "RAISE", "CALL", "PRINT", "LOG")


class OldNames:
    """A finder and loader of modules under the names of those years: what is behind one is imported when asked for."""

    def __init__(self, numpy: Any) -> None:
        self._numpy = numpy
        self._kind_of_spec = type(numpy.__spec__)

    def install(self) -> None:
        """Go before the other finders: some of these names still exist, with less behind them, and complain."""
        sys.meta_path.insert(0, self)
        _ask_then(self._numpy, self._of_numpy)
        _ask_then(self._numpy.lib, self._of_its_library)
        vars(self._numpy.lib)["math"] = math  # without its complaint
        for name in [name for name in _PLACES if name in sys.modules]:  # numpy imports some of them itself
            vars(sys.modules[name])["__getattr__"] = self._behind(name)

    def find_spec(self, name: str, path: Sequence[str] | None = None, target: ModuleType | None = None) -> Any:
        """Find a module that is told of here; the import system calls this."""
        if name not in _PLACES:
            return None
        spec = self._kind_of_spec(name, self, is_package=name in ("numpy.compat", "numpy.core"))
        if name == "numpy.core":  # there is still one, and compiled modules look for what it holds
            spec.submodule_search_locations = [f"{folder}/core" for folder in self._numpy.__path__]
        return spec

    def create_module(self, spec: ModuleSpec) -> None:
        """Let the import system make the module."""

    def exec_module(self, module: Any) -> None:
        """Fill a module: what is behind it is looked up name by name."""
        named = self._behind(module.__name__)
        there = vars(module)
        there["__getattr__"] = named
        if module.__name__.startswith("numpy.compat"):
            there.update(_of_two_pythons())
            return
        hidden = set(vars(self._numpy)).difference(self._numpy.__all__)
        there["__all__"] = [name for name in named("__all__") if name not in hidden]

    def _behind(self, old: str) -> Callable[[str], Any]:
        """Return what looks up a name of a module of those years."""

        def named(name: str) -> Any:
            for place in (_module(_PLACES[old]), self._numpy):
                if hasattr(place, name):
                    return getattr(place, name)
            raise AttributeError(f"module {old!r} has no attribute {name!r}", name=name, obj=sys.modules.get(old))

        return named

    def _of_numpy(self, name: str) -> Any:
        if name == "compat":
            return _module("numpy.compat")
        for place, names in _STRAY.items():
            if name in names:
                return getattr(_module(f"numpy.{place}"), name)
        kind, _, short = name.partition("_")
        if kind == "ERR" and short in _ERRORS:
            return _ERRORS.index(short)
        numpy = self._numpy
        others: dict[str, Any] = {
            "cast": _ByKind(lambda kind: lambda x: numpy.asarray(x).astype(kind)),
            "nbytes": _ByKind(lambda kind: numpy.dtype(kind).itemsize),
            "find_common_type": lambda arrays, scalars: numpy.result_type(*arrays, *scalars),
            # They told somebody at a keyboard of numpy.
            **dict.fromkeys(("lookfor", "source", "who"), lambda *_, **__: None),
        }
        if name in others:
            return others[name]
        raise AttributeError

    def _of_its_library(self, name: str) -> Any:
        """Return a module of ``numpy.lib``, or a function: it had all of its modules' for itself, too."""
        if f"numpy.lib.{name}" in _PLACES:
            return _module(f"numpy.lib.{name}")
        if name.startswith("_"):
            raise AttributeError
        return getattr(self._numpy, name)


def _module(name: str) -> Any:
    __import__(name)
    return sys.modules[name]


class _ByKind(dict):  # type: ignore[type-arg]
    """A table with an answer for every kind of number."""

    def __init__(self, answer: Callable[[Any], Any]) -> None:
        super().__init__()
        self._answer = answer

    def __missing__(self, kind: Any) -> Any:
        return self._answer(kind)


def _ask_then(module: Any, then: Callable[[str], Any]) -> None:
    """Let a module look elsewhere for what it has not. What is not there either, it tells of as before."""
    first = vars(module)["__getattr__"]

    def named(name: str) -> Any:
        try:
            return first(name)
        except AttributeError:
            with suppress(AttributeError):
                return then(name)
            raise

    module.__getattr__ = named


def _of_two_pythons() -> dict[str, Any]:
    """Return what ``numpy.compat`` had: names by which a program could run in Python 2 and 3."""
    # Few programs ask for this.
    import os  # noqa: PLC0415
    import pathlib  # noqa: PLC0415
    import pickle  # noqa: PLC0415

    def as_bytes(s: Any) -> bytes:
        return s if isinstance(s, bytes) else str(s).encode("latin1")

    def as_str(s: Any) -> str:
        return s.decode("latin1") if isinstance(s, bytes) else str(s)

    return {
        "long": int, "unicode": str, "basestring": str, "bytes": bytes, "integer_types": (int,), "strchar": "U",
        "asbytes": as_bytes, "asstr": as_str, "asunicode": as_str, "sixu": lambda s: s,
        "os_fspath": os.fspath, "os_PathLike": os.PathLike, "Path": pathlib.Path, "pickle": pickle,
    }  # fmt: skip
