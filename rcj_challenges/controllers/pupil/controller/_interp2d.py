"""``scipy.interpolate.interp2d`` as scipy had it up to 1.13: it looks up numbers in a table of two axes.

It is made of what scipy still has, the splines that were behind it. This file is read when scipy has been.
"""

from __future__ import annotations

import sys

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

numpy: Any = sys.modules["numpy"]
interpolate: Any = sys.modules["scipy.interpolate"]

_DEGREES = {"linear": 1, "cubic": 3, "quintic": 5}


class interp2d:  # noqa: N801 - as it was called
    """A surface through points. Outside of them it goes on with the value at the edge."""

    def __init__(
        self,
        x: Any,
        y: Any,
        z: Any,
        kind: str = "linear",
        copy: bool = True,
        bounds_error: bool = False,
        fill_value: Any = None,
    ) -> None:
        x, y, z = numpy.ravel(x), numpy.ravel(y), numpy.asarray(z)
        if kind not in _DEGREES:
            raise ValueError(f"Unsupported interpolation type {kind!r}, must be either of {', '.join(_DEGREES)}.")
        degree = _DEGREES[kind]
        if z.size == len(x) * len(y):
            self.tck = _of_grid(x, y, z, degree)
        elif len(x) == len(y) == z.size:
            self.tck = interpolate.bisplrep(x, y, z.ravel(), kx=degree, ky=degree, s=0.0)
        else:
            raise ValueError("x, y, and z must have equal lengths for non rectangular grid")
        self.bounds_error, self.fill_value = bounds_error, fill_value
        self.x, self.y, self.z = x, y, z
        self.x_min, self.x_max, self.y_min, self.y_max = x.min(), x.max(), y.min(), y.max()

    def __call__(self, x: Any, y: Any, dx: int = 0, dy: int = 0, assume_sorted: bool = False) -> Any:
        """Return the numbers at all pairs of ``x`` and ``y``: a row for each ``y``; of one ``y`` its row alone."""
        x, y = numpy.atleast_1d(x), numpy.atleast_1d(y)
        if x.ndim != 1 or y.ndim != 1:
            raise ValueError("x and y should both be 1-D arrays")
        if not assume_sorted:
            x, y = numpy.sort(x), numpy.sort(y)
        beyond_x, beyond_y = (x < self.x_min) | (x > self.x_max), (y < self.y_min) | (y > self.y_max)
        if self.bounds_error and (beyond_x.any() or beyond_y.any()):
            ranges = f"x must be in {(self.x_min, self.x_max)!r}, y in {(self.y_min, self.y_max)!r}"
            raise ValueError(f"Values out of range; {ranges}")
        z = numpy.reshape(interpolate.bisplev(x, y, self.tck, dx, dy), (len(x), len(y))).T.copy()
        if self.fill_value is not None:
            z[:, beyond_x] = self.fill_value
            z[beyond_y, :] = self.fill_value
        return z[0] if len(z) == 1 else z


def _of_grid(x: Any, y: Any, z: Any, degree: int) -> Any:
    if z.ndim == 2 and z.shape != (len(y), len(x)):
        raise ValueError(
            "When on a regular grid with x.size = m and y.size = n, if z.ndim == 2, then z must have shape (n, m)"
        )
    by_x, by_y = numpy.argsort(x, kind="stable"), numpy.argsort(y, kind="stable")
    table = z.reshape(len(y), len(x))[by_y][:, by_x]
    spline = interpolate.RectBivariateSpline(x[by_x], y[by_y], table.T, kx=degree, ky=degree, s=0)
    return (*spline.tck[:3], degree, degree)
