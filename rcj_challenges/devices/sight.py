"""What rays can see: by the world's groups of geoms, without what is parked."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from rcj_challenges.devices.ground import Ground
from rcj_challenges.devices.poses import NOMINAL_WITHIN_M
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.world import contact

ALL_GROUPS = range(6)


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
    return np.array([group in groups for group in ALL_GROUPS], dtype=np.uint8)


class RayMask:
    """Makes geoms invisible to MuJoCo's rays for a moment: rays pass through what is fully transparent.

    Rangefinders cannot select groups, and no ray can leave out a single robot; both look at transparency.
    """

    def __init__(self, ground: Ground, roster: Roster, groups: tuple[int, ...] | None = None) -> None:
        """Remember the colours of the model, and which geoms belong to which entity.

        Args:
            ground: the compiled world.
            roster: entities whose bodies bear their names.
            groups: what is to be seen, beside the floor (a robot that has tipped over may look at it); None: all.
        """
        model = ground.model
        self._alpha: NDArray[np.float32] = model.geom_rgba[:, 3]
        self._shown = self._alpha.copy()
        selected = np.isin(model.geom_group, [*(ALL_GROUPS if groups is None else groups), contact.GROUP_FLOOR])
        self._nothing_parked = np.where(selected, np.maximum(self._shown, np.float32(0.5)), np.float32(0))
        self._masked = self._nothing_parked
        roots = model.body_rootid[model.geom_bodyid]
        self._geoms = [roots == model.body(name).id for name in roster.entities]
        self._parked: tuple[bool, ...] = (False,) * len(roster.entities)

    def hide(self, parked: tuple[bool, ...]) -> None:
        """Let rays see only what they may: the groups, without the entities that are parked."""
        if parked != self._parked:
            self._parked = parked
            self._masked = self._nothing_parked.copy()
            for geoms, gone in zip(self._geoms, parked, strict=True):
                if gone:
                    self._masked[geoms] = 0
        self._alpha[:] = self._masked

    def show(self) -> None:
        """Give everything its colour back."""
        self._alpha[:] = self._shown
