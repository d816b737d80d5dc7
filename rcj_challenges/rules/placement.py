"""How something is put somewhere, whether a layout or a rule says so: shared fields, and the sentence."""

from typing import Annotated, Literal, Protocol

from pydantic import Field

from rcj_challenges.rules.effects import Places
from rcj_challenges.rules.facing import Facing, facing_words
from rcj_challenges.rules.fields import Names, NotNegative, Point
from rcj_challenges.rules.kick import Kick
from rcj_challenges.rules.mirror import Mirror, mirrored_words
from rcj_challenges.rules.phrases import Phrases
from rcj_challenges.rules.phrasing import metres, metres_alike
from rcj_challenges.rules.places import At, place_of
from rcj_challenges.rules.places.start import Start

NoiseM = Annotated[
    Point, Field(description="half-widths of the uniform noise added to x and y, in m, each from 0 to 5")
]
ClearanceM = Annotated[
    NotNegative,
    Field(description="smallest gap to the outline of any other body, in m; the field's walls do not count"),
]
Attempts = Annotated[
    int,
    Field(
        ge=1,
        le=10_000,
        description="number of random places to try before giving up; a placement that waits for room tries 4 per tick",
    ),
]
WithoutRoom = Annotated[
    Literal["retry", "stay"],
    Field(
        description="if there is no room; retry: try again in each tick in which the rule is active, without "
        "repeating events; stay: leave the entity where it is"
    ),
]
Roll = Annotated[Kick | None, Field(description="balls only: makes the ball roll away; if omitted: it lies still")]


class _Placement(Protocol):
    @property
    def facing(self) -> Facing: ...
    @property
    def noise_m(self) -> Point: ...
    @property
    def mirror(self) -> Mirror | None: ...
    @property
    def min_clearance_m(self) -> float: ...
    @property
    def max_attempts(self) -> int: ...
    @property
    def on_failure(self) -> Literal["retry", "stay"]: ...
    @property
    def kick(self) -> Kick | None: ...


def places(placement: _Placement, names: Names, at: At, also: Mirror | None = None) -> Places:
    """Return a placement as an effect; ``also``: the mirror of the whole layout."""
    return Places(
        names,
        place_of(at),
        placement.facing,
        placement.noise_m,
        placement.kick,
        tuple(one for one in (placement.mirror, also) if one is not None),
        placement.min_clearance_m,
        placement.max_attempts,
        placement.on_failure == "retry",
    )


def placement_words(phrases: Phrases, entity: Names, at: At, placement: _Placement) -> str:
    """Return a placement as a clause: ``Y1 is put on the spot “centre”, facing the ball``."""
    wide = zip("xy", metres_alike(placement.noise_m), placement.noise_m, strict=True)
    noise = ", ".join(f"± {words} in {axis}" for axis, words, wide_m in wide if wide_m)
    subject, place = phrases.all_of(entity), place_of(at)
    rolls = _rolls(phrases, at, placement)
    if place.is_where_it_is(entity) and rolls and not noise:
        return f"{subject.does('rolls', 'roll')} on from where it is, {rolls}{_room(placement)}"
    parts = [
        put_words(phrases, entity, at),
        f" ({noise})" if noise else "",
        mirrored_words(phrases, placement.mirror, at),
        looks_words(phrases, entity, at, placement.facing),
        _room(placement),
        f", and {'each rolls' if subject.plural else 'rolls'} {rolls}" if rolls else "",
    ]
    return f"{subject.does('is', 'are')} {''.join(parts)}"


def put_words(phrases: Phrases, entity: Names, at: At) -> str:
    """Return the placement in words: ``put at their starts``, ``each put on the spot “centre”``."""
    return place_of(at).describe_placement(phrases, entity, plural=phrases.all_of(entity).plural)


def looks_words(phrases: Phrases, entity: Names, at: At, facing: Facing) -> str:
    """Return its direction in words: ``, facing the ball``; of several at their starts ``, each facing the ball``."""
    words = facing_words(phrases, facing)
    each = "each " if phrases.all_of(entity).plural and isinstance(place_of(at), Start) else ""
    return f", {each}{words}" if words else ""


def _rolls(phrases: Phrases, at: At, placement: _Placement) -> str:
    """Return the kick of a ball in words, with its mirroring, if that is not the one of its place."""
    kick, mirror = placement.kick, placement.mirror
    if kick is None:
        return ""
    rolls, changed = kick.describe(phrases), place_of(kick.towards).mirrored(phrases)
    if mirror is None or changed is None:
        return rolls
    if place_of(at).mirrored(phrases) is None:
        return f"{rolls}{mirrored_words(phrases, mirror, kick.towards)}"
    return f"{rolls}, mirrored in the same way{changed}"


def _room(placement: _Placement) -> str:
    """Return the room that it needs in words, and what happens without it."""
    gap_m = placement.min_clearance_m
    gap = f", with a gap of at least {metres(gap_m)} between outlines (not to the walls)" if gap_m else ""
    return gap + (", or left where it is if there is no room" if placement.on_failure == "stay" else "")
