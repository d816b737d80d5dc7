"""Compiles words for one rule: what they need of the referee, with ``each`` and the rule's phases filled in."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from random import Random
from typing import TYPE_CHECKING, Any, TypeVar

from rcj_challenges.facts.timing import ticks_from_s
from rcj_challenges.geometry.regions import Region
from rcj_challenges.referee.compiling import CompileContext
from rcj_challenges.referee.nearness import targets_of
from rcj_challenges.referee.places import compile_mirror, compile_putting, random_point, spots_of, where_now
from rcj_challenges.referee.setting_down import Board, Job
from rcj_challenges.referee.values import compile_bound, compile_points, compile_value, counter_reader
from rcj_challenges.rules.actions.place import Place
from rcj_challenges.rules.base import Binder, Trigger
from rcj_challenges.rules.fields import LONGEST_S, Name, Names, Point, Scalar
from rcj_challenges.rules.places import Mirror, OnLine, UniformIn
from rcj_challenges.rules.values import Bound, CounterValue, Lasts, Points, Value
from rcj_challenges.scenario.floor import on_floor
from rcj_challenges.tracking.bound_rules import BoundRule, Firing, TriggerBinding
from rcj_challenges.tracking.gates import GateLine
from rcj_challenges.tracking.sequences import SequenceTracker
from rcj_challenges.tracking.state import Clock, Number
from rcj_challenges.tracking.target import Target
from rcj_challenges.tracking.trackers import Tracker

_T = TypeVar("_T", bound=Tracker)


class RuleBinder:
    """Implements `Binder` for one rule.

    Args:
        context: what the compilers of all words share.
        rule: the rule.
    """

    def __init__(self, context: CompileContext, rule: BoundRule) -> None:
        self.rule = rule
        self.state = context.state
        self.hits = context.hits
        self.contacts = context.contacts
        self.pose_history = context.pose_history
        self.clock_events = context.clock_events
        self.drawn: Mapping[str, tuple[str, ...]] = context.roster.drawn
        self._context = context
        self._trigger = ""
        self._position = 0

    def bind(self, position: int, trigger: Trigger) -> None:
        """Bind the rule to one of its triggers.

        Args:
            position: its place in the rule.
            trigger: the trigger.
        """
        self._position, self._trigger = position, trigger.name()
        trigger.bind(self)

    def binding(self, entity: int | None = None) -> TriggerBinding:
        """Return the rule's binding to the trigger that is compiled.

        What is about a zone or gate comes last: of an event about a robot and a gate, the robot is named.
        """
        things = self._context.roster.things
        name, turn = (None, len(things)) if entity is None else (things[entity], entity)
        return TriggerBinding(self.rule, name, self._trigger, (self.rule.rank, self._position, turn))

    # --- names ------------------------------------------------------------------------------------------------------

    def members(self, names: Names) -> tuple[str, ...]:
        """Return what names stand for: groups expanded, ``each`` replaced, without repeats, in order."""
        return self._context.members(names, self.rule.each)

    def entities(self, names: Names) -> tuple[int, ...]:
        """Return the indices of entities."""
        return self._context.entities(names, self.rule.each)

    def things(self, names: Names) -> tuple[int, ...]:
        """Return the indices of what can be touched: entities, fixed obstacles, walls."""
        return self._context.things(names, self.rule.each)

    def index_of(self, name: str) -> int | None:
        """Return the index of something that can be touched; None for anything else."""
        return self._context.roster.index.get(name)

    def name_of(self, entity: int) -> str:
        """Return the name of an entity."""
        return self._context.roster.entities[entity]

    # --- what is followed -------------------------------------------------------------------------------------------

    def region(self, names: Names) -> Region:
        """Return the region of a zone, or of several zones taken as one."""
        return self._context.region(names, self.rule.each)

    def gate(self, name: str) -> GateLine:
        """Return a gate."""
        return self._context.gate(name)

    def sequences(self, name: str) -> dict[str | None, SequenceTracker]:
        """Return the trackers of a sequence by whose it is; None for one that is not kept per entity."""
        return self._context.sequence_trackers(name)

    def track(self, kind: type[_T], key: tuple[object, ...], make: Callable[[], _T]) -> _T:
        """Return the tracker that follows ``key`` in the phases of the rule; rules that follow the same share it."""
        return self._context.track(kind, key, self.rule.phases, make)

    def track_alone(self, tracker: Tracker) -> None:
        """Follow a tracker that is not shared, in the phases of the rule."""
        self._context.track_alone(tracker, self.rule.phases)

    def reset_with_draws(self, tracker: Tracker, names: tuple[str, ...]) -> None:
        """Reset a tracker whenever one of the draws among these names decides otherwise."""
        self._context.reset_with_draws(tracker, names)

    def thing(self, name: str) -> int:
        """Return the index of one thing that can be touched."""
        return self._context.thing(name, self.rule.each)

    def whose(self, name: str | None) -> str | None:
        """Return whose counter, flag, timer or sequence a name stands for; None: all of them, or the only one."""
        return self._context.whose(name, self.rule.each)

    def drawn_value(self, value: Scalar) -> Scalar:
        """Return a value of a draw: ``each`` is a name where the rule is for one."""
        return self._context.drawn_value(value, self.rule.each)

    def targets(self, named: Name | Point) -> tuple[Target, ...]:
        """Return what a distance is measured to: what a name stands for, or a point."""
        return targets_of(named, self._context, self.rule.each)

    def locate(self, what: Name | Point) -> Callable[[], Point | None]:
        """Return what finds where a thing, a spot, a zone's centre or a point is; None while it is off the field."""
        return where_now(self._context, what, self.rule.each)

    def free_spots(self, names: Names, clearance_m: float) -> Callable[[], Iterable[bool]]:
        """Return what finds for each of some spots whether no robot's or ball's centre is near."""
        state, bodies = self.state, self._context.bodies
        spots = spots_of(self._context, names, self.rule.each)

        def free() -> Iterable[bool]:
            board = Board(state, bodies, set())
            return (board.free(spot, clearance_m, None) for spot in spots())

        return free

    def bound(self, bound: Bound) -> Callable[[], Number]:
        """Return what reads what is compared with: a number, a counter, or the lowest or highest of others."""
        return compile_bound(bound, self._context, self.rule.each)

    # --- for actions ------------------------------------------------------------------------------------------------

    def points(self, points: Points) -> Callable[[Firing], Number]:
        """Return what reads a number of points: one amount, or the sum of numbers and weighted ones."""
        return compile_points(points, self._context, self.rule.each)

    def value(self, value: Value) -> Callable[[Firing], Any]:
        """Return what reads a value of an event's payload."""
        return compile_value(value, self._context, self.rule.each)

    def ticks(self, lasts_s: Lasts) -> Callable[[], int]:
        """Return what reads how many ticks something lasts: a number, or what a draw or a counter says."""
        if isinstance(lasts_s, CounterValue):
            read = counter_reader(lasts_s, self._context, self.rule.each)
            # A counter may be anything: to end a match as a fault because a penalty is too long helps no one.
            return lambda: ticks_from_s(min(max(0.0, read()), LONGEST_S))
        return lambda: self.state.lasting_ticks(lasts_s)

    def wind_up(self, timer: str, clock: Clock, owner: str | None) -> None:
        """Give a clock of a timer its length, as its draw has decided or its counter says by now."""
        self.state.wind_up(clock, self._context.scenario.timers[timer].lasts_s, owner)

    def timers_changed(self) -> None:
        """Reschedule the trackers after a timer was started or stopped."""
        self._context.timers_changed()

    def reset(self, tracker: Tracker) -> None:
        """Reset a tracker, because a rule says so."""
        self._context.trackers.reset(tracker)

    def release(self, robots: tuple[int, ...]) -> None:
        """Let robots go that rules hold."""
        self._context.trackers.release(self.state.held.release(robots))

    def decide_draw(self, draw: str, value: Scalar | None) -> None:
        """Draw anew, or set a draw to a value; what follows the draw is reset if it changed."""
        before = self.state.draws[draw]
        if value is not None:
            self.state.set_draw(draw, value)
        else:
            self.state.draw_anew(draw, self._context.scenario.draws[draw])
        if self.state.draws[draw] != before:
            self._context.has_drawn(draw)

    def draw_values(self, draw: str) -> tuple[Scalar, ...]:
        """Return the values of a draw."""
        return self._context.scenario.draws[draw].values

    def enter_phase(self, phase: str) -> None:
        """Enter a phase, at once."""
        self._context.enter_phase(phase)

    def emit(self, event: str, payload: dict[str, object], about: tuple[str, ...]) -> None:
        """Write an event."""
        self._context.emit(event, payload, about)

    # --- places -----------------------------------------------------------------------------------------------------

    def random_point(self, place: UniformIn | OnLine) -> Callable[[Random], Point]:
        """Return what draws a point of zones or of a segment, every one equally likely."""
        return random_point(place, self._context, self.rule.each)

    def mirror_signs(self, mirror: Mirror | None) -> Callable[[], Point]:
        """Return what reads the signs of x and y that a mirror gives now; without one they are positive."""
        return (lambda: (1, 1)) if mirror is None else compile_mirror(mirror, self._context)

    def decided_place(self, spot: str) -> Point | None:
        """Return where a test has decided that chance sets a spot this time; None: chance decides."""
        return self.state.decided_place(spot)

    def is_on_floor(self, point: Point) -> bool:
        """Return whether a point lies inside the walls."""
        return on_floor(point, self._context.floor)

    def layout_jobs(self, layout: str, mirror: Mirror | None) -> list[Job]:
        """Return the placements of a layout, in order."""
        context, each = self._context, self.rule.each
        key = (layout, each, mirror)
        puttings = context.layouts.get(key)
        if puttings is None:
            puttings = context.layouts[key] = [
                compile_putting(placing, context, entity, each, stream, also=mirror)
                for number, placing in enumerate(context.scenario.placements[layout])
                for entity in context.entities(placing.entity, each)
                for stream in (f"placement/{layout}/{number}/{self.name_of(entity)}",)
            ]
        return [Job(putting.entity, putting, self.rule) for putting in puttings]

    def placement_job(self, placing: Place, entity: int) -> Job:
        """Return the placement of one entity."""
        stream = f"rule/{self.rule.name}/{self.name_of(entity)}"
        return Job(entity, compile_putting(placing, self._context, entity, self.rule.each, stream), self.rule)

    def place(self, jobs: list[Job]) -> None:
        """Ask for placements, to be carried out after all actions of the tick."""
        for job in jobs:
            if job.putting is not None and job.putting.flips:
                self._context.queue.ask(replace(job, signs=job.putting.signs()))
            else:
                self._context.queue.ask(job)

    def place_later(self, job: Job, ticks: int) -> None:
        """Ask for a placement so many ticks from now, of what is off the field until then."""
        self._context.queue.ask_later(replace(job, due=self.state.tick + ticks, comes_back=True))

    def remove(self, entity: int) -> None:
        """Ask for an entity to be taken off the field."""
        self._context.queue.ask(Job(entity, None, self.rule))


if TYPE_CHECKING:
    _: type[Binder] = RuleBinder
