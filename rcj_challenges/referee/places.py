"""Where things go: each word of ``at`` compiled, and facing and mirroring. One visible dict: `PLACES`."""

from __future__ import annotations

import random
from collections.abc import Callable
from math import atan2, cos, pi, sin, sqrt
from typing import Any, NamedTuple, TypeVar

from rcj_challenges.referee.compiling import CompileContext
from rcj_challenges.referee.random_points import Sampler, point_sampler
from rcj_challenges.referee.setting_down import Board, Kick, Point, Putting, Request, Where
from rcj_challenges.rules.places import (
    MAX_KICK_MPS,
    AtPoint,
    AtSpot,
    Choice,
    DrawnSpeed,
    FurthestFree,
    Mirror,
    NearestFree,
    OnLine,
    RandomFacing,
    RelativeTo,
    Towards,
    UniformIn,
)
from rcj_challenges.rules.places import Kick as KickModel
from rcj_challenges.rules.values import CounterValue
from rcj_challenges.scenario.measured import centre_of, middle_of
from rcj_challenges.scenario.starting import start_noise_m, start_pose

Locate = Callable[[Board], Point]
"""Returns where something is now."""

_Value = TypeVar("_Value")


class _Anchor(NamedTuple):
    """Beside what something is put: where that is now, and the index of the entity; None: a spot or a point."""

    locate: Locate
    entity: int | None = None


# Distances are compared to the nanometre, so that spots at equal distances stand in the order of the file.
_EQUAL_DIGITS = 9


def spots_of(
    context: CompileContext, names: str | tuple[str, ...], each: str | None
) -> Callable[[], tuple[Point, ...]]:
    """Return what tells where spots are now, groups expanded, in order.

    Raises:
        ValueError: one of them is no spot.
    """
    spots, members = context.state.spots, context.members(names, each)
    points = tuple(spots[spot_name(context, name)] for name in members)
    if context.remembered.isdisjoint(members):
        return lambda: points
    return lambda: tuple(spots[name] for name in members)


def where_now(context: CompileContext, what: str | Point, each: str | None) -> Callable[[], Point | None]:
    """Return what tells where a thing, a spot, a zone's centre or a point is now; None while it is off the field.

    A draw's name stands for what it has decided then.
    """
    if isinstance(what, tuple):
        return lambda: what
    state, name = context.state, context.members(what, each)[0]
    if name in context.roster.drawn:
        finders = {one: where_now(context, one, None) for one in context.roster.drawn[name]}

        def decided() -> Point | None:
            return finders[str(state.draws[name])]()

        return decided
    if name in context.scenario.zones:
        centre = centre_of(context.scenario.zones[name])
        return lambda: centre
    if name in context.scenario.obstacles and name not in context.roster.entities:
        middle = middle_of(context.scenario.obstacles[name])[:2]
        return lambda: middle
    if name not in context.roster.entities:
        spot = spot_name(context, name)
        return lambda: state.spots[spot]
    index = context.roster.index[name]
    return lambda: state.poses[index][:2] if state.present[index] else None


def spot_name(context: CompileContext, name: object) -> str:
    """Return the name of a spot.

    Raises:
        ValueError: there is no spot of this name.
    """
    if not isinstance(name, str) or name not in context.state.spots:
        message = f"unknown spot {name!r}"
        raise ValueError(message)
    return name


def _spot_or_draw(context: CompileContext, name: str) -> Callable[[], Point]:
    """Return what reads where a spot is now, or the spot that a draw of this name decided."""
    spots, draws = context.state.spots, context.state.draws
    if name in context.scenario.draws and name not in spots:
        return lambda: spots[spot_name(context, draws[name])]
    spot = spot_name(context, name)
    return lambda: spots[spot]


def _anchored(context: CompileContext, what: str | Point, each: str | None) -> Callable[[], _Anchor]:
    """Return what tells beside what something is put, or what it looks at: a draw's name stands for what it decided."""
    if isinstance(what, tuple):
        return _always(_Anchor(lambda _board: what))
    member = context.members(what, each)[0]
    among = context.roster.drawn.get(member)
    if among is None:
        return _always(_one_anchor(context, member))
    anchors, draws = {one: _one_anchor(context, one) for one in among}, context.state.draws
    return lambda: anchors[str(draws[member])]


def _one_anchor(context: CompileContext, name: str) -> _Anchor:
    index = context.roster.index.get(name, len(context.roster.entities))
    if index < len(context.roster.entities):
        return _Anchor(lambda board: board.poses[index][:2], entity=index)
    spot, spots = spot_name(context, name), context.state.spots
    return _Anchor(lambda _board: spots[spot])


