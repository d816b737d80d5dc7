"""Notes on rules that were triggered in a test but did not fire because a condition did not hold."""

from __future__ import annotations

from collections.abc import Container, Iterable, Mapping
from math import inf
from typing import NamedTuple

import yaml

from rcj_challenges.core.timing import s_from_ticks
from rcj_challenges.rules.actions import AnyAction
from rcj_challenges.rules.actions.count import Count
from rcj_challenges.rules.actions.emit import Emit
from rcj_challenges.rules.actions.end import End
from rcj_challenges.rules.actions.hold import Hold
from rcj_challenges.rules.actions.release import Release
from rcj_challenges.rules.actions.score import Score
from rcj_challenges.rules.actions.set_flag import SetFlag
from rcj_challenges.rules.actions.set_phase import SetPhase
from rcj_challenges.rules.actions.toggle_flag import ToggleFlag
from rcj_challenges.rules.base import Condition
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import EACH, OTHER
from rcj_challenges.tracking.bound_rules import Denied


class Wanted(NamedTuple):
    """What differs from the expectations of a test.

    Attributes:
        missing: the events that did not come, with the time in s at which they were expected, if at any.
        scores: the entrants with another score.
        counters: the counters with another value.
        flags: the flags with another value.
        phase: the phase that it should be; None: it is.
        over: whether nothing, or the half only, is over that should be.
        held: whether a robot is held that should not be, or the other way round.
    """

    missing: Mapping[str, float | None]
    scores: Container[str] = ()
    counters: Container[str] = ()
    flags: Container[str] = ()
    phase: str | None = None
    over: bool = False
    held: bool = False


_MAX_NOTES = 3
"""At most so many rules are noted for a failed test."""
_YET = " yet: a rule made it true in that tick, which other rules see one tick later, like an emitted event"


def denied_condition_notes(
    denied: Denied,
    scenario: Scenario,
    wanted: Wanted,
    fired: Container[str],
) -> Iterable[str]:
    """Return notes on rules that never fired but would have changed what differs from the expectations.

    Args:
        denied: what conditions did not hold.
        scenario: the scenario.
        wanted: what the test expects and is otherwise.
        fired: the rules that fired at some time.
    """
    noted = 0
    for name, ticks in denied.items():
        rule = scenario.rules[name]
        emitted = [one.event for one in rule.actions if isinstance(one, Emit) and one.event in wanted.missing]
        if not (emitted or any(_does(one, wanted) for one in rule.actions)) or name in fired or noted == _MAX_NOTES:
            continue
        noted += 1
        tick = _nearest(ticks, wanted.missing[emitted[0]] if emitted else None)
        condition, held_after = ticks[tick]
        which = _as_written(rule.conditions[condition])
        yet = _YET if held_after else ""
        yield f"note: {name} was triggered at {s_from_ticks(tick):g} s, and {which} did not hold{yet}"


def _as_written(condition: Condition) -> str:
    """Return a condition as an author writes it."""
    data = condition.model_dump(mode="json", by_alias=True, exclude_unset=True)
    data = {"condition": data.pop("condition"), **data}
    return str(yaml.safe_dump(data, default_flow_style=True, sort_keys=False, width=inf)).strip()


def _does(action: AnyAction, wanted: Wanted) -> bool:
    """Return whether an action changes what differs from the expectations, apart from events."""
    match action:
        case Score():
            does = bool(wanted.scores) and _may_be(action.entrant, wanted.scores)
        case Count():
            does = action.counter in wanted.counters
        case SetFlag() | ToggleFlag():
            does = action.flag in wanted.flags
        case SetPhase():
            does = action.phase == wanted.phase
        case End():
            does = wanted.over
        case _:
            does = wanted.held and isinstance(action, Hold | Release)
    return does


def _may_be(entrant: object, scores: Container[str]) -> bool:
    """Return whether a score may be that of one of some entrants; ``each`` and the last toucher may be any of them."""
    return not isinstance(entrant, str) or entrant in (EACH, OTHER) or entrant in scores


def _nearest(ticks: Iterable[int], at_s: float | None) -> int:
    """Return the tick nearest to a time; the last one if there is none."""
    return max(ticks) if at_s is None else min(ticks, key=lambda tick: abs(s_from_ticks(tick) - at_s))
