"""Maps names to MuJoCo's numbers, once, after the model is compiled."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import accumulate
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from rcj_challenges.chassis.base import Chassis
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.world import contact
from rcj_challenges.world.build_field import FLOOR_GEOM, OBSTACLE

NO_THING = -1
"""Stands for the floor and its border, which never count as touched, in place of a thing's index."""


Indices = NDArray[np.intp]
Numbers = NDArray[np.float64]


def one_by_one(numbers: Any) -> memoryview[float]:
    """Return a view of MuJoCo's numbers for single reads and writes, which take a third of numpy's time.

    ``numbers`` is an array of float64 in one dimension, whose memory stays where it is.
    """
    view: Any = memoryview(numbers)
    return cast("memoryview[float]", view)


@dataclass(frozen=True)
class WorldTables:
    """Where things are found in the model. Entities and things are numbered as in the roster.

    Attributes:
        robots, balls: how many entities are robots and balls; the others are movable obstacles.
        bodies: ``[entity] -> `` body id: a robot's is that of its chassis.
        chassis: ``[robot] -> `` geom ids of its body and of its wheels.
        geom_things: ``[geom] -> `` index of the thing it belongs to, ``NO_THING`` for the floor and its border.
        dofs: ``[entity] -> `` its degrees of freedom in `qvel`, wheels included.
        qpos_at: ``[entity] -> `` address in `qpos` of its first number; of a ball x, y, z and its quaternion follow,
            else y and the yaw; of robots their wheels.
    """

    robots: int
    balls: int
    bodies: tuple[int, ...]
    chassis: tuple[tuple[int, ...], ...]
    geom_things: Indices
    dofs: tuple[Indices, ...]
    qpos_at: tuple[int, ...]

    @classmethod
    def of(cls, model: Any, roster: Roster) -> WorldTables:
        """Look everything up in a compiled model."""
        bodies = tuple(int(model.body(name).id) for name in roster.entities)
        return cls(
            robots=roster.robots,
            balls=roster.balls,
            bodies=bodies,
            chassis=tuple(
                tuple(range(first, first + int(model.body_geomnum[body])))
                for body in bodies[: roster.robots]
                for first in (int(model.body_geomadr[body]),)
            ),
            geom_things=np.array([_thing_of(model, roster, geom) for geom in range(model.ngeom)], dtype=np.intp),
            dofs=tuple(np.flatnonzero(model.body_rootid[model.dof_bodyid] == body) for body in bodies),
            qpos_at=tuple(int(model.jnt_qposadr[model.body_jntadr[body]]) for body in bodies),
        )

    @property
    def ball_range(self) -> range:
        """The entities that are balls."""
        return range(self.robots, self.robots + self.balls)


def _thing_of(model: Any, roster: Roster, geom: int) -> int:
    """Return the thing a geom belongs to: by its body's name if that moves, else by its own."""
    root = int(model.body_rootid[model.geom_bodyid[geom]])
    name: str = model.geom(geom).name
    if root:
        return roster.index[model.body(root).name]
    if name == FLOOR_GEOM or model.geom_group[geom] == contact.GROUP_BORDER:
        return NO_THING
    if name.startswith(OBSTACLE):
        return roster.index[name.removeprefix(OBSTACLE)]
    return len(roster.things) - 1


def turned_at(chassis: Iterable[Chassis]) -> tuple[int, ...]:
    """Return the places in `userdata` at which each robot's wheels without joints begin, and their number."""
    return tuple(accumulate((len(one.wheels()) if one.MOTOR_JOINT else 0 for one in chassis), initial=0))


def reach_m(model: Any, data: Any, geoms: tuple[int, ...]) -> float:
    """Return the largest distance of a robot's outline from the centre of its body."""
    centre = data.geom_xpos[geoms[0]]
    return float(max(np.linalg.norm(data.geom_xpos[geom] - centre) + model.geom_rbound[geom] for geom in geoms))
