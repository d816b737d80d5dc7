"""Names that numpy had until 2.0: programs of 2021 to 2023 were written for numpy 1.19 to 1.24."""

from __future__ import annotations

import math
from contextlib import suppress
from typing import Any

_SAME_AS = {
    "Inf": "inf", "Infinity": "inf", "PINF": "inf", "infty": "inf", "NaN": "nan", "NAN": "nan",
    "float_": "float64", "complex_": "complex128", "unicode_": "str_", "string_": "bytes_",
    "product": "prod", "cumproduct": "cumprod", "sometrue": "any", "alltrue": "all", "round_": "round",
    "trapz": "trapezoid", "row_stack": "vstack", "in1d": "isin",
}  # fmt: skip
_PYTHON_S_OWN = {"float": float, "int": int, "complex": complex, "object": object, "str": str, "math": math}


def restore_old_names(numpy: Any) -> None:
    """Give numpy back what it called its things, and let numbers read as numbers: ``1.5``, not ``np.float64(1.5)``."""
    there = vars(numpy)
    for old, new in _SAME_AS.items():
        if new in there:
            there.setdefault(old, there[new])
    for old, thing in _PYTHON_S_OWN.items():
        there.setdefault(old, thing)
    there.setdefault("NINF", -math.inf)
    with suppress(AttributeError, TypeError, ValueError):  # a numpy that reads that way already, or not any more
        numpy.set_printoptions(legacy="1.25")
