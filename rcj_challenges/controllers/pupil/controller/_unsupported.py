"""Webots classes that no robot here has: programs may import and name them, but creating one is refused."""

from __future__ import annotations


class Unsupported:
    """What is not on these robots."""

    def __init__(self, *args: object, **kwargs: object) -> None:
        kinds = type(self).__mro__  # a team's own class may be one of them
        raise NotImplementedError(f"there is no {kinds[kinds.index(Unsupported) - 1].__name__} on these robots")


_NAMES = (
    *("Accelerometer", "Altimeter", "Brake", "Camera", "CameraRecognitionObject", "Connector", "Display"),
    *("ImageRef", "Gyro", "InertialUnit", "LED", "LightSensor", "Motion", "Pen"),
    *("Radar", "RadarTarget", "RangeFinder", "Skin", "Speaker", "TouchSensor", "VacuumGripper"),
)

globals().update({name: type(name, (Unsupported,), {"__module__": __name__}) for name in _NAMES})
