"""Notes on rules that were triggered in a test but did not fire because a condition did not hold."""

from __future__ import annotations

from collections.abc import Container, Iterable, Mapping
from math import inf
from typing import NamedTuple, assert_never

import yaml

from rcj_challenges.core.timing import s_from_ticks
from rcj_challenges.rules import effects
from rcj_challenges.rules.base import Condition
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import EACH, OTHER
from rcj_challenges.tracking.bound_rules import Denied


class Wanted(NamedTuple):
    """What differs from the expectations of a test.

    Attributes:
        missing: the events that did not come, with the time in s at which they were expected, if at any.
        over: whether nothing, or the half only, is over that should be.
        held: whether a robot is held that should not be, or the other way round.
    """

    missing: Mapping[str, float | None]
    scores: Container[str] = ()
    entries: Container[tuple[str, str]] = ()
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
    """Return notes on rules that never fired but would have changed what differs from the expectations."""
    noted = 0
    for name, ticks in denied.items():
        rule = scenario.rules[name]
        does = [one for one in rule.all_effects() if _changes(one, wanted)]
        if not does or name in fired or noted == _MAX_NOTES:
            continue
        noted += 1
        emitted = (wanted.missing[one.event] for one in does if isinstance(one, effects.Emits))
        tick = _nearest(ticks, next(emitted, None))
        condition, held_after = ticks[tick]
        which = _as_written(rule.conditions[condition])
        yet = _YET if held_after else ""
        yield f"note: {name} was triggered at {s_from_ticks(tick):g} s, and {which} did not hold{yet}"


def _as_written(condition: Condition) -> str:
    """Return a condition as an author writes it."""
    data = condition.model_dump(mode="json", by_alias=True, exclude_unset=True)
    data = {condition.name(): data.pop(condition.name()), **data}
    return str(yaml.safe_dump(data, default_flow_style=True, sort_keys=False, width=inf)).strip()


def _changes(effect: effects.Effect, wanted: Wanted) -> bool:  # noqa: PLR0911 - one for each kind
    """Return whether an effect is on what differs from the expectations."""
    match effect:
        case effects.Emits(event):
            return event in wanted.missing
        case effects.Scores(entrant):
            # Each, other and the last to touch something may be any of them.
            return bool(wanted.scores) and (entrant in (None, EACH, OTHER) or entrant in wanted.scores)
        case effects.Writes(section, name):
            return (section, name) in wanted.entries
        case effects.SetsPhase(phase):
            return phase == wanted.phase
        case effects.Ends():
            return wanted.over
        case effects.Holds() | effects.Releases():
            return wanted.held
        case effects.Places() | effects.PlacesLayout() | effects.Removes() | effects.Draws() | effects.SetsSpot():
            return False
        case _:
            assert_never(effect)


def _nearest(ticks: Iterable[int], at_s: float | None) -> int:
    """Return the tick nearest to a time; the last one if there is none."""
    return max(ticks) if at_s is None else min(ticks, key=lambda tick: abs(s_from_ticks(tick) - at_s))
