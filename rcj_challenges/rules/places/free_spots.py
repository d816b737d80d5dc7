"""What the places ``nearest_free`` and ``furthest_free`` share."""

from math import sqrt
from typing import ClassVar

from rcj_challenges.rules.base import Phrases, PlaceRequest, PlaceResolver, PlaceWord, Scope
from rcj_challenges.rules.fields import Names, NotNegative, Point, described
from rcj_challenges.rules.phrasing import FREE_SPOT_NOTE, USUALLY_FREE_M, within_words
from rcj_challenges.rules.places.apart import nearest_of

# Distances are compared to the nanometre, so that spots at equal distances stand in the order of the file.
_EQUAL_DIGITS = 9
REFERENCES = (
    "entities, spots, groups (of them the nearest on the field), a point, each, or a draw's name; if omitted: the "
    "entity being placed"
)


class FreeSpot(PlaceWord):
    """One of the first free spots, in the order of their distances from something.

    Attributes:
        REFERENCE: the field that names this; without it distances are measured from what is put there.
        SIGN: 1 if the nearest spot is the first, -1 if the furthest is.
        HOW: the relation in words.
    """

    choose_among: int = described(1, "choose at random among this many of the first", ge=1, le=100)
    clearance_m: NotNegative = described(
        USUALLY_FREE_M,
        "a spot is free if the entity fits there and no centre of a robot or ball (including its own) is within this "
        "distance, in m",
    )

    NOTES = (FREE_SPOT_NOTE,)
    REFERENCE: ClassVar[str]
    SIGN: ClassVar[float]
    HOW: ClassVar[str]

    @property
    def reference(self) -> Names | Point | None:
        """What distances are measured from: of several the nearest."""
        found: Names | Point | None = getattr(self, self.REFERENCE)
        return found

    def compile(self, to: Scope, _entity: int) -> PlaceResolver:
        places = None if self.reference is None else to.places(self.reference)
        spots = [to.locate(name) for name in to.members(getattr(self, self.KEY))]

        def find(request: PlaceRequest) -> Point | None:
            board, entity = request.board, request.entity
            near = [board.poses[entity][:2]] if places is None else places(board, entity)

            def rank(spot: Point) -> float:
                away = min((sqrt((spot[0] - x) ** 2 + (spot[1] - y) ** 2) for x, y in near), default=0.0)
                return round(self.SIGN * away, _EQUAL_DIGITS)

            free = [
                spot
                for spot in (request.mirrored(read()) for read in spots)
                if board.free(spot, self.clearance_m, entity) and request.fits(spot)
            ]
            free.sort(key=rank)
            return request.rng.choice(free[: self.choose_among]) if free else None

        return PlaceResolver(find, random=self.choose_among > 1)

    def describe(self, phrases: Phrases) -> str:
        clearance = within_words(self.clearance_m)
        own = f" ({clearance.strip()})" if clearance else ""
        spots = phrases.all_of(getattr(self, self.KEY)).text
        those = f"the free one{own} of {spots} that is"
        if self.choose_among > 1:
            those = f"a random one of the {self.choose_among} free ones{own} of {spots} that are"
        return (
            f"on {those} {self.HOW} {'where it is' if self.reference is None else nearest_of(phrases, self.reference)}"
        )
