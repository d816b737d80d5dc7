"""Builds the `MjSpec` of a scenario: solver settings, and everything on the field in the order of the roster."""

from __future__ import annotations

from itertools import combinations

import mujoco

from rcj_challenges.chassis.base import GRAVITY_MPS2
from rcj_challenges.core.timing import SUBSTEP_S
from rcj_challenges.scenario.kits import chassis_of
from rcj_challenges.scenario.models.field import Wall
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.world import contact
from rcj_challenges.world.build_bodies import (
    add_ball,
    add_ball_contact,
    add_ball_robot_contact,
    add_movable_obstacle,
    add_robot,
)
from rcj_challenges.world.build_field import add_fixed_obstacle, add_floor, add_walls
from rcj_challenges.world.tables import turned_at


def build_spec(scenario: Scenario, roster: Roster) -> mujoco.MjSpec:
    """Return the spec of a scenario's world. Moving bodies stand in the order of the roster's entities."""
    spec = mujoco.MjSpec()
    spec.modelname = scenario.id
    _set_options(spec)
    field = scenario.field
    add_floor(spec, field)
    add_walls(spec, field)
    for name in roster.things[len(roster.entities) : -1]:
        add_fixed_obstacle(spec, name, scenario.obstacles[name], field.friction)
    chassis = {name: chassis_of(scenario, name) for name in roster.entities[: roster.robots]}
    heaviest_kg = max((one.mass_kg for one in chassis.values()), default=0.001)
    rigidity = {name: contact.ball_rigidity(ball.mass_kg, heaviest_kg) for name, ball in scenario.balls.items()}
    spec.nuserdata = turned_at(chassis.values())[-1]
    for name in roster.entities:
        if name in chassis:
            add_robot(spec, name, chassis[name], field.friction)
        elif name in scenario.balls:
            softness = contact.ball_on_solid(field.restitution, rigidity[name])
            add_ball(spec, name, scenario.balls[name], field.friction, softness)
        else:
            obstacle = scenario.obstacles[name]
            if isinstance(obstacle, Wall):
                raise TypeError(f"obstacle {name} is a wall, and walls cannot move")
            add_movable_obstacle(spec, name, obstacle, field.friction)
    for ball in scenario.balls:
        for robot in scenario.robots:
            add_ball_robot_contact(spec, ball, robot, chassis[robot], field.friction, rigidity[ball])
    for ball, other in combinations(scenario.balls, 2):
        softness = contact.ball_on_solid(field.restitution, max(rigidity[ball], rigidity[other]))
        add_ball_contact(spec, ball, other, softness, field.friction)
    return spec


def _set_options(spec: mujoco.MjSpec) -> None:
    option = spec.option
    option.timestep = SUBSTEP_S
    option.gravity = [0, 0, -GRAVITY_MPS2]
    # Nothing in the model has damping or a motor force, so an implicit integrator would cost 12 % and change nothing.
    option.integrator = mujoco.mjtIntegrator.mjINT_EULER
    option.solver = mujoco.mjtSolver.mjSOL_NEWTON
    option.cone = mujoco.mjtCone.mjCONE_PYRAMIDAL
    # Not "auto": that flips to sparse at 60 degrees of freedom, and MuJoCo 4.0.0's sparse Cholesky is wrong.
    option.jacobian = mujoco.mjtJacobian.mjJAC_DENSE
    # Faults are reported (PhysicsFault), never papered over by an automatic reset.
    option.disableflags = mujoco.mjtDisableBit.mjDSBL_MIDPHASE | mujoco.mjtDisableBit.mjDSBL_AUTORESET
