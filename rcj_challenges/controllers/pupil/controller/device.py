"""What all devices have in common."""

from __future__ import annotations

from typing import Any

from ._hub import Hub, complain


class Device:
    """A part of the robot, as ``getDevice`` returns it."""

    def __init__(self, hub: Hub, spec: dict[str, Any]) -> None:
        self._hub = hub
        self._spec = spec
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

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self.getName()!r}>"

    name = property(getName)
    model = property(getModel)
    node_type = property(getNodeType)


class Sensor(Device):
    """A device that must be enabled before it measures."""

    def __init__(self, hub: Hub, spec: dict[str, Any]) -> None:
        super().__init__(hub, spec)
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

    sampling_period = property(getSamplingPeriod)
