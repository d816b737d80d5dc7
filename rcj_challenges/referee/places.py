"""Where things go: each word of ``at`` compiled, and facing and mirroring. One visible dict: `PLACES`."""

from __future__ import annotations

import random
from collections.abc import Callable
from math import atan2, cos, pi, sin, sqrt
from typing import Any, NamedTuple, TypeVar

from rcj_challenges.referee.compiling import Workshop
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
from rcj_challenges.rules.places import (
    Kick as KickModel,
)
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


def spots_of(workshop: Workshop, names: str | tuple[str, ...], each: str | None) -> Callable[[], tuple[Point, ...]]:
    """Return what tells where spots are now, groups expanded, in order.

    Raises:
        ValueError: one of them is no spot.
    """
    spots, members = workshop.state.spots, workshop.members(names, each)
    points = tuple(spots[spot_name(workshop, name)] for name in members)
    if workshop.remembered.isdisjoint(members):
        return lambda: points
    return lambda: tuple(spots[name] for name in members)


def where_now(workshop: Workshop, what: str | Point, each: str | None) -> Callable[[], Point | None]:
    """Return what tells where a thing, a spot, a zone's centre or a point is now; None while it is off the field.

    A draw's name stands for what it has decided then.
    """
    if isinstance(what, tuple):
        return lambda: what
    state, name = workshop.state, workshop.members(what, each)[0]
    if name in workshop.roster.drawn:
        finders = {one: where_now(workshop, one, None) for one in workshop.roster.drawn[name]}

        def decided() -> Point | None:
            return finders[str(state.draws[name])]()

        return decided
    if name in workshop.scenario.zones:
        centre = centre_of(workshop.scenario.zones[name])
        return lambda: centre
    if name in workshop.scenario.obstacles and name not in workshop.roster.entities:
        middle = middle_of(workshop.scenario.obstacles[name])[:2]
        return lambda: middle
    if name not in workshop.roster.entities:
        spot = spot_name(workshop, name)
        return lambda: state.spots[spot]
    index = workshop.roster.index[name]
    return lambda: state.poses[index][:2] if state.present[index] else None


def spot_name(workshop: Workshop, name: object) -> str:
    """Return the name of a spot.

    Raises:
        ValueError: there is no spot of this name.
    """
    if not isinstance(name, str) or name not in workshop.state.spots:
        message = f"unknown spot {name!r}"
        raise ValueError(message)
    return name


def _spot_or_draw(workshop: Workshop, name: str) -> Callable[[], Point]:
    """Return what reads where a spot is now, or the spot that a draw of this name decided."""
    spots, draws = workshop.state.spots, workshop.state.draws
    if name in workshop.scenario.draws and name not in spots:
        return lambda: spots[spot_name(workshop, draws[name])]
    spot = spot_name(workshop, name)
    return lambda: spots[spot]


def _anchored(workshop: Workshop, what: str | Point, each: str | None) -> Callable[[], _Anchor]:
    """Return what tells beside what something is put, or what it looks at: a draw's name stands for what it decided."""
    if isinstance(what, tuple):
        return _always(_Anchor(lambda _board: what))
    member = workshop.members(what, each)[0]
    among = workshop.roster.drawn.get(member)
    if among is None:
        return _always(_one_anchor(workshop, member))
    anchors, draws = {one: _one_anchor(workshop, one) for one in among}, workshop.state.draws
    return lambda: anchors[str(draws[member])]


def _one_anchor(workshop: Workshop, name: str) -> _Anchor:
    index = workshop.roster.index.get(name, len(workshop.roster.entities))
    if index < len(workshop.roster.entities):
        return _Anchor(lambda board: board.poses[index][:2], entity=index)
    spot, spots = spot_name(workshop, name), workshop.state.spots
    return _Anchor(lambda _board: spots[spot])


def _locate(workshop: Workshop, what: str | Point, each: str | None) -> Locate:
    """Return what tells where an entity, a spot or a point is, or what a draw of this name decided."""
    anchor = _anchored(workshop, what, each)
    return lambda board: anchor().locate(board)


# --- the words of `at` ----------------------------------------------------------------------------------------------


def at_start(_model: object, workshop: Workshop, entity: int, _each: str | None) -> Where:
    """Its own start, with its noise."""
    name = workshop.roster.entities[entity]
    x, y, _ = start_pose(workshop.scenario, name)
    noise = start_noise_m(workshop.scenario, name)
    return Where(lambda request: request.mirrored((x, y)), noise_m=noise)


def at_point(model: AtPoint, _workshop: Workshop, _entity: int, _each: str | None) -> Where:
    """A point."""
    return Where(lambda request: request.mirrored(model.point))


def at_spot(model: AtSpot, workshop: Workshop, _entity: int, each: str | None) -> Where:
    """A spot, or the spot that a draw decided."""
    read = _spot_or_draw(workshop, workshop.members(model.spot, each)[0])
    return Where(lambda request: request.mirrored(read()))


def uniform_in(model: UniformIn, workshop: Workshop, _entity: int, each: str | None) -> Where:
    """A random point of a bounded zone, or of several taken as one."""
    sample = random_point(model, workshop, each)
    return Where(lambda request: request.mirrored(sample(request.rng)), random=True)


def on_line(model: OnLine, workshop: Workshop, _entity: int, each: str | None) -> Where:
    """A random point of a segment."""
    sample = random_point(model, workshop, each)
    return Where(lambda request: request.mirrored(sample(request.rng)), random=True)


