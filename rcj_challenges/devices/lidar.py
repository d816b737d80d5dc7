"""The device ``lidar``: a ring of rays, all at once or a part of the turn each tick."""

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

from rcj_challenges.chassis.base import Chassis
from rcj_challenges.core.timing import TICK_S
from rcj_challenges.devices.base import Device, Fitted, RobotSetup, Sensor, SensorContext
from rcj_challenges.devices.noise import Noise
from rcj_challenges.devices.poses import RobotPose, Vector
from rcj_challenges.devices.wording import noise_words, order_words
from rcj_challenges.rules.fields import NotNegative, Positive, described
from rcj_challenges.rules.phrasing import counted, degrees, metres

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

LOWEST_HZ = 1.0
HIGHEST_HZ = 25.0
"""Bounds of ``setFrequency``, as in the Webots reference (Lidar: minFrequency, maxFrequency)."""

_MAX_SECTORS = 1_000
"""Sectors of a turning head that are kept; at 10 Hz there are 25."""


class LidarDevice(Device):
    """A laser scanner with one layer. The defaults are those of the original's robots."""

    # Their source: reference, section 4.2.

    device: Literal["lidar"]
    points: int = described(360, "number of readings, evenly spaced over field_of_view_rad", ge=1, le=1440)
    field_of_view_rad: Positive = described(6.283185307179586, "angle covered by the readings in rad", le=6.2832)
    min_range_m: NotNegative = described(0.01, "things nearer than this, in m, read as inf")
    max_range_m: Positive = described(3.0, "things farther than this, in m, read as inf", le=50)
    frame: Literal["field", "legacy"] = described(
        "field",
        "frame of its points; field: x ahead, y left, z up; legacy: x left, y up, z ahead as in the 2021 worlds",
    )
    height_m: Positive = described(0.0425, "height of the scanning plane above the floor in m")
    rotating: bool = described(
        True, "True: a rotating head refreshes part of the readings each tick; False: all are refreshed"
    )
    frequency_hz: Positive = described(10.0, "revolutions per second of a rotating head", le=31)
    noise_m: NotNegative = described(0.0, "standard deviation of each reading in m")

    CLASS = "lidar"
    ACCEPTS = frozenset({"sampling", "frequencies"})
    FREE = frozenset({"height_m"})
    MAX_SHOWN = 180  # rays of a picture: more cannot be distinguished
    PAGE_FACTS = ("first_bearing_rad", "bearing_step_rad", "max_range")
    EXAMPLE = """
robots:
  Y1: {devices: {lidar: {device: lidar, points: 180, max_range_m: 1.5, rotating: false, noise_m: 0.005}}}
"""

    @property
    def numbers(self) -> int:
        return self.points

    @property
    def is_full_turn(self) -> bool:
        """Whether it looks all around; a turn that was rounded is one."""
        return math.isclose(self.field_of_view_rad, 2 * math.pi, rel_tol=1e-4)

    @property
    def bearings(self) -> tuple[float, float]:
        """The bearing of cell 0 and the step from cell to cell, in rad, counter-clockwise from the front.

        A full turn begins at the front (reference, 4.2); a part of one spans from its left edge to its right edge. Both
        run clockwise.
        """
        if self.is_full_turn:
            return 0.0, -2 * math.pi / self.points
        if self.points == 1:
            return 0.0, 0.0
        return self.field_of_view_rad / 2, -self.field_of_view_rad / (self.points - 1)

    def place(self) -> Vector:
        return 0.0, 0.0, self.height_m

    def looks(self) -> tuple[float, float]:
        return 0.0, self.field_of_view_rad

    def facts(self, _setup: RobotSetup) -> dict[str, Any]:
        first_rad, step_rad = self.bearings
        return {
            "horizontal_resolution": self.points,
            "number_of_layers": 1,
            "number_of_points": self.points,
            "fov": self.field_of_view_rad,
            "vertical_fov": 0.0,
            "min_range": self.min_range_m,
            "max_range": self.max_range_m,
            "frequency": self.frequency_hz,
            "min_frequency": min(LOWEST_HZ, self.frequency_hz),
            "max_frequency": max(HIGHEST_HZ, self.frequency_hz),
            "rotating": self.rotating,
            "first_bearing_rad": first_rad,
            "bearing_step_rad": step_rad,
            **({"frame": self.frame} if self.frame != "field" else {}),
        }

    def contradictions(self, _chassis: Chassis) -> Iterator[tuple[str, str]]:
        if self.min_range_m >= self.max_range_m:
            yield "min_range_m", "must be less than max_range_m"

    def make_sensor(self, fitted: Fitted, context: SensorContext) -> Sensor:
        return LidarSensor(self, fitted, context)

    def describe(self) -> str:
        turning = f", turning at {self.frequency_hz:g} Hz" if self.rotating else ""
        noise = noise_words(metres(self.noise_m) if self.noise_m else "")
        order = order_words(self.frame, ", its points given as [left, up, ahead]")
        return (
            f"lidar, {counted(self.points, 'point')}, {metres(self.min_range_m)} to {metres(self.max_range_m)}"
            f"{turning}{order}{noise}, {metres(self.height_m)} above the floor, {self._sweep()}"
        )

    def _sweep(self) -> str:
        if self.points == 1:
            return "straight ahead"  # whatever its field of view is
        over = f"over {degrees(self.field_of_view_rad)} from left to right"
        return "clockwise from the front" if self.is_full_turn else over


