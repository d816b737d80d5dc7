"""Names to MuJoCo's numbers, once, after the model is compiled."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rcj_challenges.scenario.roster import Roster
from rcj_challenges.world.build_bodies import WHEELS
from rcj_challenges.world.build_field import FLOOR_GEOM, OBSTACLE

NO_THING = -1
"""In place of a thing's index: the floor, which never counts as touched."""

Indices = NDArray[np.intp]


@dataclass(frozen=True)
class WorldTables:
    """Where things are found in the model. Entities and things are numbered as in the roster.

    Attributes:
        bodies: ``[entity] -> `` body id: a robot's is its cube.
        cubes: ``[robot] -> `` geom id of its cube.
        wheels: ``[robot] -> `` geom ids of its left and right wheel.
        geom_things: ``[geom] -> `` index of the thing it belongs to, ``NO_THING`` for the floor.
        pose_at: ``[entity] -> `` addresses in `qpos` of x, y and yaw; of a ball, x, y and its height.
        dofs: ``[entity] -> `` its degrees of freedom in `qvel`, wheels included.
        robots, balls: how many entities are robots and balls.
        wheel_at: ``[2 * robot + side] -> `` address in `qpos` of the wheel's angle; left is 0.
        wheel_dofs: the same in `qvel`.
    """

    bodies: tuple[int, ...]
    cubes: tuple[int, ...]
    wheels: tuple[tuple[int, int], ...]
    geom_things: Indices
    pose_at: Indices
    dofs: tuple[Indices, ...]
    robots: int
    balls: int
    wheel_at: Indices
    wheel_dofs: Indices

    @classmethod
    def of(cls, model: Any, roster: Roster) -> WorldTables:
        """Look everything up in a compiled model."""
        robots = roster.entities[: roster.robots]
        bodies = tuple(int(model.body(name).id) for name in roster.entities)
        wheel_joints = [model.joint(f"{name}/{wheel}_wheel") for name in robots for wheel in WHEELS]
        return cls(
            bodies=bodies,
            cubes=tuple(int(model.geom(f"{name}/cube").id) for name in robots),
            wheels=tuple(
                (int(model.geom(f"{name}/left_wheel").id), int(model.geom(f"{name}/right_wheel").id)) for name in robots
            ),
            geom_things=_geom_things(model, roster),
            pose_at=np.array([_pose_addresses(model, body) for body in bodies], dtype=np.intp).reshape(-1, 3),
            dofs=tuple(np.flatnonzero(model.body_rootid[model.dof_bodyid] == body) for body in bodies),
            robots=roster.robots,
            balls=roster.balls,
            wheel_at=np.array([joint.qposadr[0] for joint in wheel_joints], dtype=np.intp),
            wheel_dofs=np.array([joint.dofadr[0] for joint in wheel_joints], dtype=np.intp),
        )

    @property
    def ball_range(self) -> range:
        """The entities that are balls."""
        return range(self.robots, self.robots + self.balls)


def _pose_addresses(model: Any, body: int) -> list[int]:
    """Three consecutive addresses: x, y, yaw of what moves in the plane; x, y, z of a ball's free joint."""
    first = int(model.jnt_qposadr[model.body_jntadr[body]])
    return [first, first + 1, first + 2]


def _geom_things(model: Any, roster: Roster) -> Indices:
    """Map geoms to things: by the body's name for what moves, by the geom's own name for what does not."""
    walls = len(roster.things) - 1
    things = []
    for geom in range(model.ngeom):
        name = model.geom(geom).name
        root = model.body(int(model.body_rootid[model.geom_bodyid[geom]])).name
        if name == FLOOR_GEOM and root == "world":
            things.append(NO_THING)
        elif root != "world":
            things.append(roster.index[root])
        elif name.startswith(OBSTACLE):
            things.append(roster.index[name.removeprefix(OBSTACLE)])
        else:
            things.append(walls)
    return np.array(things, dtype=np.intp)
