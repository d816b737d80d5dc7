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
from rcj_challenges.referee.compiling import Workshop
from rcj_challenges.referee.places import compile_mirror, compile_putting, random_point, spot_name, where_now
from rcj_challenges.referee.rules import Occasion, StandingRule
from rcj_challenges.referee.sequences import sequence_watches
from rcj_challenges.referee.setting_down import Job
from rcj_challenges.referee.state import Clock, Number
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

Act = Callable[[Occasion], None]

_MOST_TRIES = 1000
"""So often chance looks for a point inside the walls, of a zone that may lie outside for the most part."""


def compile_action(model: Action, workshop: Workshop, rule: StandingRule) -> Act:
    """Return a compiled action of a rule."""
    return ACTIONS[model.action](model, workshop, rule)


def _receiver(entrant: str | LastToucher, workshop: Workshop, rule: StandingRule) -> Callable[[], str | None]:
    """Return what tells whose the points are: the named entrant's, or those of whoever drives a robot."""
    drivers = workshop.state.entrant_of
    if isinstance(entrant, LastToucher):
        touched = workshop.thing(entrant.last_touch, rule.each)
        contacts, names = workshop.contacts, workshop.roster.entities
        contacts.follow_last(touched)

        def driver_of_the_last() -> str | None:
            robot = contacts.last(touched)
            return None if robot is None else drivers.get(names[robot])

        return driver_of_the_last
    robot = None if entrant in workshop.scenario.entrants else {EACH: rule.each, OTHER: rule.other}.get(entrant)
    whose = entrant if robot is None else drivers.get(robot)
    return lambda: whose


def score(model: Score, workshop: Workshop, rule: StandingRule) -> Act:
    """Give points to an entrant; to nobody if nobody touched what they are given for."""
    state, receiver = workshop.state, _receiver(model.entrant, workshop, rule)
    points = compile_points(model.points, workshop, rule.each)
    bounded = change_bound(model)

    def act(occasion: Occasion) -> None:
        entrant = receiver()
        if entrant is None:
            return
        given = bounded(points(occasion), state.scores[entrant])
        state.scores[entrant] = on_paper(state.scores[entrant] + given)
        occasion.scored[entrant] = on_paper(occasion.scored.get(entrant, 0) + given)

    return act


def count(model: Count, workshop: Workshop, rule: StandingRule) -> Act:
    """Change a counter: first ``to``, then ``by``."""
    counters, name, whose = workshop.state.counters, model.counter, workshop.whose(model.entity, rule.each)
    to = None if model.to is None else compile_points(model.to, workshop, rule.each)
    by = 1 if model.by is None and model.to is None else model.by
    step = None if by is None else compile_points(by, workshop, rule.each)

    within, bounded = amount_bound(model), change_bound(model)

    def changed(value: Number, occasion: Occasion) -> Number:
        value = value if to is None else within(to(occasion))
        return on_paper(value if step is None else value + bounded(step(occasion), value))

    def act(occasion: Occasion) -> None:
        value = counters[name]
        if isinstance(value, dict):
            for member in value if whose is None else (whose,):
                value[member] = changed(value[member], occasion)
        else:
            counters[name] = changed(value, occasion)

    return act


def _change_flag(
    workshop: Workshop, rule: StandingRule, name: str, entity: str | None, new: Callable[[bool], bool]
) -> Act:
    flags, whose = workshop.state.flags, workshop.whose(entity, rule.each)

    def act(_occasion: Occasion) -> None:
        value = flags[name]
        if isinstance(value, dict):
            for member in value if whose is None else (whose,):
                value[member] = new(value[member])
        else:
            flags[name] = new(value)

    return act


def set_flag(model: SetFlag, workshop: Workshop, rule: StandingRule) -> Act:
    """Set or clear a flag."""
    to = model.to
    return _change_flag(workshop, rule, model.flag, model.entity, lambda _value: to)


def toggle_flag(model: ToggleFlag, workshop: Workshop, rule: StandingRule) -> Act:
    """Turn a flag over."""
    return _change_flag(workshop, rule, model.flag, model.entity, lambda value: not value)


