"""Random errors of sensors: one stream per device and half, one row of draws per tick.

The draws of tick k are always the k-th of their stream, whether a program reads them or not. So neither the sampling
period of a device, nor another device more or less, ever shifts a reading.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Self

from rcj_challenges.core.play import HalfInfo
from rcj_challenges.core.streams import stream_seed

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from rcj_challenges.devices.base import Fitted

_DRAWS_PER_BLOCK = 8192
"""Numbers drawn at once: drawing singly costs more than measuring. Of no influence on the numbers themselves."""


def sensor_stream(half: HalfInfo, robot: str, device: str) -> np.random.Generator:
    """Return the generator of one device of one robot in one half."""
    import numpy as np

    name = f"half {half.half}/sensor/{robot}/{device}"
    return np.random.Generator(np.random.PCG64(stream_seed(half.match_seed, name)))


def drawn_once(fitted: Fitted, half: HalfInfo) -> float:
    """Return the normal draw of a device for a whole half, from a stream of its own."""
    return float(sensor_stream(half, fitted.robot_name, f"{fitted.spec.name}/drift").standard_normal())


class Noise:
    """Normal draws of several devices, side by side."""

    def __init__(
        self, half: HalfInfo, devices: Sequence[tuple[str, str]], draws_per_tick: int = 1,
        scale: NDArray[np.float64] | float = 1.0,
    ) -> None:  # fmt: skip
        """Open a stream for each device, (robot, device) by name.

        Each uses so many numbers in a tick; a row is multiplied by ``scale``: one number, or one for each of its draws.
        """
        import numpy as np

        self._streams = [sensor_stream(half, robot, device) for robot, device in devices]
        self._draws = draws_per_tick
        self._ticks = max(1, _DRAWS_PER_BLOCK // max(1, draws_per_tick * len(devices)))
        self._block = np.empty((0, len(devices) * draws_per_tick))
        self._listed: list[list[float]] = []
        self._first = 0
        self._scale = scale

    @classmethod
    def of(cls, fitted: Fitted, half: HalfInfo, draws_per_tick: int = 1) -> Self:
        """Return the noise of one device."""
        return cls(half, [(fitted.robot_name, fitted.spec.name)], draws_per_tick)

    def row(self, tick: int) -> NDArray[np.float64]:
        """Return the draws of a tick, shape [devices · draws_per_tick]. Ticks must not go back."""
        while tick >= self._first + len(self._block):
            import numpy as np

            self._first += len(self._block)
            shape = (self._ticks, self._draws)
            block = np.concatenate([stream.standard_normal(shape) for stream in self._streams], axis=1)
            self._block = block * self._scale
            self._listed = []
        row: NDArray[np.float64] = self._block[tick - self._first]
        return row

    def numbers(self, tick: int) -> list[float]:
        """Return the draws of a tick as numbers: for a handful of them. Ticks must not go back."""
        if tick >= self._first + len(self._listed):
            self.row(tick)
            self._listed = self._block.tolist()
        return self._listed[tick - self._first]
