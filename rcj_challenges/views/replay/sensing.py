"""Sensor recordings for the page: readings rounded to what can be seen, packed, and what programs printed.

A block has, for each robot and each of its columns, first the ticks, int32 differences as four planes of bytes, lowest
first; the page undoes it in ``viewer/sensors.js``. The exact numbers are in the record (``records/sensors.py``).
"""

from __future__ import annotations

import base64
import json
import zlib
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from rcj_challenges.facts.timing import TICK_S
from rcj_challenges.facts.traffic import DeviceSpec
from rcj_challenges.records.sensors import SensorHalf, SensorTrack

UNITS = {
    "position_sensor": 1e-3,
    "gps": 1e-4,
    "compass": 1e-4,
    "distance_sensor": 0.1,
    "lidar": 1e-3,
}
"""What 1 is worth, in the unit of the device's own numbers."""
STRENGTH, DIRECTION, VELOCITY_RADPS = 1e-2, 1e-4, 1e-3

MOST_RAYS = 180
"""Rays of a lidar that the page carries: more cannot be told apart in a picture."""
MOST_LETTERS = 1_000_000
"""Printed text in a page; all of it is in the logs."""

NAN, INFINITE, MINUS_INFINITE = -(2**31), 2**31 - 1, -(2**31) + 1
_LARGEST = 2**31 - 2
_ZLIB_LEVEL = 6

Array = npt.NDArray[Any]


class _Column(NamedTuple):
    unit: float
    numbers: Array


def sensor_facts(half: SensorHalf) -> dict[str, Any]:
    """Return how a half's block is to be read, and which device each column belongs to."""
    return {
        "robots": [_robot_facts(track) for track in half.robots.values()],
        "full_at": half.full_at,
        "damaged": half.damaged,
    }


def sensor_block(half: SensorHalf) -> str:
    """Return the readings of all robots as text."""
    packer = zlib.compressobj(_ZLIB_LEVEL)
    parts = []
    for track in half.robots.values():
        parts.append(packer.compress(_planes(track.ticks.astype(np.int64))))
        parts += [packer.compress(_planes(_whole(column))) for column in _columns(track)]
    return base64.b64encode(b"".join([*parts, packer.flush()])).decode("ascii")


def output_block(half: SensorHalf) -> str:
    """Return what programs printed as text: packed JSON, ``[robot, tick, text]`` in order."""
    entries: list[tuple[str, int, str]] = []
    for name, track in half.robots.items():
        left = MOST_LETTERS // len(half.robots)
        for tick, text in track.output:
            entries.append((name, tick, text[:left]))
            left -= len(text)
            if left <= 0:
                entries.append((name, tick, "… (more in the log)\n"))
                break
    data = json.dumps(entries, separators=(",", ":")).encode("ascii")
    return base64.b64encode(zlib.compress(data, _ZLIB_LEVEL)).decode("ascii")


def _robot_facts(track: SensorTrack) -> dict[str, Any]:
    robot = track.robot
    return {
        "name": robot.name,
        "rows": len(track.ticks),
        "units": [column.unit for column in _columns(track)],
        "devices": [
            {
                "name": device.name,
                "kind": device.kind,
                "columns": _shown_width(device),
                "facts": _ray_facts(device),
            }
            for device in robot.devices
            if device.width
        ],
        "packets": robot.packets,
        "motors": [device.name for device in robot.motors],
    }


def _ray_facts(device: DeviceSpec) -> dict[str, Any]:
    """Return what drawing a device's rays needs."""
    if device.kind == "distance_sensor":
        return {"bearing_rad": device.facts["bearing_rad"], "max_value": device.facts["max_value"]}
    if device.kind == "lidar":
        step = _stride(device)
        return {
            "first_bearing_rad": device.facts["first_bearing_rad"],
            "bearing_step_rad": device.facts["bearing_step_rad"] * step,
            "max_range": device.facts["max_range"],
        }
    return {}


def _columns(track: SensorTrack) -> Iterator[_Column]:
    """Yield the columns of a robot: devices in order, a wheel's angle followed by its speed; packets; motors."""
    for device in track.robot.devices:
        if not device.width:
            continue
        readings = track.values[:, device.slot : device.slot + device.width : _stride(device)]
        for part in range(readings.shape[1]):
            yield _Column(UNITS.get(device.kind, 1e-3), readings[:, part])
        if device.kind == "position_sensor":
            yield _Column(VELOCITY_RADPS, _speeds(track.ticks, readings[:, 0]))
    for packet in range(track.robot.packets):
        yield _Column(STRENGTH, track.packets[:, packet, 0])
        for axis in (1, 2, 3):
            yield _Column(DIRECTION, track.packets[:, packet, axis])
    for motor in range(len(track.robot.motors)):
        yield _Column(VELOCITY_RADPS, track.motors[:, motor])


def _shown_width(device: DeviceSpec) -> int:
    if device.kind == "position_sensor":
        return 2
    return -(-device.width // _stride(device))


def _stride(device: DeviceSpec) -> int:
    return -(-device.width // MOST_RAYS) if device.kind == "lidar" else 1


def _speeds(ticks: Array, angles: Array) -> Array:
    """Return how fast a wheel turned from the observation before to each one, in rad/s."""
    speeds = np.full(len(angles), np.nan)
    passed = np.diff(ticks.astype(np.int64)) * TICK_S
    with np.errstate(divide="ignore", invalid="ignore"):
        speeds[1:] = np.diff(angles) / passed
    return speeds


def _whole(column: _Column) -> Array:
    """Return a column as whole numbers of its unit."""
    numbers = column.numbers
    with np.errstate(invalid="ignore", over="ignore"):
        scaled = np.rint(numbers / column.unit)
    whole: Array = np.clip(np.nan_to_num(scaled, nan=0.0, posinf=0.0, neginf=0.0), -_LARGEST, _LARGEST).astype(np.int64)
    whole[np.isnan(numbers)] = NAN
    whole[np.isposinf(numbers)] = INFINITE
    whole[np.isneginf(numbers)] = MINUS_INFINITE
    return whole


def _planes(numbers: Array) -> bytes:
    """Return differences from number to number, wrapped to 32 bits, as planes of bytes."""
    steps: Array = np.diff(numbers, prepend=0).astype(np.int64) & 0xFFFFFFFF
    return bytes(steps.astype("<u4").view(np.uint8).reshape(-1, 4).T.tobytes())
