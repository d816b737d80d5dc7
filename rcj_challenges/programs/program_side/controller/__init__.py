"""The module that robot programs import: ``from controller import Robot``.

Names follow the Webots Python interface: methods in camelCase, and properties in snake_case. Each class can be
imported from a module of its own too, as in R2023a (``controller.gps``).
"""

from __future__ import annotations

import os
import sys

from .device import Device, Sensor, class_name
from .motor import Motor
from .radio import Emitter, Receiver
from .robot import Robot
from .sensors import GPS, Compass, DistanceSensor, PositionSensor

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

__all__ = [
    "GPS", "LED", "Accelerometer", "Altimeter", "AnsiCodes", "Brake", "Camera", "CameraRecognitionObject", "Compass",
    "Connector", "ContactPoint", "Device", "Display", "DistanceSensor", "Emitter", "Field", "Gyro", "ImageRef",
    "InertialUnit", "Joystick", "Keyboard", "Lidar", "LidarPoint", "LightSensor", "Motion", "Motor", "Mouse",
    "MouseState", "Node", "Pen", "PositionSensor", "Radar", "RadarTarget", "RangeFinder", "Receiver", "Robot",
    "Sensor", "Skin", "Speaker", "Supervisor", "TouchSensor", "VacuumGripper",
    "os", "sys",  # up to R2022b `import *` gave these two as well, for the module had imported them
]  # fmt: skip

_SECOND_CLASSES = {
    "camera": "CameraRecognitionObject", "display": "ImageRef", "mouse": "MouseState", "node": "ContactPoint",
}  # fmt: skip


class _ClassModules:
    """Finds and loads ``controller.distance_sensor`` and the like, which have no files: a module for each class."""

    @staticmethod
    def find_spec(name: str, *_more: object) -> Any:
        package, _, module = name.rpartition(".")
        is_known = package == __name__ and class_name(module) in __all__
        return type(__spec__)(name, _ClassModules) if is_known else None  # type: ignore[arg-type]

    @staticmethod
    def create_module(spec: object) -> None:
        pass

    @staticmethod
    def exec_module(module: Any) -> None:
        short = module.__name__.rpartition(".")[2]
        names = [name for name in (class_name(short), _SECOND_CLASSES.get(short)) if name]
        package = sys.modules[__name__]
        vars(module).update({name: getattr(package, name) for name in names}, __all__=names)


sys.meta_path.append(_ClassModules)


_FILES = {
    "Camera": "camera", "CameraRecognitionObject": "camera", "Lidar": "lidar", "LidarPoint": "lidar",
    **dict.fromkeys(("Accelerometer", "Gyro", "InertialUnit", "LED", "LightSensor", "TouchSensor"), "rare_devices"),
}  # fmt: skip


def __getattr__(name: str) -> Any:
    """Read what few programs import, also by ``import *``, when one does: each file costs every program."""
    if name not in __all__:
        raise AttributeError(f"module 'controller' has no attribute {name!r}", name=name, obj=sys.modules[__name__])
    module = __import__(_FILES.get(name, "_placeholders"), globals(), None, [name], 1)
    globals()[name] = there = getattr(module, name)
    return there


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
