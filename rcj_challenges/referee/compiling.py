"""From the names of a scenario to indices, regions and closures: what every word needs to be compiled, once.

A word's compiler gets the `Workshop`: it resolves names (``each`` included), shares watches between rules that follow
the same thing, and keeps the ears of the moments that have no place on the field.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import NamedTuple, TypeVar

from rcj_challenges.facts.timing import ticks_from_s
from rcj_challenges.referee.bodies import Bodies
from rcj_challenges.referee.contacts import Contacts
from rcj_challenges.referee.regions import AnyOf, Drawn, Outlined, Region, region_of
from rcj_challenges.referee.rules import Hits, Listener, StandingRule
from rcj_challenges.referee.setting_down import Putting, Queue
from rcj_challenges.referee.state import State
from rcj_challenges.referee.watching import Lookout, Track, Watch
from rcj_challenges.rules.fields import Names, Scalar
from rcj_challenges.rules.places import Mirror
from rcj_challenges.scenario.catalogue import EACH
from rcj_challenges.scenario.remembered import remembered_spots
from rcj_challenges.scenario.roster import written_for

_W = TypeVar("_W", bound=Watch)
_DECIMALS = 9
"""Of times that are told: 3 times 0.1 s are 0.3 s."""


class Appointment(NamedTuple):
    """A time, or a row of times, of the half's clock for which a rule waits.

    Attributes:
        listener: its ear.
        at_s: the first time.
        every_s: how long after one the next comes; None: there is no other.
        past: how many have come.
    """

    listener: Listener
    at_s: float
    every_s: float | None
    past: int = 0

    @property
    def next_s(self) -> float:
        """The next time, counted from the first: times that are no whole ticks do not add up to a delay."""
        return self.at_s if self.every_s is None else round(self.at_s + self.past * self.every_s, _DECIMALS)


@dataclass
class Moments:
    """Ears for what happens at no place: by what they wait for; of an event also by whom it is about, None: anybody."""

    half_started: list[Listener] = field(default_factory=list)
    half_ended: list[Listener] = field(default_factory=list)
    entered: dict[str, list[tuple[str | None, Listener]]] = field(default_factory=dict)
    events: dict[tuple[str, str | None], list[Listener]] = field(default_factory=dict)
    times: dict[int, list[Appointment]] = field(default_factory=dict)
    faults: dict[str, list[Listener]] = field(default_factory=dict)
    messages: dict[str, list[tuple[Callable[[str], bool], Listener]]] = field(default_factory=dict)

    def wait_for(self, appointment: Appointment, after: int = 0) -> None:
        """Let a rule hear the half's clock when it next shows what the rule waits for, later than a tick."""
        self.times.setdefault(max(after + 1, ticks_from_s(appointment.next_s)), []).append(appointment)

    def due_at(self, clock: int) -> list[Appointment]:
        """Return who waits for what the clock shows now; those who wait for more than one time go on waiting."""
        due = self.times.pop(clock, [])
        for one in due:
            if one.every_s is not None:
                self.wait_for(one._replace(past=one.past + 1), after=clock)
        return due


class Workshop:
    """All that compilers of words share.

    Attributes:
        state: the referee's memory; closures read it when they run.
        hits: where watches report.
        lookout: where watches are followed.
        track: judged poses of the past.
        moments: ears for moments.
        contacts: who touches whom.
        bodies: outlines.
        queue: placements asked for.
        emit: writes an event; set by the engine.
        enter_phase: enters a phase; set by the engine.
        sequences: their watches, by name and whose way they follow.
        layouts: compiled layouts by name, what ``each`` stands for, and mirror.
        timers_changed: to be called after a timer was started or stopped; the lookout reckons anew.
        remembered: the spots that rules set: they are to be read anew each time.
    """

    def __init__(self, state: State) -> None:
        self.state = state
        self.scenario = state.scenario
        self.roster = state.roster
        self.hits = Hits()
        self.track = Track()
        self.lookout = Lookout(state)
        self.moments = Moments()
        self.contacts = Contacts(state.roster.robots)
        self.bodies = Bodies(state.scenario, state.roster)
        self.queue = Queue()
        self.emit: Callable[[str, dict[str, object], tuple[str, ...]], None] = lambda _name, _payload, _about: None
        self.enter_phase: Callable[[str], None] = lambda _phase: None
        self.timers_changed: Callable[[], None] = self.lookout.reckon
        self._by_draw: dict[str, list[Watch]] = {}
        self.remembered = frozenset(remembered_spots(state.scenario))
        self.sequences: dict[tuple[str, str], Watch] = {}
        self.layouts: dict[tuple[str, str | None, Mirror | None], list[Putting]] = {}
        self._members: dict[tuple[Names, str | None], tuple[str, ...]] = {}
        self._shared: dict[tuple[object, ...], Watch] = {}

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
        """Return whose counter, flag, timer or sequence is meant; None: all of them, or the only one."""
        return each if name == EACH else name

    def drawn_value(self, value: Scalar, each: str | None) -> Scalar:
        """Return the value of a draw that is meant: ``each`` is a name where the rule is for somebody."""
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

    def follow_draws(self, watch: Watch, names: tuple[str, ...]) -> None:
        """Let a watch begin anew whenever one of the draws among these names decides otherwise."""
        for name in names:
            if name in self.roster.drawn and watch not in self._by_draw.setdefault(name, []):
                self._by_draw[name].append(watch)

    def has_drawn(self, name: str) -> None:
        """Let all that follows what a draw decided begin anew: its change is no edge."""
        self.lookout.restart(*self._by_draw.get(name, ()))

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

    # --- watches and ears -------------------------------------------------------------------------------------------

    def listener(self, rule: StandingRule, position: int, trigger: str, entity: int | None = None) -> Listener:
        """Return the ear of a rule's trigger (its place in the rule is ``position``).

        What is about a zone or gate comes last: of an event about a robot and a gate, which both are heard, the robot
        can be told.
        """
        things = self.roster.things
        name, turn = (None, len(things)) if entity is None else (things[entity], entity)
        return Listener(rule, name, trigger, (rule.rank, position, turn))

    def watch(self, kind: type[_W], key: tuple[object, ...], rule: StandingRule, make: Callable[[], _W]) -> _W:
        """Return the watch that follows ``key`` in the phases of the rule; rules that follow the same share it."""
        full = (kind, *key, rule.phases)
        found = self._shared.get(full)
        if found is None:
            found = make()
            found.phases = rule.phases
            self._shared[full] = found
            self.lookout.add(found)
        if not isinstance(found, kind):
            message = f"two kinds of watches under one key: {full}"
            raise TypeError(message)
        return found


def any_of(regions: tuple[Region, ...]) -> Region:
    """Return several regions taken as one."""
    return regions[0] if len(regions) == 1 else AnyOf(regions)
