"""Draws that rules always set before anything reads them, so that chance never decides them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from rcj_challenges.rules.actions.draw import DrawAction
from rcj_challenges.rules.triggers.half_started import HalfStarted
from rcj_challenges.rules.values.draw import DrawnDuration
from rcj_challenges.scenario.half_start import firing_each_half
from rcj_challenges.scenario.models.scenario import Rule, Scenario
from rcj_challenges.scenario.roster import BOUND


def set_from_the_start(scenario: Scenario) -> frozenset[str]:
    """Return the draws that rules set as each half starts and that nothing draws again."""
    surely = firing_each_half(scenario)
    actions = [(name, action) for name, rule in scenario.rules.items() for action in rule.actions]
    setting = {
        action.draw
        for name, action in actions
        if isinstance(action, DrawAction)
        and action.as_ is not None
        and (action.as_ not in BOUND or action.as_ in scenario.draws[action.draw].values)
        and name in surely
    }
    drawn = {action.draw for _, action in actions if isinstance(action, DrawAction) and action.as_ is None}
    return frozenset(setting - drawn - (_used_at_start(scenario) if setting else set()))


def _fires_at_start(rule: Rule) -> bool:
    return any(isinstance(one, HalfStarted) for one in rule.triggers)


def _used_at_start(scenario: Scenario) -> set[str]:
    """Return the names in rules that fire at the start, which see what was drawn, and in durations."""
    timers, phases = scenario.timers.values(), scenario.phases.values()
    lasts_s = [*(one.lasts_s for one in timers), *(one.lasts_s for one in phases)]
    lasting = {one.draw for one in lasts_s if isinstance(one, DrawnDuration)}
    rules = [rule for rule in scenario.rules.values() if _fires_at_start(rule)]
    others = [action for rule in rules for action in rule.actions if not isinstance(action, DrawAction)]
    named = [*(condition for rule in rules for condition in rule.conditions), *others]
    return lasting | {name for model in named for name in _texts(model.model_dump())}


def _texts(data: Any) -> Iterator[str]:
    if isinstance(data, str):
        yield data
    for inner in data.values() if isinstance(data, dict) else data if isinstance(data, list | tuple) else ():
        yield from _texts(inner)
