"""Triggers at moments: the half, phases, times, timers, events, faults of programs."""

from __future__ import annotations

from rcj_challenges.facts.timing import s_from_ticks
from rcj_challenges.referee.compiling import Appointment, Workshop
from rcj_challenges.referee.conditions import compile_message
from rcj_challenges.referee.rules import Listener, StandingRule
from rcj_challenges.referee.state import Clock
from rcj_challenges.referee.watching import NEVER, DueWatch
from rcj_challenges.rules.triggers import (
    HalfEnded,
    HalfStarted,
    OnEvent,
    PhaseEntered,
    ProgramFault,
    Tells,
    TimeReached,
    TimerExpired,
)


def half_started(model: HalfStarted, rule: StandingRule, position: int, workshop: Workshop) -> None:
    """Fires at tick 0, after the draws."""
    workshop.moments.half_started.append(workshop.listener(rule, position, model.trigger))


def half_ended(model: HalfEnded, rule: StandingRule, position: int, workshop: Workshop) -> None:
    """Fires once after the last tick."""
    workshop.moments.half_ended.append(workshop.listener(rule, position, model.trigger))


def phase_entered(model: PhaseEntered, rule: StandingRule, position: int, workshop: Workshop) -> None:
    """Fires when a phase is entered: in the tick in which the one before ran out, or one tick after ``set_phase``."""
    listeners = workshop.moments.entered.setdefault(model.phase, [])
    listeners.append((model.from_, workshop.listener(rule, position, model.trigger)))


def time_reached(model: TimeReached, rule: StandingRule, position: int, workshop: Workshop) -> None:
    """Fires when the clock of the half reaches a time, and again every so often if asked."""
    workshop.moments.wait_for(Appointment(workshop.listener(rule, position, model.trigger), model.at_s, model.every_s))


def event(model: OnEvent, rule: StandingRule, position: int, workshop: Workshop) -> None:
    """Fires one tick after an event was emitted."""
    events, things = workshop.moments.events, workshop.roster.index
    about = (None,) if model.entity is None else workshop.members(model.entity, rule.each)
    for one in about:
        entity = None if one is None else things.get(one)  # a zone or a gate is none
        events.setdefault((model.event, one), []).append(workshop.listener(rule, position, model.trigger, entity))


def program_fault(model: ProgramFault, rule: StandingRule, position: int, workshop: Workshop) -> None:
    """Fires when a robot's program has failed."""
    for entity in workshop.entities(model.robot, rule.each):
        listener = workshop.listener(rule, position, model.trigger, entity)
        workshop.moments.faults.setdefault(workshop.roster.entities[entity], []).append(listener)


def tells(model: Tells, rule: StandingRule, position: int, workshop: Workshop) -> None:
    """Fires when a robot has told the referee something by radio."""
    says = compile_message(model, workshop)
    for entity in workshop.entities(model.entity, rule.each):
        listener = workshop.listener(rule, position, model.trigger, entity)
        workshop.moments.messages.setdefault(workshop.roster.entities[entity], []).append((says, listener))


def timer_expired(model: TimerExpired, rule: StandingRule, position: int, workshop: Workshop) -> None:
    """Fires when a timer reaches its length; of a timer per entity that of ``each``, else any of them."""
    clocks = workshop.state.timers[model.timer]
    own = rule.each if rule.each in clocks else None
    watch = workshop.watch(TimerWatch, (model.timer,), rule, lambda: TimerWatch(clocks, workshop))
    for member in clocks if own is None else (own,):
        whose = workshop.roster.index.get(member) if member is not None else None
        watch.listeners.setdefault(member, []).append(workshop.listener(rule, position, model.trigger, whose))


class TimerWatch(DueWatch):
    """Waits for the clocks of a timer to reach their length."""

    def __init__(self, clocks: dict[str | None, Clock], workshop: Workshop) -> None:
        self.listeners: dict[str | None, list[Listener]] = {}
        self._clocks = clocks
        self._state = workshop.state
        self._hits = workshop.hits

    @staticmethod
    def _end(clock: Clock) -> int:
        return NEVER if clock.since is None else clock.since + clock.length - clock.elapsed

    def restart(self) -> None:
        """Wait for what runs; what has run out before is past."""
        self.reckon()

    def reckon(self) -> None:
        """Find the next clock to run out."""
        ends = (self._end(clock) for clock in self._clocks.values())
        self.due = min((end for end in ends if end > self._state.tick), default=NEVER)

    def look(self) -> None:
        """Report the clocks that reach their length at this tick."""
        for member, clock in self._clocks.items():
            if self._end(clock) == self._state.tick:
                ran_s = s_from_ticks(clock.length)
                self._hits.report(self.listeners.get(member, []), ran_s, clock.length_s)
        self.reckon()
