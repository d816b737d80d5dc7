"""How something is put somewhere, whether a layout or a rule says so: what may be said of it, and the sentence."""

from dataclasses import replace
from math import atan2, pi
from random import Random
from typing import Annotated, Any, Literal

from pydantic import Field

from rcj_challenges.rules.base import Phrases, Scope, ValueWord
from rcj_challenges.rules.effects import Places
from rcj_challenges.rules.fields import Name, Names, NotNegative, Point, Strict, Yes, described
from rcj_challenges.rules.phrasing import WAITING_NOTE, heading, listed, metres, metres_alike, number, quoted_measure
from rcj_challenges.rules.places import At, place_of
from rcj_challenges.rules.places.start import Start
from rcj_challenges.rules.refs import ANCHOR, DRAW, ENTITIES, FLAG
from rcj_challenges.rules.values import NUMBERS, amount_words, compile_amount
from rcj_challenges.rules.values.draw import NumberDraw
from rcj_challenges.tracking.bound_rules import NO_FIRING
from rcj_challenges.tracking.places import Board, CompiledFacing, CompiledKick, point_of
from rcj_challenges.tracking.state import RefereeState

# --- which way it looks -----------------------------------------------------------------------------------------------


class Towards(Strict):
    """Faces an entity, a spot or a point, as positioned after all placements of the tick."""

    towards: Annotated[Name | Point, ANCHOR] = described(..., "an entity, a spot, each, a draw's name, or [x, y] in m")


class RandomFacing(Strict):
    """Look anywhere, every direction equally likely."""

    random: Yes


Facing = Annotated[
    Literal["start", "keep"] | float | Towards | RandomFacing,
    Field(
        union_mode="left_to_right",
        description="start: its start yaw; keep: as it is; a yaw in rad; {towards: NAME}; {random: true}",
    ),
]


def compile_facing(facing: Facing, to: Scope, entity: int) -> CompiledFacing:
    """Return a function from a point to the yaw there, in rad."""
    ((_, _, start_yaw), _), state = to.start_of(entity), to.state
    match facing:
        case Towards():
            target = to.anchor(facing.towards)

            def towards(board: Board, point: Point, _rng: Random) -> float:
                x, y = point_of(target(), board)
                return start_yaw if (x, y) == point else atan2(y - point[1], x - point[0])

            return towards
        case RandomFacing():
            return lambda _board, _point, rng: rng.uniform(-pi, pi)
        case "keep":
            return lambda _board, _point, _rng: state.poses[entity][2]
        case _:
            yaw = start_yaw if facing == "start" else float(facing)
            return lambda _board, _point, _rng: yaw


def facing_words(phrases: Phrases, facing: Facing) -> str:
    """Return the direction of something that is not that of its start: ``facing the ball``."""
    match facing:
        case "start":
            return ""
        case "keep":
            way = "the way it did before"
        case Towards():
            way = phrases.point(facing.towards)
        case RandomFacing():
            way = "a random way"
        case _:
            way = heading(facing)
    return f"facing {way}"


# --- a ball that rolls away -------------------------------------------------------------------------------------------

MAX_KICK_MPS = 3
"""Up to what the walls are known to hold, with a margin (ADR 2)."""
_DRAWN_SPEEDS = replace(DRAW, numbers=(0.001, MAX_KICK_MPS))
_KickSpeed = Annotated[float, Field(gt=0, le=MAX_KICK_MPS)]


class DrawnSpeed(NumberDraw):
    """The speed that a draw decided, when the ball is set down."""

    draw: Annotated[Name, _DRAWN_SPEEDS] = described(..., "a draw whose values are speeds in m/s, over 0 and up to 3")


_SPEEDS = NUMBERS.beside(
    {"number": _KickSpeed, "pair": tuple[_KickSpeed, _KickSpeed]},
    lambda value: "pair" if isinstance(value, list | tuple) else "number",
    DrawnSpeed,
)


