"""Draws moments of a run with `mujoco.Renderer`."""

from __future__ import annotations

import math
from typing import Any

import mujoco
import numpy as np
from PIL import Image

from rcj_challenges.views.palette import rgb
from rcj_challenges.views.video.camera import Camera
from rcj_challenges.views.video.clips import Moment
from rcj_challenges.views.video.footage import Footage, Poses
from rcj_challenges.views.video.scene import FLOOR_BODY, build_scene

_LIGHT_M = 0.004
_HIDDEN_M = 1000.0
"""What is off the field is put here, beyond what the camera sees."""


class SceneRenderer:
    """Draws moments as pictures of a size in pixels; smooth edges take several times as long.

    Raises:
        RuntimeError: there is no OpenGL; importing this module may also raise `ImportError` or `AttributeError`.
    """

    def __init__(self, footage: Footage, size: tuple[int, int], camera: Camera, *, fine: bool) -> None:
        self._footage, self._size, self._camera, self._fine = footage, size, camera, fine
        self._entities = footage.things["entities"]
        self._shown: Footage | None = None
        self._renderer: Any = None
        self._dress(footage.halves[0].info.half)
        self._option: Any = mujoco.MjvOption()
        self._option.geomgroup[:] = 1
        self._camera_state: Any = mujoco.MjvCamera()

    def _dress(self, half: int) -> None:
        """Build the scene with the bodies that robots have in a half, unless it is there."""
        footage = self._footage.dressed(half)
        if self._shown is not None and footage.scenario == self._shown.scenario:
            return
        if self._renderer is not None:
            self._renderer.close()
        self._shown = footage
        self._model = build_scene(footage, self._size, fine=self._fine)
        self._data: Any = mujoco.MjData(self._model)
        try:
            self._renderer = mujoco.Renderer(self._model, self._size[1], self._size[0])
        except mujoco.FatalError as error:
            raise RuntimeError(str(error)) from error

    def draw(self, moment: Moment) -> Image.Image:
        """Return the picture of a moment."""
        self._dress(moment.half.info.half)
        poses = moment.half.poses_at(moment.t_s)
        view = self._camera.view(self._footage, moment, self._size[0] / self._size[1])
        self._place(poses)
        state = self._camera_state
        state.lookat[:] = view.look_at_m
        state.distance, state.azimuth, state.elevation = view.distance_m, view.azimuth_deg, view.elevation_deg
        mujoco.mj_kinematics(self._model, self._data)
        mujoco.mj_camlight(self._model, self._data)
        self._renderer.update_scene(self._data, state, self._option)
        self._add_lights(moment, poses)
        for flag in (mujoco.mjtRndFlag.mjRND_SHADOW, mujoco.mjtRndFlag.mjRND_REFLECTION):
            self._renderer.scene.flags[flag] = False
        return Image.fromarray(self._renderer.render())

    def _add_lights(self, moment: Moment, poses: Poses) -> None:
        """Add the lights of robots that are lit, in a row behind the number."""
        scene = self._renderer.scene
        for light in self._footage.lights(moment.half, moment.t_s):
            facts, (x_m, y_m, yaw_rad, z_m) = self._entities[light.entity], poses[light.entity].tolist()
            if math.isnan(x_m) or scene.ngeom >= scene.maxgeom:
                continue
            size_m, front = facts["size_m"], facts["front"]
            ahead, left = -0.44 * size_m * front, ((light.of - 1) / 2 - light.at) * 0.16 * size_m * front
            cos, sin = math.cos(yaw_rad), math.sin(yaw_rad)
            at_m = (x_m + cos * ahead - sin * left, y_m + sin * ahead + cos * left, z_m + facts["height_m"] / 2 + 0.002)
            rgba = np.array([*(part / 255 for part in rgb(light.colour)), 1.0], np.float32)
            geom = scene.geoms[scene.ngeom]
            mujoco.mjv_initGeom(
                geom, mujoco.mjtGeom.mjGEOM_SPHERE, np.full(3, _LIGHT_M), np.array(at_m), np.eye(3).ravel(), rgba
            )
            geom.emission = 0.25  # with the light of the scene about its own colour
            scene.ngeom += 1

    def close(self) -> None:
        """Free the graphics context."""
        self._renderer.close()

    def _place(self, poses: Poses) -> None:
        shown = np.where(np.isnan(poses), [_HIDDEN_M, 0.0, 0.0, 0.0], poses).tolist()
        for facts, (x_m, y_m, yaw_rad, z_m) in zip(self._entities, shown, strict=True):
            name = facts["name"]
            mocap = self._model.body(name + FLOOR_BODY).mocapid[0]
            self._data.mocap_pos[mocap] = (x_m, y_m, 0)
            self._data.mocap_quat[mocap] = _quat(yaw_rad, 0, 0, 1)
            if facts["kind"] == "ball":
                self._data.joint(name).qpos = (x_m, y_m, z_m, *_rolled(x_m, y_m, facts["radius_m"]))
                continue
            for axis, value in (("x", x_m), ("y", y_m), ("yaw", yaw_rad)):
                self._data.joint(f"{name}/{axis}").qpos = value


def _rolled(x_m: float, y_m: float, radius_m: float) -> tuple[float, float, float, float]:
    """Return the quaternion of a ball that rolled straight from the middle of the field.

    Trajectories do not hold how balls turn. This looks right in motion and needs no memory of earlier frames.
    """
    way_m = math.hypot(x_m, y_m)
    return _quat(way_m / radius_m, -y_m / way_m, x_m / way_m, 0) if way_m else (1.0, 0.0, 0.0, 0.0)


def _quat(angle_rad: float, *axis: float) -> tuple[float, float, float, float]:
    x, y, z = (math.sin(angle_rad / 2) * part for part in axis)
    return (math.cos(angle_rad / 2), x, y, z)
