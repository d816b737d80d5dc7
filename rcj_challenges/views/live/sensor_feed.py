"""Encodes the sensor recording of a half for the feed, with the numbers of the replay page."""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from rcj_challenges.core.play import HalfInfo
from rcj_challenges.records.sensors import SensedRobot, row_dtype
from rcj_challenges.views.live.feed import json_message, reading_message
from rcj_challenges.views.replay.sensor_blocks import columns_of, robot_facts, speeds, whole_numbers

Array = npt.NDArray[Any]

_MAX_CHARACTERS = 100_000
_GROUP_BITS, _MAX_GROUPS = 7, 5


class HalfSensorFeed:
    """The sensor recording of one half while it is made; a `rcj_challenges.records.sensors.SensorListener`.

    `on_row` and `on_output`, which the match calls, only store bytes; `messages` does the work in another thread.
    """

    def __init__(self, half: HalfInfo, robots: Sequence[SensedRobot]) -> None:
        self._half = half.half
        self._robots = robots
        self._encoders = [_RowEncoder(robot) for robot in robots]
        self._rows: list[deque[bytes]] = [deque() for _ in robots]
        self._printed: deque[tuple[int, int, str]] = deque()

    @property
    def announcement(self) -> bytes:
        """The message before all readings of the half: its robots and their columns."""
        if not any(robot.devices for robot in self._robots):
            return b""  # only what programs print is recorded
        facts = {"robots": [{**robot_facts(robot), "rows": 0} for robot in self._robots]}
        return json_message({"say": "sensors", "half": self._half, "facts": facts})

    def on_row(self, robot: int, row: bytes) -> None:
        """Store a row."""
        self._rows[robot].append(row)

    def on_output(self, entry: tuple[int, int, str]) -> None:
        """Store what was printed."""
        self._printed.append(entry)

    def messages(self) -> bytes:
        """Return all that was stored since the last call, framed."""
        parts = []
        for number, (waiting, encoder) in enumerate(zip(self._rows, self._encoders, strict=True)):
            if rows := [waiting.popleft() for _ in range(len(waiting))]:
                parts.append(reading_message(self._half, number, len(rows), encoder.steps(b"".join(rows))))
        return b"".join([*parts, *self._lines()])

    def _lines(self) -> list[bytes]:
        messages, lines, characters = [], [], 0
        for _ in range(len(self._printed)):
            robot, tick, text = self._printed.popleft()
            lines.append((self._robots[robot].name, tick, text))
            characters += len(text)
            if characters > _MAX_CHARACTERS:
                messages.append(self._printed_message(lines))
                lines, characters = [], 0
        return [*messages, self._printed_message(lines)] if lines else messages

    def _printed_message(self, lines: list[tuple[str, int, str]]) -> bytes:
        return json_message({"say": "printed", "half": self._half, "lines": lines})


class _RowEncoder:
    def __init__(self, robot: SensedRobot) -> None:
        floats = (row_dtype(robot).itemsize - 4) // 8
        columns = columns_of(robot)
        self._dtype = np.dtype([("tick", "<u4"), ("floats", "<f8", (floats,))])
        self._units = np.array([column.unit for column in columns])
        self._at = np.array([column.at for column in columns], np.intp)
        self._speeds = np.array([number for number, column in enumerate(columns) if column.is_speed], np.intp)
        self._row_before = b""
        self._shown_before = np.zeros(1 + len(columns), np.int64)

    def steps(self, rows: bytes) -> bytes:
        """Return tick and columns of each row as differences to the row before, packed; the first of all to zeros."""
        known = 1 if self._row_before else 0
        recorded = np.frombuffer(self._row_before + rows, self._dtype)
        numbers = recorded["floats"][:, self._at]
        if len(self._speeds):
            numbers[:, self._speeds] = speeds(recorded["tick"], numbers[:, self._speeds])
        shown = np.empty((len(recorded) + 1 - known, 1 + len(self._units)), np.int64)
        shown[0] = self._shown_before
        shown[1:, 0] = recorded["tick"][known:]
        shown[1:, 1:] = whole_numbers(self._units, numbers[known:])
        self._row_before = rows[-self._dtype.itemsize :]
        self._shown_before = shown[-1]
        return packed_steps(np.diff(shown, axis=0))


def packed_steps(steps: Array) -> bytes:
    """Return whole numbers, wrapped to 32 bits, in as few bytes as they need: most differences need one.

    The sign goes to the lowest bit (0, -1, 1, -2 … become 0, 1, 2, 3 …), then seven bits a byte, the lowest first; the
    highest bit of a byte says that another follows.
    """
    signed = steps.ravel().astype(np.int32)
    left: Array = ((signed << 1) ^ (signed >> 31)).view(np.uint32)
    groups = np.empty((len(left), _MAX_GROUPS), np.uint8)
    is_sent = np.ones(groups.shape, np.bool_)
    for group in range(_MAX_GROUPS):
        groups[:, group] = left  # its lowest eight bits
        left = left >> _GROUP_BITS
        if group + 1 < _MAX_GROUPS:
            np.not_equal(left, 0, out=is_sent[:, group + 1])
    groups[:, :-1] &= 0x7F
    groups[:, :-1] |= is_sent[:, 1:].view(np.uint8) << 7
    return groups[is_sent].tobytes()
