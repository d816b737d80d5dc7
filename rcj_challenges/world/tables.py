"""Names to MuJoCo's numbers, once, after the model is compiled."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from rcj_challenges.scenario.roster import Roster
from rcj_challenges.world.build_field import FLOOR_GEOM, OBSTACLE

NO_THING = -1
"""In place of a thing's index: the floor, which never counts as touched."""

ROBOT_QPOS = 5
"""x, y, yaw, angle of the left wheel, of the right wheel; as many in `qvel`."""
ROBOT_YAW = 2
"""Which of them is the yaw; the angles of both wheels follow it."""
BALL_QPOS = 7
"""x, y, z, quaternion; 6 in `qvel`."""
OBSTACLE_QPOS = 3
"""x, y, yaw; as many in `qvel`."""

Indices = NDArray[np.intp]
Numbers = NDArray[np.float64]


def one_by_one(numbers: Any) -> memoryview[float]:
    """Return numbers of MuJoCo to be read and written singly: that costs a third of what numpy takes for it.

    Args:
        numbers: an array of float64 in one dimension, whose memory stays where it is.
    """
    view: Any = memoryview(numbers)
    return cast("memoryview[float]", view)


@dataclass(frozen=True)
class WorldTables:
    """Where things are found in the model. Entities and things are numbered as in the roster.

    Attributes:
        robots, balls: how many entities are robots and balls; the others are movable obstacles.
        bodies: ``[entity] -> `` body id: a robot's is its cube.
        cubes: ``[robot] -> `` geom id of its cube.
        wheels: ``[robot] -> `` geom ids of its left and right wheel.
        geom_things: ``[geom] -> `` index of the thing it belongs to, ``NO_THING`` for the floor.
        dofs: ``[entity] -> `` its degrees of freedom in `qvel`, wheels included.
        qpos_at: ``[entity] -> `` address in `qpos` of its first number; what follows: ``ROBOT_QPOS`` and so on.
    """

    robots: int
    balls: int
    bodies: tuple[int, ...]
    cubes: tuple[int, ...]
    wheels: tuple[tuple[int, int], ...]
    geom_things: Indices
    dofs: tuple[Indices, ...]
    qpos_at: tuple[int, ...]

    @classmethod
    def of(cls, model: Any, roster: Roster) -> WorldTables:
        """Look everything up in a compiled model."""
        robots = roster.entities[: roster.robots]
        bodies = tuple(int(model.body(name).id) for name in roster.entities)
        return cls(
            robots=roster.robots,
            balls=roster.balls,
            bodies=bodies,
            cubes=tuple(int(model.geom(f"{name}/cube").id) for name in robots),
            wheels=tuple(
                (int(model.geom(f"{name}/left_wheel").id), int(model.geom(f"{name}/right_wheel").id)) for name in robots
            ),
            geom_things=np.array([_thing_of(model, roster, geom) for geom in range(model.ngeom)], dtype=np.intp),
            dofs=tuple(np.flatnonzero(model.body_rootid[model.dof_bodyid] == body) for body in bodies),
            qpos_at=tuple(int(model.jnt_qposadr[model.body_jntadr[body]]) for body in bodies),
        )

    @property
    def ball_range(self) -> range:
        """The entities that are balls."""
        return range(self.robots, self.robots + self.balls)

    def by_kind(self, qpos: Numbers) -> tuple[Numbers, Numbers, Numbers]:
        """Return views of `qpos` (shape (…, nq)) with shapes (…, robots, 5), (…, balls, 7) and (…, obstacles, 3)."""
        first_ball = ROBOT_QPOS * self.robots
        first_obstacle = first_ball + BALL_QPOS * self.balls
        obstacles = len(self.bodies) - self.robots - self.balls
        before = qpos.shape[:-1]
        return (
            qpos[..., :first_ball].reshape(*before, self.robots, ROBOT_QPOS),
            qpos[..., first_ball:first_obstacle].reshape(*before, self.balls, BALL_QPOS),
            qpos[..., first_obstacle:].reshape(*before, obstacles, OBSTACLE_QPOS),
        )


def _thing_of(model: Any, roster: Roster, geom: int) -> int:
    """Return the thing a geom belongs to: by its body's name if that moves, else by its own."""
    root = int(model.body_rootid[model.geom_bodyid[geom]])
    name: str = model.geom(geom).name
    if root:
        return roster.index[model.body(root).name]
    if name == FLOOR_GEOM:
        return NO_THING
    if name.startswith(OBSTACLE):
        return roster.index[name.removeprefix(OBSTACLE)]
    return len(roster.things) - 1
