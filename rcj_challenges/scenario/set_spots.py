"""Spots that rules set during a half; all others stay where the file has them."""

from __future__ import annotations

from rcj_challenges.rules.actions.set_spot import SetSpot
from rcj_challenges.rules.values.reported import ReportedValue
from rcj_challenges.scenario.half_start import firing_each_half
from rcj_challenges.scenario.models.places import Spot
from rcj_challenges.scenario.models.scenario import Scenario


def spots_set_by_rules(scenario: Scenario) -> tuple[str, ...]:
    """Return the spots that a rule sets, in the order of the file, where each half starts with them."""
    actions = (action for rule in scenario.rules.values() for action in rule.actions)
    named = {action.spot for action in actions if isinstance(action, SetSpot)}
    return tuple(name for name in scenario.spots if name in named)


def fixed_spots(scenario: Scenario) -> dict[str, Spot]:
    """Return the spots that no rule sets."""
    remembered = spots_set_by_rules(scenario)
    return {name: spot for name, spot in scenario.spots.items() if name not in remembered}


def spots_set_at_start(scenario: Scenario) -> tuple[str, ...]:
    """Return the spots that a rule always sets as a half starts: they are never where the file has them."""
    named = {
        action.spot
        for rule in firing_each_half(scenario)
        for action in scenario.rules[rule].actions
        # No robot has sent a position yet when a half starts.
        if isinstance(action, SetSpot) and not isinstance(action.to, ReportedValue)
    }
    return tuple(name for name in scenario.spots if name in named)
