"""All that the referee remembers within a half, in one place: where things are, what was counted, which phase it is."""

from __future__ import annotations

import random
import struct
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import sqrt

from rcj_challenges.facts.amounts import on_paper, plain
from rcj_challenges.facts.play import HalfInfo, Pose2
from rcj_challenges.facts.streams import random_stream, stream_seed
from rcj_challenges.facts.timing import TICK_S, s_from_ticks, ticks_from_s
from rcj_challenges.referee.held import Held
from rcj_challenges.rules.fields import LONGEST_S, Scalar
from rcj_challenges.rules.values import CounterValue, DrawnDuration
from rcj_challenges.scenario.catalogue import EACH
from rcj_challenges.scenario.drawn import Series, drawable, series_of
from rcj_challenges.scenario.halves import half_length_s
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.models.state import Draw, Phase
from rcj_challenges.scenario.roster import Roster

Number = int | float

Lasting = float | DrawnDuration | CounterValue
"""How long something lasts, as the scenario's models have it."""

_FLOAT32 = struct.Struct("<f")


def float32(value: float) -> float:
    """Return the value as the world and the trajectory keep it, so that a placed pose is exactly the pose judged."""
    return float(_FLOAT32.unpack(_FLOAT32.pack(value))[0])


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
        """Return how long it has run."""
        return min(self.length, self.elapsed + (tick - self.since if self.since is not None else 0))

    def running(self, tick: int) -> bool:
        """Return whether it runs and has not reached its length."""
        return self.since is not None and self.ticks(tick) < self.length


