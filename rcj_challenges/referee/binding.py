"""Compiles words for one rule: what they need of the referee, with ``each`` and the rule's phases filled in."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, TypeVar

from rcj_challenges.geometry.regions import Region
from rcj_challenges.referee.compiling import CompileContext
from rcj_challenges.referee.nearness import targets_of
from rcj_challenges.referee.places import spots_of, where_now
from rcj_challenges.referee.setting_down import Board
from rcj_challenges.referee.values import compile_bound
from rcj_challenges.rules.base import Binder, Trigger
from rcj_challenges.rules.fields import Name, Names, Point, Scalar
from rcj_challenges.rules.values import Bound
from rcj_challenges.tracking.bound_rules import BoundRule, TriggerBinding
from rcj_challenges.tracking.gates import GateLine
from rcj_challenges.tracking.sequences import SequenceTracker
from rcj_challenges.tracking.state import Number
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


if TYPE_CHECKING:
    _: type[Binder] = RuleBinder
