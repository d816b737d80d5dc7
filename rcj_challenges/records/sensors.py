"""Sensor recordings: what each program saw, set and printed, tick by tick; made on request (``--record sensors``).

``sensors/half-1.sensors`` begins with a line of JSON that tells which devices each robot has; chunks follow, each of
some seconds: ``CHNK``, the length of what follows (little-endian uint32), and a zlib stream. That holds a line of JSON
(rows for each robot, printed text), then each robot's rows of `row_dtype`, column by column of bytes: bytes of one
place change little from row to row, so they pack well. Numbers are the float64 that the program got, bit for bit.

A file is appended to and never changed, so a kill loses the last `TICKS_BETWEEN_WRITES` at most, and no file grows
beyond `MOST_BYTES_A_HALF`: what comes later is left out, and the recording says from which tick on.
"""

from __future__ import annotations

import math
import struct
import zlib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, BinaryIO, Protocol

import numpy as np
import numpy.typing as npt

from rcj_challenges.devices import device_of_class
from rcj_challenges.facts.traffic import DeviceSpec, MotorCommand, Observation, RobotSpec
from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.folder import RECORD_VERSION, SENSORS, read_file
from rcj_challenges.records.lines import json_line, parsed
from rcj_challenges.records.track import write_all

TICKS_BETWEEN_WRITES = 125
"""4 s of the match: longer chunks pack better, shorter ones lose less on a kill."""

MOST_BYTES_A_HALF = 15_000_000
MOST_LETTERS_A_HALF = 2_000_000
"""Of printed text; all of it stands in ``logs/``."""

FLOATS_PER_PACKET = 4
"""Strength (1 / m²), then the direction x, y, z in the robot's frame."""

_MAGIC = b"CHNK"
_HEAD = struct.Struct("<4sI")
_ZLIB_LEVEL = 1
_MOST_CHUNK_BYTES = 100_000_000
_NO_PACKET = (math.nan,) * FLOATS_PER_PACKET

DAMAGE = (OSError, ValueError, KeyError, TypeError, AttributeError, IndexError, OverflowError, MemoryError)
"""What json, numpy and arithmetic raise on a file that is not what it should be."""

Array = npt.NDArray[Any]


@dataclass(frozen=True)
class SensedRobot:
    """What is recorded of one robot.

    Attributes:
        name: ``B1``.
        devices: all of its devices, as its program knows them.
        values: how many numbers an observation has.
        ball_receivers: names of the receivers that hear balls.
        packets: how many of the ball's packets an observation is recorded with: the last ones.
    """

    name: str
    devices: tuple[DeviceSpec, ...]
    values: int
    ball_receivers: tuple[str, ...] = ()
    packets: int = 0

    @property
    def motors(self) -> tuple[DeviceSpec, ...]:
        """Its motors, in order."""
        return tuple(device for device in self.devices if "motors" in device_of_class(device.kind).ACCEPTS)

    @classmethod
    def of(cls, spec: RobotSpec, ball_receivers: Sequence[str], balls: int) -> SensedRobot:
        """Return what is to be recorded of a robot; ``balls`` is how many of them may be heard at once."""
        return cls(spec.name, spec.devices, spec.values, tuple(ball_receivers), balls if ball_receivers else 0)


def row_dtype(robot: SensedRobot) -> np.dtype[np.void]:
    """Return the layout of one observation.

    ``tick``; ``values``: the numbers of its devices by slot (NaN before the first sample); ``packets``: the ball's, the
    newest last, NaN where there are fewer; ``motors``: the velocities in rad/s that the program set on this
    observation, NaN while it has not set any or while the motor holds an angle.
    """
    return np.dtype(
        [
            ("tick", "<u4"),
            ("values", "<f8", (robot.values,)),
            ("packets", "<f8", (robot.packets, FLOATS_PER_PACKET)),
            ("motors", "<f8", (len(robot.motors),)),
        ]
    )


class SensorListener(Protocol):
    """Somebody who is given a recording while it is made. Calls must return at once: the match waits for them."""

    def sensed(self, robot: int, row: bytes) -> None:
        """Take a row of `row_dtype`, as it is recorded.

        Args:
            robot: its place in the order of the recording.
            row: the observation, with what the program set on it.
        """

    def printed(self, entry: tuple[int, int, str]) -> None:
        """Take what a program printed, as it is recorded: robot, tick of the observation before, text."""


