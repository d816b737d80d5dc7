"""The floor inside the walls, and which points are on it."""

from __future__ import annotations

from collections.abc import Sequence

from rcj_challenges.geometry.polygons import Point, side
from rcj_challenges.scenario.models.field import FieldModel

Corners = tuple[Point, ...]


def floor_parts(field: FieldModel) -> list[Corners]:
    """Return the convex parts of the floor inside the walls: the field, then its goals, counter-clockwise."""
    x, y, cut = field.width_m / 2, field.length_m / 2, field.corner_cut_m
    octagon = ((x, cut - y), (x, y - cut), (x - cut, y), (cut - x, y), (-x, y - cut), (-x, cut - y), (cut - x, -y))
    parts: list[Corners] = [(*octagon, (x - cut, -y))]
    for goal in field.goals.values():
        half, far = goal.width_m / 2, y + goal.depth_m
        low, high = (y, far) if goal.end == "positive_y" else (-far, -y)
        parts.append(((-half, low), (half, low), (half, high), (-half, high)))
    return parts


def on_floor(point: Point, parts: Sequence[Corners]) -> bool:
    """Return whether a point is on the floor."""
    return any(all(side(a, b, point) >= 0 for a, b in zip(p, (*p[1:], p[0]), strict=True)) for p in parts)
