"""Actions: each word compiled into something that changes the state. One visible dict: `ACTIONS`.

Actions run in order and read current values: count, then score, pays the new count.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import inf
from typing import Any

from rcj_challenges.facts.amounts import on_paper
from rcj_challenges.facts.messages import position_in
from rcj_challenges.facts.timing import ticks_from_s
from rcj_challenges.referee.bounds import amount_bound, change_bound
from rcj_challenges.referee.compiling import CompileContext
from rcj_challenges.referee.places import compile_mirror, compile_putting, random_point, spot_name, where_now
from rcj_challenges.referee.setting_down import Job
from rcj_challenges.referee.values import compile_points, compile_value, counter_reader
from rcj_challenges.rules.actions import (
    Action,
    Count,
    DrawAction,
    Emit,
    End,
    Hold,
    LastToucher,
    Place,
    Release,
    Remove,
    Score,
    SequenceAction,
    SetFlag,
    SetPhase,
    SetSpot,
    TimerAction,
    ToggleFlag,
)
from rcj_challenges.rules.fields import LONGEST_S
from rcj_challenges.rules.places import Mirror, OnLine, UniformIn
from rcj_challenges.rules.values import CounterValue, DrawValue, ToldValue
from rcj_challenges.scenario.catalogue import EACH, OTHER
from rcj_challenges.scenario.floor import floor_parts, on_floor
from rcj_challenges.tracking.bound_rules import BoundRule, Firing
from rcj_challenges.tracking.state import Clock, Number

Act = Callable[[Firing], None]

_MOST_TRIES = 1000
"""So often chance looks for a point inside the walls, of a zone that may lie outside for the most part."""


def compile_action(model: Action, context: CompileContext, rule: BoundRule) -> Act:
    """Return a compiled action of a rule."""
    return ACTIONS[model.action](model, context, rule)


def _receiver(entrant: str | LastToucher, context: CompileContext, rule: BoundRule) -> Callable[[], str | None]:
    """Return what tells whose the points are: the named entrant's, or those of whoever drives a robot."""
    drivers = context.state.entrant_of
    if isinstance(entrant, LastToucher):
        touched = context.thing(entrant.last_touch, rule.each)
        contacts, names = context.contacts, context.roster.entities
        contacts.follow_last(touched)

        def driver_of_the_last() -> str | None:
            robot = contacts.last(touched)
            return None if robot is None else drivers.get(names[robot])

        return driver_of_the_last
    robot = None if entrant in context.scenario.entrants else {EACH: rule.each, OTHER: rule.other}.get(entrant)
    whose = entrant if robot is None else drivers.get(robot)
    return lambda: whose


def score(model: Score, context: CompileContext, rule: BoundRule) -> Act:
    """Give points to an entrant; to nobody if nobody touched what they are given for."""
    state, receiver = context.state, _receiver(model.entrant, context, rule)
    points = compile_points(model.points, context, rule.each)
    bounded = change_bound(model)

    def act(firing: Firing) -> None:
        entrant = receiver()
        if entrant is None:
            return
        given = bounded(points(firing), state.scores[entrant])
        state.scores[entrant] = on_paper(state.scores[entrant] + given)
        firing.scored[entrant] = on_paper(firing.scored.get(entrant, 0) + given)

    return act


def count(model: Count, context: CompileContext, rule: BoundRule) -> Act:
    """Change a counter: first ``to``, then ``by``."""
    counters, name, whose = context.state.counters, model.counter, context.whose(model.entity, rule.each)
    to = None if model.to is None else compile_points(model.to, context, rule.each)
    by = 1 if model.by is None and model.to is None else model.by
    step = None if by is None else compile_points(by, context, rule.each)

    within, bounded = amount_bound(model), change_bound(model)

    def changed(value: Number, firing: Firing) -> Number:
        value = value if to is None else within(to(firing))
        return on_paper(value if step is None else value + bounded(step(firing), value))

    def act(firing: Firing) -> None:
        value = counters[name]
        if isinstance(value, dict):
            for member in value if whose is None else (whose,):
                value[member] = changed(value[member], firing)
        else:
            counters[name] = changed(value, firing)

    return act


def _change_flag(
    context: CompileContext, rule: BoundRule, name: str, entity: str | None, new: Callable[[bool], bool]
) -> Act:
    flags, whose = context.state.flags, context.whose(entity, rule.each)

    def act(_firing: Firing) -> None:
        value = flags[name]
        if isinstance(value, dict):
            for member in value if whose is None else (whose,):
                value[member] = new(value[member])
        else:
            flags[name] = new(value)

    return act


def set_flag(model: SetFlag, context: CompileContext, rule: BoundRule) -> Act:
    """Set or clear a flag."""
    to = model.to
    return _change_flag(context, rule, model.flag, model.entity, lambda _value: to)


