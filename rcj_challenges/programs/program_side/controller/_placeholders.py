"""Webots classes that few programs import: constants, unused input devices, and what no robot here has.

Each file costs every program, so this one is read when a program first asks for one of these names.
"""

from __future__ import annotations

import math

from ._connection import complain, number
from .device import ReadOnly
from .robot import Robot

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable


class Unsupported:
    """What is not on these robots: programs may import and name it, but creating one is refused."""

    def __init__(self, *args: object, **kwargs: object) -> None:
        kinds = type(self).__mro__  # a team's own class may be one of them
        raise NotImplementedError(f"there is no {kinds[kinds.index(Unsupported) - 1].__name__} on these robots")


for _name in (
    *("Altimeter", "Brake", "Connector", "Display", "ImageRef", "Motion", "Pen"),
    *("Radar", "RadarTarget", "RangeFinder", "Skin", "Speaker", "VacuumGripper"),
):
    globals()[_name] = type(_name, (Unsupported,), {"__module__": __name__})


class Node(Unsupported):
    """Constants for ``getNodeType()``: ``Node.GPS``. A program can get no nodes themselves."""

    NO_NODE, APPEARANCE, BACKGROUND, BILLBOARD, BOX, CAD_SHAPE, CAPSULE, COLOR, CONE, COORDINATE = range(10)
    CYLINDER, DIRECTIONAL_LIGHT, ELEVATION_GRID, FOG, GROUP, IMAGE_TEXTURE, INDEXED_FACE_SET = range(10, 17)
    INDEXED_LINE_SET, MATERIAL, MESH, MUSCLE, NORMAL, PBR_APPEARANCE, PLANE, POINT_LIGHT, POINT_SET = range(17, 26)
    SHAPE, SPHERE, SPOT_LIGHT, TEXTURE_COORDINATE, TEXTURE_TRANSFORM, TRANSFORM, VIEWPOINT, ROBOT = range(26, 34)
    ACCELEROMETER, ALTIMETER, BRAKE, CAMERA, COMPASS, CONNECTOR, DISPLAY, DISTANCE_SENSOR, EMITTER = range(34, 43)
    GPS, GYRO, INERTIAL_UNIT, LED, LIDAR, LIGHT_SENSOR, LINEAR_MOTOR, PEN, POSITION_SENSOR, RADAR = range(43, 53)
    RANGE_FINDER, RECEIVER, ROTATIONAL_MOTOR, SKIN, SPEAKER, TOUCH_SENSOR, VACUUM_GRIPPER = range(53, 60)
    BALL_JOINT, BALL_JOINT_PARAMETERS, CHARGER, CONTACT_PROPERTIES, DAMPING, FLUID, FOCUS = range(60, 67)
    HINGE_JOINT, HINGE_JOINT_PARAMETERS, HINGE_2_JOINT, IMMERSION_PROPERTIES, JOINT_PARAMETERS = range(67, 72)
    LENS, LENS_FLARE, PHYSICS, RECOGNITION, SLIDER_JOINT, SLOT, SOLID, SOLID_REFERENCE, TRACK = range(72, 81)
    TRACK_WHEEL, WORLD_INFO, ZOOM, MICROPHONE, RADIO = range(81, 86)


class ContactPoint(Unsupported):
    """Where two bodies touch: only supervisors get it."""


class Field(Unsupported):
    """Constants only; a program cannot get fields."""

    NO_FIELD, SF_BOOL, SF_INT32, SF_FLOAT, SF_VEC2F, SF_VEC3F, SF_ROTATION, SF_COLOR, SF_STRING, SF_NODE = range(10)
    MF, MF_BOOL, MF_INT32, MF_FLOAT, MF_VEC2F, MF_VEC3F, MF_ROTATION, MF_COLOR, MF_STRING, MF_NODE = range(16, 26)


class AnsiCodes:
    """Escape sequences (ECMA-48). A robot's log keeps them as they are printed."""

    RESET, BOLD, UNDERLINE, CLEAR_SCREEN = "\x1b[0m", "\x1b[1m", "\x1b[4m", "\x1b[2J"


for _place, _first in (("FOREGROUND", 30), ("BACKGROUND", 40)):
    for _number, _colour in enumerate(("BLACK", "RED", "GREEN", "YELLOW", "BLUE", "MAGENTA", "CYAN", "WHITE"), _first):
        setattr(AnsiCodes, f"{_colour}_{_place}", f"\x1b[{_number}m")


