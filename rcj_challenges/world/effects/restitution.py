"""Corrects balls that glance off walls and obstacles: restitution bounds their speed, friction follows Coulomb.

MuJoCo's friction is convex: a ball that slides along a wall is also pushed off it, in proportion to its sliding speed.
One that met a wall at 85° from the normal left it five times too fast (ADR 2). So after each sub-step the excess
impulse of a contact is taken back, and so is friction beyond its coefficient times the remaining impulse. A movable
obstacle receives the opposite impulse.
"""

from __future__ import annotations

import math
from collections import Counter
from typing import Any

import numpy as np

from rcj_challenges.chassis.base import YAW
from rcj_challenges.core.amounts import add_up
from rcj_challenges.core.timing import SUBSTEP_S
from rcj_challenges.world import contact
from rcj_challenges.world.effects.base import Effect, Scene
from rcj_challenges.world.tables import one_by_one

_SPUN_BY = 5 / 2
"""An impulse at the surface changes the speed of the surface, by turning, so many times as much as the ball's."""

_EDGES = 4
"""Of MuJoCo's pyramid of friction: in each, the push is joined by friction times itself, forth or back along x or y."""

_REMEMBERED = 4096
"""How many patterns of touching geoms are remembered. Most sub-steps repeat the pattern of the one before."""

_HELD = 1e-3
"""Things held by friction still move a little, as it is not quite rigid: by less than this share of what it could
stop."""

Vector = tuple[float, float, float]


class _Recoil:
    """One movable obstacle, in a sub-step in which a single ball touches it: its response to another impulse.

    An obstacle glides and turns in the plane, and each of its three degrees of freedom has its own dry friction
    (`friction`). So its motion under the push of one ball, and of nothing else, can be computed exactly.
    """

    def __init__(self, scene: Scene, entity: int) -> None:
        model, data, tables = scene.model, scene.data, scene.tables
        self._qpos, self._qvel = one_by_one(data.qpos), one_by_one(data.qvel)
        self._qacc, self._limits_n = one_by_one(data.qacc), one_by_one(model.dof_frictionloss)
        self._at, self._first = tables.qpos_at[entity], int(tables.dofs[entity][0])
        # Mass along x and y, moment of inertia about the vertical through its middle.
        self._inertias: list[float] = model.dof_M0[self._first : self._first + YAW + 1].tolist()

    def speed_mps(self, point: Vector, way: Vector) -> float:
        """Return the speed of the obstacle's surface in a direction, at a point of the field."""
        return add_up(self._qvel[self._first + k] * arm for k, arm in enumerate(self._arms(point, way)))

    def yields_per_kg(self, point: Vector, way: Vector) -> float:
        """Return the speed of its surface per impulse, in m/s for each N·s, excluding degrees held by friction."""
        given = 0.0
        for k, arm in enumerate(self._arms(point, way)):
            inertia = self._inertias[k]
            if abs(self._qvel[self._first + k]) > _HELD * self._limits_n[self._first + k] * SUBSTEP_S / inertia:
                given += arm * arm / inertia
        return given

    def take(self, point: Vector, impulse_ns: Vector) -> None:
        """Let the ball's impulse in this sub-step have been this one, and friction hold against it."""
        for k, turned in enumerate(self._arms(point, impulse_ns)):
            at = self._first + k
            before = self._qvel[at] - self._qacc[at] * SUBSTEP_S
            pushed = before + turned / self._inertias[k]
            stopped = self._limits_n[at] * SUBSTEP_S / self._inertias[k]
            self._qvel[at] = math.copysign(max(0.0, abs(pushed) - stopped), pushed)

    def _arms(self, point: Vector, way: Vector) -> Vector:
        """Return the effect of a vector at a point along x, along y and about the vertical."""
        x, y = point[0] - self._qpos[self._at], point[1] - self._qpos[self._at + 1]
        return way[0], way[1], x * way[1] - y * way[0]


Bounce = tuple[int, int, int, _Recoil | None]
"""The contact's index, the ball's geom, 1 if the normal points out of the ball, else -1, and what it met if movable."""


