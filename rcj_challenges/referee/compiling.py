"""Resolves names to indices, regions and trackers, once for all rules."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any, TypeVar, cast

from rcj_challenges.core.timing import TICK_S, ticks_from_s
from rcj_challenges.geometry.regions import Region
from rcj_challenges.referee.bodies import Bodies
from rcj_challenges.referee.placement import PlacementQueue, PlacementSpec
from rcj_challenges.referee.scope import NameScope
from rcj_challenges.referee.state import State
from rcj_challenges.rules.fields import LONGEST_S
from rcj_challenges.rules.placement import Mirror
from rcj_challenges.rules.values import Lasts, Value, compile_duration, compile_value
from rcj_challenges.scenario.models.scenario import Broadcast, Scenario
from rcj_challenges.scenario.models.state import Sequence
from rcj_challenges.scenario.walk import walk
from rcj_challenges.tracking.bound_rules import NO_FIRING, Firing, Reader
from rcj_challenges.tracking.clock_events import ClockEvents
from rcj_challenges.tracking.sequences import SequencePath, SequenceTracker
from rcj_challenges.tracking.trackers import Tracker, TrackerManager

_T = TypeVar("_T", bound=Tracker)


class CompileContext:
    """What the compilers of all words share.

    Attributes:
        emit: writes an event.
        enter_phase: enters a phase.
        layouts: compiled layouts by name, what ``each`` stands for, and mirror.
    """

    def __init__(
        self,
        state: State,
        emit: Callable[[str, dict[str, object], tuple[str, ...]], None],
        enter_phase: Callable[[str], None],
    ) -> None:
        self.state = state
        self.scenario = state.scenario
        self.roster = state.roster
        self.trackers = TrackerManager(state)
        self.clock_events = ClockEvents()
        self.bodies = Bodies(state.scenario, state.roster)
        self.queue = PlacementQueue()
        self.emit, self.enter_phase = emit, enter_phase
        self._by_draw: dict[str, dict[Tracker, None]] = {}
        self._sequences: dict[str, dict[str | None, SequenceTracker]] = {}
        self.layouts: dict[tuple[str, str | None, Mirror | None], list[PlacementSpec]] = {}
        self._shared: dict[tuple[object, ...], Tracker] = {}
        self.names = NameScope(state)
        self._lengths: dict[tuple[Lasts, str | None, str | None], Callable[[Firing], float | None]] = {}

    def set_length(self, timer: str, owner: str | None) -> None:
        """Give a clock of a timer the length that it has by now; without one it runs on."""
        clock, written = self.state.timers[timer][owner], self.scenario.timers[timer]
        lasts_s = self.length_s(written.lasts_s, owner, written.per)
        clock.length_s = LONGEST_S if lasts_s is None else lasts_s
        clock.length = ticks_from_s(clock.length_s)

    def set_lengths(self) -> None:
        """Give each timer the length that it has as the half starts, and reset roles with their phases."""
        for name, role in self.scenario.roles.items():
            self.state.anew_in(role.keep, partial(self.assign, name, partial(self.state.begin_role, name)))
        for name, clocks in self.state.timers.items():
            self.state.anew_in(self.scenario.timers[name].keep, partial(self._begin_timer, name))
            for owner, clock in clocks.items():
                if not clock.length_s:
                    self.set_length(name, owner)

    def _begin_timer(self, name: str) -> None:
        timer = self.scenario.timers[name]
        for owner, clock in self.state.timers[name].items():
            self.set_length(name, owner)
            runs = timer.starts if timer.while_ is None else clock.since is not None
            clock.elapsed, clock.since = 0, self.state.tick if runs else None

    def length_s(self, lasts_s: Lasts | None, owner: str | None = None, per: str | None = None) -> float | None:
        """Return the length in s that a timer or a phase has by now; None: it has none."""
        if lasts_s is None:
            return None
        read = self._lengths.get((lasts_s, owner, per))
        if read is None:
            scope = NameScope(self.state, owner, per)
            read = self._lengths[lasts_s, owner, per] = compile_duration(lasts_s, scope, least=TICK_S)
        return read(NO_FIRING)

    def reset_with_draws(self, tracker: Tracker, names: tuple[str, ...]) -> None:
        """Reset a tracker whenever one of the draws among these names, or at which circles sit, decides otherwise."""
        anchors = [getattr(self.scenario.zones.get(name), "anchor", None) for name in self.roster.may_be(names)]
        for name in (*names, *anchors):
            if name in self.roster.drawn or name in self.roster.roles:
                self._by_draw.setdefault(name, {})[tracker] = None

    def assign(self, role: str, assign: Callable[[], None]) -> None:
        """Assign a role or draw, and if that changes it, reset all that follows it: its change is not an edge."""
        before = self.state.draws[role]
        assign()
        if self.state.draws[role] != before:
            self.trackers.reset(*self._by_draw.get(role, ()))

    # --- trackers ---------------------------------------------------------------------------------------------------

    def track(self, kind: type[_T], key: tuple[object, ...] | None, phases: frozenset[str] | None, *args: Any) -> _T:
        """Return the tracker that follows ``key`` in some phases, which rules share; without a key one of its own."""
        shared = None if key is None else self._shared.get((kind, *key, phases))
        if shared is not None:
            return cast("_T", shared)
        tracker = kind(self.state, *args)
        tracker.phases = phases
        self.trackers.all.append(tracker)
        if key is not None:
            self._shared[kind, *key, phases] = tracker
        return tracker

    def sequence_trackers(self, name: str) -> dict[str | None, SequenceTracker]:
        """Return the trackers of a sequence by whose it is; None for one that is not kept per entity.

        All rules share them, and they are active wherever one of these is.
        """
        if name not in self._sequences:
            self._sequences[name] = self._track_sequence(self.scenario.sequences[name], _phases_of(self.scenario, name))
        return self._sequences[name]

    def _track_sequence(self, sequence: Sequence, phases: frozenset[str] | None) -> dict[str | None, SequenceTracker]:
        steps = tuple(self.names.members(places) for places in sequence.places())
        names = tuple(dict.fromkeys(name for step in steps for name in step))
        zones: dict[str, Region] = {name: self.names.zone(name) for name in names if name in self.scenario.zones}
        gates = {name: self.names.gate(name) for name in names if name not in zones}
        path = SequencePath(
            steps,
            sequence.cyclic,
            sequence.wrong_step == "break",
            sequence.when_placed == "goes_on",
            sequence.order == "any",
        )
        members = self.names.members(sequence.followed)
        return {
            None if sequence.per is None else member: self.track(
                SequenceTracker, None, phases, self.roster.index[member], path, zones, gates
            )
            for member in members
        }


def _phases_of(scenario: Scenario, sequence: str) -> frozenset[str] | None:
    """Return the phases in which a sequence is followed: those of the rules that name it; None: all of them.

    A rule that only resets it does not follow it.
    """
    following = [
        rule.phases
        for rule in scenario.rules.values()
        if any(getattr(word, "sequence", None) == sequence for word, _ in walk((rule.triggers, rule.conditions)))
    ]
    return None if "any" in following else frozenset(phase for phases in following for phase in phases)


# --- the broadcast ----------------------------------------------------------------------------------------------------


Told = dict[str, Any]


class Broadcasting:
    """Reads the values of a scenario's broadcast."""

    def __init__(self, broadcast: Broadcast, context: CompileContext) -> None:
        """Compile it.

        Args:
            broadcast: of the scenario.
            context: whose state the values are read from.
        """
        self._every_ticks = broadcast.every_ticks
        self._to_all = _readers(broadcast.fields, context)
        self._to_some: dict[int, dict[str, Reader]] = {}
        for name, fields in (broadcast.only or {}).items():
            readers = _readers(fields, context)
            for robot in context.roster.expand(name) if readers else ():
                self._to_some.setdefault(context.roster.index[robot], {}).update(readers)

    def values_at(self, tick: int) -> tuple[Told | None, dict[int, Told] | None]:
        """Return the values sent to all robots at a tick, and to single ones besides, by index; None: nothing."""
        if tick % self._every_ticks:
            return None, None
        to_some = {robot: _read(readers) for robot, readers in self._to_some.items()}
        return _read(self._to_all), to_some or None


def _readers(fields: Mapping[str, Value], context: CompileContext) -> dict[str, Reader]:
    return {key: compile_value(value, context.names) for key, value in fields.items()}


def _read(readers: Mapping[str, Reader]) -> Told:
    return {key: read(NO_FIRING) for key, read in readers.items()}
