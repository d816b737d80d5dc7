"""Lint of moments that a rule cannot hear: a time that comes while it does not live.

A phase is entered at some time and is over some time later. How early and how late that can be follows from the phases
themselves where they end by themselves; where a rule decides it, it may be at any time.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import NamedTuple

from rcj_challenges.facts.timing import ticks_from_s
from rcj_challenges.scenario.errors import listing
from rcj_challenges.scenario.halves import longest_half_s
from rcj_challenges.scenario.lint.suspect import Subject, Suspect, lengths_s, lives_in
from rcj_challenges.scenario.models.actions import SetPhase, TimerAction
from rcj_challenges.scenario.models.scenario import Rule
from rcj_challenges.scenario.models.state import Phase
from rcj_challenges.scenario.models.triggers import TimeReached, TimerExpired, Trigger
from rcj_challenges.scenario.tree import Path, node_at

_NEVER = float("inf")
_MOST_VISITS = 200
"""Of phases that follow each other more often than this nothing is said."""


def check_moments(subject: Subject) -> Iterator[Suspect]:
    """Times that come when the rule that waits for them does not live, or may not."""
    by_clock, by_ticks = _Course(subject, of_clock=True), _Course(subject, of_clock=False)
    for name, rule in subject.standing():
        for index, trigger in enumerate(rule.triggers):
            at_s = time_of(trigger, subject)
            if at_s is None:
                continue
            course = by_clock if isinstance(trigger, TimeReached) else by_ticks
            if course.visits is None:
                continue
            going_on = course.going_on(ticks_from_s(at_s))
            path: Path = ("rules", name, "triggers", index)
            if not any(lives_in(rule, phase) for phase in going_on):
                later = _later_ticks(trigger, subject)
                if not any(lives_in(rule, phase) for tick in later for phase in course.going_on(tick)):
                    yield _never(path, at_s, rule, going_on)
            elif not _comes_again(trigger) and node_at(subject.tree, ("rules", name, "phases")) is None:
                missed = [phase for phase in going_on if not _is_heard_in(phase, trigger, subject)]
                if missed:
                    yield _missed(path, at_s, rule, missed)


def _never(path: Path, at_s: float, rule: Rule, going_on: list[str]) -> Suspect:
    then = f"which at {at_s:g} s is not going on"
    return Suspect(
        "rule_never_fires",
        path,
        f"it lives only in phase {listing(rule.phases)}, {then}; what may be then is {listing(going_on)}"
        if going_on
        else f"it lives only in phase {listing(rule.phases)}, {then}",
        f"write phases: [{', '.join(going_on)}], or phases: any" if going_on else "correct the time, or the phases",
    )


def _missed(path: Path, at_s: float, rule: Rule, missed: list[str]) -> Suspect:
    lived = [*rule.phases, *missed]
    return Suspect(
        "moment_may_be_missed",
        path,
        f"it lives in play only, and {at_s:g} s may also come in phase {listing(missed)}: then it never fires",
        f"write phases: [{', '.join(lived)}], or phases: any; if that is meant, phases: [{', '.join(rule.phases)}]",
    )


def time_of(trigger: Trigger, subject: Subject) -> float | None:
    """Return the time in s for which a trigger waits, if it is always the same."""
    if isinstance(trigger, TimeReached):
        return trigger.at_s
    if not isinstance(trigger, TimerExpired):
        return None
    timer = subject.scenario.timers[trigger.timer]
    touched = any(isinstance(model, TimerAction) and model.timer == trigger.timer for model, _ in subject.models)
    if not timer.starts or touched or not isinstance(timer.lasts_s, int | float):
        return None
    return timer.lasts_s


def _comes_again(trigger: Trigger) -> bool:
    return isinstance(trigger, TimeReached) and trigger.every_s is not None


def _later_ticks(trigger: Trigger, subject: Subject) -> Iterator[int]:
    """Yield the ticks of the clock at which a time comes again."""
    if not isinstance(trigger, TimeReached) or trigger.every_s is None:
        return
    end, past = ticks_from_s(longest_half_s(subject.scenario.match)), 1
    while (tick := ticks_from_s(trigger.at_s + past * trigger.every_s)) <= end:
        yield tick
        past += 1


def _is_heard_in(phase: str, trigger: Trigger, subject: Subject) -> bool:
    """Return whether some rule waits for the same in a phase: then what is to happen there is said."""
    return any(lives_in(rule, phase) and trigger in rule.triggers for rule in subject.scenario.rules.values())


class _Visit(NamedTuple):
    """A time of a phase.

    Attributes:
        phase: which.
        first, last: the earliest and latest tick at which it is entered.
        by_rule: whether a rule enters it: what comes in that very tick is over then.
    """

    phase: str
    first: float
    last: float
    by_rule: bool


class _Course:
    """When phases can go on, in ticks of the half or of its clock."""

    def __init__(self, subject: Subject, *, of_clock: bool) -> None:
        self._subject = subject
        self._of_clock = of_clock
        self.phases = [name for name in dict.fromkeys(("play", *subject.scenario.phases)) if name in subject.reached]
        self._clock_stops = any(self._model(phase).clock == "stops" for phase in self.phases)
        in_clock_time = of_clock or not self._clock_stops
        self._end = ticks_from_s(longest_half_s(subject.scenario.match)) if in_clock_time else _NEVER

    @cached_property
    def visits(self) -> list[_Visit] | None:
        """All times of phases; None: too many to tell."""
        found: list[_Visit] = []
        todo = [_Visit(self._subject.scenario.first_phase, 0, 0, by_rule=False)]
        while todo:
            visit = todo.pop()
            if visit.first > self._end or any(_is_within(visit, other) for other in found):
                continue
            found.append(visit)
            if len(found) > _MOST_VISITS:
                return None
            todo += self._following(visit)
        return found

    def going_on(self, tick: int) -> list[str]:
        """Return the phases in which a tick may come."""
        heard = {visit.phase for visit in self.visits or () if self._hears(visit, tick)}
        return [phase for phase in self.phases if phase in heard]

    def _hears(self, visit: _Visit, tick: int) -> bool:
        if self._of_clock and self._model(visit.phase).clock == "stops":
            # The clock stands; only the tick with which the phase before is over may be that one.
            return not visit.by_rule and visit.first <= tick <= visit.last
        return visit.first + visit.by_rule <= tick < visit.last + self._lasts(visit.phase)[1]

    def _following(self, visit: _Visit) -> Iterator[_Visit]:
        shortest, longest = self._lasts(visit.phase)
        model = self._model(visit.phase)
        if model.lasts_s is not None:
            yield _Visit(model.next, visit.first + shortest, visit.last + longest, by_rule=False)
        for rule in self._subject.scenario.rules.values():
            entered = {action.phase for action in rule.actions if isinstance(action, SetPhase)}
            for low, high in self._fires(rule) if entered and lives_in(rule, visit.phase) else ():
                first, last = max(low, visit.first), min(high, visit.last + longest)
                yield from (_Visit(phase, first, last, by_rule=True) for phase in sorted(entered) if first <= last)

    def _fires(self, rule: Rule) -> Iterator[tuple[float, float]]:
        """Yield from when to when each trigger of a rule may fire."""
        for trigger in rule.triggers:
            at_s = time_of(trigger, self._subject)
            if at_s is None or _comes_again(trigger):
                yield 0, _NEVER
                continue
            tick = ticks_from_s(at_s)
            # A clock that stops lags behind the ticks.
            is_of_clock = isinstance(trigger, TimeReached)
            lags = self._clock_stops and is_of_clock != self._of_clock
            yield (0 if lags and not is_of_clock else tick), (_NEVER if lags and is_of_clock else tick)

    def _model(self, phase: str) -> Phase:
        return self._subject.scenario.phases.get(phase) or Phase()

    def _lasts(self, phase: str) -> tuple[float, float]:
        """Return how many ticks a phase lasts, at least and at most, if no rule ends it."""
        model = self._model(phase)
        if self._of_clock and model.clock == "stops":
            return 0, 0
        if model.lasts_s is None:
            return _NEVER, _NEVER
        ticks = [ticks_from_s(length) for length in lengths_s(model.lasts_s, self._subject.scenario)]
        return (min(ticks), max(ticks)) if ticks else (1, _NEVER)


def _is_within(visit: _Visit, other: _Visit) -> bool:
    return (
        (visit.phase, visit.by_rule) == (other.phase, other.by_rule)
        and other.first <= visit.first
        and visit.last <= other.last
    )
