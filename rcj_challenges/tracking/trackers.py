"""Trackers follow things from tick to tick on behalf of rules; the manager updates only those that need it.

Three kinds of trackers. A `PositionTracker` follows one entity and is only advanced when its centre leaves a cell in
which nothing can change. A `DueTracker` knows the earliest tick at which it could have something to report. A
`TickTracker` is updated on every tick. A tracker is active in the phases of its rules; elsewhere it costs nothing, and
when it becomes active, or its entity is put elsewhere, it is reset: before := now.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Literal, NamedTuple

from rcj_challenges.core.play import Pose2
from rcj_challenges.geometry.regions import EVERYWHERE, Cell, common_cell
from rcj_challenges.tracking.bound_rules import Test, TriggerBinding
from rcj_challenges.tracking.state import Clock, RefereeState

NEVER = 1 << 62


class Missed(NamedTuple):
    """What a tracker saw for the first time that sets off no rule, although one seems to wait for it; for tests.

    Attributes:
        kind: true: it held already; placed: it was put into a zone; crossed: it crossed a gate the way that does not
            count.
        what: the zone as it is written, or the gate and the direction.
        bindings: those of the rules; none if it is no step of a sequence.
    """

    tick: int
    kind: Literal["true", "placed", "crossed"]
    what: str = ""
    bindings: Sequence[TriggerBinding] = ()


class Tracker:
    """Something followed for rules that are active in the same phases.

    Attributes:
        phases: in which it is active; None: in all.
        since: the tick at which it was last reset.
        missed: what set off no rule; None: nothing.
    """

    phases: frozenset[str] | None = None
    since = 0
    missed: Missed | None = None

    def __init__(self, state: RefereeState, *entities: int) -> None:
        self.bindings: list[TriggerBinding] = []
        self.entities = entities
        self._state = state
        self._hits = state.hits

    def is_active_in(self, phase: str) -> bool:
        """Return whether it is active in a phase."""
        return self.phases is None or phase in self.phases

    def reset(self) -> None:
        """Forget the past: what is true now was true before; by default there is none."""

    def moved(self) -> None:
        """React to one of its entities being put elsewhere or taken off: by default it is reset."""
        self.reset()

    def settle(self) -> None:
        """Report what came true after the last tick, in which no time passes; by default nothing does."""


class PositionTracker(Tracker):
    """A tracker on where one entity's centre is."""

    def __init__(self, state: RefereeState, entity: int) -> None:
        super().__init__(state, entity)
        self.entity = entity

    def cell(self, x_m: float, y_m: float) -> Cell:
        """Return a cell around the centre in which this tracker has nothing to do."""
        raise NotImplementedError

    def advance(self, before: list[Pose2], substeps: list[list[Pose2]]) -> None:
        """Follow the way through the sub-steps.

        Args:
            before: poses by entity before the first of them.
            substeps: ``[sub-step][entity]``.
        """
        raise NotImplementedError


class DueTracker(Tracker):
    """A tracker that needs to look only from a tick on.

    Attributes:
        due: the earliest tick at which it could have something to say.
    """

    due: int = NEVER

    def update(self) -> None:
        """Report what is due, and set the next ``due``."""
        raise NotImplementedError

    def reschedule(self) -> None:
        """Set ``due`` after an action changed what it depends on; by default it depends on nothing."""

    def release(self, robots: frozenset[int]) -> None:
        """Set ``due`` after robots that rules held were let go; by default it does not depend on them."""


class TickTracker(Tracker):
    """A tracker that looks on every tick."""

    def update(self) -> None:
        """Report what happened in this tick."""
        raise NotImplementedError


class _Active:
    """The trackers that are active in one phase; ``stays``: entities whose way can change when something is due."""

    def __init__(self, trackers: Iterable[Tracker], phase: str, entities: int) -> None:
        self.all = [tracker for tracker in trackers if tracker.is_active_in(phase)]
        self.by_entity: list[list[PositionTracker]] = [[] for _ in range(entities)]
        self.stays: set[int] = set()
        for tracker in self.all:
            if isinstance(tracker, PositionTracker):
                self.by_entity[tracker.entity].append(tracker)
                if isinstance(tracker, DueTracker):
                    self.stays.add(tracker.entity)
        self.due = [tracker for tracker in self.all if isinstance(tracker, DueTracker)]
        self.ticking = [tracker for tracker in self.all if isinstance(tracker, TickTracker)]


