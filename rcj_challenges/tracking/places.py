"""Places as plain data: what a compiled place finds, for what, and on which field."""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

from rcj_challenges.core.play import Pose2

Point = tuple[float, float]


class Poses(Protocol):
    """Where the entities are."""

    @property
    def poses(self) -> list[Pose2]:
        """By entity, where it is: placed already, or not moved, or (lifted) where it was."""


class Board(Poses, Protocol):
    """The field while things are placed."""

    def free(self, spot: Point, clearance_m: float, entity: int | None) -> bool:
        """Return whether no robot's or ball's centre is nearer to a spot than a strict limit in m.

        The present place of the entity that is to be put there, if any, counts as well.
        """


Anchor = int | Point
"""Something beside which things are put: an entity, by its index, or where a spot or a point is."""


def point_of(anchor: Anchor, field: Poses) -> Point:
    """Return where an anchor is on a field."""
    return field.poses[anchor][:2] if isinstance(anchor, int) else anchor


@dataclass(frozen=True, slots=True)
class PlaceRequest:
    """What a place is looked for.

    Attributes:
        entity: index of what is to be put there.
        mirrored: mirrors a point as the scenario asks (or not).
        fits: whether the entity can stand at a point, with the facing it will have.
    """

    board: Board
    entity: int
    mirrored: Callable[[Point], Point]
    rng: random.Random
    fits: Callable[[Point], bool]


@dataclass(frozen=True)
class PlaceResolver:
    """A compiled place.

    Attributes:
        find: returns a point, or None if there is none (no free spot).
        random: whether another attempt can give another point.
        noise_m: half widths of noise that the place itself brings along (a start pose's).
    """

    find: Callable[[PlaceRequest], Point | None]
    random: bool = False
    noise_m: Point = (0.0, 0.0)


@dataclass(frozen=True)
class CompiledKick:
    """How a ball rolls away from where it is put.

    Attributes:
        towards: the place that it is aimed at.
        speeds_mps: returns the least and the most as they are now; every speed between is equally likely, and at 0 or
            less it lies still.
    """

    towards: PlaceResolver
    speeds_mps: Callable[[], tuple[float, float]]


CompiledFacing = Callable[[Board, Point, random.Random], float]
"""Returns the yaw in rad of an entity for the board, the point and the stream."""


@dataclass(frozen=True)
class Target:
    """Something that a distance is measured to.

    Attributes:
        away_m: returns how far the point (x, y) is from it now, in m; None while it is off the field.
        place: returns where it is now, x and y first, None while it is off the field; itself None of a zone, a gate or
            a wall, which is no point, and from which nothing is measured.
        entity: the index of the entity that it is, or with which it moves; None of what belongs to none.
    """

    away_m: Callable[[float, float], float | None]
    place: Callable[[], tuple[float, ...] | None] | None
    entity: int | None = None
