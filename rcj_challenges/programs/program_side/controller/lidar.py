"""The laser scanner."""

from __future__ import annotations

import math
from struct import Struct

from ._connection import Connection, complain
from .device import ReadOnly, Sensor

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

_POINT = Struct("<3fif")  # a point in a buffer: x, y, z, layer_id, time


class LidarPoint:
    """One reading as a point.

    Attributes:
        x: forward, in m, in the robot's frame; of a lidar of 2021: to the left.
        y: to the left, in m; of a lidar of 2021: up.
        z: up, in m; of a lidar of 2021: forward.
        layer_id: 0, there is one layer.
        time: when it was read, in s.
    """

    def __init__(self, x: float, y: float, z: float, layer_id: int, time: float) -> None:
        self.x, self.y, self.z, self.layer_id, self.time = x, y, z, layer_id, time

    def __repr__(self) -> str:
        return f"LidarPoint(x={self.x!r}, y={self.y!r}, z={self.z!r}, layer_id={self.layer_id}, time={self.time!r})"


class Lidar(Sensor):
    """Ranges all around, one layer. Index 0 looks forward, the index grows clockwise."""

    def _rcj_set_up(self, connection: Connection, spec: dict[str, Any]) -> None:
        super()._rcj_set_up(connection, spec)
        self._rcj_end = self._rcj_place + 1
        self._rcj_form = Struct(f"<{spec['width']}d")
        self._rcj_has_cloud = False
        self._rcj_frequency = float(self._rcj_facts.get("frequency", 10.0))

    def _rcj_numbers(self) -> tuple[float, ...]:
        packed: Any = super()._rcj_numbers()[0]
        return self._rcj_form.unpack(packed)

    def getRangeImage(self, data_type: str = "list") -> Any:
        """Return the ranges in m: ``inf`` beyond the range, 0.0 where the head has not been yet.

        Index 0 looks forward, the index grows clockwise by 1°. ``data_type="buffer"`` gives a bytearray of float32.

        Example:
            ``ahead_m = lidar.getRangeImage()[0]``
        """
        ranges = self._rcj_numbers()
        return bytearray(Struct(f"<{len(ranges)}f").pack(*ranges)) if data_type == "buffer" else list(ranges)

    def getLayerRangeImage(self, layer: int) -> list[float]:
        """Return the ranges of a layer; there is one, 0."""
        return list(self._rcj_numbers()) if layer == 0 else []

    def getRangeImageArray(self) -> list[list[float]]:
        """Return the ranges as columns: ``[index][layer]``."""
        return [[reading] for reading in self._rcj_numbers()]

    def enablePointCloud(self) -> None:
        """Let ``getPointCloud`` answer."""
        self._rcj_has_cloud = True

    def disablePointCloud(self) -> None:
        """Let ``getPointCloud`` give nothing."""
        self._rcj_has_cloud = False

    def isPointCloudEnabled(self) -> bool:
        """Return whether ``getPointCloud`` answers."""
        return self._rcj_has_cloud

    def getPointCloud(self, data_type: str = "list") -> Any:
        """Return the readings as a list of `LidarPoint`; empty unless ``enablePointCloud`` was called.

        ``data_type="buffer"`` gives them as a bytearray: of each point x, y, z as float32, layer_id as int32 and time
        as float32.
        """
        points = self._rcj_points() if self._rcj_has_cloud else []
        if data_type != "buffer":
            return points
        return bytearray().join([_POINT.pack(one.x, one.y, one.z, one.layer_id, one.time) for one in points])

    def _rcj_points(self) -> list[LidarPoint]:
        readings, time = self._rcj_numbers(), self._rcj_connection.time_s()
        first = float(self._rcj_facts.get("first_bearing_rad", 0.0))
        step = float(self._rcj_facts.get("bearing_step_rad", -self.getFov() / max(len(readings), 1)))
        bearings = [first + step * index for index in range(len(readings))]
        flat = [
            (_part(reading, math.cos(bearing)), _part(reading, math.sin(bearing)))
            for reading, bearing in zip(readings, bearings, strict=True)
        ]
        if self._rcj_facts.get("frame") == "legacy":
            return [LidarPoint(left, 0.0, ahead, 0, time) for ahead, left in flat]
        return [LidarPoint(ahead, left, 0.0, 0, time) for ahead, left in flat]

    def getLayerPointCloud(self, layer: int, data_type: str = "list") -> Any:
        """Return the points of a layer as `getPointCloud` does; there is one, 0."""
        if layer == 0:
            return self.getPointCloud(data_type)
        return bytearray() if data_type == "buffer" else []

    def getHorizontalResolution(self) -> int:
        """The number of readings of a layer."""
        return int(self._rcj_spec["width"])

    def getNumberOfLayers(self) -> int:
        """Return 1."""
        return 1

    def getNumberOfPoints(self) -> int:
        """The number of readings in all."""
        return self.getHorizontalResolution()

    def getMinRange(self) -> float:
        """Return the smallest range in m."""
        return float(self._rcj_facts.get("min_range", 0.01))

    def getMaxRange(self) -> float:
        """Return the largest range in m."""
        return float(self._rcj_facts.get("max_range", 3.0))

    def getFov(self) -> float:
        """Return the angle that the readings cover, in rad."""
        return float(self._rcj_facts.get("fov", math.tau))

    def getVerticalFov(self) -> float:
        """Return 0: one flat layer."""
        return 0.0

    def getFrequency(self) -> float:
        """Return the turns per second of the head."""
        return self._rcj_frequency

    def setFrequency(self, frequency: float) -> None:
        """Let the head turn at this pace in Hz, within its bounds."""
        asked = float(frequency)
        if math.isnan(asked):
            complain(f"Error: {self.getName()!r}: setFrequency(NaN) is refused.", "correct this call")
            return
        self._rcj_frequency = min(max(asked, self.getMinFrequency()), self.getMaxFrequency())
        self._rcj_connection.spin(self._rcj_index, self._rcj_frequency)

    def getMinFrequency(self) -> float:
        """Return the slowest pace of the head in Hz."""
        return float(self._rcj_facts.get("min_frequency", 1.0))

    def getMaxFrequency(self) -> float:
        """Return the fastest pace of the head in Hz."""
        return float(self._rcj_facts.get("max_frequency", 25.0))

    range_image = ReadOnly(getRangeImage)
    point_cloud = ReadOnly(getPointCloud)
    point_cloud_enabled = ReadOnly(isPointCloudEnabled)
    horizontal_resolution = ReadOnly(getHorizontalResolution)
    number_of_layers = ReadOnly(getNumberOfLayers)
    number_of_points = ReadOnly(getNumberOfPoints)
    min_range = ReadOnly(getMinRange)
    max_range = ReadOnly(getMaxRange)
    fov = ReadOnly(getFov)
    vertical_fov = ReadOnly(getVerticalFov)
    frequency = property(getFrequency, setFrequency)
    min_frequency = ReadOnly(getMinFrequency)
    max_frequency = ReadOnly(getMaxFrequency)


def _part(reading: float, share: float) -> float:
    """Return a component of a reading that may be ``inf``; a direction at right angles has none of it."""
    return reading * share if abs(share) > 1e-12 else 0.0
