"""Records what programs print, see and set, between the loop and its drivers, which are unaware of it."""

from __future__ import annotations

import codecs
import io
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Protocol, Self

from rcj_challenges.core.play import Fault, HalfInfo
from rcj_challenges.core.traffic import Observation, Request, RobotSpec
from rcj_challenges.devices.ball_receiver import BallReceiverDevice
from rcj_challenges.match.driver import Driver
from rcj_challenges.match.observers import Observer
from rcj_challenges.records.sensors import SensedRobot, SensorWriter
from rcj_challenges.records.writer import RecordWriter
from rcj_challenges.scenario.kits import devices_of
from rcj_challenges.scenario.models.scenario import Scenario


class LogTail:
    """The text appended to a program's log from now on, without the match's heading of a half."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._at = path.stat().st_size if path.exists() else 0
        self._decoder = codecs.getincrementaldecoder("utf-8")("replace")
        self._headed = False
        self._file: io.FileIO | None = None

    def new_text(self) -> str:
        """Return the text appended since the last call."""
        try:
            if self._file is None:
                self._file = io.FileIO(self._path)
                self._file.seek(self._at)
            text = self._decoder.decode(self._file.readall())
        except OSError:
            return ""
        if text and not self._headed:
            self._headed = True
            text = text.partition("\n")[2]
        return text

    def close(self) -> None:
        """Close the file."""
        if self._file is not None:
            self._file.close()


class LoggingDriver(Driver, Protocol):
    """A driver with a log: a program."""

    def keep_output(self) -> int:
        """Append its output so far to its log; return the number of bytes appended."""


class _RecordedDriver:
    """A driver that is recorded."""

    def __init__(self, driver: LoggingDriver, number: int, writer: SensorWriter, tail: LogTail) -> None:
        self._driver = driver
        self._number = number
        self._writer = writer
        self._tail = tail
        self._log_bytes = 0
        self.limit_fault = driver.limit_fault

    def release(self, observation: Observation) -> None:
        self._writer.record_observation(self._number, observation)
        self._driver.release(observation)

    def collect(self) -> Request | Fault:
        return self._recorded(self._driver.collect())

    def collect_soon(self) -> Request | Fault | None:
        answer = self._driver.collect_soon()
        return None if answer is None else self._recorded(answer)

    def _recorded(self, answer: Request | Fault) -> Request | Fault:
        # What it printed on this observation was written before its request: lines are not held back.
        log_bytes = self._driver.keep_output()
        printed = self._tail.new_text() if log_bytes != self._log_bytes else ""
        self._log_bytes = log_bytes
        if isinstance(answer, Fault):
            self._writer.record_output(self._number, printed)
        else:
            self._writer.record_action(self._number, answer.motors, printed)
        return answer


class SensorRecording:
    """The recording of one half while it is played; a context manager.

    It only observes: the loop, the programs and the digest are the same with and without it.
    """

    def __init__(
        self, scenario: Scenario, record: RecordWriter, half: int, specs: Mapping[int, RobotSpec], *, sensors: bool
    ) -> None:
        """Prepare it, before the programs are launched; without ``sensors`` only their output is recorded."""
        self._numbers = {robot: number for number, robot in enumerate(specs)}
        self._tails = [LogTail(record.logs / f"{spec.name}.log") for spec in specs.values()]
        self._robots = _sensed(scenario, specs) if sensors else [SensedRobot(spec.name) for spec in specs.values()]
        self._writer = SensorWriter(record.folder, half, self._robots)

    def wrap(self, drivers: Mapping[int, LoggingDriver]) -> Mapping[int, Driver]:
        """Return drivers by robot index that are recorded."""
        numbers = self._numbers
        return {
            robot: _RecordedDriver(driver, numbers[robot], self._writer, self._tails[numbers[robot]])
            for robot, driver in drivers.items()
        }

    def attach(self, observer: Observer, half: HalfInfo) -> None:
        """Pass on the data recorded from now on to an observer."""
        self._writer.set_listeners(observer.sensing(half, self._robots))

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        for number, tail in enumerate(self._tails):
            self._writer.record_output(number, tail.new_text())
            tail.close()
        self._writer.close()


def _sensed(scenario: Scenario, specs: Mapping[int, RobotSpec]) -> Sequence[SensedRobot]:
    balls = sum(ball.emits for ball in scenario.balls.values())  # integers
    robots = []
    for spec in specs.values():
        devices = devices_of(scenario, spec.name).items()
        receivers = [name for name, device in devices if isinstance(device, BallReceiverDevice)]
        robots.append(SensedRobot.of(spec, receivers, balls))
    return robots