def toggle_flag(model: ToggleFlag, context: CompileContext, rule: BoundRule) -> Act:
    """Turn a flag over."""
    return _change_flag(context, rule, model.flag, model.entity, lambda value: not value)


def timer(model: TimerAction, context: CompileContext, rule: BoundRule) -> Act:
    """Start, stop or reset a timer."""
    state, do = context.state, model.do
    clocks, whose = state.timers[model.timer], context.whose(model.entity, rule.each)
    meant = tuple(clocks.items()) if whose is None else ((whose, clocks[whose]),)
    lasts_s = context.scenario.timers[model.timer].lasts_s

    def change(owner: str | None, clock: Clock) -> None:
        elapsed = clock.ticks(state.tick)
        if do == "restart" or (do == "start" and clock.since is None and elapsed == 0):
            state.wind_up(clock, lasts_s, owner)
            clock.elapsed, clock.since = 0, state.tick
        elif do == "reset":
            clock.elapsed, clock.since = 0, None
        elif do == "stop":
            clock.elapsed, clock.since = elapsed, None
        elif clock.since is None and elapsed < clock.length:
            clock.since = state.tick

    def act(_firing: Firing) -> None:
        for owner, clock in meant:
            change(owner, clock)
        context.timers_changed()

    return act


def sequence(model: SequenceAction, context: CompileContext, rule: BoundRule) -> Act:
    """Begin a sequence anew: that of one, or of all who have one."""
    trackers, whose = context.sequence_trackers(model.sequence), context.whose(model.entity, rule.each)
    meant = tuple(trackers.values()) if whose is None else (trackers[whose],)

    def act(_firing: Firing) -> None:
        for tracker in meant:
            context.trackers.reset(tracker)

    return act


def set_spot(model: SetSpot, context: CompileContext, rule: BoundRule) -> Act:
    """Set a spot to where something is now, to its mirror image, or where chance says: there only inside the walls.

    What is off the field leaves it where it is.
    """
    state, name = context.state, spot_name(context, model.spot)
    where = _place_of(model.to, context, rule, f"spot/{name}")
    signs = (lambda: (1, 1)) if model.mirror is None else compile_mirror(model.mirror, context)
    of_chance = isinstance(model.to, UniformIn | OnLine)
    floor = floor_parts(context.scenario.field)

    def act(_firing: Firing) -> None:
        decided = state.decided_place(name) if of_chance else None
        if decided is not None:
            state.spots[name] = decided
            return
        sign_x, sign_y = signs()
        for _ in range(_MOST_TRIES if of_chance else 1):
            point = where()
            if point is None:
                return
            there = (point[0] * sign_x + 0.0, point[1] * sign_y + 0.0)  # adding 0 makes no -0
            if not of_chance or on_floor(there, floor):
                state.spots[name] = there
                return

    return act


def _place_of(
    to: Any, context: CompileContext, rule: BoundRule, stream: str
) -> Callable[[], tuple[float, float] | None]:  # fmt: skip
    """Return what finds the place that a spot is set to; None if there is none at present."""
    match to:
        case ToldValue():
            return _heard(context, to, rule)
        case UniformIn() | OnLine():
            sample, state = random_point(to, context, rule.each), context.state
            return lambda: sample(state.stream(stream))
        case _:
            return where_now(context, to, rule.each)


def _heard(context: CompileContext, told: ToldValue, rule: BoundRule) -> Callable[[], tuple[float, float] | None]:
    """Return what tells the position that a robot has told by radio; None if it was none."""
    heard, robot = context.state.heard, context.members(told.told, rule.each)[0]
    return lambda: position_in(heard.get(robot, ""))


def draw(model: DrawAction, context: CompileContext, rule: BoundRule) -> Act:
    """Draw anew, or set a draw to a value."""
    state, name = context.state, model.draw
    fixed = None if model.as_ is None else context.drawn_value(model.as_, rule.each)
    drawn = context.scenario.draws[name]

    def act(_firing: Firing) -> None:
        before = state.draws[name]
        if fixed is not None:
            state.set_draw(name, fixed)
        else:
            state.draw_anew(name, drawn)
        if state.draws[name] != before:
            context.has_drawn(name)

    return act


def place(model: Place, context: CompileContext, rule: BoundRule) -> Act:
    """Put entities somewhere: by a layout, or one after the other."""
    if isinstance(model.layout, DrawValue):
        state, name = context.state, model.layout.draw
        layouts = {
            value: layout_jobs(context, str(value), rule, model.mirror) for value in context.scenario.draws[name].values
        }
        return lambda _firing: _ask(context, layouts[state.draws[name]])
    if model.layout is not None:
        jobs = layout_jobs(context, model.layout, rule, model.mirror)
    else:
        if model.entity is None or model.at is None:
            message = f"rules.{rule.name}: place needs a layout, or entity and at"
            raise ValueError(message)
        names = context.members(model.entity, rule.each)
        jobs = [
            Job(entity, compile_putting(model, context, entity, rule.each, f"rule/{rule.name}/{name}"), rule)
            for name, entity in zip(names, context.entities(model.entity, rule.each), strict=True)
        ]
    return lambda _firing: _ask(context, jobs)


