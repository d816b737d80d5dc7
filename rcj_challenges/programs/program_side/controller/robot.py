"""The robot itself."""

from __future__ import annotations

import math
import os
import sys

from ._connection import Connection, complain, connected
from .device import Device, ReadOnly, class_name, device_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any, NoReturn, Self


def _class_of(kind: str) -> Any:
    """Return the class of a kind of devices; that of a kind which Webots does not have is in the module of its name."""
    name, package = class_name(kind), sys.modules[__package__]
    module = package if name in package.__all__ else __import__(kind, globals(), None, [name], 1)
    return getattr(module, name)


class Robot:
    """The robot that this program drives. A program creates one, often of its own subclass.

    Private names begin with ``_rcj_``, so that a subclass does not override them by accident. For the same reason no
    method calls another that could be overridden.
    """

    MODE_SIMULATION, MODE_CROSS_COMPILATION, MODE_REMOTE_CONTROL = range(3)
    EVENT_QUIT, EVENT_NO_EVENT, EVENT_MOUSE_CLICK, EVENT_MOUSE_MOVE = -1, 0, 1, 2
    EVENT_KEYBOARD, EVENT_JOYSTICK_BUTTON, EVENT_JOYSTICK_AXIS, EVENT_JOYSTICK_POV = 4, 8, 16, 32

    created: Robot | None = None

    _rcj_connection: Connection
    _rcj_warned_about: set[str]
    _rcj_inputs: dict[str, Any]
    _rcj_custom_data = ""
    _rcj_battery_period_ms = 0

    def __new__(cls, *_: object, **__: object) -> Self:
        """Make a robot that complains until ``__init__``, which a class of a team's own may forget, has run."""
        robot = super().__new__(cls)
        robot._rcj_connection = _NotBegun(cls.__name__)  # type: ignore[assignment] # until it is begun
        robot._rcj_warned_about = set()
        robot._rcj_inputs = {}
        return robot

    def __init__(self) -> None:
        self._rcj_connection = connection = connected()
        if connection.robot_made:  # going on is harmless; ending the program would cost a robot
            complain(
                f"Error: only one Robot can be made: this second {type(self).__name__} is the same robot.",
                "make it once, and hand it to what needs it: def run(robot): …",
            )
            return
        connection.robot_made = True
        for spec in connection.spec["devices"]:
            connection.devices[spec["name"]] = _class_of(spec["kind"])._rcj_made(connection, spec)  # noqa: SLF001 - for this alone
        Robot.created = self

    def __copy__(self) -> Self:
        """Return the robot itself: there is only one."""
        return self

    def __deepcopy__(self, _memo: object) -> Self:
        """Return the robot itself: there is only one."""
        return self

    def step(self, time_step: float | None = None, timeStep: float | None = None, duration: float | None = None) -> int:
        """Let ``time_step`` ms pass, rounded up to whole ticks of 32 ms. Returns 0, or -1 when the match is over.

        ``timeStep`` and ``duration`` are its names in other versions.

        Raises:
            TypeError: no number was given.

        Example:
            ``while robot.step(32) != -1:``
        """
        # Not keyword-only: Python calls slower what has such arguments.
        connection = self._rcj_connection
        if time_step is None:
            time_step = connection.duration_ms(timeStep, duration)
        return 0 if connection.exchange(time_step) else -1

    def stepBegin(self, time_step: float | None = None) -> None:
        """Begin a step of ``time_step`` ms. What is set from now on until ``stepEnd`` takes effect in the next one."""
        self._rcj_connection.begin(self._rcj_connection.duration_ms(time_step))

    def stepEnd(self) -> int:
        """Take the step that ``stepBegin`` began. Returns 0, or -1 when the match is over."""
        return 0 if self._rcj_connection.end() else -1

    def waitForUserInputEvent(self, event_type: int, timeout: float = 0) -> int:
        """Return ``Robot.EVENT_NO_EVENT`` at once: there is no user input."""
        return Robot.EVENT_NO_EVENT

    def getName(self) -> str:
        """Return the robot's name: colour (``B`` or ``Y``) and number.

        Example:
            ``robot.getName()[0] == "Y"`` in a robot of the yellow team.
        """
        return str(self._rcj_connection.spec["name"])

    def getTime(self) -> float:
        """Return simulated seconds since the half began.

        Example:
            ``robot.getTime()`` is 0.32 after ten steps of 32 ms.
        """
        return self._rcj_connection.time_s()

    def getBasicTimeStep(self) -> float:
        """Return the length of a tick in ms."""
        return float(self._rcj_connection.spec["basic_step_ms"])

    def getDevice(self, name: str) -> Any:
        """Return the device of that name; None, and a message, if the robot has none.

        Example:
            ``gps = robot.getDevice("gps")``
        """
        return self._rcj_connection.devices.get(name) or device_of(self._rcj_connection, name, "Device")

    def getDeviceByIndex(self, index: int) -> Device | None:
        """Return a device by its number; None if there is none."""
        devices = list(self._rcj_connection.devices.values())
        return devices[index] if 0 <= index < len(devices) else None

    def getNumberOfDevices(self) -> int:
        """The number of devices of the robot."""
        return len(self._rcj_connection.devices)

    def _rcj_devices(self) -> dict[str, Device]:
        return dict(self._rcj_connection.devices)

    def getType(self) -> int:
        """Return its kind, as ``Node`` numbers them: ``Node.ROBOT``."""
        from ._placeholders import Node  # noqa: PLC0415 - each import costs every program

        return Node.ROBOT

    def getModel(self) -> str:
        """Return the robot's model: none."""
        return ""

    def getCustomData(self) -> str:
        """Return the text given to ``setCustomData``; empty at first."""
        return self._rcj_custom_data

    def setCustomData(self, customData: str) -> None:
        """Store a text. Only this program reads it."""
        self._rcj_custom_data = customData

    def getSupervisor(self) -> bool:
        """Return False: a player's robot is not a supervisor."""
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
        """Return the folder in which ``controllers`` holds what the team handed in."""
        return os.path.dirname(self._rcj_connection.root)  # noqa: PTH120 - pathlib would cost each program its import

    def getWorldPath(self) -> str:
        """Return nothing: there is no world file."""
        return ""

    def getUrdf(self, prefix: str = "") -> str:
        """Return nothing: robots are not described in URDF."""
        return ""

    def getKeyboard(self) -> Any:
        """Return a keyboard on which no key is pressed."""
        return self._rcj_input("Keyboard")

    def getMouse(self) -> Any:
        """Return a mouse that never moves."""
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

    # Older names.
    wwiSend = wwiSendText  # noqa: N815 - these are methods
    wwiReceive = wwiReceiveText  # noqa: N815

    def _rcj_input(self, kind: str) -> Any:
        if kind not in self._rcj_inputs:
            from . import _placeholders  # noqa: PLC0415 - each import costs every program

            self._rcj_inputs[kind] = getattr(_placeholders, kind)()
        return self._rcj_inputs[kind]

    name = ReadOnly(getName)
    time = ReadOnly(getTime)
    basic_time_step = ReadOnly(getBasicTimeStep)
    model = ReadOnly(getModel)
    custom_data = property(getCustomData, setCustomData)
    supervisor = ReadOnly(getSupervisor)
    synchronization = ReadOnly(getSynchronization)
    mode = ReadOnly(getMode)
    number_of_devices = ReadOnly(getNumberOfDevices)
    devices = ReadOnly(_rcj_devices)
    project_path = ReadOnly(getProjectPath)
    world_path = ReadOnly(getWorldPath)
    keyboard = ReadOnly(getKeyboard)
    mouse = ReadOnly(getMouse)
    joystick = ReadOnly(getJoystick)


