"""What rules may take off the field: conditions on places ask nothing of it meanwhile."""

from __future__ import annotations

from collections.abc import Iterator

from rcj_challenges.scenario.catalogue import EACH, OTHER
from rcj_challenges.scenario.models.actions import Remove
from rcj_challenges.scenario.models.scenario import Rule, Scenario
from rcj_challenges.scenario.other import has_other, others_of
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


def meant_in(names: str | tuple[str, ...], rule: Rule | None, roster: Roster) -> Iterator[str]:
    """Yield what names in a rule, or in a layout, may stand for."""
    for name in (names,) if isinstance(names, str) else names:
        if name == OTHER and rule is not None and has_other(rule):
            yield from others_of(rule, rule.for_each, roster)
        elif name == EACH and rule is not None and rule.for_each is not None:
            yield from roster.may_be(rule.for_each)
        else:
            yield from roster.may_be(name)
