"""Rules that were triggered in a test and did not fire, since a condition did not hold: why an event may be missing."""

from __future__ import annotations

from collections.abc import Collection, Container, Iterable, Mapping
from typing import NamedTuple

from rcj_challenges.facts.timing import s_from_ticks
from rcj_challenges.scenario.catalogue import EACH, OTHER
from rcj_challenges.scenario.messages.written import as_written
from rcj_challenges.scenario.models.actions import Emit, Score
from rcj_challenges.scenario.models.scenario import Scenario


class Denial(NamedTuple):
    """What kept a rule from firing in a tick.

    Attributes:
        condition: the place of the first of its conditions that did not hold.
        held_after: whether it held once the rules of that tick had done what they do.
    """

    condition: int
    held_after: bool


Denied = dict[str, dict[int, Denial]]
"""By rule and tick, what kept it from firing."""

_SHOWN = 3
"""So many rules are told of a test that failed."""
_YET = (
    " yet: a rule of that very tick made it true, which others see one tick later, as they hear an event that it emits"
)


def denied_notes(
    denied: Denied,
    scenario: Scenario,
    missing: Mapping[str, float | None],
    scores: Collection[str],
    fired: Container[str],
) -> Iterable[str]:
    """Return notes on rules that never fired, and would have emitted an event that is missing or changed a score.

    Args:
        denied: what conditions did not hold.
        scenario: the scenario.
        missing: the events that did not come, with the time in s at which they were expected, if at any.
        scores: the entrants with another score than expected.
        fired: the rules that fired at some time.
    """
    told = 0
    for name, ticks in denied.items():
        rule = scenario.rules[name]
        emitted = [one.event for one in rule.actions if isinstance(one, Emit) and one.event in missing]
        scored = bool(scores) and any(isinstance(one, Score) and _may_be(one.entrant, scores) for one in rule.actions)
        if not (emitted or scored) or name in fired or told == _SHOWN:
            continue
        told += 1
        tick = _nearest(ticks, missing[emitted[0]] if emitted else None)
        condition, held_after = ticks[tick]
        which = as_written(rule.conditions[condition])
        yet = _YET if held_after else ""
        yield f"note: {name} was triggered at {s_from_ticks(tick):g} s, and {which} did not hold{yet}"


def _may_be(entrant: object, scores: Container[str]) -> bool:
    """Return whether a score may be that of one of some entrants: ``each`` and who touched something may be anybody."""
    return not isinstance(entrant, str) or entrant in (EACH, OTHER) or entrant in scores


def _nearest(ticks: Iterable[int], at_s: float | None) -> int:
    """Return the tick nearest to a time; the last one if there is none."""
    return max(ticks) if at_s is None else min(ticks, key=lambda tick: abs(s_from_ticks(tick) - at_s))