class Sector(NamedTuple):
    """Cells of a ring: which, and the parts of their rays along the robot's +x and +y."""

    cells: "slice | NDArray[np.intp]"
    forward: "NDArray[np.float64]"
    left: "NDArray[np.float64]"


class LidarSensor(Sensor):
    """One scanner. Its plane is level at its height."""

    BLANK = 0.0  # a cell that the rays have not reached yet; source: reference, 4.2

    def __init__(self, device: LidarDevice, fitted: Fitted, context: SensorContext) -> None:
        import numpy as np

        super().__init__(fitted.spec)
        self.advances = device.rotating
        self._np = np
        self._device = device
        self._cells: NDArray[np.float32] = np.full(device.points, self.BLANK, np.float32)
        self._bounds_hz = (fitted.spec.facts["min_frequency"], fitted.spec.facts["max_frequency"])
        self._frequency_hz = device.frequency_hz
        self._turns = 0.0
        self._sectors: dict[tuple[float, float], Sector] = {}
        first_rad, step_rad = device.bearings
        bearings = first_rad + step_rad * np.arange(device.points)
        self._forward = np.cos(bearings)
        self._left = np.sin(bearings)
        self._whole = Sector(slice(None), self._forward, self._left)
        # Where in its clockwise turn from the front the head passes each cell, in turns.
        self._passed_at = (-bearings / (2 * math.pi)) % 1.0
        self._above_centre_m = device.height_m - fitted.setup.chassis.height_m / 2
        self._noise = Noise.of(fitted, context.half, device.points) if device.noise_m else None
        self._fan = context.rays.fan(fitted.robot_name, device.height_m, device.max_range_m, device.points)

    def clear(self, values: list[float]) -> None:
        super().clear(values)
        self._cells[:] = self.BLANK
        self._turns = 0.0

    def set_frequency(self, frequency_hz: float) -> None:
        if math.isfinite(frequency_hz):
            lowest, highest = self._bounds_hz
            self._frequency_hz = min(highest, max(lowest, frequency_hz))

    def read(self, tick: int, pose: RobotPose, values: list[float]) -> None:
        """Write all cells into the robot's numbers: as they are, if the head turns; else measured now."""
        if not self.advances:
            self._measure(tick, pose, self._whole)
        values[self.slot : self.slot + self.width] = self._cells.tolist()

    def advance(self, tick: int, pose: RobotPose) -> None:
        """Refresh the cells that a rotating head passes in one tick."""
        begin, passes = self._turns, self._frequency_hz * TICK_S  # less than a turn: at most 31 Hz
        # Rounded, so that a head that comes back to the same place is seen to be there.
        self._turns = round(begin + passes, 12) % 1.0
        sector = self._sectors.get((begin, passes))
        if sector is None:
            sector = self._sector(begin, passes)
        self._measure(tick, pose, sector)

    def _sector(self, begin: float, passes: float) -> Sector:
        """Return the cells that the head passes from one place on, in turns; kept, for it passes them again."""
        np = self._np
        # Rounded to a billionth of a turn: whether a cell is passed must not hang on the last bit of a sum.
        since = np.round((self._passed_at - begin) % 1.0, 9) % 1.0
        cells = np.flatnonzero(since < round(passes, 9))
        if len(self._sectors) >= _MAX_SECTORS:
            self._sectors.clear()
        sector = self._sectors[begin, passes] = Sector(cells, self._forward[cells], self._left[cells])
        return sector

    def _measure(self, tick: int, pose: RobotPose, sector: Sector) -> None:
        chosen, forward, left = sector
        np, device, fan = self._np, self._device, self._fan
        fan.origin[:] = (pose.x, pose.y, pose.z + self._above_centre_m)
        rays = fan.directions[: len(forward)]
        rays[:, 0] = pose.cos * forward - pose.sin * left
        rays[:, 1] = pose.sin * forward + pose.cos * left
        distances = fan.cast(len(forward))
        unseen = (distances < device.min_range_m) | (distances > device.max_range_m)
        if self._noise is not None:
            distances += device.noise_m * self._noise.row(tick)[chosen]
            np.maximum(distances, 0.0, out=distances)
        self._cells[chosen] = np.where(unseen, np.inf, distances)