class State:
    """What the referee knows at a tick.

    Attributes:
        tick: tick of the half.
        clock: ticks of the half's clock: those of phases whose clock stops are not in it.
        phase: the phase now.
        poses: by entity, where it is now (after a placement: where it was put).
        before: by entity, where it was a tick ago (or was put then).
        by_hand: who was put where it is by hand since a tick ago, which tests do: its speed is unknown then.
        uprights: by entity, cosine of the tilt.
        present: by entity, whether it is on the field.
        held: who is held, by the phase or by rules; also of those off the field.
        put_at: by entity, [x, y] where it was last put, or started.
        ways: by entity whose way somebody asks for, how far it has driven or rolled in the half, in m.
        spots: by name, [x, y] where it is now: where the scenario says, until a rule sets it.
        scores: by entrant, as seated in this half.
        heard: by robot, what it has told the referee by radio, the last time in this half.
        counters, flags: by name; a mapping by entity for those kept per entity.
        timers: by name, then entity (None for one that is not kept per entity).
        draws: by name, the value drawn.
        ended: None, or why an ``end`` action ended the half.
        match_over: whether that action ended the whole match.
    """

    def __init__(self, scenario: Scenario, roster: Roster, half: HalfInfo) -> None:
        self.scenario = scenario
        self.roster = roster
        self.half = half
        self.tick = 0
        self.clock = 0
        self.phase = scenario.first_phase
        self.poses: list[Pose2] = []
        self.before: list[Pose2] = []
        self.by_hand: frozenset[int] = frozenset()
        self.ways: dict[int, float] = {}
        self.spots = {name: (spot.x_m, spot.y_m) for name, spot in scenario.spots.items()}
        self.uprights: list[float] = []
        self.present = [True] * len(roster.entities)
        self.held = Held()
        self.put_at: list[tuple[float, float]] = []
        self.heard: dict[str, str] = {}
        self.scores: dict[str, Number] = {name: half.scores.get(name, 0) for name in scenario.entrants}
        self.counters: dict[str, Number | dict[str, Number]] = {}
        self.flags: dict[str, bool | dict[str, bool]] = {}
        self.timers: dict[str, dict[str | None, Clock]] = {}
        self.draws: dict[str, Scalar] = {}
        self._undrawn: dict[str, list[Scalar]] = {}
        self._decided: dict[str, list[Scalar]] = {}
        self._decided_spots: dict[str, list[tuple[float, float]]] = {}
        self.ended: str | None = None
        self.match_over = False
        self.entrant_of = {robot: name for name, entrant in scenario.entrants.items() for robot in entrant.robots}
        self._streams: dict[str, random.Random] = {}
        self._fill()

    def _fill(self) -> None:
        kept_counters, kept_flags = self.half.kept.get("counters", {}), self.half.kept.get("flags", {})
        for name, counter in self.scenario.counters.items():
            first = on_paper(counter.initial)
            if counter.keep == "match" and name in kept_counters:
                kept = kept_counters[name]
                self.counters[name] = dict(kept) if isinstance(kept, dict) else kept
            else:
                self.counters[name] = first if counter.per is None else dict.fromkeys(self._members(counter.per), first)
        for name, flag in self.scenario.flags.items():
            if flag.keep == "match" and name in kept_flags:
                kept = kept_flags[name]
                self.flags[name] = dict(kept) if isinstance(kept, dict) else bool(kept)
            elif flag.per is None:
                self.flags[name] = flag.initial
            else:
                self.flags[name] = dict.fromkeys(self._members(flag.per), flag.initial)
        for name, timer in self.scenario.timers.items():
            members = (None,) if timer.per is None else self._members(timer.per)
            since = 0 if timer.starts else None
            # How long they are is known when everything is drawn.
            self.timers[name] = {member: Clock(0, since=since) for member in members}

    def _members(self, group: str) -> tuple[str, ...]:
        return self.roster.expand(group)

    def stream(self, use: str) -> random.Random:
        """Return the random stream of a use in this half."""
        found = self._streams.get(use)
        if found is None:
            found = random_stream(self.half.match_seed, f"{use}/half-{self.half.half}")
            self._streams[use] = found
        return found

    def decide_draws(self, decided: Mapping[str, Series]) -> None:
        """Draw everything at the start of the half, but for what is decided beforehand or kept from the last half.

        Of several values that are decided, the later ones come when it is drawn anew. Timers get their length then.

        Raises:
            ValueError: a value is decided that the draw cannot have, or for a draw that does not exist.
        """
        for name, series in decided.items():
            self._decided[name] = list(series_of(series))
            known = self.scenario.draws[name].values if name in self.scenario.draws else ()
            wrong = [value for value in self._decided[name] if value not in known]
            if wrong:
                message = f"draws.{name}: {wrong[0]!r} is not one of its values"
                raise ValueError(message)
        kept, undrawn = self.half.kept.get("draws", {}), self.half.kept.get("undrawn", {})
        for name, draw in self.scenario.draws.items():
            if draw.not_again is not None:
                self._undrawn[name] = list(undrawn.get(name, draw.values))
            if name in decided:
                self.draw_anew(name, draw)
            elif draw.keep == "match" and name in kept:
                self.draws[name] = kept[name]
                if name not in undrawn:  # else it was taken out when it was drawn
                    self.set_draw(name, kept[name])
            else:
                self.draw_anew(name, draw)
        for name, timer in self.scenario.timers.items():
            for whose, clock in self.timers[name].items():
                self.wind_up(clock, timer.lasts_s, whose)

    def wind_up(self, clock: Clock, lasts_s: Lasting, whose: str | None) -> None:
        """Give a clock its length, as its draw has decided or its counter says by now.

        Args:
            clock: the clock.
            lasts_s: how long it lasts.
            whose: whom it is kept for; None for a single one.
        """
        clock.length_s = self._lasting_s(lasts_s, whose)
        clock.length = ticks_from_s(clock.length_s)

    def lasting_ticks(self, lasts_s: Lasting) -> int:
        """Return a duration in ticks, as its draw has decided or its counter says by now."""
        return ticks_from_s(self._lasting_s(lasts_s))

    def _lasting_s(self, lasts_s: Lasting, each: str | None = None) -> float:
        match lasts_s:
            case DrawnDuration():
                return float(self.draws[lasts_s.draw])
            case CounterValue():
                whose = each if lasts_s.entity == EACH else lasts_s.entity
                said = self.counter(lasts_s.counter, whose)
                # A counter may be anything: to end a match as a fault because it was reckoned too far helps nobody.
                return min(max(TICK_S, float(said)), LONGEST_S)
            case _:
                return lasts_s

    def set_draw(self, name: str, value: Scalar) -> None:
        """Let a draw have a value, which has been drawn then."""
        self.draws[name] = value
        undrawn = self._undrawn.get(name, [])
        if value in undrawn:
            undrawn.remove(value)

    def draw_anew(self, name: str, draw: Draw) -> None:
        """Draw a value, equally likely each: with ``not_last`` never the one it has, with ``not_again`` one left.

        As long as a test has decided what comes next, that comes.
        """
        last = (self.draws[name],) if name in self.draws else ()
        values, left = drawable(draw, self._undrawn.get(name, draw.values), last)
        if draw.not_again is not None:
            self._undrawn[name] = list(left)
        decided = self._decided.get(name)
        self.set_draw(name, decided.pop(0) if decided else self.stream(f"draw/{name}").choice(values))

    def undecided(self) -> dict[str, list[Scalar]]:
        """Return of the values that a test decided those that have not come."""
        return {name: list(left) for name, left in self._decided.items() if left}

    def decide_spots(self, decided: Mapping[str, Sequence[tuple[float, float]]]) -> None:
        """Let a test decide where chance sets spots, each the first times."""
        self._decided_spots = {name: list(places) for name, places in decided.items()}

    def decided_place(self, spot: str) -> tuple[float, float] | None:
        """Return where a test has decided that chance sets a spot this time; None: chance decides."""
        places = self._decided_spots.get(spot)
        return places.pop(0) if places else None

    def undecided_spots(self) -> dict[str, int]:
        """Return how many of the places that a test decided have not come, by spot."""
        return {name: len(left) for name, left in self._decided_spots.items() if left}

    def kept(self) -> dict[str, dict[str, object]]:
        """Return what lives on of draws, flags and counters, for the next half's `HalfInfo.kept`."""
        counters: dict[str, object] = {
            name: dict(value) if isinstance(value, dict) else value
            for name, value in self.counters.items()
            if self.scenario.counters[name].keep == "match"
        }
        undrawn: dict[str, object] = {
            name: list(left) for name, left in self._undrawn.items() if self.scenario.draws[name].not_again == "match"
        }
        return {
            "draws": {name: self.draws[name] for name, draw in self.scenario.draws.items()
                      if draw.keep == "match" and name in self.draws},
            "flags": {name: self.flags[name] for name, flag in self.scenario.flags.items() if flag.keep == "match"},
            **({"undrawn": undrawn} if undrawn else {}),
            **({"counters": counters} if counters else {}),
        }  # fmt: skip

    def follow_way(self, entity: int) -> None:
        """Add up the way of an entity from now on."""
        self.ways.setdefault(entity, 0.0)

    def add_ways(self) -> None:
        """Add the ways of the last tick; where something was put, its way begins."""
        for entity in self.ways:
            (x, y, _), (was_x, was_y, _) = self.poses[entity], self.before[entity]
            self.ways[entity] += sqrt((x - was_x) ** 2 + (y - was_y) ** 2)

    def phase_model(self, name: str) -> Phase:
        """Return a phase of the scenario; ``play`` need not be written."""
        return self.scenario.phases.get(name) or Phase()

    def counter(self, name: str, entity: str | None) -> Number:
        """Return a counter; one kept per entity without an entity is the sum; an entrant's name is its score."""
        value = self.counters.get(name)
        if value is None:
            return self.scores[name]
        if isinstance(value, dict):
            return value[entity] if entity is not None else on_paper(sum(value.values()))
        return value

    def flag(self, name: str, entity: str | None) -> bool:
        """Return a flag; one kept per entity without an entity is whether any of them is set."""
        value = self.flags[name]
        if isinstance(value, dict):
            return value[entity] if entity is not None else any(value.values())
        return value

    def half_length_s(self) -> Number:
        """Return the length of the half in s as the record prints it.

        The scenario's own number (600, as in the original's log) unless the half is played at another length.
        """
        nominal = half_length_s(self.scenario.match, self.half.half)
        return plain(nominal if ticks_from_s(nominal) == self.half.ticks else s_from_ticks(self.half.ticks))

    def seed_id(self) -> str:
        """Return eight hexadecimal digits that tell two seeds apart without telling the seed."""
        return f"{stream_seed(self.half.match_seed, 'seed_id') & 0xFFFFFFFF:08x}"
