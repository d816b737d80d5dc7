"""Spots that rules set, so that a place is remembered; all others stay where the file says."""

from __future__ import annotations

from rcj_challenges.rules.actions.set_spot import SetSpot
from rcj_challenges.rules.values.told import ToldValue
from rcj_challenges.scenario.beginnings import starting_each_half
from rcj_challenges.scenario.models.places import Spot
from rcj_challenges.scenario.models.scenario import Scenario


def remembered_spots(scenario: Scenario) -> tuple[str, ...]:
    """Return the spots that a rule sets, in the order of the file; where that has them, each half begins."""
    actions = (action for rule in scenario.rules.values() for action in rule.actions)
    named = {action.spot for action in actions if isinstance(action, SetSpot)}
    return tuple(name for name in scenario.spots if name in named)


def fixed_spots(scenario: Scenario) -> dict[str, Spot]:
    """Return the spots that no rule sets."""
    remembered = remembered_spots(scenario)
    return {name: spot for name, spot in scenario.spots.items() if name not in remembered}


def set_at_once(scenario: Scenario) -> tuple[str, ...]:
    """Return those that a rule sets as each half starts, whatever else is so: they are never where the file says."""
    named = {
        action.spot
        for rule in starting_each_half(scenario)
        for action in scenario.rules[rule].actions
        # Nobody has told a place yet when a half starts.
        if isinstance(action, SetSpot) and not isinstance(action.to, ToldValue)
    }
    return tuple(name for name in scenario.spots if name in named)
