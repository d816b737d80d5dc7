"""The timeline of a run, built tick by tick: events with their causes, score, phases, held robots, counters that rank.

The referee's output of a match that is played, and the log of one that was recorded, give the same timeline. Replay
page, live page, premiere, video, statistics and the commentary in a terminal are made from it.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from rcj_challenges.core.amounts import Score, round_score
from rcj_challenges.core.changes import Change, CountersChange, HeldChange, PhaseChange, ScoreChange
from rcj_challenges.core.grouping import grouped
from rcj_challenges.core.play import Event, Fault, Firing, HalfInfo
from rcj_challenges.records.referee_log import RefereeLog
from rcj_challenges.records.reflog import PROGRAM_FAULT
from rcj_challenges.records.trajectory import HalfTrack
from rcj_challenges.rules.effects import Emits
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.views.standing import RankingCounters

POINTS = "POINTS"
"""Name of what stands in the timeline for points that a rule gives without an event."""

MAX_UNANNOUNCED = 300
"""Of points without an event, for each rule and half: a rule that scores in each tick would bury everything else."""


@dataclass(frozen=True, slots=True)
class TimelineEvent:
    """An event, and why it happened.

    Attributes:
        half: from 1.
        tick: when it happened; for a program's failure the tick in which it failed: the referee learns of it in the
            next one.
        name: of the event; `POINTS` for points without one.
        cause: the firing that emitted it; None for a program's failure, or if the log has lost it.
        is_first: whether it is the first event of its cause: the score changes once, also by a rule with several.
        score: by team, after its cause; without one, after the tick.
    """

    half: int
    tick: int
    name: str
    payload: Mapping[str, Any]
    cause: Firing | None
    fault: Fault | None
    is_first: bool
    score: Mapping[str, Score]

    @property
    def scored(self) -> Mapping[str, Score]:
        """Points that its cause gave, by seat."""
        return {} if self.cause is None else self.cause.scored


Changes = dict[str, list[list[Any]]]
"""By what changes, a row for each change, as pages have it: its tick, then what it is now.

``score_changes`` and ``counted`` are by team, ``phases`` with whether a kick-off is awaited; ``held`` names robots.
"""
CHANGES = ("score_changes", "counted", "phases", "held")


@dataclass
class HalfTimeline:
    """One half, and what changed in it."""

    info: HalfInfo
    changes: Changes = field(default_factory=lambda: {name: [] for name in CHANGES})


@dataclass
class Timeline:
    """A run: halves by number, and the events of all halves, in order."""

    halves: dict[int, HalfTimeline] = field(default_factory=dict)
    events: list[TimelineEvent] = field(default_factory=list)


class TimelineBuilder:
    """Builds a timeline from the referee's output, tick by tick."""

    def __init__(self, scenario: Scenario, max_unannounced: int = MAX_UNANNOUNCED) -> None:
        """Begin a run; of points without an event, the first ones of each rule and half are in the timeline."""
        self.timeline = Timeline()
        self._max_unannounced = max_unannounced
        self._emitted = {name: [one.event for one in rule.effects(Emits)] for name, rule in scenario.rules.items()}
        self._ranking = RankingCounters(scenario)
        self._unannounced: Counter[str] = Counter()
        self._half: HalfTimeline
        self._score: Mapping[str, Score] = {}
        self._after: dict[int, Mapping[str, Score]] = {}

    def begin_half(self, half: HalfInfo) -> None:
        """Begin a half; its ticks follow."""
        self._score = {half.teams[seat]: points for seat, points in half.scores.items()}
        self._half = self.timeline.halves[half.half] = HalfTimeline(half)
        self._unannounced.clear()
        self._ranking.begin(half)

    def add(
        self,
        events: Iterable[Event],
        firings: Iterable[Firing],
        changes: Iterable[Change],
        faults: Iterable[Fault] = (),
    ) -> tuple[list[TimelineEvent], Changes]:
        """Add a tick, or what follows the last one of a half; faults are also among the events.

        Returns what was added to the timeline; points without an event come last.
        """
        before, news = self._score, grouped(self._rows(changes))
        for name, rows in news.items():
            self._half.changes[name] += rows
        ran = [firing for firing in firings if firing.suppressed is None]
        self._add_up(before, ran)
        found = [*self._joined(events, ran, {fault.robot: fault for fault in faults}), *self._points(ran)]
        self.timeline.events += found
        return found, news

    def _add_up(self, score: Mapping[str, Score], firings: Iterable[Firing]) -> None:
        """Note the score after each of several rules that scored in a tick; the last one made that of the tick."""
        self._after.clear()
        scoring = [firing for firing in firings if any(firing.scored.values())]
        for firing in scoring[:-1]:
            points = {self._half.info.teams.get(seat, seat): number for seat, number in firing.scored.items()}
            score = {team: round_score(number + points.get(team, 0)) for team, number in score.items()}
            self._after[id(firing)] = score

    def _rows(self, changes: Iterable[Change]) -> Iterator[tuple[str, list[Any]]]:
        teams = self._half.info.teams
        for change in changes:
            match change:
                case PhaseChange(tick, phase, is_waiting):
                    yield "phases", [tick, phase, is_waiting]
                case HeldChange(tick, robots):
                    yield "held", [tick, list(robots)]
                case ScoreChange(tick, scores):
                    self._score = {teams[seat]: points for seat, points in scores.items() if seat in teams}
                    yield "score_changes", [tick, self._score]
                case CountersChange(tick, counters):
                    if (counted := self._ranking.by_team(counters)) is not None:
                        yield "counted", [tick, counted]

    def _joined(
        self, events: Iterable[Event], firings: Iterable[Firing], faults: Mapping[str, Fault]
    ) -> Iterator[TimelineEvent]:
        """Yield events with their causes: an event takes the first firing that emits it and is not taken yet."""
        waiting = grouped((name, firing) for firing in firings for name in self._emitted.get(firing.rule, ()))
        taken: list[Firing] = []
        for event in events:
            causes = waiting.get(event.name)
            cause = causes.pop(0) if causes else None
            fault = None
            if cause is None and event.name == PROGRAM_FAULT:
                fault = faults.get(str(event.payload.get("robot_name")))
            is_first = not any(cause is one for one in taken)
            taken += [] if cause is None else [cause]
            yield self._event(event, cause, fault, is_first=is_first)

    def _points(self, firings: Iterable[Firing]) -> Iterator[TimelineEvent]:
        """Yield the points that rules give without an event."""
        for firing in firings:
            if any(firing.scored.values()) and not self._emitted.get(firing.rule):
                self._unannounced[firing.rule] += 1
                if self._unannounced[firing.rule] <= self._max_unannounced:
                    yield self._event(Event(firing.tick, POINTS), firing, None, is_first=True)

    def _event(self, event: Event, cause: Firing | None, fault: Fault | None, *, is_first: bool) -> TimelineEvent:
        tick = event.tick if fault is None else fault.tick
        score = self._after.get(id(cause), self._score)
        return TimelineEvent(self._half.info.half, tick, event.name, event.payload, cause, fault, is_first, score)


def timeline_of(scenario: Scenario, halves: Iterable[HalfTrack], log: RefereeLog) -> Timeline:
    """Return the timeline of the halves of a recorded run; other halves in the log are ignored."""
    builder = TimelineBuilder(scenario)
    for half in halves:
        builder.begin_half(half.info)
        for one in log.ticks:
            if one.half == half.info.half:
                builder.add(one.events, one.firings, one.changes, half.faults.get(one.tick, ()))
    return builder.timeline
