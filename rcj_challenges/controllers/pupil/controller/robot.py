"""The robot itself."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ._hub import complain, connected
from .device import Device
from .lidar import Lidar
from .motor import Motor
from .radio import Emitter, Receiver
from .sensors import GPS, Compass, DistanceSensor, PositionSensor

_CLASSES: dict[str, type[Device]] = {
    "motor": Motor,
    "position_sensor": PositionSensor,
    "gps": GPS,
    "compass": Compass,
    "distance_sensor": DistanceSensor,
    "receiver": Receiver,
    "emitter": Emitter,
    "lidar": Lidar,
}


class Robot:
    """The robot that this program drives. A program makes one."""

    MODE_SIMULATION, MODE_CROSS_COMPILATION, MODE_REMOTE_CONTROL = range(3)

    created: Robot | None = None

    def __init__(self) -> None:
        hub = connected()
        if hub.robot_made:
            raise RuntimeError("Only one instance of the Robot class should be created.")
        hub.robot_made = True
        self._hub = hub
        self._devices = {spec["name"]: _CLASSES[spec["kind"]](hub, spec) for spec in hub.spec["devices"]}
        self._by_index = list(self._devices.values())
        self._told_of: set[str] = set()
        Robot.created = self

    def step(self, timeStep: float | None = None) -> int:
        """Let ``timeStep`` ms pass, rounded up to whole ticks of 32 ms. Returns 0, or -1 when the match is over."""
        return 0 if self._hub.exchange(self.getBasicTimeStep() if timeStep is None else timeStep) else -1

    def getName(self) -> str:
        """Return the robot's name: colour and number, ``Y1``."""
        return str(self._hub.spec["name"])

    def getTime(self) -> float:
        """Return simulated seconds since the half began."""
        return self._hub.time_s()

    def getBasicTimeStep(self) -> float:
        """Return the length of a tick in ms."""
        return float(self._hub.spec["basic_step_ms"])

    def getDevice(self, name: str) -> Any:
        """Return the device of that name; None, and a message, if the robot has none."""
        found = self._devices.get(name)
        if found is None:
            complain(f'Warning: "{name}" device not found. This robot has: {", ".join(self._devices)}.')
        return found

    def getDeviceByIndex(self, index: int) -> Device | None:
        """Return a device by its number; None if there is none."""
        return self._by_index[index] if 0 <= index < len(self._by_index) else None

    def getNumberOfDevices(self) -> int:
        """Return how many devices the robot has."""
        return len(self._by_index)

    def getModel(self) -> str:
        """Return the robot's model: none."""
        return ""

    def getCustomData(self) -> str:
        """Return nothing: there is no custom data."""
        return ""

    def getSupervisor(self) -> bool:
        """Return False: a player's robot is no supervisor."""
        return False

    def getSynchronization(self) -> bool:
        """Return True: the match waits for each step."""
        return True

    def getMode(self) -> int:
        """Return ``Robot.MODE_SIMULATION``."""
        return self.MODE_SIMULATION

    def _legacy(self, method: str, name: str) -> Any:
        if method not in self._told_of:
            self._told_of.add(method)
            complain(f"DEPRECATION: Robot.{method} is deprecated, please use Robot.getDevice instead.")
        return self.getDevice(name)

    def __getattr__(self, attribute: str) -> Callable[[str], Any]:
        """``getMotor``, ``getReceiver`` … of the years before 2020: as ``getDevice``, after a line of deprecation."""
        if attribute in _LEGACY:
            return lambda name: self._legacy(attribute, name)
        raise AttributeError(f"{type(self).__name__!r} object has no attribute {attribute!r}")

    name = property(getName)
    time = property(getTime)
    basic_time_step = property(getBasicTimeStep)
    model = property(getModel)
    custom_data = property(getCustomData)
    supervisor = property(getSupervisor)
    synchronization = property(getSynchronization)
    mode = property(getMode)
    number_of_devices = property(getNumberOfDevices)


_LEGACY = frozenset(
    "get" + kind
    for kind in (
        *("Accelerometer", "Brake", "Camera", "Compass", "Connector", "Display", "DistanceSensor", "Emitter", "GPS"),
        *("Gyro", "InertialUnit", "LED", "Lidar", "LightSensor", "Motor", "Pen", "PositionSensor", "Radar"),
        *("RangeFinder", "Receiver", "Servo", "Speaker", "TouchSensor"),
    )
)


class Supervisor(Robot):
    """What only referees may be."""

    def __init__(self) -> None:
        raise PermissionError("a player's program cannot be a Supervisor: use Robot")