class _Rows:
    """The rows of one robot that are not written yet."""

    def __init__(self, robot: SensedRobot) -> None:
        receivers = {device.index for device in robot.devices if device.name in robot.ball_receivers}
        self._ball_receivers = receivers
        self._packets = robot.packets
        self._motor_at = {device.index: at for at, device in enumerate(robot.motors)}
        self._motors = [math.nan] * len(robot.motors)
        floats = robot.values + FLOATS_PER_PACKET * robot.packets + len(robot.motors)
        self._pack = struct.Struct(f"<I{floats}d").pack
        self._bytes_per_row = 4 + 8 * floats
        self._values: list[float] = [math.nan] * robot.values
        self._heard: list[float] = list(_NO_PACKET * robot.packets)
        self._rows = bytearray()
        self.tick = 0

    def saw(self, observation: Observation) -> None:
        self.tick = observation.tick
        self._values = observation.values
        if self._packets:
            heard = [packet for packet in observation.packets if packet.device in self._ball_receivers]
            numbers: list[float] = list(_NO_PACKET * max(0, self._packets - len(heard)))
            for packet in heard[-self._packets :]:
                numbers += (packet.strength, *packet.direction)
            self._heard = numbers

    def did(self, motors: Sequence[MotorCommand]) -> bytes:
        for command in motors:
            held = not math.isinf(command.position_rad)
            self._motors[self._motor_at[command.device]] = math.nan if held else command.velocity_radps
        row = self._pack(self.tick, *self._values, *self._heard, *self._motors)
        self._rows += row
        return row

    def take(self) -> tuple[int, bytes]:
        """Return number and bytes of the rows, column by column, and forget them."""
        count = len(self._rows) // self._bytes_per_row
        planes = np.frombuffer(bytes(self._rows), np.uint8).reshape(count, self._bytes_per_row).T.tobytes()
        self._rows.clear()
        return count, planes


class SensorWriter:
    """Writes the sensor recording of one half."""

    def __init__(self, folder: Path, half: int, robots: Sequence[SensedRobot]) -> None:
        """Open the file.

        Args:
            folder: of the run.
            half: 1-based.
            robots: those whose programs are recorded; calls name them by their place in this order.
        """
        (folder / SENSORS).mkdir(exist_ok=True)
        self._file: BinaryIO = _path(folder, half).open("xb", buffering=0)
        self._rows = [_Rows(robot) for robot in robots]
        self._listeners: tuple[SensorListener, ...] = ()
        self._output: list[tuple[int, int, str]] = []
        self._letters_left = MOST_LETTERS_A_HALF
        self._next_write = TICKS_BETWEEN_WRITES
        self._is_full = False
        self._size = 0
        self._append(
            json_line(
                {
                    "record": RECORD_VERSION,
                    "half": half,
                    "robots": [asdict(robot) for robot in robots],
                }
            )
        )

    def tell(self, listeners: Sequence[SensorListener]) -> None:
        """Give what is recorded from now on to these too."""
        self._listeners = tuple(listeners)

    def saw(self, robot: int, observation: Observation) -> None:
        """Note what a program is told."""
        if not self._is_full:
            if observation.tick >= self._next_write:
                self._write()
                self._next_write = observation.tick + TICKS_BETWEEN_WRITES
            self._rows[robot].saw(observation)

    def did(self, robot: int, motors: Sequence[MotorCommand], printed: str = "") -> None:
        """Note what a program set and printed on what it was told last (before the first: at tick 0)."""
        if not self._is_full:
            row = self._rows[robot].did(motors)
            for listener in self._listeners:
                listener.sensed(robot, row)
            self.printed(robot, printed)

    def printed(self, robot: int, text: str) -> None:
        """Note what a program printed since it was told something last."""
        if text and not self._is_full and self._letters_left > 0:
            if len(text) > self._letters_left:
                text = text[: self._letters_left] + "\n… (more in logs)\n"
            self._letters_left -= len(text)
            entry = (robot, self._rows[robot].tick, text)
            self._output.append(entry)
            for listener in self._listeners:
                listener.printed(entry)

    def close(self) -> None:
        """Write what is left and close the file. Can be called again."""
        if not self._file.closed:
            self._write()
            self._file.close()

    def _write(self) -> None:
        parts = [rows.take() for rows in self._rows]
        if not self._is_full and (self._output or any(count for count, _ in parts)):
            head = {"rows": [count for count, _ in parts], "output": self._output}
            chunk = _chunk(b"".join([json_line(head), *(planes for _, planes in parts)]))
            if self._size + len(chunk) > MOST_BYTES_A_HALF:
                self._is_full = True
                ticks = [rows.tick for rows in self._rows]
                chunk = _chunk(json_line({"rows": [0] * len(parts), "output": [], "full_at": max(ticks, default=0)}))
            self._append(chunk)
        self._output = []

    def _append(self, data: bytes) -> None:
        self._size += len(data)
        write_all(self._file, bytearray(data))


def _chunk(data: bytes) -> bytes:
    packed = zlib.compress(data, _ZLIB_LEVEL)
    return _HEAD.pack(_MAGIC, len(packed)) + packed


def _path(folder: Path, half: int) -> Path:
    return folder / SENSORS / f"half-{half}.sensors"


