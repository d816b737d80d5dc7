"""Friction on the floor: movable obstacles that glide, and balls that slow down while they roll."""

from __future__ import annotations

import math

from rcj_challenges.core.timing import SUBSTEP_S, TICK_S
from rcj_challenges.world.effects.base import Effect, Scene
from rcj_challenges.world.tables import one_by_one

_TURNING_ALONG = 7 / 5
"""A rolling ball has the inertia of this many times its mass: its rotation must be slowed down too."""

_AT_REST_MPS = 1e-9

_HOLDS = math.pi / 4 / math.log(1 + math.sqrt(2))
"""Share of friction that each of x and y has at standstill: the mean over all directions of what starts to move the
obstacle is then the whole friction (0.89 along x or y, 1.26 along a diagonal)."""


def mean_distance_m(size_x_m: float, size_y_m: float) -> float:
    """Return the mean distance of the points of a rectangle from its middle.

    It is the lever arm with which friction under even pressure resists turning on the spot.
    """
    across = math.hypot(size_x_m, size_y_m)
    by_x = size_x_m**2 / size_y_m * math.log((size_y_m + across) / size_x_m)
    by_y = size_y_m**2 / size_x_m * math.log((size_x_m + across) / size_y_m)
    return (2 * across + by_x + by_y) / 12


class GlidingFriction(Effect):
    """Friction of movable obstacles acts against their motion, whichever way they glide.

    MuJoCo's joint friction acts along x and along y, each bounded separately. With the whole of Coulomb's force in
    each, an obstacle is held 1.4 times as hard along a diagonal, and one that is pushed in any other direction glides
    off along x or y (ADR 2). So before each sub-step the force is shared out by the direction in which the obstacle
    glides.
    """

    def __init__(self, scene: Scene) -> None:
        """Find the obstacles; the friction along x that the model was built with is the whole friction of each."""
        model, data, tables = scene.model, scene.data, scene.tables
        self._qvel, self._limits_n = one_by_one(data.qvel), one_by_one(model.dof_frictionloss)
        # By obstacle: where it stands in `qvel`, its friction, and the speed that it takes off in a sub-step.
        self._obstacles = []
        for entity in range(tables.ball_range.stop, len(tables.bodies)):
            first, mass_kg = int(tables.dofs[entity][0]), float(model.body_mass[tables.bodies[entity]])
            friction_n = self._limits_n[first]
            if friction_n > 0.0:  # without friction there is nothing to divide
                self._obstacles.append((first, friction_n, friction_n / mass_kg * SUBSTEP_S))
        self.is_needed = bool(self._obstacles)

    def before_substep(self, _substep: int) -> None:
        qvel, limits_n = self._qvel, self._limits_n
        for first, friction_n, stops_mps in self._obstacles:
            x, y = abs(qvel[first]), abs(qvel[first + 1])
            speed_mps = math.hypot(x, y)
            # If friction can stop it within this sub-step, its direction does not matter.
            whole_mps = max(speed_mps, stops_mps)
            held_n = _HOLDS * friction_n * (1 - speed_mps / whole_mps)
            limits_n[first] = held_n + friction_n * x / whole_mps
            limits_n[first + 1] = held_n + friction_n * y / whole_mps


class RollingFriction(Effect):
    """Balls that slow down while they roll; in the original they do not.

    MuJoCo's own friction of rolling is a soft contact: a ball at 0.3 m/s that should stop within 1.5 s still rolls at
    0.07 after 2.5 s. So a force acts on the ball, computed for each tick.
    """

    def __init__(self, scene: Scene) -> None:
        data, tables, balls = scene.data, scene.tables, scene.scenario.balls
        self._qvel, self._forces_n = one_by_one(data.qvel), one_by_one(data.qfrc_applied)
        self._balls = [
            (int(tables.dofs[entity][0]), ball.mass_kg * _TURNING_ALONG, ball.slows_mps2)
            for entity, ball in zip(tables.ball_range, balls.values(), strict=True)
            if ball.slows_mps2 is not None
        ]
        self.is_needed = bool(self._balls)

    def before_substep(self, substep: int) -> None:
        """Apply to each ball the force that slows it down; stop one that would come to rest in this tick."""
        if substep:
            return
        for at, inertia_kg, slows_mps2 in self._balls:
            vx, vy = self._qvel[at], self._qvel[at + 1]
            speed_mps = math.hypot(vx, vy)
            if speed_mps < _AT_REST_MPS:
                self._forces_n[at] = self._forces_n[at + 1] = 0.0
                continue
            per_speed = -inertia_kg * min(slows_mps2, speed_mps / TICK_S) / speed_mps
            self._forces_n[at], self._forces_n[at + 1] = per_speed * vx, per_speed * vy
