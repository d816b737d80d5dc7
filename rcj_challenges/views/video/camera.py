"""From where the field is seen: the cameras of the replay page."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import product
from typing import Any, NamedTuple

import numpy as np

from rcj_challenges.core.errors import RcjError
from rcj_challenges.core.similarity import nearest_name
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.views.codes import UNKNOWN_CAMERA
from rcj_challenges.views.video.clips import Moment
from rcj_challenges.views.video.footage import Footage

FOV_RAD = 0.5
"""Vertical field of view, as in ``viewer/camera.js``; so are angles and distances."""
_STILL = ("field", "top", "side")
_ELEVATION_RAD = {"field": -0.82, "top": -math.pi / 2, "side": -0.3, "behind": -0.42, "follow-ball": -0.7}
_DISTANCE_M = {"behind": 0.62, "follow-ball": 1.1}
_SMOOTHING_S = 0.8
"""A camera that follows something looks at its average position over this time, so that it glides over jumps."""
_LOOK_AHEAD_M = 0.16
"""A camera behind a robot looks at a point in front of it."""
_MARGIN = 0.97
"""Part of the picture that a still camera fills with the field."""


class View(NamedTuple):
    """MuJoCo's free camera: the point it looks at, its distance from there, and its angles."""

    look_at_m: tuple[float, float, float]
    distance_m: float
    azimuth_deg: float
    elevation_deg: float


@dataclass(frozen=True)
class Camera:
    """A camera; one of the kinds ``behind`` and ``follow-ball`` has the index of a robot or ball, others -1.

    ``field`` shows all of it, from a raised seat; ``top`` and ``side`` are still, too.
    """

    kind: str
    entity: int = -1

    @classmethod
    def parse(cls, name: str, roster: Roster) -> Camera:
        """Return the camera with a name, such as ``top`` or ``behind:Y1``.

        Raises:
            RcjError: there is no such camera, robot or ball.
        """
        if name == "follow-ball" and roster.balls:
            return cls(name, roster.robots)
        if name in _STILL:
            return cls(name)
        behind = [f"behind:{robot}" for robot in roster.entities[: roster.robots]]
        if name in behind:
            return cls("behind", behind.index(name))
        cameras = (*_STILL, *(["follow-ball"] if roster.balls else []), *behind)
        near = nearest_name(name, cameras)
        guess = "" if near is None else f"did you mean {near!r}? "
        raise RcjError(
            f"--camera {name[:60]!r} is unknown", f"{guess}There are: {', '.join(cameras)}", code=UNKNOWN_CAMERA
        )

    def view(self, footage: Footage, moment: Moment, aspect: float) -> View:
        """Return from where a moment is seen, in a picture of a shape (width by height)."""
        corners, upright = _field_corners(footage, aspect)
        azimuth_deg, elevation_deg = 90.0 if upright else 0.0, math.degrees(_ELEVATION_RAD[self.kind])
        if self.entity < 0:
            return _fitted(corners, azimuth_deg, elevation_deg, aspect)
        x_m, y_m, yaw_rad = moment.half.smoothed(self.entity, moment.t_s, _SMOOTHING_S)
        if math.isnan(x_m):
            x_m = y_m = 0.0
        elif self.kind == "behind":
            yaw_rad += math.pi if footage.things["entities"][self.entity]["front"] < 0 else 0.0
            x_m, y_m = x_m + _LOOK_AHEAD_M * math.cos(yaw_rad), y_m + _LOOK_AHEAD_M * math.sin(yaw_rad)
            azimuth_deg = math.degrees(yaw_rad)
        return View((x_m, y_m, 0.03), _DISTANCE_M[self.kind], azimuth_deg, elevation_deg)


def axes(view: View) -> tuple[Any, Any, Any]:
    """Return the unit vectors forward, right and up of a view. Source: MuJoCo's `mjv_cameraFrame`."""
    a, e = math.radians(view.azimuth_deg), math.radians(view.elevation_deg)
    forward = np.array([math.cos(e) * math.cos(a), math.cos(e) * math.sin(a), math.sin(e)])
    right = np.array([math.sin(a), -math.cos(a), 0.0])
    return forward, right, np.cross(right, forward)


def _field_corners(footage: Footage, aspect: float) -> tuple[Any, bool]:
    """Return the corners of field and goals, at the floor and on the walls, and whether the field stands upright."""
    field = footage.things["field"]
    x_m, y_m = field["width_m"] / 2 + 0.01, field["length_m"] / 2 + 0.01
    ends = list(product((-x_m, x_m), (-y_m, y_m)))
    for goal in field["goals"]:
        end_m = (1 if goal["end"] == "positive_y" else -1) * (y_m + goal["depth_m"])
        ends += [(half_m, end_m) for half_m in (-goal["width_m"] / 2, goal["width_m"] / 2)]
    return np.array([(*end, z_m) for end in ends for z_m in (0.0, field["wall_height_m"])]), aspect < 0.95


def _fitted(corners: Any, azimuth_deg: float, elevation_deg: float, aspect: float) -> View:
    """Return the nearest view in which all corners are in the picture.

    A corner with the coordinates u (along an axis of the picture) and z (forward) is seen from the distance d, aimed at
    a, if abs(u - a) <= t * (d + z), where t is the tangent of half the field of view. The smallest d and its a follow.
    """
    forward, right, up = axes(View((0, 0, 0), 0, azimuth_deg, elevation_deg))
    depths_m = corners @ forward
    tan_up = math.tan(FOV_RAD / 2) * _MARGIN
    distance_m, look_at_m = 0.0, np.zeros(3)
    for axis, tangent in ((right, tan_up * aspect), (up, tan_up)):
        low_m = float((corners @ axis - tangent * depths_m).max())
        high_m = float((corners @ axis + tangent * depths_m).min())
        distance_m = max(distance_m, (low_m - high_m) / (2 * tangent))
        look_at_m += axis * (low_m + high_m) / 2
    x_m, y_m, z_m = look_at_m.tolist()
    return View((x_m, y_m, z_m), distance_m, azimuth_deg, elevation_deg)