def timer(model: TimerAction, workshop: Workshop, rule: StandingRule) -> Act:
    """Start, stop or reset a timer."""
    state, do = workshop.state, model.do
    clocks, whose = state.timers[model.timer], workshop.whose(model.entity, rule.each)
    meant = tuple(clocks.items()) if whose is None else ((whose, clocks[whose]),)
    lasts_s = workshop.scenario.timers[model.timer].lasts_s

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

    def act(_occasion: Occasion) -> None:
        for owner, clock in meant:
            change(owner, clock)
        workshop.timers_changed()

    return act


def sequence(model: SequenceAction, workshop: Workshop, rule: StandingRule) -> Act:
    """Begin a sequence anew: that of one, or of all who have one."""
    watches, whose = sequence_watches(workshop, model.sequence), workshop.whose(model.entity, rule.each)
    meant = tuple(watches.values()) if whose is None else (watches[whose],)

    def act(_occasion: Occasion) -> None:
        for watch in meant:
            workshop.lookout.restart(watch)

    return act


def set_spot(model: SetSpot, workshop: Workshop, rule: StandingRule) -> Act:
    """Set a spot to where something is now, to its mirror image, or where chance says: there only inside the walls.

    What is off the field leaves it where it is.
    """
    state, name = workshop.state, spot_name(workshop, model.spot)
    where = _place_of(model.to, workshop, rule, f"spot/{name}")
    signs = (lambda: (1, 1)) if model.mirror is None else compile_mirror(model.mirror, workshop)
    of_chance = isinstance(model.to, UniformIn | OnLine)
    floor = floor_parts(workshop.scenario.field)

    def act(_occasion: Occasion) -> None:
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
    to: Any, workshop: Workshop, rule: StandingRule, stream: str
) -> Callable[[], tuple[float, float] | None]:  # fmt: skip
    """Return what finds the place that a spot is set to; None if there is none at present."""
    match to:
        case ToldValue():
            return _heard(workshop, to, rule)
        case UniformIn() | OnLine():
            sample, state = random_point(to, workshop, rule.each), workshop.state
            return lambda: sample(state.stream(stream))
        case _:
            return where_now(workshop, to, rule.each)


def _heard(workshop: Workshop, told: ToldValue, rule: StandingRule) -> Callable[[], tuple[float, float] | None]:
    """Return what tells the position that a robot has told by radio; None if it was none."""
    heard, robot = workshop.state.heard, workshop.members(told.told, rule.each)[0]
    return lambda: position_in(heard.get(robot, ""))


def draw(model: DrawAction, workshop: Workshop, rule: StandingRule) -> Act:
    """Draw anew, or set a draw to a value."""
    state, name = workshop.state, model.draw
    fixed = None if model.as_ is None else workshop.drawn_value(model.as_, rule.each)
    drawn = workshop.scenario.draws[name]

    def act(_occasion: Occasion) -> None:
        before = state.draws[name]
        if fixed is not None:
            state.set_draw(name, fixed)
        else:
            state.draw_anew(name, drawn)
        if state.draws[name] != before:
            workshop.has_drawn(name)

    return act


def place(model: Place, workshop: Workshop, rule: StandingRule) -> Act:
    """Put entities somewhere: by a layout, or one after the other."""
    if isinstance(model.layout, DrawValue):
        state, name = workshop.state, model.layout.draw
        layouts = {
            value: layout_jobs(workshop, str(value), rule, model.mirror)
            for value in workshop.scenario.draws[name].values
        }
        return lambda _occasion: _ask(workshop, layouts[state.draws[name]])
    if model.layout is not None:
        jobs = layout_jobs(workshop, model.layout, rule, model.mirror)
    else:
        if model.entity is None or model.at is None:
            message = f"rules.{rule.name}: place needs a layout, or entity and at"
            raise ValueError(message)
        names = workshop.members(model.entity, rule.each)
        jobs = [
            Job(entity, compile_putting(model, workshop, entity, rule.each, f"rule/{rule.name}/{name}"), rule)
            for name, entity in zip(names, workshop.entities(model.entity, rule.each), strict=True)
        ]
    return lambda _occasion: _ask(workshop, jobs)


