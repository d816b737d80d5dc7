"""What the places ``nearest_free`` and ``furthest_free`` share."""

from math import sqrt
from typing import TYPE_CHECKING

from rcj_challenges.rules.base import Phrases, PlaceRequest, PlaceResolver, Scope
from rcj_challenges.rules.fields import Name, Names, Point
from rcj_challenges.rules.phrasing import within_words

if TYPE_CHECKING:
    from rcj_challenges.rules.places.furthest_free import FurthestFree
    from rcj_challenges.rules.places.nearest_free import NearestFree


# Distances are compared to the nanometre, so that spots at equal distances stand in the order of the file.
_EQUAL_DIGITS = 9
CLEARANCE_DESCRIPTION = (
    "a spot is free if the entity fits there and no centre of a robot or ball (including its "
    "own) is within this distance, in m"
)


def compile_free_spot(
    place: "FurthestFree | NearestFree", to: Scope, names: Names, reference: Name | Point | None, *, sign: float
) -> PlaceResolver:
    """Return a function that draws one of the first free spots, the nearest (``sign`` 1) or the furthest (-1) first.

    Distances are measured from the reference, or without one from what is put there.
    """
    locate = None if reference is None else to.anchor(reference)
    spots = to.spots(names)

    def find(request: PlaceRequest) -> Point | None:
        board, entity = request.board, request.entity
        x, y = board.poses[entity][:2] if locate is None else locate().locate(board)
        free = [
            spot
            for spot in map(request.mirrored, spots())
            if board.free(spot, place.clearance_m, entity) and request.fits(spot)
        ]
        free.sort(key=lambda spot: round(sign * sqrt((spot[0] - x) ** 2 + (spot[1] - y) ** 2), _EQUAL_DIGITS))
        return request.rng.choice(free[: place.choose_among]) if free else None

    return PlaceResolver(find, random=place.choose_among > 1)


def describe_free_spot(
    place: "FurthestFree | NearestFree", phrases: Phrases, how: str, names: Names, reference: Name | Point | None
) -> str:
    """Return the place, ``how`` being ``nearest to`` or ``furthest from``."""
    clearance = within_words(place.clearance_m)
    own = f" ({clearance.strip()})" if clearance else ""
    those = f"the free one{own} of {phrases.all_of(names).text} that is"
    if place.choose_among > 1:
        those = f"a random one of the {place.choose_among} free ones{own} of {phrases.all_of(names).text} that are"
    return f"on {those} {how} {'where it is' if reference is None else phrases.point(reference)}"
