"""Lint of attempts that are judged twice: once by a rule, and a tick apart by the timer of the same attempt.

An event is heard one tick later. A rule that judges and leaves it to the one that hears its event to end the attempt
leaves a tick in which the attempt still goes on: the timer may run out in it, and `exclusive` covers one tick only.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import product
from typing import NamedTuple

from rcj_challenges.facts.timing import TICK_S
from rcj_challenges.scenario.lint.logic import Way, exclude, ways_to_hold
from rcj_challenges.scenario.lint.suspect import Subject, Suspect, lengths_s, lives_in
from rcj_challenges.scenario.models.actions import (
    Count,
    DrawAction,
    Emit,
    End,
    Score,
    SetFlag,
    SetPhase,
    TimerAction,
    ToggleFlag,
)
from rcj_challenges.scenario.models.conditions import Condition, CounterIs, Drawn, FlagIs, TimerIs
from rcj_challenges.scenario.models.scenario import Rule
from rcj_challenges.scenario.models.triggers import Holds, OnEvent, TimerExpired

_OF_ANOTHER_ATTEMPT = ("restart", "reset", "stop")


class _Attempt(NamedTuple):
    """Two rules that judge an attempt, and the one that ends it a tick later.

    Attributes:
        timer: the timer of the attempt.
        outcome: the rule that judges before the time is up.
        too_late: the rule that judges when the timer has run out.
        after: the rule that hears the event of the outcome and ends the attempt.
        event: that event.
    """

    timer: str
    outcome: str
    too_late: str
    after: str
    event: str


def check_judged_twice(subject: Subject) -> Iterator[Suspect]:
    """Rules that judge an attempt and leave it to another, which hears their event a tick later, to end it."""
    rules = dict(subject.standing())
    reported: set[str] = set()
    for attempt in _attempts(rules):
        late = _late_event(attempt, rules)
        if attempt.outcome not in reported and _goes_on(attempt, rules) and _can_follow(attempt, subject):
            reported.add(attempt.outcome)
            yield _twice(
                attempt.outcome,
                f"'{attempt.after}', which hears {attempt.event} one tick later, ends the attempt: the timer "
                f"'{attempt.timer}' may run out in that tick, and then '{attempt.too_late}' judges too",
                f"end it in this rule: {{action: timer, timer: {attempt.timer}, do: stop}}, or set_phase",
            )
        if late and attempt.too_late not in reported and _comes_late(attempt, rules) and _can_come(attempt, subject):
            reported.add(attempt.too_late)
            yield _twice(
                attempt.too_late,
                f"'{attempt.after}', which hears {late} one tick later, ends the attempt: in that tick "
                f"'{attempt.outcome}' may judge too",
                f"let that rule ask {{condition: timer, timer: {attempt.timer}}}, which holds while the timer runs, or "
                "set_phase in this one",
            )


def _twice(rule: str, reason: str, remedy: str) -> Suspect:
    return Suspect("judged_twice", ("rules", rule), f"it judges, and {reason}", remedy, at_key=True)


def _attempts(rules: Mapping[str, Rule]) -> Iterator[_Attempt]:
    for too_late, timer in _judged_by_time(rules):
        for outcome, rule in rules.items():
            if outcome != too_late and _judges(rule) and timer not in _timers(rule):
                for after, event in _afterwards(rule, rules):
                    yield _Attempt(timer, outcome, too_late, after, event)


def _late_event(attempt: _Attempt, rules: Mapping[str, Rule]) -> str | None:
    """Return the event of the rule of the time that the rule which ends the attempt hears as well."""
    heard = _afterwards(rules[attempt.too_late], rules)
    return next((event for after, event in heard if after == attempt.after), None)


def _judged_by_time(rules: Mapping[str, Rule]) -> Iterator[tuple[str, str]]:
    """Yield the rules that judge when a timer has run out, each with its timer."""
    for name, rule in rules.items():
        if _judges(rule):
            yield from ((name, timer) for timer in dict.fromkeys(_timers(rule)))


def _timers(rule: Rule) -> Iterator[str]:
    return (trigger.timer for trigger in rule.triggers if isinstance(trigger, TimerExpired))


def _judges(rule: Rule) -> bool:
    return any(isinstance(action, Score | Count) for action in rule.actions)


def _afterwards(rule: Rule, rules: Mapping[str, Rule]) -> Iterator[tuple[str, str]]:
    """Yield the rules that hear what a rule emits, each with the event."""
    for action in rule.actions:
        if isinstance(action, Emit):
            yield from ((name, action.event) for name, one in rules.items() if _hears(one, action.event))


def _hears(rule: Rule, event: str) -> bool:
    return any(isinstance(trigger, OnEvent) and trigger.event == event for trigger in rule.triggers)


# --- whether the attempt goes on for a tick ---------------------------------------------------------------------------


def _goes_on(attempt: _Attempt, rules: Mapping[str, Rule]) -> bool:
    """Return whether only the rule that hears the event ends the attempt, and no rule of the outcome's moment."""
    after, too_late = rules[attempt.after], rules[attempt.too_late]
    if any(_sets(rule, attempt.timer) or _ends(rule, too_late) for rule in _at_once(attempt.outcome, rules)):
        return False
    if _sets(after, attempt.timer):
        return True
    # Leaving the phase may have to do with other things than the attempt, unless the time being up does it as well.
    return _ends(after, too_late) and (_late_event(attempt, rules) is not None or _ends(too_late, too_late))


