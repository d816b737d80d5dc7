"""Builds the moving bodies: robots, balls and movable obstacles.

A robot moves in the plane: it cannot tip, lean or climb (ADR 2). Its outline against ball, walls and other robots is
the body of its chassis with its jaws, and its wheels as cylinders. Its grip on the floor is dry friction in several
directions, as tendons with friction loss; the drive of its chassis adapts their coefficients to the robot's yaw.
"""

from __future__ import annotations

import math
from dataclasses import replace

import mujoco

from rcj_challenges.chassis.base import GRAVITY_MPS2, Chassis, Grip, Wheel
from rcj_challenges.geometry.polygons import Point
from rcj_challenges.scenario.models.field import Ball, Box, Cylinder
from rcj_challenges.world import contact
from rcj_challenges.world.build_field import set_surface
from rcj_challenges.world.effects.friction import mean_distance_m

WHEEL_BELOW_BODY_M = 0.0001
"""How much lower the wheels reach than the body. Source: reference, section 2 (0.0376 and 0.0375 below the centre)."""

MOTOR_INERTIA_KGM2 = 100.0
"""Of a wheel's drive: so large that only its motor turns it. The original's motors have 10 N·m, five hundred times what
grip can resist."""


def add_robot(spec: mujoco.MjSpec, name: str, chassis: Chassis, friction: float) -> None:
    """Add a robot that looks along +x at the origin.

    Names: bodies ``B1``, ``B1/left_wheel`` …; geoms ``B1/body``, ``B1/left_wheel`` …; joints ``B1/x``, ``B1/y``,
    ``B1/yaw``, ``B1/left_wheel`` …; tendons ``B1/left_grip`` …
    """
    body = _add_planar_body(spec, name, chassis.height_m / 2)
    for part, outline in chassis.solids().items():
        mass_kg = chassis.mass_kg if part == "body" else 0.0
        geom = body.add_geom(name=f"{name}/{part}", mass=mass_kg, group=contact.GROUP_CHASSIS)
        _shape(spec, geom, outline, chassis.height_m / 2)
        make_solid(geom, friction)
    for wheel in chassis.wheels():
        _add_wheel(body, f"{name}/{wheel.part}", wheel, chassis, friction)
    if chassis.MOTOR_JOINT:
        motor = body.add_body(name=f"{name}/{chassis.MOTOR_JOINT}", mass=1e-6, ipos=[0, 0, 0], explicitinertial=True)
        motor.inertia = [1e-9] * 3
        _add_motor(motor)
    for grip in chassis.grips(friction):
        _add_grip(spec, name, grip)


def _shape(spec: mujoco.MjSpec, geom: mujoco.MjsGeom, outline: tuple[Point, ...], half_m: float) -> None:
    """Make a geom an upright prism: a box, or else a convex mesh."""
    (west, east), (south, north) = ((min(along), max(along)) for along in zip(*outline, strict=True))
    if set(outline) == {(west, south), (west, north), (east, south), (east, north)}:
        geom.type, geom.size = mujoco.mjtGeom.mjGEOM_BOX, [(east - west) / 2, (north - south) / 2, half_m]
        geom.pos = [(west + east) / 2, (south + north) / 2, 0.0]
        return
    mesh = spec.add_mesh(name=geom.name)
    mesh.uservert = [part for x, y in outline for z in (-half_m, half_m) for part in (x, y, z)]
    geom.type, geom.meshname = mujoco.mjtGeom.mjGEOM_MESH, mesh.name


def add_ball(spec: mujoco.MjSpec, name: str, ball: Ball, friction: float, softness: contact.Softness) -> None:
    """Add a ball at the origin; body and geom have its name."""
    body = spec.worldbody.add_body(name=name, pos=[0, 0, ball.radius_m])
    body.add_freejoint(name=name)
    geom = body.add_geom(
        name=name,
        type=mujoco.mjtGeom.mjGEOM_SPHERE,
        size=[ball.radius_m, 0, 0],
        mass=ball.mass_kg,
        contype=contact.AMONG_SOLIDS | contact.ON_FLOOR,
        conaffinity=contact.AMONG_SOLIDS | contact.FIXED | contact.ON_FLOOR,
        group=contact.GROUP_BALLS,
        priority=contact.PRIORITY_BALL,
    )
    set_surface(geom, softness, min(friction, contact.BALL_ON_SOLID_FRICTION))


def add_ball_robot_contact(
    spec: mujoco.MjSpec, ball: str, robot: str, chassis: Chassis, friction: float, rigidity: float
) -> None:
    """Give the contact of a ball with a robot its own parameters."""
    softness = replace(contact.SOLIDS, rigidity=rigidity)
    for part in (*chassis.solids(), *(wheel.part for wheel in chassis.wheels() if chassis.sticks_out(wheel))):
        add_ball_contact(spec, ball, f"{robot}/{part}", softness, friction)


def add_ball_contact(spec: mujoco.MjSpec, ball: str, other: str, softness: contact.Softness, friction: float) -> None:
    """Give the contact of a ball with another geom its own parameters."""
    pair = spec.add_pair(geomname1=other, geomname2=ball)
    pair.condim = 3
    slides = min(friction, contact.BALL_ON_MOVING_FRICTION)
    pair.friction = [slides, slides, 0, 0, 0]
    pair.solref = softness.solref
    pair.solimp = softness.solimp


