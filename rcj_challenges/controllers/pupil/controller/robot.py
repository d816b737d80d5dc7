"""The robot itself."""

from __future__ import annotations

import math
import os
from collections.abc import Callable
from typing import Any

from ._hub import complain, connected
from .device import Device, ReadOnly
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
    """The robot that this program drives. A program makes one, often of a class of its own.

    What it keeps to itself has names that begin with ``_rcj_``, which such a class does not hit by accident. For the
    same reason no method calls another that it could override.
    """

    MODE_SIMULATION, MODE_CROSS_COMPILATION, MODE_REMOTE_CONTROL = range(3)

    created: Robot | None = None

    def __init__(self) -> None:
        hub = connected()
        if hub.robot_made:
            raise RuntimeError("Only one instance of the Robot class should be created.")
        hub.robot_made = True
        self._rcj_hub = hub
        self._rcj_devices: dict[str, Device] = {}
        for spec in hub.spec["devices"]:
            self._rcj_devices[spec["name"]] = _CLASSES[spec["kind"]](hub, spec, self._rcj_devices)
        self._rcj_told_of: set[str] = set()
        self._rcj_inputs: dict[str, Any] = {}
        self._rcj_custom_data = ""
        self._rcj_battery_period_ms = 0
        Robot.created = self

    def step(self, timeStep: float | None = None) -> int:
        """Let ``timeStep`` ms pass, rounded up to whole ticks of 32 ms. Returns 0, or -1 when the match is over."""
        hub = self._rcj_hub
        return 0 if hub.exchange(hub.spec["basic_step_ms"] if timeStep is None else timeStep) else -1

    def getName(self) -> str:
        """Return the robot's name: colour and number, ``Y1``."""
        return str(self._rcj_hub.spec["name"])

    def getTime(self) -> float:
        """Return simulated seconds since the half began."""
        return self._rcj_hub.time_s()

    def getBasicTimeStep(self) -> float:
        """Return the length of a tick in ms."""
        return float(self._rcj_hub.spec["basic_step_ms"])

    def getDevice(self, name: str) -> Any:
        """Return the device of that name; None, and a message, if the robot has none."""
        return self._rcj_device(name)

    def getDeviceByIndex(self, index: int) -> Device | None:
        """Return a device by its number; None if there is none."""
        return list(self._rcj_devices.values())[index] if 0 <= index < len(self._rcj_devices) else None

    def getNumberOfDevices(self) -> int:
        """Return how many devices the robot has."""
        return len(self._rcj_devices)

    def getModel(self) -> str:
        """Return the robot's model: none."""
        return ""

    def getCustomData(self) -> str:
        """Return what ``setCustomData`` was given; nothing at first."""
        return self._rcj_custom_data

    def setCustomData(self, customData: str) -> None:
        """Remember a text. Nobody else reads it."""
        self._rcj_custom_data = customData

    def getSupervisor(self) -> bool:
        """Return False: a player's robot is no supervisor."""
        return False

    def getSynchronization(self) -> bool:
        """Return True: the match waits for each step."""
        return True

    def getMode(self) -> int:
        """Return ``Robot.MODE_SIMULATION``."""
        return Robot.MODE_SIMULATION

    def setMode(self, mode: int, arg: Any = None) -> None:
        """Accepted without effect: there is no other mode."""

    def getProjectPath(self) -> str:
        """Return the current folder, which is the program's own: there is no other one of the project."""
        return os.getcwd()  # noqa: PTH109 - programs want a str, and pathlib would cost each of them its import

    def getWorldPath(self) -> str:
        """Return nothing: there is no world file."""
        return ""

    def getKeyboard(self) -> Any:
        """Return a keyboard on which no key is pressed."""
        return self._rcj_input("Keyboard")

    def getMouse(self) -> Any:
        """Return a mouse that nobody moves."""
        return self._rcj_input("Mouse")

    def getJoystick(self) -> Any:
        """Return a joystick that is not plugged in."""
        return self._rcj_input("Joystick")

    def batterySensorEnable(self, samplingPeriod: float) -> None:
        """Remember a period in ms. There is no battery: the robots never tire."""
        self._rcj_battery_period_ms = int(samplingPeriod) if samplingPeriod > 0 else 0

    def batterySensorDisable(self) -> None:
        """Forget the period."""
        self._rcj_battery_period_ms = 0

    def batterySensorGetSamplingPeriod(self) -> int:
        """Return the period in ms that was asked for; 0 if it is disabled."""
        return self._rcj_battery_period_ms

    def batterySensorGetValue(self) -> float:
        """Return NaN: there is no battery."""
        return math.nan

    def wwiSendText(self, text: str) -> None:
        """Accepted without effect: there is no robot window."""

    def wwiReceiveText(self) -> str:
        """Return nothing: there is no robot window."""
        return ""

    def _rcj_device(self, name: str) -> Any:
        found = self._rcj_devices.get(name)
        if found is None:
            complain(f'Warning: "{name}" device not found. This robot has: {", ".join(self._rcj_devices)}.')
        return found

    def _rcj_input(self, kind: str) -> Any:
        if kind not in self._rcj_inputs:
            from . import keyboard  # noqa: PLC0415 - each import costs every program

            self._rcj_inputs[kind] = getattr(keyboard, kind)()
        return self._rcj_inputs[kind]

    def _rcj_legacy(self, method: str, name: str) -> Any:
        if method not in self._rcj_told_of:
            self._rcj_told_of.add(method)
            complain(f"DEPRECATION: Robot.{method} is deprecated, please use Robot.getDevice instead.")
        return self._rcj_device(name)

    def __getattr__(self, attribute: str) -> Callable[[str], Any]:
        """``getMotor``, ``getReceiver`` … of the years before 2020: as ``getDevice``, after a line of deprecation."""
        if attribute in _LEGACY:
            return lambda name: self._rcj_legacy(attribute, name)
        raise AttributeError(f"{type(self).__name__!r} object has no attribute {attribute!r}")

    name = ReadOnly(getName)
    time = ReadOnly(getTime)
    basic_time_step = ReadOnly(getBasicTimeStep)
    model = ReadOnly(getModel)
    custom_data = property(getCustomData, setCustomData)
    supervisor = ReadOnly(getSupervisor)
    synchronization = ReadOnly(getSynchronization)
    mode = ReadOnly(getMode)
    number_of_devices = ReadOnly(getNumberOfDevices)
    project_path = ReadOnly(getProjectPath)
    world_path = ReadOnly(getWorldPath)
    keyboard = ReadOnly(getKeyboard)
    mouse = ReadOnly(getMouse)
    joystick = ReadOnly(getJoystick)


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
