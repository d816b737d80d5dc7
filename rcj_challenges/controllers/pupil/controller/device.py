"""What all devices have in common."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ._hub import Hub, complain


class ReadOnly:
    """An attribute in snake_case that gives what a getter returns.

    A program that assigns to it puts a value of its own in its place, as with any other name: that is how programs of
    the years before these attributes use names like ``name`` and ``time``. A ``property`` would refuse it.
    """

    def __init__(self, getter: Callable[[Any], Any]) -> None:
        self._getter = getter
        self.__doc__ = getter.__doc__

    def __get__(self, thing: Any, kind: type | None = None) -> Any:
        return self if thing is None else self._getter(thing)


class Device:
    """A part of the robot, as ``getDevice`` returns it."""

    def __init__(self, hub: Hub, spec: dict[str, Any], siblings: dict[str, Device]) -> None:
        """``siblings`` are all devices of the robot by name, also those that are still to be made."""
        self._hub = hub
        self._spec = spec
        self._siblings = siblings
        self._facts: dict[str, Any] = spec["facts"]
        self._index: int = spec["index"]

    def getName(self) -> str:
        """Return its name."""
        return str(self._spec["name"])

    def getModel(self) -> str:
        """Return its model: none of these devices has one."""
        return ""

    def getNodeType(self) -> int:
        """Return 0: there are no Webots nodes here."""
        return 0

    def _sibling(self, kind: str, name: str) -> Any:
        """Return the device of this name if the robot has it and it is of this kind; else None."""
        found = self._siblings.get(name)
        return found if found is not None and found._spec["kind"] == kind else None  # noqa: SLF001 - its own class

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self.getName()!r}>"

    name = ReadOnly(getName)
    model = ReadOnly(getModel)
    node_type = ReadOnly(getNodeType)


class Sensor(Device):
    """A device that must be enabled before it measures."""

    def __init__(self, hub: Hub, spec: dict[str, Any], siblings: dict[str, Device]) -> None:
        super().__init__(hub, spec, siblings)
        self._period_ms = 0
        self._warned = False
        self._place = hub.place_of.get(spec["slot"], 0)
        self._end = self._place + int(spec["width"])

    def enable(self, samplingPeriod: float) -> None:
        """Measure every ``samplingPeriod`` ms, rounded up to whole ticks. The first value is there a period later."""
        if not samplingPeriod > 0:
            self.disable()
            return
        self._period_ms = int(samplingPeriod)
        self._hub.sample(self._index, self._hub.ticks_from_ms(samplingPeriod))

    def disable(self) -> None:
        """Stop measuring."""
        self._period_ms = 0
        self._hub.sample(self._index, 0)

    def getSamplingPeriod(self) -> int:
        """Return the period in ms that was asked for; 0 if it is disabled."""
        return self._period_ms

    def _numbers(self) -> tuple[float, ...]:
        """Return its numbers in the latest observation; NaN before the first sample."""
        if not self._period_ms and not self._warned:
            self._warned = True
            complain(f"Warning: {self.getName()!r} is read but not enabled: call enable(32) before the first step.")
        return self._hub.numbers[self._place : self._end]

    sampling_period = ReadOnly(getSamplingPeriod)
