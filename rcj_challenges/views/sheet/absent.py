"""What rules may take off the field: conditions on places ask nothing of it meanwhile."""

from __future__ import annotations

from rcj_challenges.rules.actions.remove import Remove
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.other import meant_in
from rcj_challenges.scenario.roster import Roster


def taken_off(scenario: Scenario, roster: Roster) -> frozenset[str]:
    """Return the names of all that some rule may take off the field."""
    return frozenset(
        name
        for rule in scenario.rules.values()
        for action in rule.actions
        if isinstance(action, Remove)
        for name in meant_in(action.entity, rule, roster)
    )
