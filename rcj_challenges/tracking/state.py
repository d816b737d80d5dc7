"""The referee's state within a half, as plain data."""

from __future__ import annotations

import random
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import sqrt
from typing import Any

from rcj_challenges.core.amounts import add_up, round_score
from rcj_challenges.core.play import HalfInfo, Pose2
from rcj_challenges.core.streams import random_stream, stream_seed
from rcj_challenges.core.timing import TICK_S
from rcj_challenges.tracking.bound_rules import HitBuffer
from rcj_challenges.tracking.contacts import Contacts
from rcj_challenges.tracking.held import Held
from rcj_challenges.tracking.pose_history import PoseHistory

Number = int | float


@dataclass(slots=True)
class Clock:
    """One timer: it runs up to its length and stands there.

    Attributes:
        length: in ticks.
        length_s: as the scenario says it, or its draw; whole ticks may be a little longer.
        elapsed: ticks run until it was last started or held.
        since: tick from which it runs, None while it is held.
    """

    length: int
    elapsed: int = 0
    since: int | None = None
    length_s: float = 0.0

    def ticks(self, tick: int) -> int:
        """Return the ticks that it has run."""
        return min(self.length, self.elapsed + (tick - self.since if self.since is not None else 0))

    def running(self, tick: int) -> bool:
        """Return whether it runs and has not reached its length."""
        return self.since is not None and self.ticks(tick) < self.length


class RefereeState:
    """What the referee knows at a tick.

    Attributes:
        clock: ticks of the half's clock: those of phases whose clock stops are not in it.
        names: by entity, its name.
        robots: the names of robots.
        poses: by entity, where it is now (after a placement: where it was put).
        seen: by entity, where it is in the sub-step that a tracker looks at; None: ``poses`` are looked at.
        before: by entity, where it was a tick ago (or was put then).
        by_hand: entities that a test moved by hand since the last tick; their speed is unknown.
        uprights: by entity, cosine of the tilt.
        present: by entity, whether it is on the field.
        contacts: what touches what.
        hits: where trackers report.
        held: which robots are held, by the phase or by rules, on the field or off it.
        placed_at: by entity, the pose in which it was last put, or started.
        ways: by entity, how far it has driven or rolled in the half, in m; only entities that a rule asks about.
        pose_history: judged poses of the past.
        spots: by name, [x, y] where it is now: where the scenario says, until a rule sets it.
        decided_spots: by spot set by chance, the next places that a test decides.
        half_length_s: the length of the half in s, as the record prints it.
        scores: by entrant, as seated in this half.
        began_with: the scores at the beginning of the ``half`` and of the ``phase``.
        messages: by robot, its last radio message to the referee in this half.
        counters, flags: by name; a mapping by entity for those kept per entity.
        first: the values at the beginning of a half, by section and name.
        keeps: by counter that keeps the lowest or highest of what it is given, how that is found.
        draws: what was drawn, and the members that have the roles, by name; None: nothing has the role.
        timers: by name, then entity (None for one that is not kept per entity).
        entrant_of: by robot, the entrant it plays for.
        ended: None, or why an ``end`` action ended the half.
        match_over: whether that action ended the whole match.
    """

    def __init__(self, half: HalfInfo, phase: str, names: Sequence[str], robots: int) -> None:
        self.half = half
        self.tick = 0
        self.clock = 0
        self.phase = phase
        self.poses: list[Pose2] = []
        self.seen: list[Pose2] | None = None
        self.before: list[Pose2] = []
        self.by_hand: frozenset[int] = frozenset()
        self.ways: dict[int, float] = {}
        self.pose_history = PoseHistory()
        self.spots: dict[str, tuple[float, float]] = {}
        self.decided_spots: dict[str, list[tuple[float, float]]] = {}
        self.half_length_s: Number = 0
        self.uprights: list[float] = []
        self.names, self.robots = names, frozenset(names[:robots])
        self.present = [True] * len(names)
        self.contacts = Contacts(robots)
        self.hits = HitBuffer()
        self.held = Held()
        self.placed_at: list[Pose2] = []
        self.messages: dict[str, str] = {}
        self.scores: dict[str, Number] = {}
        self.began_with: dict[str, dict[str, Number]] = {}
        self.counters: dict[str, Number | dict[str, Number | None] | None] = {}
        self.flags: dict[str, bool | dict[str, bool]] = {}
        self.first: dict[str, dict[str, Any]] = {}
        self.keeps: dict[str, Callable[[Number, Number], Number]] = {}
        self.timers: dict[str, dict[str | None, Clock]] = {}
        self.draws: dict[str, Any] = {}
        self.ended: str | None = None
        self.match_over = False
        self.entrant_of: dict[str, str] = {}
        self._streams: dict[str, random.Random] = {}

    def stream(self, use: str) -> random.Random:
        """Return the random stream of a use in this half."""
        found = self._streams.get(use)
        if found is None:
            found = random_stream(self.half.match_seed, f"{use}/half-{self.half.half}")
            self._streams[use] = found
        return found

    def add_ways(self) -> None:
        """Add the ways of the last tick; where something was put, its way begins."""
        for entity in self.ways:
            (x, y, _), (was_x, was_y, _) = self.poses[entity], self.before[entity]
            self.ways[entity] += sqrt((x - was_x) ** 2 + (y - was_y) ** 2)

    def speed_mps(self, entity: int) -> float | None:
        """Return the speed of an entity in the last tick; None off the field, and of what a test moved by hand."""
        if not self.present[entity] or entity in self.by_hand:
            return None
        (x, y, _), (was_x, was_y, _) = self.poses[entity], self.before[entity]
        return sqrt((x - was_x) ** 2 + (y - was_y) ** 2) / TICK_S

    def counter(self, name: str, entity: str | None) -> Number | None:
        """Return a counter; None: it has no value; one kept per entity without an entity is the sum."""
        value = self.counters[name]
        if isinstance(value, dict):
            numbers = (one for one in value.values() if one is not None)
            return value[entity] if entity is not None else round_score(add_up(numbers))
        return value

    def flag(self, name: str, entity: str | None) -> bool:
        """Return a flag; one kept per entity without an entity is whether any of them is set."""
        value = self.flags[name]
        if isinstance(value, dict):
            return value[entity] if entity is not None else any(value.values())
        return value

    def seed_id(self) -> str:
        """Return eight hexadecimal digits that identify the seed without revealing it."""
        return f"{stream_seed(self.half.match_seed, 'seed_id') & 0xFFFFFFFF:08x}"
