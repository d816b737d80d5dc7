"""Sensor recordings for the page: readings rounded to what can be seen, packed, and what programs printed.

A block has, for each robot and each of its columns, first the ticks, int32 differences as four planes of bytes, lowest
first; the page undoes it in ``viewer/sensors.js``. Packets of cameras stand in blocks of some seconds each: the size of
a head of JSON, the head, the packets (``viewer/pictures.js``). The exact numbers are in the record
(``records/sensors.py``).
"""

from __future__ import annotations

import base64
import json
import zlib
from itertools import groupby
from operator import itemgetter
from typing import Any

import numpy as np
import numpy.typing as npt

from rcj_challenges.core.traffic import DeviceSpec
from rcj_challenges.devices import device_of_class
from rcj_challenges.records.sensors import SensedRobot, SensorHalf

STRENGTH, DIRECTION, VELOCITY_RADPS = 1e-2, 1e-4, 1e-3

NAN, INFINITE, MINUS_INFINITE = -(2**31), 2**31 - 1, -(2**31) + 1
PICTURE_TICKS = 500
"""16 s: what six cameras take in that time is 3 MB when it is unpacked."""

_LARGEST = 2**31 - 2
_ZLIB_LEVEL = 6

Array = npt.NDArray[Any]


def sensor_facts(half: SensorHalf) -> dict[str, Any]:
    """Return the layout of a half's block: which device each column belongs to."""
    return {
        "robots": [robot_facts(track.robot) | {"rows": len(track.ticks)} for track in half.robots.values()],
        "full_at": half.full_at,
        "picture_ticks": PICTURE_TICKS,
        "damaged": half.damaged,
    }


def sensor_block(half: SensorHalf) -> str:
    """Return the readings of all robots as text."""
    packer = zlib.compressobj(_ZLIB_LEVEL)
    parts = []
    for track in half.robots.values():
        parts.append(packer.compress(_planes(track.ticks.astype(np.int64))))
        units, at = columns_of(track.robot)
        rows = len(track.ticks)
        floats = np.hstack((track.values, track.packets.reshape(rows, -1), track.motors))[:, at]
        parts += [packer.compress(_planes(column)) for column in whole_numbers(units, floats).T]
    return base64.b64encode(b"".join([*parts, packer.flush()])).decode("ascii")


def picture_blocks(half: SensorHalf) -> dict[str, str]:
    """Return the packets of all cameras in blocks by id; each begins with what was there before."""
    entries = sorted(
        (tick // PICTURE_TICKS, name, number, tick, data)
        for name, track in half.robots.items()
        for tick, number, data in track.pictures
    )
    newest: dict[tuple[str, int], tuple[int, bytes]] = {}
    blocks = {}
    for block, some in groupby(entries, key=itemgetter(0)):
        held = [(name, number, *one) for (name, number), one in newest.items()]
        held += [(name, number, tick, data) for _, name, number, tick, data in some]
        newest |= {(name, number): (tick, data) for name, number, tick, data in held}
        head = json.dumps([(name, number, tick, len(data)) for name, number, tick, data in held]).encode("ascii")
        body = b"".join([len(head).to_bytes(4, "little"), head, *(data for *_, data in held)])
        blocks[f"pictures-{half.half}-{block}"] = base64.b64encode(zlib.compress(body, _ZLIB_LEVEL)).decode("ascii")
    return blocks


def output_block(half: SensorHalf) -> str:
    """Return the output of programs as packed JSON, ``[robot, tick, text]`` in order."""
    entries = [(name, tick, text) for name, track in half.robots.items() for tick, text in track.output]
    data = json.dumps(entries, separators=(",", ":")).encode("ascii")
    return base64.b64encode(zlib.compress(data, _ZLIB_LEVEL)).decode("ascii")


def robot_facts(robot: SensedRobot) -> dict[str, Any]:
    """Return the columns that the page has of a robot, with the device of each."""
    return {
        "name": robot.name,
        "units": columns_of(robot)[0].tolist(),
        "devices": [
            {
                "name": device.name,
                "kind": device.kind,
                "columns": -(-device.width // _stride(device)),
                "facts": _page_facts(device),
            }
            for device in robot.devices
            if device.width
        ],
        "packets": robot.packets,
        "motors": [[device.name, device.facts.get("unit", "rad/s")] for device in robot.motors],
        "lights": [device.facts.get("colours") for device in robot.motors],
        "cameras": [
            [device.index, device.name, device.facts["width"], device.facts["height"]] for device in robot.cameras
        ],
    }


def _page_facts(device: DeviceSpec) -> dict[str, Any]:
    facts = {name: device.facts[name] for name in device_of_class(device.kind).PAGE_FACTS}
    # Of readings that are skipped evenly, those that are shown are further apart.
    return {name: value * _stride(device) if name == "bearing_step_rad" else value for name, value in facts.items()}


def columns_of(robot: SensedRobot) -> tuple[Array, Array]:
    """Return of the columns of a robot the units, and the places among the floats of a recorded row.

    The floats are values, packets and motors; of the values of devices with many, some are skipped.
    """
    units, at = list[float](), list[int]()
    for device in robot.devices:
        shown = range(device.slot, device.slot + device.width, _stride(device))
        units += [device_of_class(device.kind).RESOLUTION] * len(shown)
        at += shown
    units += [STRENGTH, DIRECTION, DIRECTION, DIRECTION] * robot.packets + [VELOCITY_RADPS] * len(robot.motors)
    return np.array(units), np.array([*at, *range(robot.values, robot.values + len(units) - len(at))], np.intp)


def whole_numbers(units: Array, numbers: Array) -> Array:
    """Return numbers, ``[N, columns]``, as multiples of the units of their columns; `NAN` stands for what is none."""
    with np.errstate(invalid="ignore", over="ignore"):
        whole: Array = np.clip(np.rint(numbers / units), -_LARGEST, _LARGEST).astype(np.int64)
    if not np.isfinite(numbers).all():
        whole[np.isnan(numbers)] = NAN
        whole[numbers == np.inf] = INFINITE
        whole[numbers == -np.inf] = MINUS_INFINITE
    return whole


def _stride(device: DeviceSpec) -> int:
    """Return the number of readings for each that is shown."""
    return max(1, -(-device.width // device_of_class(device.kind).MAX_SHOWN))


def _planes(numbers: Array) -> bytes:
    """Return differences from number to number, wrapped to 32 bits, as planes of bytes."""
    steps: Array = np.diff(numbers, prepend=0).astype(np.int64) & 0xFFFFFFFF
    return bytes(steps.astype("<u4").view(np.uint8).reshape(-1, 4).T.tobytes())
