"""Places: where something is put, one file each."""

from typing import Annotated, Literal

from rcj_challenges.rules.base import KeyedVocabulary, PlaceWord
from rcj_challenges.rules.places.choice import Choice
from rcj_challenges.rules.places.furthest_free import FurthestFree
from rcj_challenges.rules.places.nearest_free import NearestFree
from rcj_challenges.rules.places.on_line import OnLine
from rcj_challenges.rules.places.point import AtPoint
from rcj_challenges.rules.places.relative_to import RelativeTo
from rcj_challenges.rules.places.spot import AtSpot
from rcj_challenges.rules.places.start import Start
from rcj_challenges.rules.places.uniform_in import UniformIn

PLACES = KeyedVocabulary({"word": Literal["start"]}, lambda value: "word" if isinstance(value, str) else None)
PLACES.add(
    Start,
    AtPoint,
    AtSpot,
    UniformIn,
    OnLine,
    Choice,
    NearestFree,
    FurthestFree,
    RelativeTo,
)

At = Annotated[PlaceWord | Literal["start"], PLACES]
"""Where something is put; the word ``start`` is short for ``{start: true}``."""


def place_of(at: PlaceWord | Literal["start"]) -> PlaceWord:
    """Return a place written in full."""
    return Start(start=True) if isinstance(at, str) else at
