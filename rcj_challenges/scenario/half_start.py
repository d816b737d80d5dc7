"""What rules do as a half starts: which of them fire, and which draws and spots they set before anything reads them."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import groupby
from operator import attrgetter
from typing import Any

from rcj_challenges.rules.base import ValueWord
from rcj_challenges.rules.effects import Draws, HalfStart, SetsPhase, SetsSpot
from rcj_challenges.scenario.models.places import Spot
from rcj_challenges.scenario.models.scenario import Rule, Scenario
from rcj_challenges.scenario.roster import BOUND


def rules_at_start(scenario: Scenario) -> Iterator[tuple[Rule, bool]]:
    """Yield the rules that may fire as a half starts, in their order, each with whether it fires in every half.

    A rule of a lower priority may have left the first phase before.
    """
    first = frozenset({scenario.first_phase})
    phases = first  # one of these is on
    starting = sorted((rule for rule in scenario.rules.values() if rule.moments(HalfStart)), key=_PRIORITY)
    for _, group in groupby(starting, key=_PRIORITY):
        then = phases  # a phase that a rule sets begins after the rules of its priority
        for rule in group:
            own = phases | first if rule.phases == "any" else frozenset(rule.phases)
            if not (first <= own and phases & own):
                continue
            surely = phases <= own and not rule.conditions and rule.exclusive is None
            yield rule, surely
            entered = {one.phase for one in rule.effects(SetsPhase)[:1]}
            if entered:
                then = frozenset(entered) if surely and then == phases else then | entered
        phases = then


_PRIORITY = attrgetter("priority")


def _firing_each_half(scenario: Scenario) -> list[Rule]:
    return [rule for rule, surely in rules_at_start(scenario) if surely]


# --- draws ------------------------------------------------------------------------------------------------------------


def set_from_the_start(scenario: Scenario) -> frozenset[str]:
    """Return the draws that rules set as each half starts and that nothing draws again: chance never decides them."""
    setting = {
        one.draw
        for rule in _firing_each_half(scenario)
        for one in rule.effects(Draws)
        if one.value is not None and (one.value not in BOUND or one.value in scenario.draws[one.draw].values)
    }
    drawn = {one.draw for one in scenario.effects(Draws) if one.value is None}
    return frozenset(setting - drawn - (_used_at_start(scenario) if setting else set()))


def _used_at_start(scenario: Scenario) -> set[str]:
    """Return the names in rules that fire at the start, which see what was drawn, and in durations."""
    lasting = [one.lasts_s for section in (scenario.timers, scenario.phases) for one in section.values()]
    rules = [rule for rule in scenario.rules.values() if rule.moments(HalfStart)]
    others = [one for rule in rules for one in rule.actions if not any(isinstance(e, Draws) for e in one.effects())]
    named = (*(one for one in lasting if isinstance(one, ValueWord)), *(one for r in rules for one in r.conditions))
    return {name for model in (*named, *others) for name in _texts(model.model_dump())}


def _texts(data: Any) -> Iterator[str]:
    if isinstance(data, str):
        yield data
    for inner in data.values() if isinstance(data, dict) else data if isinstance(data, list | tuple) else ():
        yield from _texts(inner)


# --- spots ------------------------------------------------------------------------------------------------------------


def spots_set_by_rules(scenario: Scenario) -> tuple[str, ...]:
    """Return the spots that a rule sets, in the order of the file, where each half starts with them."""
    named = {one.spot for one in scenario.effects(SetsSpot)}
    return tuple(name for name in scenario.spots if name in named)


def fixed_spots(scenario: Scenario) -> dict[str, Spot]:
    """Return the spots that no rule sets."""
    named = spots_set_by_rules(scenario)
    return {name: spot for name, spot in scenario.spots.items() if name not in named}


def spots_set_at_start(scenario: Scenario) -> tuple[str, ...]:
    """Return the spots that a rule always sets as a half starts: they are never where the file has them."""
    named = {e.spot for rule in _firing_each_half(scenario) for e in rule.effects(SetsSpot) if e.at is not None}
    return tuple(name for name in scenario.spots if name in named)
