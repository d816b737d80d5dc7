"""Encodes the sensor recording of a half for the feed, with the numbers of the replay page."""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence

import numpy as np

from rcj_challenges.core.play import HalfInfo
from rcj_challenges.records.sensors import SensedRobot, row_dtype
from rcj_challenges.views.live.feed import json_message, reading_message
from rcj_challenges.views.replay.sensor_blocks import columns_of, robot_facts, whole_numbers


class HalfSensorFeed:
    """The sensor recording of one half while it is made; a `rcj_challenges.records.sensors.SensorListener`.

    `on_row` and `on_output`, which the match calls, only store bytes; `messages` does the work in another thread.
    """

    def __init__(self, half: HalfInfo, robots: Sequence[SensedRobot]) -> None:
        self._half = half.half
        self._robots = robots
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
        for number, (robot, waiting) in enumerate(zip(self._robots, self._rows, strict=True)):
            if rows := [waiting.popleft() for _ in range(len(waiting))]:
                parts.append(reading_message(self._half, number, len(rows), _shown(robot, b"".join(rows))))
        printed = [self._printed.popleft() for _ in range(len(self._printed))]
        if lines := [(self._robots[robot].name, tick, text) for robot, tick, text in printed]:
            parts.append(json_message({"say": "printed", "half": self._half, "lines": lines}))
        return b"".join(parts)


def _shown(robot: SensedRobot, rows: bytes) -> bytes:
    """Return tick and columns of recorded rows, int32 ``[row][column]``."""
    units, at = columns_of(robot)
    recorded = np.frombuffer(rows, [("tick", "<u4"), ("floats", "<f8", ((row_dtype(robot).itemsize - 4) // 8,))])
    return np.column_stack((recorded["tick"], whole_numbers(units, recorded["floats"][:, at]))).astype("<i4").tobytes()
