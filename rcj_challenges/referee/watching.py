"""What is followed from tick to tick on behalf of rules, and the lookout that does so cheaply.

Three kinds of watches. A `PositionWatch` follows one entity and only looks when its centre leaves a cell in which
nothing can change. A `DueWatch` knows the earliest tick at which it could have something to say. A `TickWatch` looks
on every tick. A watch lives in the phases of its rules; while it does not live it costs nothing, and when it comes
to life, or its entity is put elsewhere, it begins anew: before := now.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from rcj_challenges.facts.play import Pose2
from rcj_challenges.referee.regions import EVERYWHERE, Cell, common_cell
from rcj_challenges.referee.state import State

NEVER = 1 << 62


class Watch:
    """Something followed on behalf of rules that live in the same phases.

    Attributes:
        phases: in which it lives; None: in all.
        entities: the indices of those whose placement makes it begin anew.
        since: the tick at which it last began anew.
    """

    phases: frozenset[str] | None = None
    entities: tuple[int, ...] = ()
    since = 0

    def lives_in(self, phase: str) -> bool:
        """Return whether it lives in a phase."""
        return self.phases is None or phase in self.phases

    def restart(self) -> None:
        """Begin anew: what is true now was true before."""
        raise NotImplementedError

    def moved(self) -> None:
        """Take note that one of its entities was put elsewhere or taken off: it begins anew."""
        self.restart()


class PositionWatch(Watch):
    """A watch on where one entity's centre is."""

    entity: int

    def cell(self, x_m: float, y_m: float) -> Cell:
        """Return a cell around the centre in which this watch has nothing to do."""
        raise NotImplementedError

    def advance(self, before: list[Pose2], substeps: list[list[Pose2]]) -> None:
        """Look at the way through the sub-steps.

        Args:
            before: poses by entity before the first of them.
            substeps: ``[sub-step][entity]``.
        """
        raise NotImplementedError


class DueWatch(Watch):
    """A watch that needs to look only from a tick on.

    Attributes:
        due: the earliest tick at which it could have something to say.
    """

    due: int = NEVER

    def look(self) -> None:
        """Look, and set ``due`` anew."""
        raise NotImplementedError

    def reckon(self) -> None:
        """Set ``due`` anew after an action changed what it depends on; by default it depends on nothing."""

    def let_go(self, robots: frozenset[int]) -> None:
        """Set ``due`` anew after robots that rules held were let go; by default it does not depend on them."""


class TickWatch(Watch):
    """A watch that looks on every tick."""

    def look(self) -> None:
        """Look."""
        raise NotImplementedError


class Track:
    """Judged poses of the last ticks, as far back as the longest window asks.

    Attributes:
        first: the tick of the oldest pose kept.
        poses: ``[tick - first][entity]``.
    """

    def __init__(self) -> None:
        self.first = 0
        self.poses: list[list[Pose2]] = []
        self._needed = 0

    def need(self, ticks: int) -> None:
        """Ask for at least this many ticks of the past."""
        self._needed = max(self._needed, ticks)

    @property
    def used(self) -> bool:
        """Whether anybody asked for the past."""
        return self._needed > 0

    def add(self, poses: list[Pose2]) -> None:
        """Add the judged poses of a tick."""
        kept = self.poses
        kept.append(poses)
        if len(kept) > 2 * self._needed + 2:
            gone = len(kept) - self._needed - 1
            del kept[:gone]
            self.first += gone

    def of(self, entity: int, from_tick: int, to_tick: int) -> list[Pose2]:
        """Return the entity's judged poses of the ticks from ``from_tick`` to ``to_tick``, both included."""
        return [poses[entity] for poses in self.poses[from_tick - self.first : to_tick + 1 - self.first]]


class _Alive:
    """The watches that live in one phase; ``stays``: entities whose way can change when something is due."""

    def __init__(self, watches: Iterable[Watch], phase: str, entities: int) -> None:
        self.all = [watch for watch in watches if watch.lives_in(phase)]
        self.by_entity: list[list[PositionWatch]] = [[] for _ in range(entities)]
        self.stays: set[int] = set()
        for watch in self.all:
            if isinstance(watch, PositionWatch):
                self.by_entity[watch.entity].append(watch)
                if isinstance(watch, DueWatch):
                    self.stays.add(watch.entity)
        self.due = [watch for watch in self.all if isinstance(watch, DueWatch)]
        self.ticking = [watch for watch in self.all if isinstance(watch, TickWatch)]


