"""The module that robot programs import: ``from controller import Robot``.

Names follow the Webots Python interface: methods in camelCase, and properties in snake_case. Each class has a module of
its own too, as in R2023a (``controller.gps``); they are read only by programs that import them.
"""

from __future__ import annotations

import os
import sys

from .device import Device, Sensor
from .motor import Motor
from .radio import Emitter, Receiver
from .robot import Robot
from .sensors import GPS, Compass, DistanceSensor, PositionSensor

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

__all__ = [
    "GPS",
    "LED",
    "Accelerometer",
    "Altimeter",
    "AnsiCodes",
    "Brake",
    "Camera",
    "CameraRecognitionObject",
    "Compass",
    "Connector",
    "ContactPoint",
    "Device",
    "Display",
    "DistanceSensor",
    "Emitter",
    "Field",
    "Gyro",
    "ImageRef",
    "InertialUnit",
    "Joystick",
    "Keyboard",
    "Lidar",
    "LidarPoint",
    "LightSensor",
    "Motion",
    "Motor",
    "Mouse",
    "MouseState",
    "Node",
    "Pen",
    "PositionSensor",
    "Radar",
    "RadarTarget",
    "RangeFinder",
    "Receiver",
    "Robot",
    "Sensor",
    "Skin",
    "Speaker",
    "Supervisor",
    "TouchSensor",
    "VacuumGripper",
    "os",  # up to R2022b `import *` gave these two as well, for the module had imported them
    "sys",
]

_SELDOM_IMPORTED = {
    "AnsiCodes": "ansi_codes",
    "ContactPoint": "node",
    "Field": "field",
    "Joystick": "keyboard",
    "Keyboard": "keyboard",
    "Lidar": "lidar",
    "LidarPoint": "lidar",
    "Mouse": "keyboard",
    "MouseState": "keyboard",
    "Node": "node",
    "Supervisor": "supervisor",
}


def __getattr__(name: str) -> Any:
    """Read what few programs import, also by ``import *``, when one does: each file costs every program."""
    if name not in __all__:
        raise AttributeError(f"module 'controller' has no attribute {name!r}", name=name, obj=sys.modules[__name__])
    module = __import__(_SELDOM_IMPORTED.get(name, "_absent"), globals(), None, [name], 1)
    globals()[name] = there = getattr(module, name)
    return there


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
