"""Resolves names to indices, regions and trackers, once for all rules."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from rcj_challenges.geometry.regions import AnyOf, Drawn, Outlined, Region
from rcj_challenges.referee.bodies import Bodies
from rcj_challenges.referee.placement import PlacementQueue, PlacementSpec
from rcj_challenges.referee.state import State
from rcj_challenges.referee.zones import region_of
from rcj_challenges.rules.fields import Names, Scalar
from rcj_challenges.rules.mirror import Mirror
from rcj_challenges.scenario.catalogue import EACH
from rcj_challenges.scenario.floor import floor_parts
from rcj_challenges.scenario.followed import followed, phases_of
from rcj_challenges.scenario.models.state import Sequence
from rcj_challenges.scenario.remembered import remembered_spots
from rcj_challenges.scenario.roster import written_for
from rcj_challenges.tracking.bound_rules import HitBuffer
from rcj_challenges.tracking.clock_events import ClockEvents
from rcj_challenges.tracking.contacts import Contacts
from rcj_challenges.tracking.gates import GateLine
from rcj_challenges.tracking.pose_history import PoseHistory
from rcj_challenges.tracking.sequences import SequencePath, SequenceTracker
from rcj_challenges.tracking.trackers import Tracker, TrackerManager

_T = TypeVar("_T", bound=Tracker)


class CompileContext:
    """What the compilers of all words share.

    Attributes:
        state: the referee's memory; closures read it when they run.
        hits: where trackers report.
        trackers: the trackers of all rules.
        pose_history: judged poses of the past.
        clock_events: triggers that no tracker follows.
        contacts: what touches what.
        bodies: outlines.
        queue: placements asked for.
        emit: writes an event; set by the engine.
        enter_phase: enters a phase; set by the engine.
        layouts: compiled layouts by name, what ``each`` stands for, and mirror.
        timers_changed: to be called after a timer was started or stopped; trackers are rescheduled.
        floor: what lies inside the walls.
        remembered: the spots that rules set; they are read each time.
    """

    def __init__(self, state: State) -> None:
        self.state = state
        self.scenario = state.scenario
        self.roster = state.roster
        self.hits = HitBuffer()
        self.pose_history = PoseHistory()
        self.trackers = TrackerManager(state)
        self.clock_events = ClockEvents()
        self.contacts = Contacts(state.roster.robots)
        self.bodies = Bodies(state.scenario, state.roster)
        self.queue = PlacementQueue()
        self.emit: Callable[[str, dict[str, object], tuple[str, ...]], None] = lambda _name, _payload, _about: None
        self.enter_phase: Callable[[str], None] = lambda _phase: None
        self.timers_changed: Callable[[], None] = self.trackers.reschedule
        self._by_draw: dict[str, list[Tracker]] = {}
        self.floor = floor_parts(state.scenario.field)
        self.remembered = frozenset(remembered_spots(state.scenario))
        self._sequences: dict[tuple[str, str], SequenceTracker] = {}
        self.layouts: dict[tuple[str, str | None, Mirror | None], list[PlacementSpec]] = {}
        self._members: dict[tuple[Names, str | None], tuple[str, ...]] = {}
        self._shared: dict[tuple[object, ...], Tracker] = {}

    # --- names ------------------------------------------------------------------------------------------------------

    def members(self, names: Names, each: str | None) -> tuple[str, ...]:
        """Return what names stand for: groups expanded, ``each`` replaced, without repeats, in order."""
        known = self._members.get((names, each))
        if known is None:
            known = self._members[names, each] = self.roster.expand(written_for(names, each))
        return known

    def entities(self, names: Names, each: str | None) -> tuple[int, ...]:
        """Return the indices of entities.

        Raises:
            ValueError: one of them is no entity.
        """
        return tuple(self.entity(name, each) for name in self.members(names, each))

    def entity(self, name: str, each: str | None) -> int:
        """Return the index of one entity; of a group its first member.

        Raises:
            ValueError: it is no entity.
        """
        index = self.thing(name, each)
        if index >= len(self.roster.entities):
            message = f"not an entity: {self.roster.things[index]!r}"
            raise ValueError(message)
        return index

    def things(self, names: Names, each: str | None) -> tuple[int, ...]:
        """Return the indices of what can be touched: entities, fixed obstacles, walls.

        Raises:
            ValueError: one of them is nothing of this.
        """
        return tuple(self.thing(name, each) for name in self.members(names, each))

    def thing(self, name: str, each: str | None) -> int:
        """Return the index of one thing that can be touched; of a group its first member.

        Raises:
            ValueError: it is no such thing.
        """
        member = self.members(name, each)[0]
        index = self.roster.index.get(member)
        if index is None:
            message = f"not an entity or obstacle: {member!r}"
            raise ValueError(message)
        return index

    def whose(self, name: str | None, each: str | None) -> str | None:
        """Return whose counter, flag, timer or sequence a name stands for; None: all of them, or the only one."""
        return each if name == EACH else name

    def drawn_value(self, value: Scalar, each: str | None) -> Scalar:
        """Return a value of a draw; ``each`` stands for a name if the rule has ``for_each``."""
        return each if value == EACH and each is not None else value

    def region(self, names: Names, each: str | None) -> Region:
        """Return the region of a zone, or of several zones taken as one.

        Raises:
            ValueError: one of them is no zone.
        """
        return any_of(tuple(self._zone_or_drawn(name) for name in self.members(names, each)))

    def _zone_or_drawn(self, name: str) -> Region:
        among = self.roster.drawn.get(name)
        if among is None:
            return self.zone(name)
        draws, regions = self.state.draws, {zone: self.zone(zone) for zone in among}
        return Drawn(lambda: regions[str(draws[name])])

    def spot_name(self, name: object) -> str:
        """Return the name of a spot.

        Raises:
            ValueError: there is no spot of this name.
        """
        if not isinstance(name, str) or name not in self.state.spots:
            message = f"unknown spot {name!r}"
            raise ValueError(message)
        return name

    def reset_with_draws(self, tracker: Tracker, names: tuple[str, ...]) -> None:
        """Reset a tracker whenever one of the draws among these names decides otherwise."""
        for name in names:
            if name in self.roster.drawn and tracker not in self._by_draw.setdefault(name, []):
                self._by_draw[name].append(tracker)

    def has_drawn(self, name: str) -> None:
        """Reset all that follows what a draw decided: its change is not an edge."""
        self.trackers.reset(*self._by_draw.get(name, ()))

    def zone(self, name: str) -> Outlined:
        """Return the region of one zone.

        Raises:
            ValueError: there is none of this name.
        """
        zone = self.scenario.zones.get(name)
        if zone is None:
            message = f"unknown zone {name!r}"
            raise ValueError(message)
        return region_of(zone)

    # --- trackers ---------------------------------------------------------------------------------------------------

    def track(
        self, kind: type[_T], key: tuple[object, ...], phases: frozenset[str] | None, make: Callable[[], _T]
    ) -> _T:
        """Return the tracker that follows ``key`` in some phases; rules that follow the same share it."""
        full = (kind, *key, phases)
        tracker = self._shared.get(full)
        if tracker is None:
            tracker = self._shared[full] = make()
            self.track_alone(tracker, phases)
        if not isinstance(tracker, kind):
            message = f"two kinds of trackers under one key: {full}"
            raise TypeError(message)
        return tracker

    def track_alone(self, tracker: Tracker, phases: frozenset[str] | None) -> None:
        """Follow a tracker that is not shared."""
        tracker.phases = phases
        self.trackers.add(tracker)

    def gate(self, name: str) -> GateLine:
        """Return a gate.

        Raises:
            KeyError: there is none of this name.
        """
        gate = self.scenario.gates[name]
        anchor = None if gate.anchor is None else self.entity(gate.anchor, None)
        return GateLine(gate.from_m, gate.to_m, anchor, self.state)

    def sequence_trackers(self, name: str) -> dict[str | None, SequenceTracker]:
        """Return the trackers of a sequence by whose it is; None for one that is not kept per entity.

        All rules share them, and they are active wherever one of these is.
        """
        sequence = self.scenario.sequences[name]
        members = self.members(followed(sequence), None)
        for member in members:
            if (name, member) not in self._sequences:
                tracker = self._sequences[name, member] = self._sequence_tracker(sequence, member)
                self.track_alone(tracker, phases_of(self.scenario, name))
        return {None if sequence.per is None else member: self._sequences[name, member] for member in members}

    def _sequence_tracker(self, sequence: Sequence, member: str) -> SequenceTracker:
        steps = tuple(self.members(places, None) for places in sequence.places())
        names = tuple(dict.fromkeys(name for step in steps for name in step))
        zones: dict[str, Region] = {name: self.zone(name) for name in names if name in self.scenario.zones}
        gates = {name: self.gate(name) for name in names if name not in zones}
        path = SequencePath(steps, sequence.cyclic, sequence.wrong_step == "break", sequence.when_placed == "goes_on")
        return SequenceTracker(self.entity(member, None), path, zones, gates, self.state, self.hits)


def any_of(regions: tuple[Region, ...]) -> Region:
    """Return several regions taken as one."""
    return regions[0] if len(regions) == 1 else AnyOf(regions)