def _comes_late(attempt: _Attempt, rules: Mapping[str, Rule]) -> bool:
    """Return whether the attempt goes on for a tick when its time is up."""
    after, outcome = rules[attempt.after], rules[attempt.outcome]
    if any(_sets(rule, attempt.timer) or _ends(rule, outcome) for rule in _at_once(attempt.too_late, rules)):
        return False
    return _sets(after, attempt.timer) or _ends(after, outcome)


def _at_once(name: str, rules: Mapping[str, Rule]) -> Iterator[Rule]:
    """Yield a rule, and those that are set off by the same."""
    triggers = rules[name].triggers
    return (rule for rule in rules.values() if any(trigger in triggers for trigger in rule.triggers))


def _sets(rule: Rule, timer: str) -> bool:
    return any(
        isinstance(action, TimerAction) and action.timer == timer and action.do in _OF_ANOTHER_ATTEMPT
        for action in rule.actions
    )


def _ends(rule: Rule, other: Rule) -> bool:
    """Return whether a rule ends the half, or enters a phase in which another rule does not live."""
    return any(
        isinstance(action, End) or (isinstance(action, SetPhase) and not lives_in(other, action.phase))
        for action in rule.actions
    )


# --- whether both can judge -------------------------------------------------------------------------------------------


def _can_follow(attempt: _Attempt, subject: Subject) -> bool:
    """Return whether the time can be up in the tick after the outcome."""
    rules = subject.scenario.rules
    outcome, too_late = rules[attempt.outcome], rules[attempt.too_late]
    if _always_holds_by(outcome, lambda one: _keeps_from_end(one, attempt.timer, subject)):
        return False
    ways = ways_to_hold(outcome.conditions) or ()
    sooner = [way for way in ways if not any(_keeps_from_end(one, attempt.timer, subject) for one in way)]
    return _can_come_after(outcome, sooner, too_late, ways_to_hold(too_late.conditions) or (), subject)


def _can_come(attempt: _Attempt, subject: Subject) -> bool:
    """Return whether the outcome can come in the tick after the time was up."""
    rules = subject.scenario.rules
    outcome, too_late = rules[attempt.outcome], rules[attempt.too_late]
    if _always_holds_by(outcome, lambda one: _asks_for_running(one, attempt.timer)):
        return False
    ways = ways_to_hold(outcome.conditions) or ()
    later = [way for way in ways if not any(_asks_for_running(one, attempt.timer) for one in way)]
    return _can_come_after(too_late, ways_to_hold(too_late.conditions) or (), outcome, later, subject)


