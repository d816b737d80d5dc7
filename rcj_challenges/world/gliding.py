"""Movable obstacles: their friction on the floor acts against their motion, whichever way they glide.

MuJoCo's friction of joints acts along x and along y, each bounded by itself. With the whole of Coulomb's force in each,
an obstacle is held 1.4 times as hard along a diagonal, and one that is pushed in any other direction glides off along x
or y (ADR 2). So the force is shared out anew before each sub-step, by the direction in which the obstacle glides.
"""

from __future__ import annotations

import math
from typing import Any

from rcj_challenges.facts.timing import SUBSTEP_S
from rcj_challenges.world.tables import WorldTables, one_by_one

_HOLDS = math.pi / 4 / math.log(1 + math.sqrt(2))
"""Share of friction that each of x and y has at standstill: the mean over all directions of what starts to move the
obstacle is then the whole friction (0.89 along x or y, 1.26 along a diagonal)."""


def mean_distance_m(size_x_m: float, size_y_m: float) -> float:
    """Return how far the points of a rectangle are from its middle, in the mean.

    Friction under even pressure resists turning on the spot with so much of an arm.
    """
    across = math.hypot(size_x_m, size_y_m)
    by_x = size_x_m**2 / size_y_m * math.log((size_y_m + across) / size_x_m)
    by_y = size_y_m**2 / size_x_m * math.log((size_x_m + across) / size_y_m)
    return (2 * across + by_x + by_y) / 12


class Gliding:
    """The friction of all movable obstacles on the floor."""

    def __init__(self, model: Any, data: Any, tables: WorldTables) -> None:
        """Find the obstacles; the friction along x that the model was built with is the whole friction of each."""
        self._qvel, self._limits_n = one_by_one(data.qvel), one_by_one(model.dof_frictionloss)
        # By obstacle: where it stands in `qvel`, its friction, and the speed that it takes off in a sub-step.
        self._obstacles = []
        for entity in range(tables.ball_range.stop, len(tables.bodies)):
            first, mass_kg = int(tables.dofs[entity][0]), float(model.body_mass[tables.bodies[entity]])
            friction_n = self._limits_n[first]
            if friction_n > 0.0:  # on ice there is nothing to share out
                self._obstacles.append((first, friction_n, friction_n / mass_kg * SUBSTEP_S))

    def before_substep(self) -> None:
        """Share out the friction by the present velocities."""
        qvel, limits_n = self._qvel, self._limits_n
        for first, friction_n, stops_mps in self._obstacles:
            x, y = abs(qvel[first]), abs(qvel[first + 1])
            speed_mps = math.hypot(x, y)
            # What friction can stop within this sub-step has no direction that would still count at its end.
            whole_mps = max(speed_mps, stops_mps)
            held_n = _HOLDS * friction_n * (1 - speed_mps / whole_mps)
            limits_n[first] = held_n + friction_n * x / whole_mps
            limits_n[first + 1] = held_n + friction_n * y / whole_mps
