"""The match in three dimensions, by `mujoco.Renderer`."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from itertools import product
from typing import Any

import mujoco
import numpy as np
from PIL import Image

from rcj_challenges.views.video.camera import CALM_S, Camera, ends_of_field
from rcj_challenges.views.video.colours import EDGE, WHITE
from rcj_challenges.views.video.footage import Footage, Poses
from rcj_challenges.views.video.ground import moving_gate_lines
from rcj_challenges.views.video.lettering import Lettering, line_height
from rcj_challenges.views.video.solid_model import gates_of, solid_model
from rcj_challenges.views.video.timeline import Moment

_SAMPLES = 4
"""For each pixel, in pictures. A film goes without: they cost a software GPU half of its speed, and edges that are
staircases in a picture pass in motion."""

_ELEVATION_DEG = {"field": -52.0, "top": -90.0, "side": -20.0, "behind": -24.0, "follow-ball": -40.0}
_FOV_DEG = 32.0
_CLOSE_M = {"behind": 0.95, "follow-ball": 1.5}
_HIDDEN_M = -50.0
"""Where what is off the field is put: under the ground."""


class Solid:
    """Draws moments in 3-D.

    Args:
        footage: what is shown.
        size: of the whole picture, in pixels.
        top: how much of it is left free for the board.
        camera: where it is looked at from.
        lettering: for the robots' names and numbers.
        shadows: whether this is a fine picture: things throw shadows, edges are smooth. Takes ten times as long.
    """

    name = "in 3-D"

    def __init__(
        self,
        footage: Footage,
        size: tuple[int, int],
        top: int,
        camera: Camera,
        lettering: Lettering,
        *,
        shadows: bool,
    ) -> None:
        self._size, self._top, self._camera, self._lettering = size, top, camera, lettering
        self._entities = footage.things["entities"]
        width, height = size[0], size[1] - top
        samples = _SAMPLES if shadows else 0
        self._model = solid_model(footage, (width, height), samples, lettering, shadows=shadows)
        self._model.vis.global_.fovy = _FOV_DEG
        self._data: Any = mujoco.MjData(self._model)
        self._mocap = [int(self._model.body(entity["name"]).mocapid[0]) for entity in self._entities]
        self._gates = {
            entity: int(self._model.body(gates_of(footage.roster.entities[entity])).mocapid[0])
            for entity in moving_gate_lines(footage)
        }
        self._renderer: Any = mujoco.Renderer(self._model, height, width)
        self._frame = Image.new("RGB", size)
        self._flags = {
            mujoco.mjtRndFlag.mjRND_SHADOW: shadows,
            mujoco.mjtRndFlag.mjRND_REFLECTION: False,
            mujoco.mjtRndFlag.mjRND_SKYBOX: shadows,
            mujoco.mjtRndFlag.mjRND_HAZE: False,
        }
        self._view: Any = mujoco.MjvCamera()
        self._view.type = mujoco.mjtCamera.mjCAMERA_FREE
        across, along = ends_of_field(footage)
        self._lying = (width >= height) == (along >= across)
        if camera.entity < 0:
            self._fit(width / height, across, along)
        self._rolled: dict[int, tuple[float, float, Any]] = {}

    def picture(self, moment: Moment) -> Image.Image:
        """Return the picture of a moment, without the board; it is drawn over by the next."""
        poses = moment.half.poses(moment.t_s)
        self._place(poses)
        self._aim(moment, poses)
        mujoco.mj_kinematics(self._model, self._data)
        mujoco.mj_camlight(self._model, self._data)
        self._renderer.update_scene(self._data, self._view)
        for flag, value in self._flags.items():
            self._renderer.scene.flags[flag] = value
        frame = self._frame
        frame.paste(Image.fromarray(self._renderer.render()), (0, self._top))
        self._write_names(frame, poses)
        return frame

    def close(self) -> None:
        """Give the graphics context back."""
        self._renderer.close()

    # --- what is where -----------------------------------------------------------------------------------------------

    def _place(self, poses: Poses) -> None:
        for entity, (mocap, facts) in enumerate(zip(self._mocap, self._entities, strict=True)):
            x_m, y_m, yaw_rad, z_m = poses[entity].tolist()
            if math.isnan(x_m):
                self._data.mocap_pos[mocap] = (0, 0, _HIDDEN_M)
                continue
            self._data.mocap_pos[mocap] = (x_m, y_m, z_m)
            if facts["kind"] == "ball":
                self._data.mocap_quat[mocap] = self._rolling(entity, x_m, y_m, float(facts["radius_m"]))
            else:
                self._data.mocap_quat[mocap] = _upright(yaw_rad)
        for entity, mocap in self._gates.items():
            x_m, y_m, yaw_rad, _ = poses[entity].tolist()
            off = math.isnan(x_m)
            self._data.mocap_pos[mocap] = (0, 0, _HIDDEN_M) if off else (x_m, y_m, 0)
            self._data.mocap_quat[mocap] = _upright(0.0 if off else yaw_rad)

    def _rolling(self, entity: int, x_m: float, y_m: float, radius_m: float) -> Any:
        """Return how a ball is turned that rolled from where it was in the last frame.

        The trajectory does not hold it: it is for the eye alone.
        """
        last_x, last_y, quat = self._rolled.get(entity, (x_m, y_m, np.array([1.0, 0, 0, 0])))
        way = math.hypot(x_m - last_x, y_m - last_y)
        if way > 1e-6:
            turn, turned = np.zeros(4), np.zeros(4)
            axis = np.array([-(y_m - last_y) / way, (x_m - last_x) / way, 0.0])
            mujoco.mju_axisAngle2Quat(turn, axis, way / radius_m)
            mujoco.mju_mulQuat(turned, turn, quat)
            quat = turned
        self._rolled[entity] = (x_m, y_m, quat)
        return quat

    # --- from where ---------------------------------------------------------------------------------------------------

    def _aim(self, moment: Moment, poses: Poses) -> None:
        """Point a camera that follows something; the others stay as they are."""
        camera, view = self._camera, self._view
        if camera.entity < 0:
            return
        x_m, y_m = camera.target(moment.half, moment.t_s)
        view.distance = _CLOSE_M[camera.kind]
        view.elevation = _ELEVATION_DEG[camera.kind]
        view.azimuth = 0.0 if self._lying else 90.0
        if camera.kind == "behind" and not math.isnan(poses[camera.entity, 0]):
            yaw_rad = moment.half.mean_yaw(camera.entity, moment.t_s, CALM_S)
            if self._entities[camera.entity]["front"] < 0:
                yaw_rad += math.pi
            view.azimuth = math.degrees(yaw_rad)
            # It looks over the robot at what lies before it.
            x_m, y_m = x_m + 0.22 * math.cos(yaw_rad), y_m + 0.22 * math.sin(yaw_rad)
        view.lookat[:] = (x_m, y_m, 0.03)

    def _fit(self, aspect: float, across: float, along: float) -> None:
        """Put a still camera as near as shows all of the field."""
        view = self._view
        view.elevation = _ELEVATION_DEG[self._camera.kind]
        view.azimuth = 0.0 if self._lying else 90.0
        corners = [np.array(corner) for corner in product((-across, across), (-along, along), (0.0, 0.09))]
        forward, right, up = _axes(view.azimuth, view.elevation)
        tall = math.tan(math.radians(_FOV_DEG) / 2) * 0.97
        wide = tall * aspect

        def seen_from(distance: float, aim: Any) -> tuple[float, float, float, float]:
            """Return the smallest and largest place of a corner in the picture: -1 to 1 is inside."""
            deep = [distance + float((corner - aim) @ forward) for corner in corners]
            xs = [float((c - aim) @ right) / d / wide for c, d in zip(corners, deep, strict=True)]
            ys = [float((c - aim) @ up) / d / tall for c, d in zip(corners, deep, strict=True)]
            return min(xs), max(xs), min(ys), max(ys)

        def fits(aim: Any, distance: float) -> bool:
            return max(map(abs, seen_from(distance, aim))) <= 1.0

        aim = np.zeros(3)
        distance = 1.0
        # What is near looks larger, so the middle of the picture is not the middle of the field: both are approached
        # by turns. The distance is bisected, the aim moved by what the picture is off.
        for _ in range(8):
            distance = _bisected(partial(fits, aim))
            low_x, high_x, low_y, high_y = seen_from(distance, aim)
            aim = aim + right * (low_x + high_x) / 2 * wide * distance + up * (low_y + high_y) / 2 * tall * distance
        view.distance = _bisected(partial(fits, aim))
        view.lookat[:] = aim

    # --- names --------------------------------------------------------------------------------------------------------

    def _write_names(self, frame: Image.Image, poses: Poses) -> None:
        """Write each robot's name above it: seen from the side nobody sees the number on the lid."""
        if self._camera.kind == "top":
            return
        size = max(8, round(min(self._size) * 0.02))
        for entity, facts in enumerate(self._entities):
            if facts["kind"] != "robot" or math.isnan(poses[entity, 0]) or entity == self._hidden_name():
                continue
            x_m, y_m, _, z_m = poses[entity].tolist()
            at = self._px((x_m, y_m, z_m + facts["size_m"] * 1.05))
            if at is None:
                continue
            mask = self._lettering.mask(str(facts["name"]), size, bold=True)
            pad = size // 4
            box = Image.new("RGBA", (mask.width + 2 * pad, line_height(size)), (*EDGE, 190))
            box.paste((*WHITE, 255), (pad, size // 8), mask)
            left, top = round(at[0] - box.width / 2), round(at[1] - box.height / 2)
            if top >= self._top:
                frame.paste(box, (left, top), box)

    def _hidden_name(self) -> int:
        return self._camera.entity if self._camera.kind == "behind" else -1

    def _px(self, point: tuple[float, float, float]) -> tuple[float, float] | None:
        """Return where a point is in the picture; None behind the camera."""
        forward, right, up = _axes(self._view.azimuth, self._view.elevation)
        eye = np.array(self._view.lookat) - self._view.distance * forward
        to = np.array(point) - eye
        deep = float(to @ forward)
        if deep <= 0.05:
            return None
        width, height = self._size[0], self._size[1] - self._top
        scale = height / 2 / math.tan(math.radians(_FOV_DEG) / 2) / deep
        return width / 2 + float(to @ right) * scale, self._top + height / 2 - float(to @ up) * scale


def _upright(yaw_rad: float) -> tuple[float, float, float, float]:
    """Return the quaternion of what stands upright and is turned by a yaw."""
    return math.cos(yaw_rad / 2), 0.0, 0.0, math.sin(yaw_rad / 2)


def _axes(azimuth_deg: float, elevation_deg: float) -> tuple[Any, Any, Any]:
    """Return forward, right and up of a camera. Source: MuJoCo's free camera (`mjv_cameraFrame`)."""
    a, e = math.radians(azimuth_deg), math.radians(elevation_deg)
    forward = np.array([math.cos(e) * math.cos(a), math.cos(e) * math.sin(a), math.sin(e)])
    right = np.array([math.sin(a), -math.cos(a), 0.0])
    return forward, right, np.cross(right, forward)


def _bisected(fits: Callable[[float], bool]) -> float:
    """Return the smallest distance in m that fits."""
    near, far = 0.2, 60.0
    for _ in range(40):
        middle = (near + far) / 2
        near, far = (near, middle) if fits(middle) else (middle, far)
    return far