def add_movable_obstacle(spec: mujoco.MjSpec, name: str, obstacle: Box | Cylinder, friction: float) -> None:
    """Add an obstacle that robots can push, at the origin; body and geom have its name. It glides and cannot tip."""
    height = obstacle.height_m / 2
    friction_n = obstacle.mass_kg * GRAVITY_MPS2 * min(friction, contact.OBSTACLE_GLIDES)
    if isinstance(obstacle, Box):
        shape, size = mujoco.mjtGeom.mjGEOM_BOX, [obstacle.size_m[0] / 2, obstacle.size_m[1] / 2, height]
        arm_m = mean_distance_m(*obstacle.size_m)
    else:
        shape, size = mujoco.mjtGeom.mjGEOM_CYLINDER, [obstacle.radius_m, height, 0]
        arm_m = obstacle.radius_m * 2 / 3
    body = _add_planar_body(spec, name, height, (friction_n, friction_n, friction_n * arm_m))
    geom = body.add_geom(name=name, type=shape, size=size, mass=obstacle.mass_kg, group=contact.GROUP_FIXTURES)
    make_solid(geom, friction)


def make_solid(geom: mujoco.MjsGeom, friction: float) -> None:
    """Let a geom touch all solids, but not the floor."""
    geom.contype, geom.conaffinity = contact.AMONG_SOLIDS, contact.AMONG_SOLIDS | contact.FIXED
    geom.priority = contact.PRIORITY_SOLID
    set_surface(geom, contact.SOLIDS, friction)


def _add_planar_body(
    spec: mujoco.MjSpec, name: str, height_m: float, resistance: tuple[float, float, float] = (0.0, 0.0, 0.0)
) -> mujoco.MjsBody:
    """Add a body that slides along x and y and turns about z, with dry friction in N, N and N·m."""
    body = spec.worldbody.add_body(name=name, pos=[0, 0, height_m])
    slide, hinge = mujoco.mjtJoint.mjJNT_SLIDE, mujoco.mjtJoint.mjJNT_HINGE
    for joint, kind, axis, loss in (
        ("x", slide, [1, 0, 0], resistance[0]),
        ("y", slide, [0, 1, 0], resistance[1]),
        ("yaw", hinge, [0, 0, 1], resistance[2]),
    ):
        added = body.add_joint(name=f"{name}/{joint}", type=kind, axis=axis, frictionloss=loss)
        added.solref_friction, added.solimp_friction = _dry_friction()
    return body


def _add_wheel(body: mujoco.MjsBody, name: str, wheel: Wheel, chassis: Chassis, friction: float) -> None:
    """Add a wheel.

    Its outline does not turn with it: vertical friction at the rim cannot move a robot that stays in the plane.
    MuJoCo's friction would make a push of it that drives two robots apart with 0.3 m/s (ADR 2).
    """
    radius, width, mass = wheel.radius_m, wheel.width_m, wheel.mass_kg
    centre = [wheel.x_m, wheel.y_m, radius - chassis.height_m / 2 - WHEEL_BELOW_BODY_M]
    if not chassis.MOTOR_JOINT:
        turning = body.add_body(name=name, pos=centre, mass=mass, ipos=[0, 0, 0], explicitinertial=True)
        across = mass * (3 * radius**2 + width**2) / 12
        turning.inertia = [across, mass * radius**2 / 2, across]
        _add_motor(turning)
    c, s = (part * math.sqrt(0.5) for part in (math.cos(wheel.yaw_rad / 2), math.sin(wheel.yaw_rad / 2)))
    outline = body.add_geom(
        name=name,
        type=mujoco.mjtGeom.mjGEOM_CYLINDER,
        pos=centre,
        size=[radius, width / 2, 0],
        quat=[c, c, s, s],
        mass=mass if chassis.MOTOR_JOINT else 0,
        group=contact.GROUP_WHEELS,
    )
    if chassis.sticks_out(wheel):
        make_solid(outline, min(friction, contact.WHEEL_GLIDES))
        outline.priority = contact.PRIORITY_WHEEL
    else:
        outline.contype = outline.conaffinity = 0


def _add_motor(body: mujoco.MjsBody) -> None:
    """Let a body that looks along +x turn forward about +y."""
    body.add_joint(name=body.name, type=mujoco.mjtJoint.mjJNT_HINGE, axis=[0, 1, 0], armature=MOTOR_INERTIA_KGM2)


def _add_grip(spec: mujoco.MjSpec, robot: str, grip: Grip) -> None:
    """Add a grip on the floor, for yaw 0."""
    slip = spec.add_tendon(name=f"{robot}/{grip.name}", frictionloss=grip.limit_n)
    slip.solref_friction, slip.solimp_friction = _dry_friction()
    for joint, coefficient in grip.slip.items():
        slip.wrap_joint(f"{robot}/{joint}", coefficient)


def _dry_friction() -> tuple[list[float], list[float]]:
    """`solref` and `solimp` of dry friction: slipping should stop within one sub-step."""
    softness = contact.Softness(restitution=0.0, stiffness_ps2=0.0, rigidity=contact.GRIP_RIGIDITY)
    return softness.solref, softness.solimp
