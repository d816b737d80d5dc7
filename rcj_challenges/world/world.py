"""The world: a scenario's bodies under physics, tick by tick."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from typing import Any

import mujoco
import numpy as np

from rcj_challenges.chassis.base import Drive
from rcj_challenges.core.play import Fault, Placement, Snapshot
from rcj_challenges.core.timing import SUBSTEPS_PER_TICK
from rcj_challenges.devices.base import FixedRay
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.scenario.shapes import start_pose
from rcj_challenges.world.build import build_spec
from rcj_challenges.world.effects import make_drives, make_effects
from rcj_challenges.world.effects.base import Effect, Scene
from rcj_challenges.world.effects.bumpers import Bumpers
from rcj_challenges.world.effects.tools import Tools
from rcj_challenges.world.errors import PhysicsFault
from rcj_challenges.world.rays import add_fixed_rays
from rcj_challenges.world.recorder import Recorder
from rcj_challenges.world.tables import WorldTables

PARKING_X_M = 1000.0
"""Where things are parked: far beyond the reach of any ray or radio (at most 50 m), …"""
PARKING_GAP_M = 100.0
"""… and of each other."""

_SETTLING_SUBSTEPS = 100


class World:
    """All bodies of a scenario, with views for the referee and the devices.

    Attributes:
        model, data: MuJoCo's. `data.xpos`, `data.xmat` and the poses of geoms and sites are up to date after `reset`,
            `place` and `step`. Geom groups: see `rcj_challenges.world.contact`.
        parked: ``[entity] -> `` whether it has been taken off the field.
    """

    def __init__(self, scenario: Scenario, roster: Roster, rays: Iterable[FixedRay] = ()) -> None:
        """Compile the world of a checked scenario; everything stands at its start pose. The rays turn with robots."""
        # MuJoCo would write its warnings to a file in the current folder; here `step` turns those that it counts in
        # `data.warning` into a PhysicsFault.
        mujoco.set_mju_user_warning(lambda _: None)
        spec = build_spec(scenario, roster)
        add_fixed_rays(spec, rays)
        self.model: Any = spec.compile()
        self.data: Any = mujoco.MjData(self.model)
        self.tables = WorldTables.of(self.model, roster)
        self.parked: list[bool] = [False] * len(roster.entities)
        self._held: frozenset[int] = frozenset()
        self._names = roster.entities
        self._starts = [Placement(entity, *start_pose(scenario, name)) for entity, name in enumerate(roster.entities)]
        mujoco.mj_kinematics(self.model, self.data)
        scene = Scene(self.model, self.data, self.tables, scenario, roster)
        self._drives, self._effects = make_drives(scene), make_effects(scene)
        self._kinds = list(dict.fromkeys(self._drives))
        self._bumpers = next((one for one in self._effects if isinstance(one, Bumpers)), None) or Bumpers(scene)
        tools = [one for one in self._effects if isinstance(one, Tools)]
        self._tools = {key: one for one in tools for key in one.tools}
        self._stopping: list[list[Drive | Tools]] = [[drive, *tools] for drive in self._drives]
        self._before_substep = [one.before_substep for one in self._kinds] + [
            one.before_substep for one in self._effects if type(one).before_substep is not Effect.before_substep
        ]
        self._after_substep = [
            one.after_substep for one in self._effects if type(one).after_substep is not Effect.after_substep
        ]
        self._contacts = self.data.contact
        self._ball_rest_m = self._settled_ball_heights()
        heights = tuple(float(self.model.body_pos[body, 2]) for body in self.tables.bodies)
        self._recorder = Recorder(self.data, self.tables, heights)
        self._warnings = memoryview(self.data.warning.number)
        self._no_warnings = bytes(self._warnings.nbytes)
        self._qpos, self._qvel = memoryview(self.data.qpos), memoryview(self.data.qvel)
        self.reset()

    def reset(self) -> None:
        """Put everything at its start pose without noise, at rest, wheels at angle 0 and braked, nothing parked."""
        mujoco.mj_resetData(self.model, self.data)
        self.parked[:] = [False] * len(self.parked)
        self._held = frozenset()
        for drive in self._kinds:
            drive.reset()
        for effect in self._effects:
            effect.reset()
        self.place(self._starts)

    def place(self, placements: Sequence[Placement]) -> None:
        """Lift all things to be placed, then put them down in order: standing, contact memory cleared, at rest.

        A ball that is placed with a velocity rolls off with it, without slipping.
        Wheels keep their angles and their commands. A parked entity is far away, with its wheels stopped, until it is
        placed again. An entity that is placed twice stands where the last placement put it.
        """
        for placement in placements:
            self._set_down(placement)
        mujoco.mj_kinematics(self.model, self.data)

    def set_wheel(self, robot: int, wheel: int, velocity_radps: float, position_rad: float) -> None:
        """Command a wheel. The command holds until the next one, even if the robot is placed meanwhile.

        Positive velocities drive forward. The position is ``inf`` for velocity control; else the wheel angle to go to,
        at this velocity at most, and hold.
        """
        self._drives[robot].set_wheel(robot, wheel, velocity_radps, position_rad)

    def set_tool(self, robot: int, name: str, velocity: float, position: float) -> None:
        """Command what is no wheel, such as a kicker, by the name of its device. Nothing happens while it is held."""
        self._tools[robot, name].command((robot, name), velocity, position)

    def touched_at(self, robot: int) -> Sequence[float]:
        """Return the bearings at which a robot with a touch sensor touched walls, obstacles and robots in this tick."""
        return self._bumpers.bearings[robot]

    def hold_robots(self, held: Collection[int]) -> None:
        """Brake the wheels of these robots until they are released; release all others. Commands act after that."""
        self._held = frozenset(held)
        for robot in range(self.tables.robots):
            self._stop(robot)

    def step(self, tick: int, faults: tuple[Fault, ...] = ()) -> Snapshot:
        """Make the four sub-steps of a tick; return poses and touches of each, those that MuJoCo solved in it.

        ``faults`` are of programs that failed since the last snapshot, to be handed on in it.

        Raises:
            PhysicsFault: MuJoCo warned of an unstable or overfull simulation.
        """
        model, data, contacts, recorder, mj_step = self.model, self.data, self._contacts, self._recorder, mujoco.mj_step
        for substep in range(SUBSTEPS_PER_TICK):
            for before_substep in self._before_substep:
                before_substep(substep)
            mj_step(model, data)
            pattern: bytes = contacts.geom.tobytes()
            for after_substep in self._after_substep:
                after_substep(pattern)
            recorder.note(substep, pattern)
        if self._warnings.tobytes() != self._no_warnings:
            raise PhysicsFault(self._what_is_wrong(tick))
        mujoco.mj_kinematics(model, data)
        return recorder.snapshot(tick, faults)

    def judged(self) -> Snapshot:
        """Return the present poses as a snapshot of tick 0, in which nothing touches."""
        return self._recorder.present()

    def state_bytes(self) -> bytes:
        """Return `qpos` and `qvel`: the physics' part of the digest. All machines of MuJoCo are little-endian."""
        return self._qpos.tobytes() + self._qvel.tobytes()

    def poses_bytes(self) -> bytes:
        """Return the poses of the latest snapshot as `Recorder.poses` has them: the record's part of it."""
        return self._recorder.poses

    def _stop(self, robot: int) -> None:
        """Brake a robot that is held or parked; release any other."""
        for one in self._stopping[robot]:
            one.set_stopped(robot, stopped=robot in self._held or self.parked[robot])

    def _set_down(self, placement: Placement) -> None:
        entity = placement.entity
        self.parked[entity] = placement.parked
        if entity < self.tables.robots:
            self._stop(entity)
        x, y, yaw = placement.x_m, placement.y_m, placement.yaw_rad
        if placement.parked:
            x, y, yaw = PARKING_X_M + entity * PARKING_GAP_M, 0.0, 0.0
        first = self.tables.qpos_at[entity]
        qpos = self.data.qpos
        qpos[first], qpos[first + 1] = x, y
        if entity in self.tables.ball_range:
            qpos[first + 2] = self._ball_rest_m[entity - self.tables.robots]
            qpos[first + 3 : first + 7] = (1.0, 0.0, 0.0, 0.0)
        else:
            qpos[first + 2] = yaw
        dofs = self.tables.dofs[entity]
        self.data.qvel[dofs] = 0.0
        self.data.qacc_warmstart[dofs] = 0.0
        if placement.vx_mps or placement.vy_mps:
            self._roll(placement)

    def _roll(self, placement: Placement) -> None:
        """Set a ball rolling: its lowest point stands still on the floor.

        Raises:
            ValueError: it is no ball.
        """
        entity, vx, vy = placement.entity, placement.vx_mps, placement.vy_mps
        if entity not in self.tables.ball_range:
            raise ValueError(f"only balls roll: {self._names[entity]!r}")
        above_floor_m = self._ball_rest_m[entity - self.tables.robots]
        # x, y, z, then the turning about the ball's own axes: it was just set down unturned, so they are the field's.
        self.data.qvel[self.tables.dofs[entity]] = (vx, vy, 0.0, -vy / above_floor_m, vx / above_floor_m, 0.0)

    def _settled_ball_heights(self) -> list[float]:
        """Return the height of each ball's centre at rest: measured, because contacts give way a little."""
        if not self.tables.balls:
            return []
        mujoco.mj_resetData(self.model, self.data)
        self._ball_rest_m = [float(self.model.body_pos[self.tables.bodies[ball], 2]) for ball in self.tables.ball_range]
        self.place([Placement(entity, 0, 0, 0, parked=True) for entity in range(len(self._names))])
        for _ in range(_SETTLING_SUBSTEPS):
            mujoco.mj_step(self.model, self.data)
        return [float(self.data.qpos[self.tables.qpos_at[ball] + 2]) for ball in self.tables.ball_range]

    def _what_is_wrong(self, tick: int) -> str:
        kinds = [str(mujoco.mjtWarning(kind).name) for kind in np.flatnonzero(self.data.warning.number)]
        lost = [name for name, at in zip(self._names, self.tables.qpos_at, strict=True)
                if not np.isfinite(self.data.qpos[at : at + 3]).all()]  # fmt: skip
        where = f"; no finite pose: {', '.join(lost)}" if lost else ""
        return f"the physics became unstable in tick {tick} (MuJoCo: {', '.join(kinds)}{where})"
