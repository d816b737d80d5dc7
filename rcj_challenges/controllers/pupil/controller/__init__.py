"""The module that robot programs import: ``from controller import Robot``.

Names follow the Webots Python interface: methods in camelCase, and properties in snake_case.
"""

from __future__ import annotations

from typing import Any

from .device import Device, Sensor
from .lidar import Lidar, LidarPoint
from .motor import Motor
from .radio import Emitter, Receiver
from .robot import Robot, Supervisor
from .sensors import GPS, Compass, DistanceSensor, PositionSensor

__all__ = [
    "GPS",
    "Compass",
    "Device",
    "DistanceSensor",
    "Emitter",
    "Joystick",
    "Keyboard",
    "Lidar",
    "LidarPoint",
    "Motor",
    "Mouse",
    "MouseState",
    "PositionSensor",
    "Receiver",
    "Robot",
    "Sensor",
    "Supervisor",
]

_SELDOM_IMPORTED = frozenset(("Joystick", "Keyboard", "Mouse", "MouseState"))

_NOT_ON_THESE_ROBOTS = frozenset(
    (
        *("Accelerometer", "Altimeter", "AnsiCodes", "Brake", "Camera", "CameraRecognitionObject", "Connector"),
        *("Display", "Field", "Gyro", "InertialUnit", "LED", "LightSensor", "Node", "Pen", "Radar"),
        *("RadarTarget", "RangeFinder", "Skin", "Speaker", "TouchSensor", "VacuumGripper"),
    )
)


def __getattr__(name: str) -> Any:
    """Read what few programs import; and let all import Webots classes that no robot here has: using one is refused."""
    if name in _SELDOM_IMPORTED:
        from . import keyboard  # noqa: PLC0415 - each import costs every program

        return getattr(keyboard, name)
    if name not in _NOT_ON_THESE_ROBOTS:
        raise AttributeError(f"module 'controller' has no attribute {name!r}")

    def refuse(self: object, *args: object, **kwargs: object) -> None:
        raise NotImplementedError(f"there is no {name} on these robots")

    return type(name, (), {"__init__": refuse, "__doc__": f"Not on these robots: {name}."})
