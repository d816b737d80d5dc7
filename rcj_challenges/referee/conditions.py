"""Conditions: each word compiled into a test that reads the state. One visible dict: `CONDITIONS`."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from math import atan2, cos, sin, sqrt
from typing import Any

from rcj_challenges.facts.amounts import on_paper
from rcj_challenges.facts.timing import TICK_S, s_from_ticks
from rcj_challenges.referee.compiling import CompileContext
from rcj_challenges.referee.measuring import MM_DIGITS
from rcj_challenges.referee.nearness import targets_of
from rcj_challenges.referee.places import spots_of, where_now
from rcj_challenges.referee.setting_down import Board
from rcj_challenges.referee.values import compile_bound
from rcj_challenges.rules.conditions import (
    AllOf,
    AnyOf,
    AtLeast,
    Condition,
    CounterIs,
    Distance,
    Drawn,
    FlagIs,
    HalfIs,
    InZone,
    IsHeld,
    LastTouch,
    Looks,
    SequenceAt,
    Speed,
    SpotFree,
    TimerIs,
    Told,
    WayIs,
)
from rcj_challenges.tracking.bound_rules import Test
from rcj_challenges.tracking.state import Number


def compile_condition(model: Condition, context: CompileContext, each: str | None) -> Test:
    """Return the test of a condition, turned over if it is negated."""
    test = CONDITIONS[model.condition](model, context, each)
    if model.negate:
        return lambda: not test()
    return test


def watched_entities(model: Condition, context: CompileContext, each: str | None) -> tuple[int, ...]:
    """Return the entities whose placement makes a condition begin anew: those whose place it reads."""
    match model:
        case InZone() | Speed():
            return context.entities(model.entity, each)
        case LastTouch():
            touched = context.thing(model.entity, each)
            return (touched,) if touched < len(context.roster.entities) else ()  # nobody puts a fixed obstacle
        case Distance():
            found = context.entities(model.entity, each)
            return (*found, *_anchors(model.to, context, each))
        case Looks():
            found = context.entities(model.entity, each)
            return (*found, *(() if model.towards is None else _anchors(model.towards, context, each)))
        case AnyOf() | AllOf():
            several = (watched_entities(one, context, each) for one in model.conditions)
            return tuple(dict.fromkeys(entity for one in several for entity in one))
        case _:
            return ()


def _anchors(to: str | tuple[float, float], context: CompileContext, each: str | None) -> tuple[int, ...]:
    """Return the entities among what is measured or looked to, and those with which its gates move."""
    found = (target.entity for target in targets_of(to, context, each))
    return tuple(dict.fromkeys(entity for entity in found if entity is not None))


# --- comparing and counting -----------------------------------------------------------------------------------------


def _as_it_is(number: Number) -> Number:
    return number


def _to_mm(metres: Number) -> Number:
    return round(metres, MM_DIGITS)


def _comparison(
    model: Any, context: CompileContext, each: str | None,
    rounded: Callable[[Number], Number] = _as_it_is, counted: Callable[[Number], Number] = _as_it_is,
) -> Callable[[Number], bool]:  # fmt: skip
    """Return the comparison of a model with at_least, at_most and equals, of which it has one at least.

    Bounds are rounded as asked: as what is compared with them is. What is compared with a counter is taken as `counted`
    says: as it would be counted.
    """
    least, most, equals = (
        None if bound is None else compile_bound(bound, context, each)
        for bound in (model.at_least, model.at_most, model.equals)
    )
    for_least, for_most, for_equals = (
        _as_it_is if isinstance(bound, int | float) else counted
        for bound in (model.at_least, model.at_most, model.equals)
    )

    def holds(value: Number) -> bool:
        return (
            (least is None or for_least(value) >= rounded(least()))
            and (most is None or for_most(value) <= rounded(most()))
            and (equals is None or for_equals(value) == rounded(equals()))
        )

    return holds


def _quantified(of: str | AtLeast, results: Iterable[bool]) -> bool:
    if of == "any":
        return any(results)
    if of == "none":
        return not any(results)
    judged = list(results)
    if isinstance(of, AtLeast):
        return sum(judged) >= of.at_least
    # "all" of nobody is no statement: with all of them off the field it does not hold.
    return bool(judged) and all(judged)


# --- the words ------------------------------------------------------------------------------------------------------


def in_zone(model: InZone, context: CompileContext, each: str | None) -> Test:
    """Whether centres are in a zone; entities off the field are not counted."""
    state, of = context.state, model.of
    entities, region = context.entities(model.entity, each), context.region(model.zone, each)

    def test() -> bool:
        poses = state.poses
        return _quantified(of, (region.contains(poses[e][0], poses[e][1]) for e in entities if state.present[e]))

    return test


def speed(model: Speed, context: CompileContext, each: str | None) -> Test:
    """How fast centres move: the way of the last tick over its time, in m/s."""
    state, of = context.state, model.of
    entities, holds = context.entities(model.entity, each), _comparison(model, context, each)

    def mps(entity: int) -> float:
        (x, y, _), (was_x, was_y, _) = state.poses[entity], state.before[entity]
        return sqrt((x - was_x) ** 2 + (y - was_y) ** 2) / TICK_S

    def compares(entity: int) -> bool:
        # Who jumps, by hand in a test, is neither fast nor at rest.
        return entity not in state.by_hand and holds(mps(entity))

    return lambda: _quantified(of, (compares(entity) for entity in entities if state.present[entity]))


def distance(model: Distance, context: CompileContext, each: str | None) -> Test:
    """How far centres are from another entity (the nearest of a group), a spot, a point, a zone or a gate, in m."""
    state, of = context.state, model.of
    entities, holds = context.entities(model.entity, each), _comparison(model, context, each, counted=_to_mm)
    targets = targets_of(model.to, context, each)
    # Nothing is measured from itself.
    others = {entity: tuple(target.away_m for target in targets if not target.is_with(entity)) for entity in entities}

    def results() -> Iterable[bool]:
        for entity in entities:
            if state.present[entity]:
                x, y, _ = state.poses[entity]
                found = (away_m(x, y) for away_m in others[entity])
                nearest = min((one for one in found if one is not None), default=None)
                if nearest is not None:
                    yield holds(nearest)

    return lambda: _quantified(of, results())


def way(model: WayIs, context: CompileContext, each: str | None) -> Test:
    """How far things have driven or rolled in the half, in m; also what is off the field."""
    state, of = context.state, model.of
    entities, holds = context.entities(model.entity, each), _comparison(model, context, each, counted=_to_mm)
    for entity in entities:
        state.follow_way(entity)
    return lambda: _quantified(of, (holds(state.ways[entity]) for entity in entities))


def looks(model: Looks, context: CompileContext, each: str | None) -> Test:
    """Whether robots look towards something or in a direction: their front points there within an angle."""
    state, of, within, heading = context.state, model.of, model.within_rad, model.heading_rad
    drawn = model.towards in context.roster.drawn
    itself = () if model.towards is None or drawn else _anchors(model.towards, context, each)
    entities = tuple(entity for entity in context.entities(model.entity, each) if entity not in itself)
    target = (lambda: None) if model.towards is None else where_now(context, model.towards, each)

    def looks_there(entity: int) -> bool:
        x, y, yaw = state.poses[entity]
        wanted = heading
        if wanted is None:
            at = target()
            if at is None or at == (x, y):  # nobody looks at itself, also if it is the one drawn
                return False
            wanted = atan2(at[1] - y, at[0] - x)
        off = wanted - yaw
        return abs(atan2(sin(off), cos(off))) <= within

    return lambda: _quantified(of, (looks_there(entity) for entity in entities if state.present[entity]))


def held(model: IsHeld, context: CompileContext, each: str | None) -> Test:
    """Whether robots are held, by a rule or by the phase; also those off the field."""
    who, of = context.state.held, model.of
    robots = context.entities(model.entity, each)
    return lambda: _quantified(of, (who.holds(robot) for robot in robots))


def any_of(model: AnyOf, context: CompileContext, each: str | None) -> Test:
    """Whether at least one of several conditions holds."""
    tests = tuple(compile_condition(one, context, each) for one in model.conditions)
    return lambda: any(test() for test in tests)


def all_of(model: AllOf, context: CompileContext, each: str | None) -> Test:
    """Whether all of several conditions hold."""
    tests = tuple(compile_condition(one, context, each) for one in model.conditions)
    return lambda: all(test() for test in tests)


def counter(model: CounterIs, context: CompileContext, each: str | None) -> Test:
    """The value of a counter or of a score; with ``of``: of so many."""
    state, name = context.state, model.counter
    holds = _comparison(model, context, each, on_paper)
    return _of_kept(model, context, each, state.counters.get(name), lambda whose: holds(state.counter(name, whose)))


def flag(model: FlagIs, context: CompileContext, each: str | None) -> Test:
    """Whether a flag is set; with ``of``: so many."""
    state, name = context.state, model.flag
    return _of_kept(model, context, each, state.flags[name], lambda whose: state.flag(name, whose))


def _of_kept(
    model: CounterIs | FlagIs | TimerIs | SequenceAt,
    context: CompileContext,
    each: str | None,
    kept: object,
    test: Callable[[str | None], bool],
) -> Test:
    """Return the test of something kept per entity: of one, of all as one, or with ``of`` of so many of them."""
    entity, of = model.entity, model.of
    if of is not None:
        keepers = kept if isinstance(kept, dict) else ()
        members = tuple(keepers) if entity is None else context.members(entity, each)
        return lambda: _quantified(of, (test(member) for member in members))
    if isinstance(entity, tuple):
        message = f"{model.condition}: several entities need 'of'"
        raise ValueError(message)  # noqa: TRY004 - refused when the scenario is loaded
    whose = context.whose(entity, each)
    return lambda: test(whose)


def drawn(model: Drawn, context: CompileContext, each: str | None) -> Test:
    """What a draw decided."""
    state, name, value = context.state, model.draw, context.drawn_value(model.equals, each)
    return lambda: state.draws[name] == value


def timer(model: TimerIs, context: CompileContext, each: str | None) -> Test:
    """How long a timer has run in s (of several the longest); without a comparison: whether one is running."""
    state, clocks = context.state, context.state.timers[model.timer]
    everyone = tuple(clocks.values())
    runs = model.at_least is None and model.at_most is None and model.equals is None
    holds = _comparison(model, context, each)

    def test(whose: str | None) -> bool:
        meant = everyone if whose is None else (clocks[whose],)
        if runs:
            return any(clock.running(state.tick) for clock in meant)
        return holds(s_from_ticks(max(clock.ticks(state.tick) for clock in meant)))

    return _of_kept(model, context, each, clocks, test)


def last_touch(model: LastTouch, context: CompileContext, each: str | None) -> Test:
    """Which robot touched something last since it was put where it is."""
    touched, by = context.thing(model.entity, each), frozenset(context.entities(model.by, each))
    contacts = context.contacts
    contacts.follow_last(touched)
    return lambda: contacts.last(touched) in by


def told(model: Told, context: CompileContext, each: str | None) -> Test:
    """What a robot has told the referee by radio, the last time."""
    heard, of, says = context.state.heard, model.of, model.matcher(context.state.draws)
    robots = context.members(model.entity, each)
    return lambda: _quantified(of, (robot in heard and says(heard[robot]) for robot in robots))


def spot_free(model: SpotFree, context: CompileContext, each: str | None) -> Test:
    """Whether no robot's or ball's centre is near a spot."""
    state, bodies, of, clearance = context.state, context.bodies, model.of, model.clearance_m
    spots = spots_of(context, model.spot, each)

    def test() -> bool:
        board = Board(state, bodies, set())
        return _quantified(of, (board.free(spot, clearance, None) for spot in spots()))

    return test


def sequence_at(model: SequenceAt, context: CompileContext, each: str | None) -> Test:
    """Which step of a sequence was reached last; with ``of``: of so many."""
    trackers = context.sequence_trackers(model.sequence)
    everyone = tuple(trackers.values())
    (step,) = context.members(model.step, each)

    def test(whose: str | None) -> bool:
        meant = everyone if whose is None else (trackers[whose],)
        return any(tracker.reached == step for tracker in meant)

    return _of_kept(model, context, each, trackers, test)


def half(model: HalfIs, context: CompileContext, each: str | None) -> Test:
    """Which half is played."""
    now = _comparison(model, context, each)(context.state.half.half)
    return lambda: now


CONDITIONS: dict[str, Callable[[Any, CompileContext, str | None], Test]] = {
    "in_zone": in_zone,
    "speed": speed,
    "distance": distance,
    "way": way,
    "looks": looks,
    "held": held,
    "any_of": any_of,
    "all_of": all_of,
    "counter": counter,
    "flag": flag,
    "drawn": drawn,
    "timer": timer,
    "last_touch": last_touch,
    "told": told,
    "spot_free": spot_free,
    "sequence_at": sequence_at,
    "half": half,
}
"""Every word of a condition, with what compiles it."""