def layout_jobs(workshop: Workshop, layout: str, rule: StandingRule, mirror: Mirror | None) -> list[Job]:
    """Return the placements of a layout, in order."""
    key = (layout, rule.each, mirror)
    puttings = workshop.layouts.get(key)
    if puttings is None:
        puttings = workshop.layouts[key] = [
            compile_putting(placing, workshop, entity, rule.each, stream, also=mirror)
            for number, placing in enumerate(workshop.scenario.placements[layout])
            for entity in workshop.entities(placing.entity, rule.each)
            for stream in (f"placement/{layout}/{number}/{workshop.roster.entities[entity]}",)
        ]
    return [Job(putting.entity, putting, rule) for putting in puttings]


def _ask(workshop: Workshop, jobs: list[Job]) -> None:
    for job in jobs:
        if job.putting is not None and job.putting.flips:
            workshop.queue.ask(replace(job, signs=job.putting.signs()))
        else:
            workshop.queue.ask(job)


def remove(model: Remove, workshop: Workshop, rule: StandingRule) -> Act:
    """Take entities off the field, for a time or until something places them."""
    state, queue = workshop.state, workshop.queue
    away = None if model.for_s is None else _staying(model.for_s, workshop, rule)
    back = Place(action="place", entity=model.entity, at=model.back_at, facing=model.facing)
    returns = {
        entity: compile_putting(
            back, workshop, entity, rule.each, f"rule/{rule.name}/{workshop.roster.entities[entity]}"
        )
        for entity in workshop.entities(model.entity, rule.each)
    }

    def act(_occasion: Occasion) -> None:
        for entity, putting in returns.items():
            queue.ask(Job(entity, None, rule))
            if away is not None:
                queue.ask_later(Job(entity, putting, rule, due=state.tick + max(1, away()), comes_back=True))

    return act


def hold(model: Hold, workshop: Workshop, rule: StandingRule) -> Act:
    """Hold robots, for a time or until something lets them go."""
    state, robots = workshop.state, workshop.entities(model.entity, rule.each)
    if model.for_s is None:
        return lambda _occasion: state.held.hold(robots, inf)
    lasts = _staying(model.for_s, workshop, rule)

    def act(_occasion: Occasion) -> None:
        ticks = lasts()
        if ticks > 0:
            state.held.hold(robots, state.tick + ticks)

    return act


def _staying(for_s: Any, workshop: Workshop, rule: StandingRule) -> Callable[[], int]:
    """Return what reads how many ticks something lasts: a number, or what a draw or a counter says now."""
    if isinstance(for_s, CounterValue):
        read = counter_reader(for_s, workshop, rule.each)
        # A counter may be anything: to end a match as a fault because a penalty was reckoned too far helps nobody.
        return lambda: ticks_from_s(min(max(0.0, read()), LONGEST_S))
    return lambda: workshop.state.lasting_ticks(for_s)


def release(model: Release, workshop: Workshop, rule: StandingRule) -> Act:
    """Let robots go that rules hold."""
    held, lookout, robots = workshop.state.held, workshop.lookout, workshop.entities(model.entity, rule.each)
    return lambda _occasion: lookout.let_go(held.release(robots))


def set_phase(model: SetPhase, workshop: Workshop, _rule: StandingRule) -> Act:
    """Enter a phase, at once."""
    phase = model.phase
    return lambda _occasion: workshop.enter_phase(phase)


def emit(model: Emit, workshop: Workshop, rule: StandingRule) -> Act:
    """Write an event."""
    name = model.event
    payload = {key: compile_value(value, workshop, rule.each) for key, value in model.payload.items()}

    def act(occasion: Occasion) -> None:
        about = tuple(one for one in (occasion.subject, occasion.place) if one is not None)
        workshop.emit(name, {key: read(occasion) for key, read in payload.items()}, about)

    return act


def end(model: End, workshop: Workshop, rule: StandingRule) -> Act:
    """End the half, or the match, after the last firing of this tick.

    The first reason stands, but one for the end of the match goes before one for the end of the half.
    """
    state, reason, match = workshop.state, model.reason or rule.name, model.what == "match"

    def act(_occasion: Occasion) -> None:
        if state.ended is None or (match and not state.match_over):
            state.ended = reason
        state.match_over = state.match_over or match

    return act


ACTIONS: dict[str, Callable[[Any, Workshop, StandingRule], Act]] = {
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
