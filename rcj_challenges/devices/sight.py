"""What rays can see, by the world's groups of geoms. What is parked is out of reach of any ray."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from rcj_challenges.devices.ground import Ground
from rcj_challenges.devices.poses import NOMINAL_WITHIN_M
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.world import contact

_ALL_GROUPS = range(6)


def groups_at(scenario: Scenario, height_m: float) -> tuple[int, ...]:
    """Return the groups of geoms that a horizontal ray at a height meets: fixtures and cubes, never wheels.

    Balls only where one is clearly taller than the ray: the lidar passes half a millimetre over the standard ball,
    and a hop must not make it appear.
    """
    tallest_m = max((2 * ball.radius_m for ball in scenario.balls.values()), default=0.0)
    balls = (contact.GROUP_BALLS,) if tallest_m > height_m + NOMINAL_WITHIN_M else ()
    return (contact.GROUP_FIXTURES, contact.GROUP_CUBES, *balls)


def as_geomgroup(groups: tuple[int, ...]) -> NDArray[np.uint8]:
    """Return groups as MuJoCo's rays want them: one flag for each of six."""
    return np.array([group in groups for group in _ALL_GROUPS], dtype=np.uint8)


class RayMask:
    """Hides geoms from MuJoCo's rangefinders for a moment.

    Rangefinders cannot select groups, but they pass through what is fully transparent.
    """

    def __init__(self, ground: Ground, groups: tuple[int, ...]) -> None:
        """Remember the colours of the model.

        Args:
            ground: the compiled world.
            groups: what is to be seen, beside the floor (a robot that has tipped over may look at it).
        """
        model = ground.model
        self._colours = memoryview(model.geom_rgba).cast("B")
        self._shown = self._colours.tobytes()
        seen = np.isin(model.geom_group, [*groups, contact.GROUP_FLOOR])
        masked = model.geom_rgba.copy()
        masked[:, 3] = np.where(seen, np.maximum(masked[:, 3], np.float32(0.5)), np.float32(0))
        self._masked = masked.tobytes()

    def hide(self) -> None:
        """Let rays see only what they may."""
        self._colours[:] = self._masked

    def show(self) -> None:
        """Give everything its colour back."""
        self._colours[:] = self._shown