def random_point(model: UniformIn | OnLine, workshop: Workshop, each: str | None) -> Sampler:
    """Return what draws a point of a zone or a segment, every one equally likely."""
    if isinstance(model, UniformIn):
        zones = {name: workshop.scenario.zones[name] for name in workshop.members(model.uniform_in, each)}
        return point_sampler(zones)
    (ax, ay), (bx, by) = model.on_line

    def on_segment(rng: random.Random) -> Point:
        share = rng.random()
        return (ax + share * (bx - ax), ay + share * (by - ay))

    return on_segment


def choice(model: Choice, workshop: Workshop, _entity: int, each: str | None) -> Where:
    """One of several spots or points; a draw's name among them stands for the spot that it decided."""
    options: list[Callable[[], Point]] = []
    for option in model.choice:
        if isinstance(option, tuple):
            options.append(_always(option))
        else:
            options += [_spot_or_draw(workshop, name) for name in workshop.members(option, each)]
    return Where(lambda request: request.mirrored(request.rng.choice(options)()), random=len(options) > 1)


def nearest_free(model: NearestFree, workshop: Workshop, entity: int, each: str | None) -> Where:
    """A random one of the nearest free spots."""
    reference = _locate(workshop, _own_or(model.to, workshop, entity), each)
    spots = spots_of(workshop, model.nearest_free, each)
    return _free_spot(spots, reference, 1.0, model.choose_among, model.clearance_m)


def furthest_free(model: FurthestFree, workshop: Workshop, entity: int, each: str | None) -> Where:
    """A random one of the furthest free spots."""
    reference = _locate(workshop, _own_or(model.from_, workshop, entity), each)
    spots = spots_of(workshop, model.furthest_free, each)
    return _free_spot(spots, reference, -1.0, model.choose_among, model.clearance_m)


def relative_to(model: RelativeTo, workshop: Workshop, _entity: int, each: str | None) -> Where:
    """Beside an entity or a spot. Mirroring turns the offset over; a spot is mirrored with it, an entity is not."""
    anchored = _anchored(workshop, model.relative_to, each)
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


PLACES: dict[str, Callable[[Any, Workshop, int, str | None], Where]] = {
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


def compile_place(at: Any, workshop: Workshop, entity: int, each: str | None) -> Where:
    """Return the compiled place of an entity."""
    word = "start" if at == "start" else next(key for key in PLACES if hasattr(at, key))
    return PLACES[word](at, workshop, entity, each)


def _always(value: _Value) -> Callable[[], _Value]:
    return lambda: value


def _own_or(name: str | Point | None, workshop: Workshop, entity: int) -> str | Point:
    return workshop.roster.entities[entity] if name is None else name


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
    facing: Any, workshop: Workshop, entity: int, each: str | None,
) -> Callable[[Board, int, Point, random.Random], float]:  # fmt: skip
    _, _, start_yaw = start_pose(workshop.scenario, workshop.roster.entities[entity])
    state = workshop.state
    match facing:
        case Towards():
            target = _locate(workshop, facing.towards, each)

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


def _compile_kick(kick: KickModel | None, workshop: Workshop, entity: int, each: str | None) -> Kick | None:
    if kick is None:
        return None
    towards = compile_place(kick.towards, workshop, entity, each)
    speed, state = kick.speed_mps, workshop.state
    match speed:
        case tuple():
            return Kick(towards, lambda: speed)
        case DrawnSpeed():
            return Kick(towards, lambda: _exactly(state.draws[speed.draw]))
        case CounterValue():
            whose = workshop.whose(speed.entity, each)
            return Kick(towards, lambda: _exactly(min(state.counter(speed.counter, whose), MAX_KICK_MPS)))
        case _:
            return Kick(towards, lambda: _exactly(speed))


def _exactly(speed_mps: Any) -> tuple[float, float]:
    return (float(speed_mps), float(speed_mps))


def compile_mirror(mirror: Mirror, workshop: Workshop) -> Callable[[], Point]:
    """Return what tells the signs of x and y now."""
    flipped = (-1.0 if mirror.axis in {"x", "both"} else 1.0, -1.0 if mirror.axis in {"y", "both"} else 1.0)
    state, flag = workshop.state, mirror.when
    if flag is None:
        return lambda: flipped
    return lambda: flipped if state.flag(flag, None) else (1.0, 1.0)


def compile_putting(
    model: Any, workshop: Workshop, entity: int, each: str | None, stream: str, *,
    also: Mirror | None = None,
) -> Putting:  # fmt: skip
    """Return how an entity is put somewhere.

    Args:
        model: a `Placing` of a layout, or a ``place`` action.
        workshop: names and state.
        entity: index of the entity.
        each: what ``each`` stands for.
        stream: name of its random stream.
        also: the mirror of the whole layout.
    """
    mirrors = [mirror for mirror in (model.mirror, also) if mirror is not None]
    return Putting(
        entity=entity,
        where=compile_place(model.at, workshop, entity, each),
        facing=_compile_facing(model.facing, workshop, entity, each),
        spins=isinstance(model.facing, RandomFacing),
        follows=isinstance(model.facing, Towards),
        noise_m=model.noise_m,
        flips=tuple(compile_mirror(mirror, workshop) for mirror in mirrors),
        clearance_m=model.min_clearance_m,
        attempts=model.max_attempts,
        retry=model.on_failure == "retry",
        stream=stream,
        kick=_compile_kick(model.kick, workshop, entity, each),
    )
