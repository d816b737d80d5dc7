"""Webots classes that no robot here has: programs may import and name them; to make one is refused."""

from __future__ import annotations


class Absent:
    """What is not on these robots."""

    def __init__(self, *args: object, **kwargs: object) -> None:
        kinds = type(self).__mro__  # a team's own class may be one of them
        raise NotImplementedError(f"there is no {kinds[kinds.index(Absent) - 1].__name__} on these robots")


class Accelerometer(Absent):
    """Measures acceleration."""


class Altimeter(Absent):
    """Measures height."""


class Brake(Absent):
    """Slows a joint down."""


class Camera(Absent):
    """Takes pictures."""


class CameraRecognitionObject(Absent):
    """What a camera recognizes."""


class Connector(Absent):
    """Holds on to others."""


class Display(Absent):
    """Shows pictures."""


class ImageRef(Absent):
    """A picture of a display."""


class Gyro(Absent):
    """Measures turning."""


class InertialUnit(Absent):
    """Measures attitude."""


class LED(Absent):
    """Shines."""


class LightSensor(Absent):
    """Measures light."""


class Motion(Absent):
    """A motion from a file."""


class Pen(Absent):
    """Draws on the floor."""


class Radar(Absent):
    """Sees targets by radio."""


class RadarTarget(Absent):
    """What a radar sees."""


class RangeFinder(Absent):
    """Takes pictures of distances."""


class Skin(Absent):
    """Moves a skin."""


class Speaker(Absent):
    """Speaks and plays sounds."""


class TouchSensor(Absent):
    """Feels bumps."""


class VacuumGripper(Absent):
    """Holds by suction."""