class Lookout:
    """Follows all watches that live in the present phase."""

    def __init__(self, state: State) -> None:
        self._state = state
        self._watches: list[Watch] = []
        self._phases: dict[str, _Alive] = {}
        self._alive = _Alive((), "", len(state.roster.entities))
        self._cells: list[Cell] = [EVERYWHERE] * len(state.roster.entities)
        self._own_cells: dict[PositionWatch, Cell] = {}
        self._due = NEVER

    def add(self, watch: Watch) -> None:
        """Follow a watch; all of them are added before the half starts."""
        self._watches.append(watch)

    @property
    def watches(self) -> tuple[Watch, ...]:
        """All watches, whether they live in the present phase or not."""
        return tuple(self._watches)

    def enter(self, phase: str, left: str | None) -> None:
        """Enter a phase: the watches that did not live in the phase left begin anew (all, if it is the same)."""
        if phase not in self._phases:
            self._phases[phase] = _Alive(self._watches, phase, len(self._cells))
        self._alive = self._phases[phase]
        for watch in self._alive.all:
            if left is None or left == phase or not watch.lives_in(left):
                self._restart(watch)
        for entity in range(len(self._cells)):
            self._fit_cell(entity)
        self._next_due()

    def begin_anew(self, entities: set[int]) -> None:
        """Begin anew all that concerns entities that were put elsewhere or taken off."""
        for watch in self._alive.all:
            if not entities.isdisjoint(watch.entities):
                watch.since = self._state.tick
                watch.moved()
        for entity in entities:
            self._fit_cell(entity)
        self._next_due()

    def reckon(self) -> None:
        """Ask all watches anew when they are due: an action changed a timer."""
        for watch in self._alive.due:
            watch.reckon()
        self._next_due()

    def let_go(self, robots: frozenset[int]) -> None:
        """Tell all watches that these robots, which rules held, may move again."""
        if robots:
            for watch in self._alive.due:
                watch.let_go(robots)
            self._next_due()

    def restart(self, *watches: Watch) -> None:
        """Begin watches anew, because a rule says so."""
        for watch in watches:
            self._restart(watch)
        for entity in dict.fromkeys(entity for watch in watches for entity in watch.entities):
            self._fit_cell(entity)
        if watches:
            self._next_due()

    def _restart(self, watch: Watch) -> None:
        watch.since = self._state.tick
        watch.restart()

    def _fit_cell(self, entity: int) -> None:
        cell = EVERYWHERE
        if self._state.present[entity]:
            x, y, _ = self._state.poses[entity]
            for watch in self._alive.by_entity[entity]:
                own = self._own_cells[watch] = watch.cell(x, y)
                cell = common_cell(cell, own)
        self._cells[entity] = cell

    def _next_due(self) -> None:
        self._due = min([watch.due for watch in self._alive.due], default=NEVER)

    def advance(self, substeps: list[list[Pose2]], *, changed_phase: bool) -> None:
        """Follow everything through the sub-steps of this tick. The state already holds its judged poses.

        Args:
            substeps: ``[sub-step][entity]``.
            changed_phase: True if a phase ran out at the start of this tick; what came to life then begins now.
        """
        left = range(len(self._cells)) if changed_phase else self._left(substeps)
        tick = self._state.tick
        if left:
            self._look_closely(left, substeps, all_of_it=changed_phase)
        if tick >= self._due:
            for watch in self._alive.due:
                if tick >= watch.due and (watch.since != tick or not changed_phase):
                    watch.look()
            self._next_due()
        for watching in self._alive.ticking:
            if watching.since != tick or not changed_phase:
                watching.look()

    def _left(self, substeps: list[list[Pose2]]) -> Sequence[int]:
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

    def _look_closely(self, entities: Sequence[int], substeps: list[list[Pose2]], *, all_of_it: bool) -> None:
        """Let the watches whose own cell was left (or all) follow the way of these entities."""
        state = self._state
        for entity in entities:
            if not state.present[entity]:
                continue
            cell = EVERYWHERE
            x, y, _ = state.poses[entity]
            for watch in self._alive.by_entity[entity]:
                own = self._own_cells[watch]
                if all_of_it or not _stayed(own, entity, substeps):
                    if watch.since != state.tick:
                        watch.advance(state.before, substeps)
                    own = self._own_cells[watch] = watch.cell(x, y)
                cell = common_cell(cell, own)
            self._cells[entity] = cell
        if not self._alive.stays.isdisjoint(entities):
            self._next_due()


def _stayed(cell: Cell, entity: int, substeps: list[list[Pose2]]) -> bool:
    x_low, x_high, y_low, y_high = cell
    for poses in substeps:
        x, y, _ = poses[entity]
        if not (x_low < x < x_high and y_low < y < y_high):
            return False
    return True
