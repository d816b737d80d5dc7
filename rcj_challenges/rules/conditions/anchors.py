"""The entities to which conditions measure or look."""

from rcj_challenges.rules.binder import Binder
from rcj_challenges.rules.fields import Name, Point


def anchors(to: Binder, named: Name | Point) -> tuple[int, ...]:
    """Return the entities among what is measured or looked to, and those with which its gates move."""
    entities = (target.entity for target in to.targets(named))
    return tuple(dict.fromkeys(entity for entity in entities if entity is not None))
