"""Lint of times: limits longer than a half, halves not played, too short or over at once, what comes too late."""

from __future__ import annotations

import math
from collections.abc import Iterator

from rcj_challenges.facts.timing import TICK_S, ticks_from_s
from rcj_challenges.scenario.errors import listing
from rcj_challenges.scenario.halves import MOST_LENGTHS, clock_may_stop, half_lengths_s, longest_half_s
from rcj_challenges.scenario.lint.logic import range_of, ways_to_hold
from rcj_challenges.scenario.lint.moments import time_of
from rcj_challenges.scenario.lint.suspect import Subject, Suspect, lengths_s, lives_in
from rcj_challenges.scenario.models.actions import Emit, End, Hold, Remove, SetPhase
from rcj_challenges.scenario.models.base import Strict
from rcj_challenges.scenario.models.conditions import Condition, HalfIs
from rcj_challenges.scenario.models.scenario import Rule, Scenario
from rcj_challenges.scenario.models.state import CounterValue, DrawnDuration, Phase, Timer
from rcj_challenges.scenario.models.triggers import (
    HalfStarted,
    Holds,
    NoProgress,
    OnEvent,
    StaysIn,
    TimeReached,
    Touches,
)
from rcj_challenges.scenario.tree import Path

_NEVER = "it never fires"


def check_times(subject: Subject) -> Iterator[Suspect]:
    """Limits that are not over before the half is."""
    half_s, longest_s = longest_half_s(subject.scenario.match), _most_s(subject.scenario)
    for model, path in subject.models:
        by_clock = isinstance(model, TimeReached)
        half = ticks_from_s(half_s if by_clock else longest_s)
        after = f"{half_s:g} s"
        if not by_clock and longest_s > half_s:
            after = f"{longest_s:g} s at most, the time included for which its clock stops"
        for key, seconds, strict, consequence in _limits(model, subject.scenario):
            ticks = ticks_from_s(seconds) if seconds else 0
            if ticks > half or (strict and ticks == half):
                yield Suspect(
                    "limit_longer_than_the_half",
                    (*path, key),
                    f"{seconds:g} s is not over before the half is, after {after}: {consequence}",
                    "shorten it, or lengthen match.half_s",
                )


def _most_s(scenario: Scenario) -> float:
    """Return how long a half may be played, in s: longer than its length where a phase stops its clock."""
    return longest_half_s(scenario.match) * (MOST_LENGTHS if clock_may_stop(scenario) else 1)


def check_phase_limits(subject: Subject) -> Iterator[Suspect]:
    """Limits that are not over before the phase is in which the rule lives: what it follows begins anew then.

    Of those that are not over before the half is either `check_times` tells.
    """
    half = ticks_from_s(_most_s(subject.scenario))
    for name, rule in subject.standing():
        phases = sorted(phase for phase in subject.reached if lives_in(rule, phase))
        longest_s = _longest_s(phases, subject)
        for index, trigger in enumerate(rule.triggers):
            if not isinstance(trigger, StaysIn | NoProgress | Holds):
                continue
            ((key, seconds, _, consequence),) = _limits(trigger, subject.scenario)
            if longest_s is not None and seconds and half > ticks_from_s(seconds) >= ticks_from_s(longest_s):
                yield Suspect(
                    "limit_longer_than_the_phase",
                    ("rules", name, "triggers", index, key),
                    f"{seconds:g} s is not over before phase {listing(phases)} is, after {longest_s:g} s, and begins "
                    f"anew with the next one: {consequence}",
                    "shorten it, let the phase last longer, or let the rule live in more phases",
                )


def _longest_s(phases: list[str], subject: Subject) -> float | None:
    """Return how long one of some phases lasts at most, in s; None: as long as rules like, or one follows another."""
    follow = any(here != to and here in phases and to in phases for here, to in subject.transitions)
    lengths: list[float] = []
    for phase in phases:
        model = subject.scenario.phases.get(phase)
        found = lengths_s(model.lasts_s, subject.scenario) if model is not None and model.lasts_s is not None else ()
        if follow or not found:
            return None
        lengths += found
    return max(lengths, default=None)


def check_halves(subject: Subject) -> Iterator[Suspect]:
    """Conditions on a half that is not played."""
    halves = subject.scenario.match.halves
    for model, path in subject.models:
        if isinstance(model, HalfIs) and (model.equals or model.at_least or 1) > halves:
            played = "one half is" if halves == 1 else f"{halves} halves are"
            yield Suspect(
                "half_never_played",
                path,
                f"only {played} played: the condition {'always' if model.negate else 'never'} holds",
                "correct the number of the half, or raise match.halves",
            )


