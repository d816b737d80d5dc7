"""Sensor recordings: what programs printed, and, with ``--record sensors``, what they saw and set, tick by tick.

``sensors/half-1.sensors`` is a file of chunks (`chunks`). Its header lists the devices of each robot. The head of a
chunk has the number of rows of each robot and the printed text; its bytes are each robot's rows of `row_dtype`, column
by column of bytes: bytes of one place change little from row to row, so they pack well. Numbers are the float64 that
the program got, bit for bit. After the rows stand the packets of cameras (`devices.camera`), which the head lists as
robot, tick, number of the camera or of its recognition, and size.

A kill loses the last `TICKS_PER_CHUNK` at most, and no file grows beyond `MAX_BYTES_A_HALF`: what comes later is left
out, and the recording says from which tick on.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Protocol, Self

import numpy as np
import numpy.typing as npt

from rcj_challenges.core.traffic import DeviceSpec, MotorCommand, Observation, RobotSpec
from rcj_challenges.devices import device_of_class
from rcj_challenges.devices.camera import RECOGNITION
from rcj_challenges.records.chunks import DAMAGE, ChunkWriter, read_chunks
from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.folder import SENSORS

TICKS_PER_CHUNK = 125
"""4 s of the match: longer chunks pack better, shorter ones lose less on a kill."""

MAX_BYTES_A_HALF = 15_000_000
MAX_PRINTED_BYTES = 100_000
"""Of printed text, of each robot in a half; all of it stands in ``logs/``."""
MORE_IN_THE_LOG = "… (more in the log)\n"

FLOATS_PER_PACKET = 4
"""Strength (1 / m²), then the direction x, y, z in the robot's frame."""

_ZLIB_LEVEL = 1
_NO_PACKET = (math.nan,) * FLOATS_PER_PACKET

Array = npt.NDArray[Any]
Picture = tuple[int, int, bytes]
"""A packet of a camera: the tick of the observation, the number of the camera or of its recognition, its bytes."""


@dataclass(frozen=True)
class SensedRobot:
    """The recorded data of one robot.

    Attributes:
        devices: all of its devices, as its program knows them; none if only what it prints is recorded.
        values: number of values in an observation.
        packets: number of the ball's packets that are recorded with an observation: the last ones.
    """

    name: str
    devices: tuple[DeviceSpec, ...] = ()
    values: int = 0
    ball_receivers: tuple[str, ...] = ()
    packets: int = 0

    @property
    def motors(self) -> tuple[DeviceSpec, ...]:
        """Its motors, in order."""
        return tuple(device for device in self.devices if "motors" in device_of_class(device.kind).ACCEPTS)

    @property
    def cameras(self) -> tuple[DeviceSpec, ...]:
        """Its cameras, in order."""
        return tuple(device for device in self.devices if device.kind == "camera")

    @classmethod
    def of(cls, spec: RobotSpec, ball_receivers: Sequence[str], balls: int) -> Self:
        """Return all that can be recorded of a robot; ``balls`` is the number that may be received at once."""
        return cls(spec.name, spec.devices, spec.values, tuple(ball_receivers), balls if ball_receivers else 0)