class TrackerManager:
    """Updates the trackers that are active in the present phase; all of them are added before the half starts."""

    def __init__(self, state: RefereeState) -> None:
        self._state = state
        self.all: list[Tracker] = []
        self._phases: dict[str, _Active] = {}
        self._active = _Active((), "", len(state.present))
        self._cells: list[Cell] = [EVERYWHERE] * len(state.present)
        self._own_cells: dict[PositionTracker, Cell] = {}
        self._due = NEVER

    def enter(self, phase: str, left: str | None) -> None:
        """Enter a phase: reset the trackers that were not active in the phase left (all, if it is the same)."""
        if phase not in self._phases:
            self._phases[phase] = _Active(self.all, phase, len(self._cells))
        self._active = self._phases[phase]
        for tracker in self._active.all:
            if left is None or left == phase or not tracker.is_active_in(left):
                self._reset(tracker)
        for entity in range(len(self._cells)):
            self._fit_cell(entity)
        self._next_due()

    def on_placed(self, entities: set[int]) -> None:
        """Update all trackers of entities that were put elsewhere or taken off."""
        for tracker in self._active.all:
            if not entities.isdisjoint(tracker.entities):
                tracker.since = self._state.tick
                tracker.moved()
        for entity in entities:
            self._fit_cell(entity)
        self._next_due()

    def reschedule(self) -> None:
        """Let all trackers set their ``due``: an action changed a timer."""
        for tracker in self._active.due:
            tracker.reschedule()
        self._next_due()

    def release(self, robots: frozenset[int]) -> None:
        """Let all trackers set their ``due`` after rules let these robots go."""
        if robots:
            for tracker in self._active.due:
                tracker.release(robots)
            self._next_due()

    def reset(self, *trackers: Tracker) -> None:
        """Reset trackers, because a rule says so."""
        for tracker in trackers:
            self._reset(tracker)
        for entity in dict.fromkeys(entity for tracker in trackers for entity in tracker.entities):
            self._fit_cell(entity)
        if trackers:
            self._next_due()

    def _reset(self, tracker: Tracker) -> None:
        tracker.since = self._state.tick
        tracker.reset()

    def _fit_cell(self, entity: int) -> None:
        cell = EVERYWHERE
        if self._state.present[entity]:
            x, y, _ = self._state.poses[entity]
            for tracker in self._active.by_entity[entity]:
                own = self._own_cells[tracker] = tracker.cell(x, y)
                cell = common_cell(cell, own)
        self._cells[entity] = cell

    def _next_due(self) -> None:
        self._due = min([tracker.due for tracker in self._active.due], default=NEVER)

    def advance(self, substeps: list[list[Pose2]], *, changed_phase: bool) -> None:
        """Follow everything through the sub-steps of this tick. The state already holds its judged poses.

        Args:
            substeps: ``[sub-step][entity]``.
            changed_phase: True if a phase ran out at the start of this tick; what came to life then begins now.
        """
        left = range(len(self._cells)) if changed_phase else self._that_left(substeps)
        tick = self._state.tick
        if left:
            self._advance_all(left, substeps, all_of_it=changed_phase)
        if tick >= self._due:
            for due in self._active.due:
                if tick >= due.due and (due.since != tick or not changed_phase):
                    due.update()
            self._next_due()
        for tracker in self._active.ticking:
            if tracker.since != tick or not changed_phase:
                tracker.update()

    def settle(self) -> None:
        """Let the active trackers report what came true after the last tick, in which no time passes."""
        for tracker in self._active.all:
            tracker.settle()

    def _that_left(self, substeps: list[list[Pose2]]) -> Sequence[int]:
        """Return the entities that left their cell in any sub-step: none, on most ticks."""
        for (x_low, x_high, y_low, y_high), *way in zip(self._cells, *substeps, strict=True):
            for x, y, _ in way:
                if not (x_low < x < x_high and y_low < y < y_high):
                    return self._all_that_left(substeps)
        return ()

    def _all_that_left(self, substeps: list[list[Pose2]]) -> list[int]:
        found = {
            entity
            for poses in substeps
            for entity, ((x_low, x_high, y_low, y_high), (x, y, _)) in enumerate(zip(self._cells, poses, strict=True))
            if not (x_low < x < x_high and y_low < y < y_high)
        }
        return sorted(found)

    def _advance_all(self, entities: Sequence[int], substeps: list[list[Pose2]], *, all_of_it: bool) -> None:
        """Let the trackers whose own cell was left (or all) follow the way of these entities."""
        state = self._state
        for entity in entities:
            if not state.present[entity]:
                continue
            cell = EVERYWHERE
            x, y, _ = state.poses[entity]
            for tracker in self._active.by_entity[entity]:
                own = self._own_cells[tracker]
                if all_of_it or not _stayed(own, entity, substeps):
                    if tracker.since != state.tick:
                        tracker.advance(state.before, substeps)
                    own = self._own_cells[tracker] = tracker.cell(x, y)
                cell = common_cell(cell, own)
            self._cells[entity] = cell
        if not self._active.stays.isdisjoint(entities):
            self._next_due()


def _stayed(cell: Cell, entity: int, substeps: list[list[Pose2]]) -> bool:
    x_low, x_high, y_low, y_high = cell
    for poses in substeps:
        x, y, _ = poses[entity]
        if not (x_low < x < x_high and y_low < y < y_high):
            return False
    return True


class RunsWhile(TickTracker):
    """Lets a clock run from a tick in which a test holds to the next one in which it does not."""

    def __init__(self, state: RefereeState, clock: Clock, test: Test, reschedule: Callable[[], None]) -> None:
        super().__init__(state)
        self._clock = clock
        self._test = test
        self._reschedule = reschedule

    def reset(self) -> None:
        """Look again: what the test says may have changed."""
        self.update()

    def update(self) -> None:
        """Start or stop the clock, as the test says."""
        clock, tick = self._clock, self._state.tick
        holds = bool(self._test())
        if holds == (clock.since is not None):
            return
        clock.elapsed = clock.ticks(tick)
        clock.since = tick if holds else None
        self._reschedule()