def check_reached(subject: Subject) -> Iterator[Suspect]:
    """Times that a shorter half does not reach."""
    lengths_s = half_lengths_s(subject.scenario.match)
    for name, rule in subject.standing():
        asked = _halves_of(rule, len(lengths_s))
        for index, trigger in enumerate(rule.triggers):
            # Beyond every half there are only times that a length on the command line has cut off.
            if not isinstance(trigger, TimeReached) or trigger.at_s > max(lengths_s):
                continue
            late = [half for half in asked if trigger.at_s > lengths_s[half - 1]]
            if late:
                yield _late(("rules", name, "triggers", index), trigger.at_s, late, never=late == asked)


def _late(path: Path, at_s: float, halves: list[int], *, never: bool) -> Suspect:
    which = f"half {halves[0]} is" if len(halves) == 1 else f"halves {', '.join(map(str, halves))} are"
    before = f"{which} over before {at_s:g} s"
    if never:
        reason = f"{before}, and the rule asks for no other: it never fires"
        return Suspect("rule_never_fires", path, reason, "correct the time, or the half")
    return Suspect(
        "time_not_in_every_half",
        path,
        f"{before}: it does not fire there",
        "correct the time, or say which halves are meant: {condition: half, …}",
    )


def check_ends(subject: Subject) -> Iterator[Suspect]:
    """Rules that end a half, or the match, in the moment in which it begins, whatever there is to play."""
    halves = subject.scenario.match.halves
    standing = list(subject.standing())
    enter = any(_hears_the_start(rule) and any(isinstance(a, SetPhase) for a in rule.actions) for _, rule in standing)
    for name, rule in standing:
        ends = [action.what for action in rule.actions if isinstance(action, End)]
        asked = _halves_of(rule, halves)
        surely = all(isinstance(condition, HalfIs) for condition in rule.conditions) and not (rule.exclusive or enter)
        if not ends or not asked or not surely or not lives_in(rule, subject.scenario.first_phase):
            continue
        if rule.for_each is not None and not subject.roster.expand(rule.for_each):
            continue
        for index, trigger in enumerate(rule.triggers):
            if isinstance(trigger, HalfStarted):
                yield _over_at_once(("rules", name, "triggers", index), asked, halves, of_match="match" in ends)


def _hears_the_start(rule: Rule) -> bool:
    return any(isinstance(trigger, HalfStarted) for trigger in rule.triggers)


def _over_at_once(path: Path, asked: list[int], halves: int, *, of_match: bool) -> Suspect:
    every = len(asked) == halves
    if of_match:
        what, begins = "the match", "it begins" if asked[0] == 1 else f"half {asked[0]} begins"
    else:
        some = f"half {asked[0]}" if len(asked) == 1 else f"each of the halves {', '.join(map(str, asked))}"
        what, begins = "the half" if halves == 1 else "each half" if every else some, "it begins"
    where = "" if every or (of_match and asked[0] == 1) else " in it"
    return Suspect(
        "over_as_it_begins",
        path,
        f"it ends {what} as {begins}: nothing can be played{where}",
        "wait for something that happens in play, or say by a condition when it is over",
    )


def _halves_of(rule: Rule, halves: int) -> list[int]:
    """Return the halves in which the conditions of a rule may hold."""
    ways = ways_to_hold(rule.conditions)
    played = range(1, halves + 1)
    if ways is None:
        return []  # too many to tell
    return [half for half in played if any(all(_may_hold_in(half, one) for one in way) for way in ways)]


def _may_hold_in(half: int, condition: Condition) -> bool:
    if not isinstance(condition, HalfIs):
        return True
    low, high = range_of(condition)
    return (low <= half <= high) != condition.negate


