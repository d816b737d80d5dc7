"""Rules that name ``other``, what was touched: such a rule exists once for each thing that may be touched."""

from __future__ import annotations

from typing import Any

from rcj_challenges.rules.base import Word
from rcj_challenges.rules.effects import Scores, Touch
from rcj_challenges.rules.fields import Strict
from rcj_challenges.rules.refs import Ref, drawn_value, ref_of
from rcj_challenges.scenario.models.scenario import Rule, Scenario
from rcj_challenges.scenario.placeholders import placeholders_in
from rcj_challenges.scenario.roster import OTHER, has_other, with_each
from rcj_challenges.scenario.walk import walk


def names_other(rule: Rule, scenario: Scenario) -> bool:
    """Return whether a rule of touches asks about what was touched, acts on it or names it in a text."""
    if not has_other(rule):
        return False
    receives = OTHER not in scenario.entrants and any(one.entrant == OTHER for one in rule.effects(Scores))
    return (
        receives
        or OTHER in placeholders_in(rule.says)
        or for_other(rule, "") != rule
        or any(isinstance(one, Word) and one.stands_for(OTHER) for one, _ in walk((rule.conditions, rule.actions)))
    )


def written_others(rule: Rule) -> tuple[str, ...]:
    """Return the names behind ``other`` as the rule's triggers write them: groups as groups."""
    return tuple(dict.fromkeys(name for one in rule.moments(Touch) for name in with_each(one.other, rule.for_each)))


def for_other(rule: Rule, other: str) -> Rule:
    """Return a rule with one name for ``other`` in its conditions and actions."""
    return rule.model_copy(
        update={"conditions": with_other(rule.conditions, other), "actions": with_other(rule.actions, other)}
    )


def with_other(value: Any, other: str) -> Any:
    """Return a part of a rule with a name wherever it says ``other``; the very same part if it never does.

    The entrant of ``score`` stays: who drives a robot is known where points are given.
    """
    if isinstance(value, Strict):
        changed = {name: _field(value, name, other) for name in type(value).model_fields}
        update = {name: field for name, field in changed.items() if field is not getattr(value, name)}
        return value.model_copy(update=update) if update else value
    if isinstance(value, tuple):
        parts = tuple(with_other(part, other) for part in value)
        return parts if any(new is not old for new, old in zip(parts, value, strict=True)) else value
    if isinstance(value, dict):
        entries = {key: with_other(part, other) for key, part in value.items()}
        return entries if any(entries[key] is not part for key, part in value.items()) else value
    return value


def _field(model: Strict, name: str, other: str) -> Any:
    value = getattr(model, name)
    if drawn_value(type(model), name) is not None:
        return other if value == OTHER else value
    reference = ref_of(type(model), name)
    if not isinstance(reference, Ref) or not reference.each:
        return with_other(value, other)
    if isinstance(value, tuple) and OTHER in value:
        return tuple(other if part == OTHER else part for part in value)
    return other if value == OTHER else with_other(value, other)
