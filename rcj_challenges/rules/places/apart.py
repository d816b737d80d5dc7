"""What random places share: they may have to be so far from something."""

from collections.abc import Callable
from math import sqrt
from random import Random
from typing import Annotated

from pydantic import Field

from rcj_challenges.rules.base import Phrases, PlaceRequest, PlaceResolver, PlaceWord, Scope
from rcj_challenges.rules.fields import Names, Point, Positive, described
from rcj_challenges.rules.phrasing import metres
from rcj_challenges.rules.refs import ANCHORS
from rcj_challenges.tracking.places import Poses

_MAX_TRIES = 100


class RandomPlace(PlaceWord):
    """A place that chance chooses, if required at some distance from other things."""

    from_: Annotated[Names | Point | None, ANCHORS] = Field(
        None,
        alias="from",
        description="what it is far from, with at_least_m: entities on the field, spots, groups of them, or a point",
    )
    at_least_m: Positive | None = described(
        None, "distance in m that it has at least from the nearest of those; without such a place there is no room"
    )

    TOGETHER = (("from_", "at_least_m", None),)

    def compile(self, to: Scope, _entity: int) -> PlaceResolver:
        return PlaceResolver(self.finder(to, self.sampler(to)), random=True)

    def sampler(self, to: Scope) -> Callable[[Random], Point]:
        """Return a function that draws a point."""
        raise NotImplementedError

    def finder(self, to: Scope, sample: Callable[[Random], Point]) -> Callable[[PlaceRequest], Point | None]:
        """Return a function that draws points until one is far enough; None: there is none so soon."""
        is_apart = self.apart(to)

        def find(request: PlaceRequest) -> Point | None:
            for _ in range(_MAX_TRIES):
                point = request.mirrored(sample(request.rng))
                if is_apart(point, request.board, request.entity):
                    return point
            return None

        return find

    def apart(self, to: Scope) -> Callable[[Point, Poses, int | None], bool]:
        """Return whether a point is far enough from all but one entity, given by its index."""
        if self.from_ is None or self.at_least_m is None:
            return lambda _point, _poses, _entity: True
        places, limit_m = to.places(self.from_), self.at_least_m

        def is_apart(point: Point, poses: Poses, entity: int | None) -> bool:
            near = places(poses, entity)
            return all(sqrt((x - point[0]) ** 2 + (y - point[1]) ** 2) >= limit_m for x, y in near)

        return is_apart

    def with_distance(self, words: str, phrases: Phrases) -> str:
        """Return the place in words with the distance that it must have."""
        if self.from_ is None or self.at_least_m is None:
            return words
        return f"{words}, at least {metres(self.at_least_m)} from {nearest_of(phrases, self.from_)}"


def nearest_of(phrases: Phrases, names: Names | Point) -> str:
    """Return something, or the nearest of several."""
    if isinstance(names, tuple) and isinstance(names[0], str):
        return f"the nearest of {phrases.all_of(names).text}"
    return phrases.point(names)