def check_last_tick(subject: Subject) -> Iterator[Suspect]:
    """Times that come with the last tick of a half, and an event of that tick that another rule waits for."""
    lengths_s = half_lengths_s(subject.scenario.match)
    heard = {
        trigger.event: name
        for name, rule in reversed(list(subject.standing()))
        for trigger in rule.triggers
        if isinstance(trigger, OnEvent)
    }
    # A clock that stops makes a half longer, in which a timer of its length runs out before the end.
    clock_stops = clock_may_stop(subject.scenario)
    for name, rule in subject.standing():
        waited = [action.event for action in rule.actions if isinstance(action, Emit) and action.event in heard]
        asked = _halves_of(rule, len(lengths_s)) if waited else []
        for index, trigger in enumerate(rule.triggers):
            at_s = time_of(trigger, subject)
            if at_s is None or (clock_stops and not isinstance(trigger, TimeReached)):
                continue
            if any(ticks_from_s(lengths_s[half - 1]) == ticks_from_s(at_s) for half in asked):
                yield Suspect(
                    "heard_after_the_end",
                    ("rules", name, "triggers", index),
                    f"{at_s:g} s is the last tick of the half; {waited[0]}, for which '{heard[waited[0]]}' waits, "
                    "would be heard one tick later: nobody hears it",
                    "do it in this rule itself, let the other one wait for half_ended, or choose an earlier time",
                )


def check_rests(subject: Subject) -> Iterator[Suspect]:
    """Rules that rest for as long as their trigger takes to repeat.

    What repeats comes at multiples of ``every_s``, each rounded to its tick: after 32 ticks and after 31, for 1 s. A
    rest is rounded up to 32, and so the repeat that comes sooner is lost. A longer rest is meant: "at most every 2 s".
    """
    for name, rule in subject.scenario.rules.items():
        for trigger in rule.triggers:
            every_s = trigger.every_s if isinstance(trigger, Holds | Touches | TimeReached) else None
            if every_s is None or rule.cooldown_s is None or rule.cooldown_s > every_s:
                continue
            soonest = math.floor(every_s / TICK_S + _EXACT)
            if ticks_from_s(rule.cooldown_s) > soonest:
                yield Suspect(
                    "cooldown_as_long_as_every_s",
                    ("rules", name, "cooldown_s"),
                    f"every_s: {every_s:g} repeats after {soonest} ticks at times, and the rest of "
                    f"{rule.cooldown_s:g} s takes {ticks_from_s(rule.cooldown_s)}: it swallows repeats",
                    "leave cooldown_s out, or make it clearly shorter than every_s",
                )
                break


_EXACT = 1e-9
"""Below a tick: 0.96 s are 30 ticks, whatever the division says."""


def _limits(model: Strict, scenario: Scenario) -> Iterator[tuple[str, float, bool, str]]:
    """Yield key, seconds, whether it must be strictly shorter than the half, and what follows if it is not."""
    match model:
        case StaysIn():
            yield "limit_s", model.limit_s, True, _NEVER
        case NoProgress():
            yield "within_s", model.within_s, True, _NEVER
        case Holds():
            yield "for_s", model.for_s, True, _NEVER
        case TimeReached(every_s=every_s) | Touches(every_s=every_s) if every_s is not None:
            yield _repeating(model, every_s)
        case Timer() if not isinstance(model.lasts_s, CounterValue):
            yield _lasting(model.lasts_s, scenario, "it never expires")
        case Phase() if model.lasts_s is not None and not isinstance(model.lasts_s, CounterValue):
            yield _lasting(model.lasts_s, scenario, "the phase never ends by itself")
        case Remove(for_s=for_s) if for_s is not None and not isinstance(for_s, CounterValue):
            yield _lasting(for_s, scenario, "what is taken off does not come back", "for_s")
        case Hold(for_s=for_s) if for_s is not None and not isinstance(for_s, CounterValue):
            yield _lasting(for_s, scenario, "who is held stays so until the half ends", "for_s")
        case Rule() if model.cooldown_s is not None:
            yield "cooldown_s", model.cooldown_s, False, "the rule fires once (max_executions: 1 says so)"


def _repeating(trigger: TimeReached | Touches, every_s: float) -> tuple[str, float, bool, str]:
    """Return the same of what a trigger that fires again waits for."""
    if isinstance(trigger, Touches):
        return "every_s", every_s, False, "it fires when the touch begins only (leave it out)"
    return "every_s", trigger.at_s + every_s, False, f"it fires once, at {trigger.at_s:g} s (leave every_s out)"


def _lasting(
    lasts_s: float | DrawnDuration, scenario: Scenario, consequence: str, key: str = "lasts_s"
) -> tuple[str, float, bool, str]:
    """Return the same of what lasts a time: of one that is drawn the longest."""
    if isinstance(lasts_s, DrawnDuration):
        return key, max(lengths_s(lasts_s, scenario)), False, f"{consequence} when that is drawn"
    return key, lasts_s, False, consequence
