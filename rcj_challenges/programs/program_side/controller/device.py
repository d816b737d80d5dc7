"""What all devices have in common."""

from __future__ import annotations

from ._connection import Connection, complain, connected, number

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any, Self

LONGEST_MS = 2**31 - 1


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
    """A part of the robot, as returned by ``getDevice`` or created from its class: ``Motor("left wheel motor")``.

    A team's class may inherit from it, so private names begin with ``_rcj_``.
    """

    def __init__(self, name: str) -> None:
        """Represent the robot's device of that name: all objects of one device share their attributes.

        If the robot has none of that name and class, a message says so as with ``getDevice``, and using this object is
        an error.
        """
        connection = connected()
        if not connection.robot_made:
            raise RuntimeError(f"{type(self).__name__}({name!r}): make the robot first: robot = Robot()")
        ours = next(kind for kind in type(self).__mro__ if kind.__module__.startswith(f"{__package__}."))
        there = device_of(connection, name, ours.__name__)
        if there is None:
            self.__class__ = type(type(self).__name__, (type(self),), {"__getattr__": _of_no_device})
            return
        shared = vars(there)
        shared.update(vars(self))
        self.__dict__ = shared

    @classmethod
    def _rcj_made(cls, connection: Connection, spec: dict[str, Any]) -> Device:
        device = cls.__new__(cls)
        device._rcj_set_up(connection, spec)  # noqa: SLF001 - its own class
        return device

    def _rcj_set_up(self, connection: Connection, spec: dict[str, Any]) -> None:
        self._rcj_connection = connection
        self._rcj_spec = spec
        self._rcj_name = str(spec["name"])
        self._rcj_facts: dict[str, Any] = spec["facts"]
        self._rcj_index: int = spec["index"]

    def __copy__(self) -> Self:
        """Return the device itself: there is only one."""
        return self

    def __deepcopy__(self, _memo: object) -> Self:
        """Return the device itself: there is only one."""
        return self

    def getName(self) -> str:
        """Return its name."""
        return self._rcj_name

    def getModel(self) -> str:
        """Return its model: none of these devices has one."""
        return ""

    def getTag(self) -> int:
        """Return its number on the robot, from 1; 0 would be the robot itself."""
        return self._rcj_index + 1

    def getNodeType(self) -> int:
        """Return its kind, as ``Node`` numbers them: ``Node.GPS``."""
        from ._placeholders import Node  # noqa: PLC0415 - each import costs every program

        kind: str = self._rcj_spec["kind"]
        return int(getattr(Node, "ROTATIONAL_MOTOR" if kind == "motor" else kind.upper()))

    def _rcj_sibling(self, kind: str, name: str) -> Any:
        """Return the device of this name if the robot has it and it is of this kind; else None."""
        there = self._rcj_connection.devices.get(name)
        return there if there is not None and there._rcj_spec["kind"] == kind else None  # noqa: SLF001 - its own class

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self.getName()!r}>"

    name = ReadOnly(getName)
    model = ReadOnly(getModel)
    node_type = ReadOnly(getNodeType)


def class_name(kind: str) -> str:
    """Return ``DistanceSensor`` for ``distance_sensor``, ``GPS`` for ``gps``."""
    return kind.upper() if kind in ("gps", "led") else "".join(part.capitalize() for part in kind.split("_"))


def device_of(connection: Connection, name: str, kind: str) -> Any:
    """Return the robot's device of that name and class; None, and a message, if the robot has none."""
    there = connection.devices.get(name)
    if there is None:
        has = ", ".join(connection.devices)
        complain(f'Warning: "{name}" device not found. This robot has: {has}.', code="no-device", subject=f"{name}")
    elif kind not in [base.__name__ for base in type(there).__mro__]:
        complain(f'Warning: "{name}" is a {type(there).__name__}, not a {kind}.')
        return None
    return there


def _of_no_device(self: object, _attribute: str) -> Any:
    error = AttributeError(f"this {type(self).__name__} is not a device of the robot (see the warning above)")
    error.name = None  # else Python puts it in, and names that sound like it are proposed
    raise error


class Sensor(Device):
    """A device that must be enabled before it measures."""

    def __init__(self, name: str, sampling_period: float | None = None) -> None:
        """Stand for the robot's sensor of that name, and enable it if a period in ms is given."""
        super().__init__(name)
        if sampling_period is not None:
            self.enable(sampling_period)

    def _rcj_set_up(self, connection: Connection, spec: dict[str, Any]) -> None:
        super()._rcj_set_up(connection, spec)
        self._rcj_period_ms = 0
        self._rcj_warned = False
        self._rcj_place = connection.place_of.get(spec["slot"], 0)
        self._rcj_end = self._rcj_place + int(spec["width"])

    def enable(self, samplingPeriod: float | None = None, *, sampling_period: float | None = None) -> None:
        """Measure every ``samplingPeriod`` ms, rounded up to whole ticks. The first value is there a period later.

        ``sampling_period`` is what R2023a calls it.

        Raises:
            TypeError: no number was given.

        Example:
            ``gps.enable(32)`` once at the start.
        """
        given = samplingPeriod if sampling_period is None else sampling_period
        period_ms = number(given, f"{self._rcj_name!r}: enable takes a number of ms, such as 32")
        if not period_ms > 0:
            self._rcj_stop()
            return
        self._rcj_period_ms = max(1, int(min(period_ms, LONGEST_MS)))  # 0 would say that it is off
        self._rcj_sample(self._rcj_connection.ticks_from_ms(period_ms))

    def disable(self) -> None:
        """Stop measuring."""
        self._rcj_stop()

    def _rcj_stop(self) -> None:
        self._rcj_period_ms = 0
        self._rcj_sample(0)

    def _rcj_sample(self, ticks: int) -> None:
        """Ask for a sample every so many ticks; 0 for none."""
        self._rcj_connection.sample(self._rcj_index, ticks)

    def getSamplingPeriod(self) -> int:
        """Return the period in ms that was asked for; 0 if it is disabled."""
        return self._rcj_period_ms

    def _rcj_numbers(self) -> tuple[float, ...]:
        """Return its numbers in the latest observation; NaN before the first sample."""
        if not self._rcj_period_ms and not self._rcj_warned:
            self._rcj_warn()
        return self._rcj_connection.numbers[self._rcj_place : self._rcj_end]

    def _rcj_warn(self) -> None:
        self._rcj_warned = True
        help_ = "call enable(32) before the first step"
        complain(f"Warning: {self._rcj_name!r} is read but not enabled: {help_}.", help_)

    sampling_period = property(getSamplingPeriod, lambda self, period_ms: self.enable(period_ms))