def _locate(context: CompileContext, what: str | Point, each: str | None) -> Locate:
    """Return what tells where an entity, a spot or a point is, or what a draw of this name decided."""
    anchor = _anchored(context, what, each)
    return lambda board: anchor().locate(board)


# --- the words of `at` ----------------------------------------------------------------------------------------------


def at_start(_model: object, context: CompileContext, entity: int, _each: str | None) -> Where:
    """Its own start, with its noise."""
    name = context.roster.entities[entity]
    x, y, _ = start_pose(context.scenario, name)
    noise = start_noise_m(context.scenario, name)
    return Where(lambda request: request.mirrored((x, y)), noise_m=noise)


def at_point(model: AtPoint, _context: CompileContext, _entity: int, _each: str | None) -> Where:
    """A point."""
    return Where(lambda request: request.mirrored(model.point))


def at_spot(model: AtSpot, context: CompileContext, _entity: int, each: str | None) -> Where:
    """A spot, or the spot that a draw decided."""
    read = _spot_or_draw(context, context.members(model.spot, each)[0])
    return Where(lambda request: request.mirrored(read()))


def uniform_in(model: UniformIn, context: CompileContext, _entity: int, each: str | None) -> Where:
    """A random point of a bounded zone, or of several taken as one."""
    sample = random_point(model, context, each)
    return Where(lambda request: request.mirrored(sample(request.rng)), random=True)


def on_line(model: OnLine, context: CompileContext, _entity: int, each: str | None) -> Where:
    """A random point of a segment."""
    sample = random_point(model, context, each)
    return Where(lambda request: request.mirrored(sample(request.rng)), random=True)


def random_point(model: UniformIn | OnLine, context: CompileContext, each: str | None) -> Sampler:
    """Return what draws a point of a zone or a segment, every one equally likely."""
    if isinstance(model, UniformIn):
        zones = {name: context.scenario.zones[name] for name in context.members(model.uniform_in, each)}
        return point_sampler(zones)
    (ax, ay), (bx, by) = model.on_line

    def on_segment(rng: random.Random) -> Point:
        share = rng.random()
        return (ax + share * (bx - ax), ay + share * (by - ay))

    return on_segment


def choice(model: Choice, context: CompileContext, _entity: int, each: str | None) -> Where:
    """One of several spots or points; a draw's name among them stands for the spot that it decided."""
    options: list[Callable[[], Point]] = []
    for option in model.choice:
        if isinstance(option, tuple):
            options.append(_always(option))
        else:
            options += [_spot_or_draw(context, name) for name in context.members(option, each)]
    return Where(lambda request: request.mirrored(request.rng.choice(options)()), random=len(options) > 1)


def nearest_free(model: NearestFree, context: CompileContext, entity: int, each: str | None) -> Where:
    """A random one of the nearest free spots."""
    reference = _locate(context, _own_or(model.to, context, entity), each)
    spots = spots_of(context, model.nearest_free, each)
    return _free_spot(spots, reference, 1.0, model.choose_among, model.clearance_m)


def furthest_free(model: FurthestFree, context: CompileContext, entity: int, each: str | None) -> Where:
    """A random one of the furthest free spots."""
    reference = _locate(context, _own_or(model.from_, context, entity), each)
    spots = spots_of(context, model.furthest_free, each)
    return _free_spot(spots, reference, -1.0, model.choose_among, model.clearance_m)


def relative_to(model: RelativeTo, context: CompileContext, _entity: int, each: str | None) -> Where:
    """Beside an entity or a spot. Mirroring turns the offset over; a spot is mirrored with it, an entity is not."""
    anchored = _anchored(context, model.relative_to, each)
    dx, dy = model.offset_m

    def find(request: Request) -> Point:
        anchor = anchored()
        x, y = anchor.locate(request.board)
        if anchor.entity is None:
            return request.mirrored((x + dx, y + dy))
        if model.turns:
            yaw = request.board.poses[anchor.entity][2]
            return (x + dx * cos(yaw) - dy * sin(yaw), y + dx * sin(yaw) + dy * cos(yaw))
        offset_x, offset_y = request.mirrored((dx, dy))
        return (x + offset_x, y + offset_y)

    return Where(find)


PLACES: dict[str, Callable[[Any, CompileContext, int, str | None], Where]] = {
    "start": at_start,
    "point": at_point,
    "spot": at_spot,
    "uniform_in": uniform_in,
    "on_line": on_line,
    "choice": choice,
    "nearest_free": nearest_free,
    "furthest_free": furthest_free,
    "relative_to": relative_to,
}
"""Every word of ``at``, with what compiles it."""