class Restitution(Effect):
    """Balls at walls and obstacles."""

    def __init__(self, scene: Scene) -> None:
        model, data, tables = scene.model, scene.data, scene.tables
        balls, field = scene.scenario.balls, scene.scenario.field
        self._data, self._friction = data, min(field.friction, contact.BALL_ON_SOLID_FRICTION)
        self._softness = contact.ball_on_solid(field.restitution)
        self._qpos, self._qvel = one_by_one(data.qpos), one_by_one(data.qvel)
        self._fixtures = frozenset(np.flatnonzero(model.geom_contype == contact.FIXED).tolist())
        self._floor = frozenset(np.flatnonzero(model.geom_contype == contact.ON_FLOOR).tolist())
        # By geom: where the ball stands in `qpos` and `qvel`, its radius and its mass.
        self._balls = {
            int(model.body_geomadr[tables.bodies[entity]]): (
                tables.qpos_at[entity],
                int(tables.dofs[entity][0]),
                ball.radius_m,
                ball.mass_kg,
            )
            for entity, ball in zip(tables.ball_range, balls.values(), strict=True)
        }
        self._obstacles = {
            int(model.body_geomadr[tables.bodies[entity]]): _Recoil(scene, entity)
            for entity in range(tables.ball_range.stop, len(tables.bodies))
        }
        self._known: dict[bytes, tuple[Bounce, ...]] = {b"": ()}

    def after_substep(self, pattern: bytes) -> None:
        bounces = self._known.get(pattern)
        if bounces is None:
            bounces = self._find(pattern)
        for index, ball, towards, obstacle in bounces:  # of a smooth wall there are none
            touch = self._data.contact[index]
            if touch.efc_address >= 0:
                self._mend(touch, ball, towards, obstacle)

    def _find(self, pattern: bytes) -> tuple[Bounce, ...]:
        """Return the contacts to look at.

        They are those of balls that touch one fixture, or one movable obstacle that nothing else touches, and, except
        for the floor, nothing else: other contacts may drive a ball off a wall, or hold an obstacle against it.
        """
        if len(self._known) >= _REMEMBERED:
            self._known = {b"": ()}
        touching: dict[int, list[tuple[int, int, int]]] = {ball: [] for ball in self._balls if self._friction > 0.0}
        pairs = np.frombuffer(pattern, dtype=np.int32).reshape(-1, 2).tolist()
        for index, (one, other) in enumerate(pairs):
            for ball, met, towards in ((one, other, 1), (other, one, -1)):
                if ball in touching and met not in self._floor:
                    touching[ball].append((index, met, towards))
        touched = Counter(geom for pair in pairs for geom in pair)
        self._known[pattern] = tuple(
            (index, ball, towards, self._obstacles.get(met))
            for ball, all_met in touching.items()
            for index, met, towards in all_met
            if len(all_met) == 1 and (met in self._fixtures or (met in self._obstacles and touched[met] == 1))
        )
        return self._known[pattern]

    def _mend(self, touch: Any, ball: int, towards: int, obstacle: _Recoil | None) -> None:
        """Take back the excess of a contact's impulse and friction."""
        row, softness = int(touch.efc_address), self._softness
        edges = slice(row, row + _EDGES)
        forces_n = self._data.efc_force[edges].tolist()
        push_ns = add_up(forces_n) * SUBSTEP_S
        if push_ns <= 0.0:
            return
        leaving_before_mps = add_up(self._data.efc_vel[edges].tolist()) / _EDGES
        frame = touch.frame.tolist()
        _, first, _, mass_kg = self._balls[ball]
        x, y, z = (-towards * axis for axis in frame[:3])
        qvel = self._qvel
        leaving_mps = qvel[first] * x + qvel[first + 1] * y + qvel[first + 2] * z
        apart_mps = -softness.restitution * leaving_before_mps - softness.stiffness_ps2 * touch.dist * SUBSTEP_S
        yields_per_kg = 0.0
        if obstacle is not None:
            point = touch.pos.tolist()
            leaving_mps -= obstacle.speed_mps(point, (x, y, z))
            yields_per_kg = obstacle.yields_per_kg(point, (x, y, z))
        moved_kg = mass_kg / (1 + mass_kg * yields_per_kg)
        too_much_ns = min(push_ns, moved_kg * (leaving_mps - max(leaving_before_mps, apart_mps)))
        if too_much_ns <= 0.0:
            return
        for axis, away in enumerate((x, y, z)):
            qvel[first + axis] -= away * too_much_ns / mass_kg
        along = self._friction * SUBSTEP_S * (forces_n[0] - forces_n[1])
        across = self._friction * SUBSTEP_S * (forces_n[2] - forces_n[3])
        rubbed_ns, most_ns = math.hypot(along, across), self._friction * (push_ns - too_much_ns)
        a, b, c, d, e, f = frame[3:]
        # The frame's forces act on the second geom: on the ball if the normal points into it.
        rub = [-towards * (along * one + across * other) for one, other in ((a, d), (b, e), (c, f))]
        kept = 1.0
        if rubbed_ns > most_ns:
            kept = most_ns / rubbed_ns
            u, v, w = ((kept - 1) * part for part in rub)
            self._push_surface(ball, (-x, -y, -z), (u, v, w))
        if obstacle is not None:
            left_ns = push_ns - too_much_ns
            u, v, w = (-left_ns * away - kept * part for away, part in zip((x, y, z), rub, strict=True))
            obstacle.take(point, (u, v, w))

    def _push_surface(self, ball: int, out: Vector, impulse_ns: Vector) -> None:
        """Let an impulse act on a ball's surface, at its point in the direction ``out``."""
        at, first, radius_m, mass_kg = self._balls[ball]
        qpos, qvel = self._qpos, self._qvel
        turned_back = (qpos[at + 3], (-qpos[at + 4], -qpos[at + 5], -qpos[at + 6]))
        # MuJoCo gives the rotation of a free body about the body's own axes.
        about = _turned(*turned_back, _cross(out, impulse_ns))
        for axis in range(3):
            qvel[first + axis] += impulse_ns[axis] / mass_kg
            qvel[first + 3 + axis] += about[axis] * _SPUN_BY / (radius_m * mass_kg)


def _cross(one: Vector, other: Vector) -> Vector:
    (a, b, c), (x, y, z) = one, other
    return b * z - c * y, c * x - a * z, a * y - b * x


def _turned(w: float, axis: Vector, vector: Vector) -> Vector:
    """Return a vector turned by a unit quaternion of w and x, y, z."""
    once = _cross(axis, vector)
    x, y, z = _cross(axis, once)
    return vector[0] + 2 * (w * once[0] + x), vector[1] + 2 * (w * once[1] + y), vector[2] + 2 * (w * once[2] + z)