def _always_holds_by(rule: Rule, keeps: Callable[[Condition], bool]) -> bool:
    """Return whether a rule fires only by what holds in that very tick, and a part of it keeps the two apart."""
    for trigger in rule.triggers:
        # An interruption that counts as holding lets it fire while the condition does not hold.
        if not isinstance(trigger, Holds) or trigger.grace_s >= TICK_S:
            return False
        ways = ways_to_hold((trigger.condition,))
        if ways is None or not all(any(keeps(one) for one in way) for way in ways):
            return False
    return True


def _can_come_after(first: Rule, ways: Sequence[Way], then: Rule, other_ways: Sequence[Way], subject: Subject) -> bool:
    """Return whether a rule can fire in the tick after another, as far as phases and conditions tell."""
    entered = [action.phase for action in first.actions if isinstance(action, SetPhase)]
    phases = entered[-1:] or _fires_in(first, subject)
    if not any(lives_in(then, phase) for phase in phases):
        return False
    if any(_is_changed(condition, first) for condition in then.conditions):
        return False
    return any(
        not any(exclude(one, other, (first, then), subject) for one, other in product(way, other_way))
        for way, other_way in product(ways, other_ways)
    )


def _fires_in(rule: Rule, subject: Subject) -> list[str]:
    """Return the phases in which a rule may fire: what hears events only comes a tick after them."""
    lived = [phase for phase in subject.reached if lives_in(rule, phase)]
    events = {trigger.event for trigger in rule.triggers if isinstance(trigger, OnEvent)}
    if not all(isinstance(trigger, OnEvent) for trigger in rule.triggers):
        return lived
    heard: set[str] = set()
    for _, other in subject.standing():
        if any(isinstance(action, Emit) and action.event in events for action in other.actions):
            entered = [action.phase for action in other.actions if isinstance(action, SetPhase)]
            before = {phase for phase in subject.reached if lives_in(other, phase)}
            heard |= set(entered[-1:]) or before | {to for here, to in subject.transitions if here in before}
    return [phase for phase in lived if phase in heard]


def _is_changed(condition: Condition, first: Rule) -> bool:
    """Return whether a condition asks for what the first rule changes: a flag that says that it was judged already."""
    parts = getattr(condition, "conditions", ())
    if parts:
        return any(_is_changed(part, first) for part in parts)
    changed: set[tuple[str, str]] = set()
    for action in first.actions:
        match action:
            case SetFlag() | ToggleFlag():
                changed.add(("flag", action.flag))
            case Count():
                changed.add(("counter", action.counter))
            case DrawAction():
                changed.add(("draw", action.draw))
    match condition:
        case FlagIs():
            return ("flag", condition.flag) in changed
        case CounterIs():
            return ("counter", condition.counter) in changed
        case Drawn():
            return ("draw", condition.draw) in changed
    return False


def _keeps_from_end(condition: Condition, timer: str, subject: Subject) -> bool:
    """Return whether a condition lets the outcome come only when the timer does not run out in the next tick."""
    if not isinstance(condition, TimerIs) or condition.timer != timer:
        return False
    bounds = (condition.at_least, condition.at_most, condition.equals)
    if condition.negate:
        return bounds == (None, None, None)
    latest = next((one for one in (condition.equals, condition.at_most) if isinstance(one, int | float)), None)
    shortest = min(lengths_s(subject.scenario.timers[timer].lasts_s, subject.scenario), default=0.0)
    return latest is not None and latest < shortest - TICK_S


def _asks_for_running(condition: Condition, timer: str) -> bool:
    """Return whether a condition holds only while a timer runs, or before it has run out."""
    if not isinstance(condition, TimerIs) or condition.timer != timer:
        return False
    plain = (condition.at_least, condition.at_most, condition.equals) == (None, None, None)
    return plain and not condition.negate