def compile_place(at: Any, context: CompileContext, entity: int, each: str | None) -> Where:
    """Return the compiled place of an entity."""
    word = "start" if at == "start" else next(key for key in PLACES if hasattr(at, key))
    return PLACES[word](at, context, entity, each)


def _always(value: _Value) -> Callable[[], _Value]:
    return lambda: value


def _own_or(name: str | Point | None, context: CompileContext, entity: int) -> str | Point:
    return context.roster.entities[entity] if name is None else name


def _free_spot(
    spots: Callable[[], tuple[Point, ...]], reference: Locate, sign: float, among: int, clearance_m: float
) -> Where:
    def find(request: Request) -> Point | None:
        x, y = reference(request.board)
        free = [
            spot
            for spot in map(request.mirrored, spots())
            if request.board.free(spot, clearance_m, request.entity) and request.fits(spot)
        ]
        free.sort(key=lambda spot: round(sign * sqrt((spot[0] - x) ** 2 + (spot[1] - y) ** 2), _EQUAL_DIGITS))
        return request.rng.choice(free[:among]) if free else None

    return Where(find, random=among > 1)


# --- facing, mirroring, and all of it together ----------------------------------------------------------------------


def _compile_facing(
    facing: Any, context: CompileContext, entity: int, each: str | None,
) -> Callable[[Board, int, Point, random.Random], float]:  # fmt: skip
    _, _, start_yaw = start_pose(context.scenario, context.roster.entities[entity])
    state = context.state
    match facing:
        case Towards():
            target = _locate(context, facing.towards, each)

            def towards(board: Board, _entity: int, point: Point, _rng: random.Random) -> float:
                x, y = target(board)
                here = (x, y) == point
                return start_yaw if here else atan2(y - point[1], x - point[0])

            return towards
        case RandomFacing():
            return lambda _board, _entity, _point, rng: rng.uniform(-pi, pi)
        case "keep":
            return lambda _board, whose, _point, _rng: state.poses[whose][2]
        case "start":
            return lambda _board, _entity, _point, _rng: start_yaw
        case _:
            yaw = float(facing)
            return lambda _board, _entity, _point, _rng: yaw


def _compile_kick(kick: KickModel | None, context: CompileContext, entity: int, each: str | None) -> Kick | None:
    if kick is None:
        return None
    towards = compile_place(kick.towards, context, entity, each)
    speed, state = kick.speed_mps, context.state
    match speed:
        case tuple():
            return Kick(towards, lambda: speed)
        case DrawnSpeed():
            return Kick(towards, lambda: _exactly(state.draws[speed.draw]))
        case CounterValue():
            whose = context.whose(speed.entity, each)
            return Kick(towards, lambda: _exactly(min(state.counter(speed.counter, whose), MAX_KICK_MPS)))
        case _:
            return Kick(towards, lambda: _exactly(speed))


def _exactly(speed_mps: Any) -> tuple[float, float]:
    return (float(speed_mps), float(speed_mps))


def compile_mirror(mirror: Mirror, context: CompileContext) -> Callable[[], Point]:
    """Return what tells the signs of x and y now."""
    flipped = (-1.0 if mirror.axis in {"x", "both"} else 1.0, -1.0 if mirror.axis in {"y", "both"} else 1.0)
    state, flag = context.state, mirror.when
    if flag is None:
        return lambda: flipped
    return lambda: flipped if state.flag(flag, None) else (1.0, 1.0)


def compile_putting(
    model: Any, context: CompileContext, entity: int, each: str | None, stream: str, *,
    also: Mirror | None = None,
) -> Putting:  # fmt: skip
    """Return how an entity is put somewhere.

    Args:
        model: a `Placing` of a layout, or a ``place`` action.
        context: names and state.
        entity: index of the entity.
        each: what ``each`` stands for.
        stream: name of its random stream.
        also: the mirror of the whole layout.
    """
    mirrors = [mirror for mirror in (model.mirror, also) if mirror is not None]
    return Putting(
        entity=entity,
        where=compile_place(model.at, context, entity, each),
        facing=_compile_facing(model.facing, context, entity, each),
        spins=isinstance(model.facing, RandomFacing),
        follows=isinstance(model.facing, Towards),
        noise_m=model.noise_m,
        flips=tuple(compile_mirror(mirror, context) for mirror in mirrors),
        clearance_m=model.min_clearance_m,
        attempts=model.max_attempts,
        retry=model.on_failure == "retry",
        stream=stream,
        kick=_compile_kick(model.kick, context, entity, each),
    )
