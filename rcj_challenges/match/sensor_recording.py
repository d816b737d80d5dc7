"""Listening in on programs for a sensor recording: between the loop and its drivers, so that neither knows of it."""

from __future__ import annotations

import codecs
import io
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Protocol, Self

from rcj_challenges.controllers.cpu_policy import CpuShare
from rcj_challenges.devices.ball_receiver import BallReceiverDevice
from rcj_challenges.facts.play import Fault, HalfInfo
from rcj_challenges.facts.traffic import Observation, Request, RobotSpec
from rcj_challenges.match.loop import Driver
from rcj_challenges.match.observers import Observer
from rcj_challenges.records.sensors import SensedRobot, SensorWriter
from rcj_challenges.records.writer import RecordWriter
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.own_devices import devices_of

_READ_BYTES = 1 << 16


class LogTail:
    """What is appended to a program's log from now on, without the line with which the match heads a half."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._at = path.stat().st_size if path.exists() else 0
        self._decoder = codecs.getincrementaldecoder("utf-8")("replace")
        self._headed = False
        self._file: io.FileIO | None = None

    def new_text(self) -> str:
        """Return what was appended since the last call."""
        try:
            if self._file is None:
                self._file = io.FileIO(self._path)
                self._file.seek(self._at)
            chunk = self._file.read(_READ_BYTES)
            while len(chunk) and len(chunk) % _READ_BYTES == 0:
                more = self._file.read(_READ_BYTES)
                chunk += more
                if not more:
                    break
        except OSError:
            return ""
        if not chunk:
            return ""
        text = self._decoder.decode(chunk)
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

    def keep_output(self) -> None:
        """Put into its log what it has printed until now."""


class _RecordedDriver:
    """A driver whose conversation with the match is written down."""

    def __init__(self, driver: LoggingDriver, number: int, writer: SensorWriter, tail: LogTail) -> None:
        self._driver = driver
        self._number = number
        self._writer = writer
        self._tail = tail

    def release(self, observation: Observation) -> None:
        """Let its ``step`` return."""
        self._writer.saw(self._number, observation)
        self._driver.release(observation)

    def share_cpus(self, share: CpuShare) -> None:
        """Let it share the CPUs like that."""
        self._driver.share_cpus(share)

    def computed_s(self) -> float:
        """Return for how long it has computed."""
        return self._driver.computed_s()

    def overstepped(self, tick: int) -> Fault | None:
        """Look whether it takes more than it may."""
        return self._driver.overstepped(tick)

    def collect(self, if_long: Callable[[], None] | None = None) -> Request | Fault:
        """Wait for its next request, or learn that it failed."""
        return self._heard(self._driver.collect(if_long))

    def collect_soon(self) -> Request | Fault | None:
        """Return its next request if it is here already."""
        answer = self._driver.collect_soon()
        return None if answer is None else self._heard(answer)

    def _heard(self, answer: Request | Fault) -> Request | Fault:
        # What it printed on this observation was written before its request: lines are not held back.
        self._driver.keep_output()
        printed = self._tail.new_text()
        if isinstance(answer, Fault):
            self._writer.printed(self._number, printed)
        else:
            self._writer.did(self._number, answer.motors, printed)
        return answer


class SensorRecording:
    """The sensor recording of one half while it is played; a context manager.

    It only listens: the loop, the programs and the digest are the same with and without it.
    """

    def __init__(
        self, scenario: Scenario, record: RecordWriter, half: int, specs: Mapping[int, RobotSpec], *, on: bool
    ) -> None:
        """Prepare it, before the programs are launched.

        Args:
            scenario: which devices hear balls, and how many balls there are.
            record: of the run.
            half: 1-based.
            specs: of the robots, by index.
            on: False: nothing is recorded, and drivers are left as they are.
        """
        self._specs = dict(specs) if on else {}
        self._tails = {robot: LogTail(record.logs / f"{spec.name}.log") for robot, spec in self._specs.items()}
        self._robots = _sensed(scenario, self._specs)
        self._writer = SensorWriter(record.folder, half, self._robots) if on else None

    def on(self, drivers: Mapping[int, LoggingDriver]) -> Mapping[int, Driver]:
        """Return drivers by robot index that are listened to."""
        writer = self._writer
        if writer is None:
            return drivers
        numbers = {robot: number for number, robot in enumerate(self._specs)}
        return {
            robot: _RecordedDriver(driver, numbers[robot], writer, self._tails[robot])
            for robot, driver in drivers.items()
        }

    def tell(self, observer: Observer, half: HalfInfo) -> None:
        """Let an observer have what is recorded from now on, if anything is and it wants it."""
        if self._writer is not None:
            self._writer.tell(observer.sensing(half, self._robots))

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        if self._writer is not None:
            for number, tail in enumerate(self._tails.values()):
                self._writer.printed(number, tail.new_text())
                tail.close()
            self._writer.close()


def _sensed(scenario: Scenario, specs: Mapping[int, RobotSpec]) -> Sequence[SensedRobot]:
    balls = sum(ball.emits for ball in scenario.balls.values())
    return [
        SensedRobot.of(
            spec,
            [
                name
                for name, device in devices_of(scenario, spec.name).items()
                if isinstance(device, BallReceiverDevice)
            ],
            balls,
        )
        for spec in specs.values()
    ]
