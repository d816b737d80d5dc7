"""What distances are measured to."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass


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

    def is_with(self, entity: int | None) -> bool:
        """Return whether it is this entity, or moves with it: nothing is measured from itself."""
        return entity is not None and self.entity == entity