class _NotBegun:
    """What stands for the connection until ``Robot.__init__`` has run."""

    def __init__(self, kind: str) -> None:
        self._kind = kind

    def __getattr__(self, attribute: str) -> NoReturn:
        raise RuntimeError(f"{self._kind}.__init__ has to call super().__init__() first: until then it is no robot")


def _getter_of_old(kind: str) -> Callable[[Robot, str], Any]:
    """Return ``getMotor``, ``getReceiver`` … of the years before 2020."""

    def get(self: Robot, name: str) -> Any:
        if kind not in self._rcj_warned_about:
            self._rcj_warned_about.add(kind)
            complain(f"DEPRECATION: Robot.get{kind} is deprecated, please use Robot.getDevice instead.")
        return device_of(self._rcj_connection, name, "Motor" if kind == "Servo" else kind)

    get.__name__ = f"get{kind}"
    get.__doc__ = f"Return the {kind} of that name, with a deprecation note; None, with a message, if there is none."
    return get


for _kind in (
    *("Accelerometer", "Altimeter", "Brake", "Camera", "Compass", "Connector", "Display", "DistanceSensor", "Emitter"),
    *("GPS", "Gyro", "InertialUnit", "LED", "Lidar", "LightSensor", "Motor", "Pen", "PositionSensor", "Radar"),
    *("RangeFinder", "Receiver", "Servo", "Skin", "Speaker", "TouchSensor", "VacuumGripper"),
):
    setattr(Robot, f"get{_kind}", _getter_of_old(_kind))
