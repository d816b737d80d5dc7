"""The part of the world that devices use: a narrow view of `rcj_challenges.world.World`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

import mujoco


class Ground(Protocol):
    """The physics under the robots.

    Bodies have the names of their entities; robots move in the plane or freely, balls freely. The joints of wheels are
    called ``B1/left_wheel``, and their angles grow while the wheels drive forward. Geoms are in the groups of
    `rcj_challenges.world.contact`.
    """

    @property
    def model(self) -> mujoco.MjModel:
        """The compiled model."""

    @property
    def data(self) -> mujoco.MjData:
        """Its state; the same object for the whole half, with poses up to date after steps and placements."""

    @property
    def parked(self) -> Sequence[bool]:
        """By entity: whether it has been taken off the field."""

    def set_wheel(self, robot: int, wheel: int, velocity_radps: float, position_rad: float) -> None:
        """Command a wheel by its number; positive drives forward; position ``inf``: by velocity."""

    def set_tool(self, robot: int, name: str, velocity: float, position: float) -> None:
        """Command what is no wheel by the name of its device."""

    def touched_at(self, robot: int) -> Sequence[float]:
        """Return the bearings at which a robot with a touch sensor touched walls, obstacles and robots in this tick."""
