"""Lint of what comes in the very tick in which another phase begins or the half ends: who lives no more is not told.

A rule that gives a point and begins a pause in one tick is the usual case. What hears the event of that rule hears it
one tick later, in the pause. What waits until the score is 5 finds it at 5 when the pause is over: it was so before.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import NamedTuple

from rcj_challenges.facts.timing import ticks_from_s
from rcj_challenges.scenario.catalogue import BOUND
from rcj_challenges.scenario.lint.logic import range_of
from rcj_challenges.scenario.lint.suspect import Subject, Suspect, lengths_s, lives_in
from rcj_challenges.scenario.models.actions import (
    Action,
    Count,
    DrawAction,
    Emit,
    End,
    Hold,
    Score,
    SetFlag,
    SetPhase,
    ToggleFlag,
)
from rcj_challenges.scenario.models.conditions import AllOf, AnyOf, Condition, CounterIs, Drawn, FlagIs, IsHeld
from rcj_challenges.scenario.models.scenario import Rule
from rcj_challenges.scenario.models.triggers import HalfEnded, Holds, OnEvent, Trigger
from rcj_challenges.scenario.tree import Path, node_at

_Makes = Callable[[Action], bool]
"""Whether an action may make what a rule waits for."""


class _Source(NamedTuple):
    """A rule from which comes what another one waits for.

    Attributes:
        name: of the rule.
        entered: the phase that it enters in the same tick, None: it enters none.
        is_last: whether the half is over with it.
        heard: whether the other one hears it.
    """

    name: str
    entered: str | None
    is_last: bool
    heard: bool


def check_unheard(subject: Subject) -> Iterator[Suspect]:
    """Events and conditions that come with a phase in which the rule that waits for them does not live."""
    for name, rule in subject.standing():
        for index, trigger in enumerate(rule.triggers):
            sources = _sources(trigger, rule, subject)
            unheard = [source for source in sources if not source.heard]
            path: Path = ("rules", name, "triggers", index)
            if unheard and len(unheard) == len(sources):
                yield _suspect("rule_never_fires", path, rule, trigger, unheard[0], subject)
                continue
            # Of what comes at the end as well, the end is hardly waited for.
            missed = [source for source in unheard if not source.is_last]
            chosen = node_at(subject.tree, ("rules", name, "phases")) is not None
            if missed and not (chosen or _is_heard_elsewhere(trigger, name, subject)):
                yield _suspect("moment_may_be_missed", path, rule, trigger, missed[0], subject)


def _suspect(kind: str, path: Path, rule: Rule, trigger: Trigger, source: _Source, subject: Subject) -> Suspect:
    when = _HEARD_LATER if isinstance(trigger, OnEvent) else _ONCE
    if source.is_last:
        remedy = f"do it in rule '{source.name}' itself, or wait for half_ended"
        return Suspect(kind, path, f"{when}; with rule '{source.name}' the half is over", remedy)
    if source.entered is None:
        reason = f"{when}; rule '{source.name}' brings that about in a phase in which this rule does not live"
    else:
        then = "which begins anew" if lives_in(rule, source.entered) else "in which this rule does not live"
        reason = f"{when}; with rule '{source.name}' phase {source.entered} begins, {then}"
    alive = rule.phases if isinstance(rule.phases, tuple) else ()
    brought = subject.scenario.rules[source.name].phases if isinstance(trigger, OnEvent) else ()
    then_on = (source.entered,) if source.entered is not None else brought if isinstance(brought, tuple) else ()
    more = [phase for phase in then_on if phase not in alive]
    remedy = f"write phases: [{', '.join((*alive, *more))}], or phases: any" if more else "write phases: any, or for_s:"
    return Suspect(kind, path, reason, remedy)


_HEARD_LATER = "an event is heard one tick later"
_ONCE = "holds without for_s fires only in the moment in which its condition comes true"


def _is_heard_elsewhere(trigger: Trigger, name: str, subject: Subject) -> bool:
    """Return whether another rule waits for the same and misses nothing of it."""
    return any(
        other != name and trigger in rule.triggers and all(source.heard for source in _sources(trigger, rule, subject))
        for other, rule in subject.standing()
    )


def _sources(trigger: Trigger, hearer: Rule, subject: Subject) -> list[_Source]:
    """Return the rules from which comes what a trigger waits for, if that is all that it depends on."""
    makes = _what_makes(trigger, subject)
    if makes is None:
        return []
    hears = _hears_event if isinstance(trigger, OnEvent) else _hears_change
    found = []
    for name, rule in subject.standing():
        if any(makes(action) for action in rule.actions):
            entered = [action.phase for action in rule.actions if isinstance(action, SetPhase)]
            last = entered[-1] if entered else None
            is_last = _is_last(rule)
            heard = not is_last and hears(hearer, rule, last, subject)
            found.append(_Source(name, last, is_last, heard))
    return found


def _is_last(rule: Rule) -> bool:
    """Return whether the half is over with a rule."""
    ends = any(isinstance(action, End) for action in rule.actions)
    return ends or all(isinstance(trigger, HalfEnded) for trigger in rule.triggers)


def _hears_event(hearer: Rule, source: Rule, entered: str | None, subject: Subject) -> bool:
    """Return whether a rule may hear an event one tick later, in the phase that its source has entered, or lives in."""
    if entered is None:
        phases = [phase for phase in subject.reached if lives_in(source, phase)]
        return any(lives_in(hearer, later) for phase in phases for later in _a_tick_later(phase, subject))
    if lives_in(hearer, entered) or _may_pass_at_once(entered, subject):
        return True
    # What fires in the same tick, and lives in the new phase too, may lead on to another one.
    return any(
        lives_in(other, entered) and isinstance(action, SetPhase) and lives_in(hearer, action.phase)
        for _, other in subject.standing()
        if any(lives_in(other, phase) and lives_in(source, phase) for phase in subject.reached - {entered})
        for action in other.actions
    )


def _a_tick_later(phase: str, subject: Subject) -> frozenset[str]:
    """Return the phases that may go on a tick after something came in a phase."""
    following = {to for here, to in subject.transitions if here == phase}
    # What lives in a phase and in the one that follows may fire in the same tick, and lead on.
    onward = {
        action.phase
        for _, rule in subject.standing()
        if lives_in(rule, phase) and any(lives_in(rule, then) for then in following)
        for action in rule.actions
        if isinstance(action, SetPhase)
    }
    at_once = {to for here, to in subject.transitions if here in following and _may_pass_at_once(here, subject)}
    return frozenset({phase, *following, *onward, *at_once})


def _may_pass_at_once(phase: str, subject: Subject) -> bool:
    model = subject.scenario.phases.get(phase)
    if model is None or model.lasts_s is None:
        return False
    return any(ticks_from_s(length) <= 1 for length in lengths_s(model.lasts_s, subject.scenario))


def _hears_change(hearer: Rule, source: Rule, entered: str | None, subject: Subject) -> bool:
    """Return whether a rule lives before and after what its source changes, and does not begin anew between."""
    together = [phase for phase in subject.reached if lives_in(hearer, phase) and lives_in(source, phase)]
    return any(entered is None or (lives_in(hearer, entered) and entered != phase) for phase in together)


def _what_makes(trigger: Trigger, subject: Subject) -> _Makes | None:
    """Return which actions make what a trigger waits for; None: it depends on more than what rules do."""
    if isinstance(trigger, OnEvent):
        return lambda action: isinstance(action, Emit) and action.event == trigger.event
    if isinstance(trigger, Holds) and trigger.for_s == 0 and trigger.every_s is None:
        return _what_makes_true(trigger.condition, subject)
    return None


def _what_makes_true(condition: Condition, subject: Subject) -> _Makes | None:
    match condition:
        case CounterIs():
            return _what_counts(condition, subject)
        case FlagIs(flag=flag):
            return lambda action: turns_flag(action, flag, to=asks_for_some(condition))
        case IsHeld() if asks_for_some(condition) and _only_rules_hold(subject):
            return lambda action: isinstance(action, Hold)
        case Drawn(negate=False):
            return lambda action: (
                isinstance(action, DrawAction)
                and action.draw == condition.draw
                and (action.as_ in (None, condition.equals) or bool({action.as_, condition.equals} & {*BOUND}))
            )
        case AnyOf(negate=False, conditions=several) | AllOf(negate=False, conditions=several):
            makers = [_what_makes_true(one, subject) for one in several]
            known = [one for one in makers if one is not None]
            return (lambda action: any(one(action) for one in known)) if len(known) == len(makers) else None
        case _:
            return None


def asks_for_some(condition: FlagIs | IsHeld) -> bool:
    """Return whether a condition waits for one to be so, and not for one that no longer is."""
    return (condition.of == "none") == condition.negate


def _only_rules_hold(subject: Subject) -> bool:
    return all(phase.robots != "held" for phase in subject.scenario.phases.values())


def turns_flag(action: Action, flag: str, *, to: bool) -> bool:
    """Return whether an action may make a flag, of whomever, set or not set."""
    if isinstance(action, SetFlag):
        return action.flag == flag and action.to == to
    return isinstance(action, ToggleFlag) and action.flag == flag


def _what_counts(condition: CounterIs, subject: Subject) -> _Makes | None:
    bounds = (condition.at_least, condition.at_most, condition.equals)
    if not all(isinstance(bound, int | float | None) for bound in bounds):
        return None  # the bound may change as well
    up = condition.at_most is not None if condition.negate else condition.at_least is not None
    down = condition.at_least is not None if condition.negate else condition.at_most is not None
    either = up == down  # between two bounds, at one value, or other than 0
    counter = subject.scenario.counters.get(condition.counter)
    # Of one that is kept for each of several the sum may reach it, whatever it is set to for one of them.
    is_one = counter is not None and counter.per is None
    least, most = range_of(condition)

    def makes(action: Action) -> bool:
        bounded = isinstance(action, Count) and (action.at_least, action.at_most) != (None, None)
        if isinstance(action, Count) and isinstance(action.to, int | float) and not bounded and is_one:
            holds = least <= action.to <= most
            return action.counter == condition.counter and holds != condition.negate
        return _changes(action, condition.counter, subject, up=up or either, down=down or either)

    return makes


def _changes(action: Action, counter: str, subject: Subject, *, up: bool, down: bool) -> bool:
    """Return whether an action may change a counter, or an entrant's score, in a way that is asked for."""
    by: object
    if isinstance(action, Count) and action.counter == counter:
        by = 1 if action.by is None and action.to is None else action.by
    elif isinstance(action, Score) and _may_get(action, counter, subject):
        by = action.points
    else:
        return False
    if not isinstance(by, int | float) or action.at_least is not None or action.at_most is not None:
        return True
    return (up and by > 0) or (down and by < 0)


def _may_get(action: Score, entrant: str, subject: Subject) -> bool:
    """Return whether an entrant may get these points: `each`, `other`, the last to touch may be anybody's robot."""
    is_known = isinstance(action.entrant, str) and action.entrant not in BOUND
    return action.entrant == entrant if is_known else entrant in subject.scenario.entrants