def row_dtype(robot: SensedRobot) -> np.dtype[np.void]:
    """Return the layout of one observation.

    ``tick``; ``values``: the numbers of its devices by slot (NaN before the first sample); ``packets``: the ball's, the
    newest last, NaN where there are fewer; ``motors``: the velocities in rad/s that the program set on this
    observation, NaN while it has not set any or while the motor holds an angle; of a kicker while its plunger is back.
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
    """Receives a recording while it is made. Calls must return at once: the match waits for them."""

    def on_row(self, robot: int, row: bytes) -> None:
        """Take a row of `row_dtype` of a robot, by its place in the order of the recording."""

    def on_output(self, entry: tuple[int, int, str]) -> None:
        """Take what a program printed, as it is recorded: robot, tick of the observation before, text."""


class _Rows:
    def __init__(self, robot: SensedRobot) -> None:
        self._ball_receivers = {device.index for device in robot.devices if device.name in robot.ball_receivers}
        self._packets = robot.packets
        self._motor_at = {device.index: at for at, device in enumerate(robot.motors)}
        self._kickers = {at for at, device in enumerate(robot.motors) if device.facts.get("unit") == "m/s"}
        self._motors = [math.nan] * len(robot.motors)
        floats = robot.values + FLOATS_PER_PACKET * robot.packets + len(robot.motors)
        self._pack = struct.Struct(f"<I{floats}d").pack
        self._bytes_per_row = 4 + 8 * floats
        self._values: list[float] = [math.nan] * robot.values
        self._received: list[float] = list(_NO_PACKET * robot.packets)
        self._rows = bytearray()
        self._cameras = {device.index + extra for device in robot.cameras for extra in (0, RECOGNITION)}
        self._pictures: list[Picture] = []
        self.is_sensed = bool(robot.devices)
        self.printed_bytes_left = MAX_PRINTED_BYTES
        self.tick = 0

    def record_observation(self, observation: Observation) -> None:
        self.tick = observation.tick
        self._values = observation.values
        if self._packets:
            received = [packet for packet in observation.packets if packet.device in self._ball_receivers]
            numbers: list[float] = list(_NO_PACKET * max(0, self._packets - len(received)))
            for packet in received[-self._packets :]:
                numbers += (packet.strength, *packet.direction)
            self._received = numbers
        if self._cameras:
            self._pictures += [
                (self.tick, packet.device, packet.data)
                for packet in observation.packets
                if packet.device in self._cameras
            ]

    def record_action(self, motors: Sequence[MotorCommand]) -> bytes:
        for command in motors:
            at, position = self._motor_at[command.device], command.position_rad
            is_shown = math.isinf(position) or (at in self._kickers and position > 0.0)
            self._motors[at] = command.velocity_radps if is_shown else math.nan
        row = self._pack(self.tick, *self._values, *self._received, *self._motors)
        self._rows += row
        return row

    def take(self) -> tuple[int, bytes, list[Picture]]:
        """Return and forget the rows, as number and bytes column by column, and the packets of cameras, by camera."""
        count = len(self._rows) // self._bytes_per_row
        planes = np.frombuffer(bytes(self._rows), np.uint8).reshape(count, self._bytes_per_row).T.tobytes()
        self._rows.clear()
        pictures, self._pictures = sorted(self._pictures, key=lambda one: one[1]), []
        return count, planes, pictures


class SensorWriter:
    """Writes the sensor recording of one half."""

    def __init__(self, folder: Path, half: int, robots: Sequence[SensedRobot]) -> None:
        """Create the file of a half; calls name robots by their place in this order."""
        (folder / SENSORS).mkdir(exist_ok=True)
        header = {"half": half, "robots": [asdict(robot) for robot in robots]}
        self._file = ChunkWriter(folder / SENSORS / f"half-{half}.sensors", header, _ZLIB_LEVEL)
        self._rows = [_Rows(robot) for robot in robots]
        self._listeners: tuple[SensorListener, ...] = ()
        self._output: list[tuple[int, int, str]] = []
        self._next_write = TICKS_PER_CHUNK
        self._is_full = False

    def set_listeners(self, listeners: Sequence[SensorListener]) -> None:
        """Pass the data recorded from now on to these, too."""
        self._listeners = tuple(listeners)

    def record_observation(self, robot: int, observation: Observation) -> None:
        """Record an observation."""
        if not self._is_full:
            if observation.tick >= self._next_write:
                self._write()
                self._next_write = observation.tick + TICKS_PER_CHUNK
            self._rows[robot].record_observation(observation)

    def record_action(self, robot: int, motors: Sequence[MotorCommand], printed: str = "") -> None:
        """Record what a program set and printed on its last observation (before the first: at tick 0)."""
        if not self._is_full:
            if self._rows[robot].is_sensed:
                row = self._rows[robot].record_action(motors)
                for listener in self._listeners:
                    listener.on_row(robot, row)
            self.record_output(robot, printed)

    def record_output(self, robot: int, text: str) -> None:
        """Record what a program printed since its last observation."""
        rows = self._rows[robot]
        if text and not self._is_full and rows.printed_bytes_left > 0:
            size = len(text.encode("utf-8", "replace"))
            if size > rows.printed_bytes_left:
                text = text.encode("utf-8", "replace")[: rows.printed_bytes_left].decode("utf-8", "ignore")
                text += "\n" * (not text.endswith("\n")) + MORE_IN_THE_LOG
            rows.printed_bytes_left -= size
            entry = (robot, rows.tick, text)
            self._output.append(entry)
            for listener in self._listeners:
                listener.on_output(entry)

    def close(self) -> None:
        """Write what is left and close the file. Can be called again."""
        self._write()
        self._file.close()

    def _write(self) -> None:
        parts = [rows.take() for rows in self._rows]
        pictures = [(robot, *picture) for robot, (_, _, taken) in enumerate(parts) for picture in taken]
        if not self._is_full and (self._output or any(count for count, _, _ in parts)):
            head = {"rows": [count for count, _, _ in parts], "output": self._output}
            if pictures:
                head["pictures"] = [(robot, tick, number, len(data)) for robot, tick, number, data in pictures]
            chunk = self._file.pack(
                head, b"".join([*(planes for _, planes, _ in parts), *(one[3] for one in pictures)])
            )
            if self._file.size_bytes + len(chunk) > MAX_BYTES_A_HALF:
                self._is_full = True
                full_at = max((rows.tick for rows in self._rows), default=0)
                chunk = self._file.pack({"rows": [0] * len(parts), "output": [], "full_at": full_at})
            self._file.append(chunk)
        self._output = []


# --- reading ----------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class SensorTrack:
    """The observations and actions of one robot's program in one half; ``N`` observations.

    Attributes:
        ticks: ``[N]``, the tick of each observation.
        values: ``[N, values]``, float64, as the program got them; NaN before the first sample.
        packets: ``[N, packets, 4]``, strength and direction of the ball's packets, the newest last.
        motors: ``[N, motors]``, velocities in rad/s that it set on the observation.
        output: printed text, with the tick of the observation before.
        pictures: the packets of its cameras, those of one after each other within 4 s.
    """

    robot: SensedRobot
    ticks: Array
    values: Array
    packets: Array
    motors: Array
    output: tuple[tuple[int, str], ...]
    pictures: tuple[Picture, ...] = ()

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
    """The sensor recording of one half; a damaged one has all that came before the damage.

    Nothing is recorded from the tick ``full_at`` on because the file had reached its size; None: all is there.
    """

    half: int
    robots: Mapping[str, SensorTrack]
    full_at: int | None = None
    damaged: bool = False

    @property
    def has_readings(self) -> bool:
        """Whether more than printed text was recorded."""
        return any(track.robot.devices for track in self.robots.values())


def read_sensors(folder: Path) -> dict[int, SensorHalf]:
    """Return the sensor recordings of a run by half; empty if there are none.

    Raises:
        RecordError: a file is not a sensor recording, or of another version.
    """
    found = {}
    for path in sorted((folder / SENSORS).glob("half-*.sensors")):
        try:
            half = _read(path)
        except DAMAGE as error:
            what = f"{folder.name}: {SENSORS}/{path.name} is not a sensor recording: {error}"
            raise RecordError.damaged(what) from error
        found[half.half] = half
    return dict(sorted(found.items()))


def _read(path: Path) -> SensorHalf:
    found = read_chunks(path)
    robots = [_robot(robot) for robot in found.header["robots"]]
    dtypes = [row_dtype(robot) for robot in robots]
    rows: list[list[Array]] = [[np.zeros(0, dtype)] for dtype in dtypes]
    output: list[list[tuple[int, str]]] = [[] for _ in robots]
    pictures: list[list[Picture]] = [[] for _ in robots]
    full_at: int | None = None
    for head, body in found.chunks:
        at = 0
        for blocks, count, dtype in zip(rows, head["rows"], dtypes, strict=True):
            size = count * dtype.itemsize
            planes = np.frombuffer(body[at : at + size], np.uint8).reshape(dtype.itemsize, count)
            blocks.append(np.ascontiguousarray(planes.T).view(dtype)[:, 0])
            at += size
        for robot, tick, number, size in head.get("pictures", ()):
            pictures[robot].append((int(tick), int(number), body[at : at + size]))
            at += size
        for robot, tick, text in head["output"]:
            output[robot].append((int(tick), str(text)))
        full_at = int(head["full_at"]) if "full_at" in head else full_at
    tracks = {}
    for robot, blocks, printed, taken in zip(robots, rows, output, pictures, strict=True):
        every = np.concatenate(blocks)
        tick, values, packets, motors = (np.ascontiguousarray(every[name]) for name in every.dtype.names or ())
        tracks[robot.name] = SensorTrack(robot, tick, values, packets, motors, tuple(printed), tuple(taken))
    return SensorHalf(int(found.header["half"]), tracks, full_at, found.is_cut_off or found.is_damaged)


def _robot(data: dict[str, Any]) -> SensedRobot:
    devices = tuple(DeviceSpec(**device) for device in data["devices"])
    return SensedRobot(data["name"], devices, int(data["values"]), tuple(data["ball_receivers"]), int(data["packets"]))