def layout_jobs(context: CompileContext, layout: str, rule: BoundRule, mirror: Mirror | None) -> list[Job]:
    """Return the placements of a layout, in order."""
    key = (layout, rule.each, mirror)
    puttings = context.layouts.get(key)
    if puttings is None:
        puttings = context.layouts[key] = [
            compile_putting(placing, context, entity, rule.each, stream, also=mirror)
            for number, placing in enumerate(context.scenario.placements[layout])
            for entity in context.entities(placing.entity, rule.each)
            for stream in (f"placement/{layout}/{number}/{context.roster.entities[entity]}",)
        ]
    return [Job(putting.entity, putting, rule) for putting in puttings]


def _ask(context: CompileContext, jobs: list[Job]) -> None:
    for job in jobs:
        if job.putting is not None and job.putting.flips:
            context.queue.ask(replace(job, signs=job.putting.signs()))
        else:
            context.queue.ask(job)


def remove(model: Remove, context: CompileContext, rule: BoundRule) -> Act:
    """Take entities off the field, for a time or until something places them."""
    state, queue = context.state, context.queue
    away = None if model.for_s is None else _staying(model.for_s, context, rule)
    back = Place(action="place", entity=model.entity, at=model.back_at, facing=model.facing)
    returns = {
        entity: compile_putting(back, context, entity, rule.each, f"rule/{rule.name}/{context.roster.entities[entity]}")
        for entity in context.entities(model.entity, rule.each)
    }

    def act(_firing: Firing) -> None:
        for entity, putting in returns.items():
            queue.ask(Job(entity, None, rule))
            if away is not None:
                queue.ask_later(Job(entity, putting, rule, due=state.tick + max(1, away()), comes_back=True))

    return act


def hold(model: Hold, context: CompileContext, rule: BoundRule) -> Act:
    """Hold robots, for a time or until something lets them go."""
    state, robots = context.state, context.entities(model.entity, rule.each)
    if model.for_s is None:
        return lambda _firing: state.held.hold(robots, inf)
    lasts = _staying(model.for_s, context, rule)

    def act(_firing: Firing) -> None:
        ticks = lasts()
        if ticks > 0:
            state.held.hold(robots, state.tick + ticks)

    return act


def _staying(for_s: Any, context: CompileContext, rule: BoundRule) -> Callable[[], int]:
    """Return what reads how many ticks something lasts: a number, or what a draw or a counter says now."""
    if isinstance(for_s, CounterValue):
        read = counter_reader(for_s, context, rule.each)
        # A counter may be anything: to end a match as a fault because a penalty was reckoned too far helps nobody.
        return lambda: ticks_from_s(min(max(0.0, read()), LONGEST_S))
    return lambda: context.state.lasting_ticks(for_s)


def release(model: Release, context: CompileContext, rule: BoundRule) -> Act:
    """Let robots go that rules hold."""
    held, trackers, robots = context.state.held, context.trackers, context.entities(model.entity, rule.each)
    return lambda _firing: trackers.release(held.release(robots))


def set_phase(model: SetPhase, context: CompileContext, _rule: BoundRule) -> Act:
    """Enter a phase, at once."""
    phase = model.phase
    return lambda _firing: context.enter_phase(phase)


def emit(model: Emit, context: CompileContext, rule: BoundRule) -> Act:
    """Write an event."""
    name = model.event
    payload = {key: compile_value(value, context, rule.each) for key, value in model.payload.items()}

    def act(firing: Firing) -> None:
        about = tuple(one for one in (firing.subject, firing.place) if one is not None)
        context.emit(name, {key: read(firing) for key, read in payload.items()}, about)

    return act


def end(model: End, context: CompileContext, rule: BoundRule) -> Act:
    """End the half, or the match, after the last firing of this tick.

    The first reason stands, but one for the end of the match goes before one for the end of the half.
    """
    state, reason, match = context.state, model.reason or rule.name, model.what == "match"

    def act(_firing: Firing) -> None:
        if state.ended is None or (match and not state.match_over):
            state.ended = reason
        state.match_over = state.match_over or match

    return act


ACTIONS: dict[str, Callable[[Any, CompileContext, BoundRule], Act]] = {
    "score": score,
    "count": count,
    "set_flag": set_flag,
    "toggle_flag": toggle_flag,
    "timer": timer,
    "sequence": sequence,
    "set_spot": set_spot,
    "draw": draw,
    "place": place,
    "remove": remove,
    "hold": hold,
    "release": release,
    "set_phase": set_phase,
    "emit": emit,
    "end": end,
}
"""Every word of an action, with what compiles it."""
