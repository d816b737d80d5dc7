"""In which ways a mirror may turn over where something is put."""

from __future__ import annotations

from collections.abc import Iterable

from rcj_challenges.scenario.models.actions import Place, SetSpot
from rcj_challenges.scenario.models.places import Mirror, Placing
from rcj_challenges.views.drawing.labels import Point

Flip = tuple[bool, bool]
"""Whether x becomes -x, and whether y becomes -y."""

AS_WRITTEN: Flip = (False, False)


def flipped(point: Point, flip: Flip) -> Point:
    """Return a point mirrored."""
    # Adding 0 makes no -0 of what lies on the axis.
    return (-point[0] + 0.0 if flip[0] else point[0], -point[1] + 0.0 if flip[1] else point[1])


def flips_of(placing: Placing | Place | SetSpot, mirrors: Iterable[Mirror | None]) -> list[Flip]:
    """Return all ways in which a placement may be mirrored: by its own mirror, and by those of its layout."""
    found = {
        (own[0] is not whole[0], own[1] is not whole[1])
        for mirror in mirrors
        for own in _ways(placing.mirror)
        for whole in _ways(mirror)
    }
    return sorted(found)


def _ways(mirror: Mirror | None) -> list[Flip]:
    if mirror is None:
        return [AS_WRITTEN]
    flip = (mirror.axis in ("x", "both"), mirror.axis in ("y", "both"))
    return [flip] if mirror.when is None else [AS_WRITTEN, flip]