class Kick(Strict):
    """Makes a placed ball roll away; mirroring its place also mirrors the aim. In tests, the ball stays where it is."""

    towards: At = described(..., "where it rolls to: any form of `at`; random places are redrawn each time")
    speed_mps: Annotated[float | tuple[float, float] | ValueWord, _SPEEDS] = described(
        ...,
        "initial speed in m/s, above 0 and at most 3; [lowest, highest]: a random speed in between; a value is read "
        "when the ball is placed (capped at 3; at 0 or less, or without such a number, the ball lies still)",
    )

    def compile(self, to: Scope, entity: int) -> CompiledKick:
        """Return the compiled aim, and what reads the speed."""
        towards, speed = place_of(self.towards).compile(to, entity), self.speed_mps
        if isinstance(speed, tuple):
            return CompiledKick(towards, lambda: speed)
        read = compile_amount(speed, to)
        return CompiledKick(towards, lambda: _exactly(min(read(NO_FIRING) or 0, MAX_KICK_MPS)))

    def describe(self, phrases: Phrases) -> str:
        """Return its speed and its aim in words: ``at 0.5 m/s towards the ball``."""
        return f"{self._how_fast(phrases)} towards {place_of(self.towards).aim(phrases)}"

    def _how_fast(self, phrases: Phrases) -> str:
        speed = self.speed_mps
        if isinstance(speed, DrawnSpeed) and not speed.is_computed():
            drawn = sorted({float(mps) for mps in phrases.draw_values(speed.draw)})
            return f"at {listed([number(mps) for mps in drawn], 'or')} m/s, as {quoted_measure(speed.draw)} is drawn,"
        if isinstance(speed, ValueWord):
            return f"with {amount_words(phrases, speed)} as its speed in m/s (at most {MAX_KICK_MPS})"
        speeds = speed if isinstance(speed, tuple) else (speed,)
        return f"at {' to '.join(dict.fromkeys(map(number, speeds)))} m/s"


def _exactly(speed_mps: Any) -> tuple[float, float]:
    return (float(speed_mps), float(speed_mps))


# --- formations that change ends --------------------------------------------------------------------------------------


class Mirror(Strict):
    """Mirrors the place and the aim but not the facing, either always or only while a flag is set."""

    axis: Literal["x", "y", "both"] = described(..., "x: x becomes -x; y: y becomes -y; both: both change sign")
    when: Annotated[Name | None, FLAG] = described(
        None, "a flag: mirrored if it is set when the action runs; if omitted: always"
    )

    def signs(self, state: RefereeState) -> Point:
        """Return the signs of x and y now."""
        if self.when is not None and not state.flag(self.when, None):
            return (1.0, 1.0)
        return (-1.0 if self.axis in {"x", "both"} else 1.0, -1.0 if self.axis in {"y", "both"} else 1.0)

    def describe(self, phrases: Phrases) -> str:
        """Return a mirror's effect and its condition, in brackets: ``(x becomes -x) if the flag “changed” is set``."""
        turned = listed([f"{axis} becomes -{axis}" for axis in ("x", "y") if self.axis in (axis, "both")], "and")
        return f"({turned})" + (f" if {phrases.kept('flag', self.when, None)} is set" if self.when else "")


def mirrored_words(phrases: Phrases, mirror: Mirror | None, at: At) -> str:
    """Return the mirroring of a place in words; an empty text if it is not, or if that changes nothing."""
    changed = None if mirror is None else place_of(at).mirrored(phrases)
    return "" if mirror is None or changed is None else f", mirrored{changed} {mirror.describe(phrases)}"


# --- all of it --------------------------------------------------------------------------------------------------------


class Placement(Strict):
    """How entities are put somewhere."""

    NOTES = (WAITING_NOTE,)

    entity: Annotated[Names | None, ENTITIES] = described(None, "what is placed: entities, groups, or each")
    at: At | None = described(None, "where")
    facing: Facing = described("start", "direction in which it faces afterwards")
    noise_m: Point = described((0.0, 0.0), "half-widths of the uniform noise added to x and y, in m, each from 0 to 5")
    mirror: Mirror | None = described(
        None, "mirrors the place and the aim of a kick; of a whole layout all its places and aims"
    )
    min_clearance_m: NotNegative = described(
        0.0, "smallest gap to the outline of any other body, in m; the field's walls do not count"
    )
    max_attempts: int = described(
        100,
        "number of random places to try before giving up; a placement that waits for room tries 4 per tick",
        ge=1,
        le=10_000,
    )
    on_failure: Literal["retry", "stay"] = described(
        "retry",
        "if there is no room; retry: try again in each tick in which the rule is active, without repeating events; "
        "stay: leave the entity where it is",
    )
    kick: Kick | None = described(None, "balls only: makes the ball roll away; if omitted: it lies still")


AS_USUAL = Placement.model_construct()


def places(placement: Placement, also: Mirror | None = None) -> Places:
    """Return a placement as an effect; ``also``: the mirror of the whole layout."""
    mirrors = tuple(one for one in (placement.mirror, also) if one is not None)
    return Places(placement.entity or (), place_of(placement.at or "start"), placement, mirrors)


def placement_words(phrases: Phrases, entity: Names, at: At, placement: Placement) -> str:
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


def _rolls(phrases: Phrases, at: At, placement: Placement) -> str:
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


def _room(placement: Placement) -> str:
    """Return the room that it needs in words, and what happens without it."""
    gap_m = placement.min_clearance_m
    gap = f", with a gap of at least {metres(gap_m)} between outlines (not to the walls)" if gap_m else ""
    return gap + (", or left where it is if there is no room" if placement.on_failure == "stay" else "")