class _Input:
    def __init__(self) -> None:
        self._period_ms = 0

    def enable(self, samplingPeriod: float | None = None, *, sampling_period: float | None = None) -> None:
        """Remember a period in ms."""
        given = samplingPeriod if sampling_period is None else sampling_period
        period_ms = number(given, f"{type(self).__name__}: enable takes a number of ms, such as 32")
        self._period_ms = int(period_ms) if period_ms > 0 else 0

    def disable(self) -> None:
        """Forget the period."""
        self._period_ms = 0

    def getSamplingPeriod(self) -> int:
        """Return the period in ms that was asked for; 0 if it is disabled."""
        return self._period_ms

    sampling_period = property(getSamplingPeriod, enable)


class Keyboard(_Input):
    """A keyboard on which no key is pressed."""

    END, HOME, LEFT, UP, RIGHT, DOWN = range(312, 318)
    PAGEUP, PAGEDOWN = 366, 367
    NUMPAD_HOME, NUMPAD_LEFT, NUMPAD_UP, NUMPAD_RIGHT, NUMPAD_DOWN = range(375, 380)
    NUMPAD_END = 382
    KEY, SHIFT, CONTROL, ALT = 0xFFFF, 0x10000, 0x20000, 0x40000

    def getKey(self) -> int:
        """Return -1: no key is pressed."""
        return -1

    key = ReadOnly(getKey)


class MouseState:
    """A mouse that is not over the field: no button is pressed, and all positions are NaN."""

    left = middle = right = False
    u = v = x = y = z = math.nan


class Mouse(_Input):
    """A mouse that never moves."""

    def __init__(self) -> None:
        super().__init__()
        self._has_place = False

    def enable3dPosition(self) -> None:
        """Accepted without effect."""
        self._has_place = True

    def disable3dPosition(self) -> None:
        """Accepted without effect."""
        self._has_place = False

    def is3dPositionEnabled(self) -> bool:
        """Return the last setting."""
        return self._has_place

    def getState(self) -> MouseState:
        """Return that nothing is pressed."""
        return MouseState()

    state = ReadOnly(getState)


class Joystick(_Input):
    """A joystick that is not plugged in."""

    def isConnected(self) -> bool:
        """Return False."""
        return False

    def getModel(self) -> str:
        """Return no name."""
        return ""

    def getNumberOfAxes(self) -> int:
        """Return 0."""
        return 0

    def getAxisValue(self, axis: int) -> int:
        """Return 0: in the middle."""
        return 0

    def getNumberOfPovs(self) -> int:
        """Return 0."""
        return 0

    def getPovValue(self, pov: int) -> int:
        """Return 0: not pressed."""
        return 0

    def getPressedButton(self) -> int:
        """Return -1: no button is pressed."""
        return -1

    connected = ReadOnly(isConnected)
    model = ReadOnly(getModel)
    number_of_axes = ReadOnly(getNumberOfAxes)
    number_of_povs = ReadOnly(getNumberOfPovs)
    pressed_button = ReadOnly(getPressedButton)


_CALLS = frozenset(
    (
        *("animationStartRecording", "animationStopRecording", "exportImage", "getFromDef", "getFromDevice"),
        *("getFromId", "getMovieStatus", "getRoot", "getSelected", "getSelf", "loadWorld", "movieFailed"),
        *("movieIsReady", "movieStartRecording", "movieStopRecording", "reloadWorld", "saveWorld", "setLabel"),
        *("setSimulationMode", "simulationGetMode", "simulationPhysicsReset", "simulationQuit", "simulationReset"),
        *("simulationResetPhysics", "simulationRevert", "simulationSetMode", "startAnimation", "startMovie"),
        *("stopAnimation", "stopMovie", "virtualRealityHeadsetGetOrientation"),
        *("virtualRealityHeadsetGetPosition", "virtualRealityHeadsetIsUsed", "worldLoad", "worldReload", "worldSave"),
    )
)


class Supervisor(Robot):
    """A robot like any other. The calls that only supervisors have do nothing and return None, after a message."""

    SIMULATION_MODE_PAUSE, SIMULATION_MODE_REAL_TIME, SIMULATION_MODE_FAST = range(3)

    def __getattr__(self, attribute: str) -> Callable[..., None]:
        if attribute not in _CALLS:
            text = f"{type(self).__name__!r} object has no attribute {attribute!r}"
            raise AttributeError(text, name=attribute, obj=self)

        def ignore(*_: object, **__: object) -> None:
            if attribute not in self._rcj_warned_about:
                self._rcj_warned_about.add(attribute)
                complain(
                    f"Warning: {attribute} is ignored and gives None: it is the referee's, this is a player's robot.",
                    "do without this call",
                    code="ignored-call",
                    subject=attribute,
                )

        return ignore
