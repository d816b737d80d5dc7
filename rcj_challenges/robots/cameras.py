"""The cameras of all robots: when each takes a picture, and where it goes."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from rcj_challenges.core.play import HalfInfo
from rcj_challenges.core.traffic import Packet
from rcj_challenges.devices.base import Eye, Fitted, Sight
from rcj_challenges.devices.camera import RECOGNITION, CameraDevice, packed
from rcj_challenges.devices.receivers import Queue
from rcj_challenges.world.poses import Poses

_NOWHERE = (0.0, 0.0, 0.0)


class Cameras:
    """All cameras of a half.

    A camera has a clock of its own: it exposes at ticks that are multiples of its period, whenever it was enabled, so
    that all that are due are taken together, which costs a third of taking them one by one (ADR 17).
    """

    def __init__(
        self, fitted: Sequence[Fitted], make_sight: Callable[[], Sight], half: HalfInfo, queues: dict[int, Queue]
    ) -> None:
        # Each camera, and each recognition, with the number by which it is asked for.
        self._all = [
            (one, one.device, one.spec.index + extra)
            for one in fitted
            if isinstance(one.device, CameraDevice)
            for extra in (0, RECOGNITION)[: 1 + one.device.recognition]
        ]
        self._queues = queues
        self._period: dict[tuple[int, int], int] = {}
        self._on: list[tuple[Fitted, CameraDevice, int, int]] = []
        if self._all:
            self._sight = make_sight()
            palette = self._sight.palette
            self._head = {(one.robot, number): camera.lit(palette, half, one) for one, camera, number in self._all}

    def set_period(self, robot: int, number: int, period_ticks: int) -> bool:
        """Let a camera take pictures at its rate, or every so many ticks if that is less often; 0 switches it off.

        The number is its index, or that of its recognition. Return whether the device is a camera.
        """
        if not any((one.robot, known) == (robot, number) for one, _, known in self._all):
            return False
        self._period[robot, number] = period_ticks
        self._on = [
            (one, camera, known, max(camera.every_ticks, period))
            for one, camera, known in self._all
            if (period := self._period.get((one.robot, known), 0))
        ]
        return True

    def silence(self, robot: int) -> None:
        """Switch off the cameras of a robot."""
        for one, _, number in self._all:
            if one.robot == robot:
                self.set_period(robot, number, 0)

    def expose(self, tick: int, poses: Poses) -> None:
        """Take the pictures that are due at ``tick``; a robot off the field sees nothing: black."""
        due: dict[tuple[float, ...], list[tuple[Fitted, Eye]]] = {}
        recognizing: list[tuple[Fitted, Eye]] = []
        for one, device, number, every_ticks in self._on:
            if tick % every_ticks:
                continue
            eye = device.eye
            if number != one.spec.index:
                if poses.parked[one.robot]:
                    self._deliver(one, number, b"")
                else:
                    recognizing.append((one, eye))
            elif poses.parked[one.robot]:
                self._deliver(one, number, bytes((1, 0, 0, 0)) + bytes(device.width * device.height))
            else:
                due.setdefault(eye.lens, []).append((one, eye))
        for together in due.values():
            pictures = self._sight.take([(one.robot, eye) for one, eye in together])
            for (one, _), picture in zip(together, pictures, strict=True):
                self._deliver(one, one.spec.index, self._head[one.robot, one.spec.index] + picture)
        if recognizing:
            found = self._sight.recognize([(one.robot, eye) for one, eye in recognizing])
            for (one, _), things in zip(recognizing, found, strict=True):
                self._deliver(one, one.spec.index + RECOGNITION, packed(things))

    def _deliver(self, one: Fitted, number: int, data: bytes) -> None:
        self._queues[one.robot].put(Packet(number, data, 0.0, _NOWHERE))
