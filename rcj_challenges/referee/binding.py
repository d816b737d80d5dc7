"""Binds the words of a rule to the referee."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from functools import partial
from typing import Any, TypeVar

from rcj_challenges.referee.bodies import PlacementBoard
from rcj_challenges.referee.compiling import CompileContext
from rcj_challenges.referee.placement import PlacementJob, compile_placement
from rcj_challenges.referee.scope import NameScope
from rcj_challenges.rules.base import Act, Condition, Trigger, ValueWord
from rcj_challenges.rules.effects import Places, PlacesLayout
from rcj_challenges.rules.fields import Names, Point, Scalar
from rcj_challenges.rules.placement import Mirror
from rcj_challenges.scenario.rule_effects import alternatives, layouts_of, roles_in
from rcj_challenges.tracking.bound_rules import BoundRule, TriggerBinding
from rcj_challenges.tracking.trackers import Tracker

_T = TypeVar("_T", bound=Tracker)


class RuleBinder(NameScope):
    """Implements `Binder` for one rule."""

    def __init__(self, context: CompileContext, rule: BoundRule, for_each: str | None) -> None:
        super().__init__(context.state, rule.each, for_each)
        self.other = rule.other
        self._context = context
        self.rule = rule
        self.trackers = context.trackers
        self.clock_events = context.clock_events
        self.drawn: Mapping[str, tuple[str, ...]] = context.roster.drawn
        self.sequences = context.sequence_trackers
        self.reset_with_draws = context.reset_with_draws
        self.set_length = context.set_length
        self.enter_phase = context.enter_phase
        self.emit = context.emit
        self._trigger = ""
        self._holders: tuple[tuple[str, str], ...] = ()
        self._by_time = False
        self._position = 0

    def bind(self, position: int, trigger: Trigger) -> None:
        """Bind the rule to one of its triggers, with the place that it has in the rule."""
        self._position, self._trigger, self._by_time = position, trigger.name(), trigger.IS_TIME
        self.named.clear()
        named = roles_in(trigger, self.roles)
        for holders, one in self.for_holders(trigger, named):
            self._holders = tuple(zip(named, holders, strict=True))
            one.bind(self)
        self._holders = ()

    def watched(self, condition: Condition) -> tuple[int, ...]:
        words = self.for_holders(condition, roles_in(condition, self.roles))
        return tuple(dict.fromkeys(entity for _, one in words for entity in one.watched(self)))

    def binding(self, about: int | str | None = None) -> TriggerBinding:
        """Return the rule's binding to the trigger that is compiled.

        What is about a zone or gate comes last: of an event about a robot and a gate, the robot is named.
        """
        things = self.roster.things
        index = self.roster.index.get(about) if isinstance(about, str) else about
        name, turn = (None, len(things)) if index is None else (things[index], index)
        key = (self.rule.rank, self._position, turn)
        holders, draws = self._holders, self.state.draws
        applies = (lambda: all(draws[role] == holder for role, holder in holders)) if holders else None
        return TriggerBinding(self.rule, name, self._trigger, key, self._by_time, applies)

    def track(self, kind: type[_T], key: tuple[object, ...] | None, *args: Any) -> _T:
        # One that is about members of roles is not shared with others: it is reset when one of these is assigned.
        own = self.each if any(isinstance(part, ValueWord) for part in key or ()) else None
        shared = None if key is None else (*key, own, *self._holders)
        tracker = self._context.track(kind, shared, self.rule.phases, *args)
        named = sorted(self.named) if key is None else ()
        self.reset_with_draws(tracker, (*(role for role, _ in self._holders), *named))
        return tracker

    def free_spots(self, names: Names, clearance_m: float) -> Callable[[], Iterable[bool]]:
        state, bodies = self.state, self._context.bodies
        spots = [self.locate(name) for name in self.members(names)]

        def free() -> Iterable[bool]:
            board = PlacementBoard(state, bodies, set())
            return (board.free(spot(), clearance_m, None) for spot in spots)

        return free

    def assign(self, name: str, value: Scalar | None) -> None:
        self._context.assign(name, partial(self.state.set_draw, name, value))

    def assign_next(self, name: str) -> None:
        self._context.assign(name, partial(self.state.assign_next, name))

    def is_on_floor(self, point: Point) -> bool:
        return self._context.bodies.floor.has(point)

    def placing(self, effect: Places | PlacesLayout) -> Act:
        ask = self._context.queue.ask

        def place(jobs: list[PlacementJob]) -> None:
            for job in jobs:
                ask(job if job.spec is None else replace(job, signs=job.spec.signs_now(self.state)))

        if isinstance(effect, Places):
            single = [self.placement_job(effect, entity) for entity in self.entities(effect.names)]
            return lambda _firing: place(single)
        layouts = {name: self._layout_jobs(name, effect.mirror) for name in layouts_of(self.scenario, effect)}
        draws, layout = self.state.draws, effect.layout
        if effect.is_drawn:
            return lambda _firing: place(layouts[str(draws[layout])])
        return lambda _firing: place(layouts[layout])

    def _layout_jobs(self, layout: str, mirror: Mirror | None) -> list[PlacementJob]:
        context, each = self._context, self.rule.each
        key = (layout, each, mirror)
        specs = context.layouts.get(key)
        if specs is None:
            specs = context.layouts[key] = [
                compile_placement(put, self, entity, stream)
                for put_in_turn in alternatives(self.scenario, PlacesLayout(layout, is_drawn=False, mirror=mirror))
                for number, put in enumerate(put_in_turn)
                for entity in self.entities(put.names)
                for stream in (f"placement/{layout}/{number}/{self.state.names[entity]}",)
            ]
        return [PlacementJob(spec.entity, spec, self.rule) for spec in specs]

    def placement_job(self, put: Places, entity: int) -> PlacementJob:
        stream = f"rule/{self.rule.name}/{self.state.names[entity]}"
        return PlacementJob(entity, compile_placement(put, self, entity, stream), self.rule)

    def remove(self, entity: int, back: PlacementJob | None = None, ticks: int = 0) -> None:
        self._context.queue.ask(PlacementJob(entity, None, self.rule))
        if back is not None:
            self._context.queue.ask_later(replace(back, due=self.state.tick + ticks, comes_back=True))