# --- reading ----------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class SensorTrack:
    """What one robot's program saw and did in one half; ``N`` observations.

    Attributes:
        robot: its devices.
        ticks: ``[N]``, at which tick each observation was made.
        values: ``[N, values]``, float64, as the program got them; NaN before the first sample.
        packets: ``[N, packets, 4]``, strength and direction of the ball's packets, the newest last.
        motors: ``[N, motors]``, velocities in rad/s that it set on the observation.
        output: what it printed: tick of the observation before, text.
    """

    robot: SensedRobot
    ticks: Array
    values: Array
    packets: Array
    motors: Array
    output: tuple[tuple[int, str], ...]

    def readings(self, device: str) -> Array:
        """Return the numbers of one device, ``[N, width]``.

        Raises:
            KeyError: it has no such device, or one without numbers.
        """
        spec = next((one for one in self.robot.devices if one.name == device and one.width), None)
        if spec is None:
            raise KeyError(device)
        return self.values[:, spec.slot : spec.slot + spec.width]


@dataclass(frozen=True)
class SensorHalf:
    """The sensor recording of one half.

    Attributes:
        half: 1-based.
        robots: by name.
        full_at: the tick from which on nothing is recorded because the file had reached its size; None: all is there.
        damaged: whether the file ends in the middle, or something in it cannot be read; what came before is here.
    """

    half: int
    robots: Mapping[str, SensorTrack]
    full_at: int | None = None
    damaged: bool = False


@dataclass
class _Gathering:
    """What has been read of a file so far."""

    rows: list[list[Array]]
    output: list[list[tuple[int, str]]]
    full_at: int | None = None
    damaged: bool = False


def read_sensors(folder: Path) -> dict[int, SensorHalf]:
    """Return the sensor recordings of a run by half; empty if it was played without them.

    Raises:
        RecordError: a file is none of ours, or written by a newer version.
    """
    found = {}
    for path in sorted((folder / SENSORS).glob("half-*.sensors")):
        try:
            half = _read(path)
        except DAMAGE as error:
            raise RecordError(f"{folder.name}: {SENSORS}/{path.name} is no sensor recording: {error}") from error
        found[half.half] = half
    return dict(sorted(found.items()))


def _read(path: Path) -> SensorHalf:
    data = read_file(path)
    end = data.index(b"\n")
    head = parsed(data[:end])
    if head["record"] > RECORD_VERSION:
        raise RecordError(f"{path.name}: written by a newer version: it needs a newer rcj-challenges")
    robots = [_robot(robot) for robot in head["robots"]]
    found = _Gathering([[] for _ in robots], [[] for _ in robots])
    dtypes = [row_dtype(robot) for robot in robots]
    for text, planes in _chunks(data, end + 1, found):
        _gather(text, planes, dtypes, found)
    tracks = {}
    for robot, dtype, rows, output in zip(robots, dtypes, found.rows, found.output, strict=True):
        every = np.concatenate(rows) if rows else np.zeros(0, dtype)
        tick, values, packets, motors = (
            np.ascontiguousarray(every[name]) for name in ("tick", "values", "packets", "motors")
        )
        tracks[robot.name] = SensorTrack(robot, tick, values, packets, motors, tuple(output))
    return SensorHalf(int(head["half"]), tracks, found.full_at, found.damaged)


def _robot(data: dict[str, Any]) -> SensedRobot:
    devices = tuple(DeviceSpec(**device) for device in data["devices"])
    return SensedRobot(data["name"], devices, int(data["values"]), tuple(data["ball_receivers"]), int(data["packets"]))


def _chunks(data: bytes, at: int, found: _Gathering) -> Iterator[tuple[dict[str, Any], bytes]]:
    """Yield head and planes of the whole chunks; notes it if the file goes wrong."""
    while at < len(data):
        body = memoryview(data)[at + _HEAD.size :]
        try:
            magic, size = _HEAD.unpack_from(data, at)
            if magic != _MAGIC or size > len(body):
                raise ValueError("no whole chunk")
            unpacker = zlib.decompressobj()
            text = unpacker.decompress(body[:size], _MOST_CHUNK_BYTES)
            if not unpacker.eof:
                raise ValueError("no whole chunk")
            end = text.index(b"\n")
            head = parsed(text[:end])
        except (struct.error, ValueError, zlib.error):
            found.damaged = True
            return
        yield head, text[end + 1 :]
        at += _HEAD.size + size


def _gather(head: dict[str, Any], planes: bytes, dtypes: Sequence[np.dtype[np.void]], found: _Gathering) -> None:
    at = 0
    for rows, count, dtype in zip(found.rows, head["rows"], dtypes, strict=True):
        size = count * dtype.itemsize
        block = np.frombuffer(planes[at : at + size], np.uint8).reshape(dtype.itemsize, count)
        rows.append(np.ascontiguousarray(block.T).view(dtype)[:, 0])
        at += size
    for robot, tick, text in head["output"]:
        found.output[robot].append((int(tick), str(text)))
    if "full_at" in head:
        found.full_at = int(head["full_at"])
