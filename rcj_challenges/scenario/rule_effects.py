"""What rules do as a half starts, where they put things, and for which names they stand with ``other``."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import groupby
from operator import attrgetter
from typing import Any

from rcj_challenges.rules.base import Condition, Word
from rcj_challenges.rules.effects import HalfStart, Places, PlacesLayout, SetsPhase, SetsSpot, Touch
from rcj_challenges.rules.fields import Strict
from rcj_challenges.rules.placement import places
from rcj_challenges.rules.refs import SCORED, Ref, SectionRef, drawn_value, ref_of, refs_of
from rcj_challenges.scenario.models.places import Spot
from rcj_challenges.scenario.models.scenario import Rule, Scenario
from rcj_challenges.scenario.placeholders import placeholders_in
from rcj_challenges.scenario.roster import EACH, OTHER, has_other, with_each
from rcj_challenges.scenario.walk import walk


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
    each_half = (rule for rule, surely in rules_at_start(scenario) if surely)
    named = {one.spot for rule in each_half for one in rule.effects(SetsSpot) if one.at is not None}
    return tuple(name for name in scenario.spots if name in named)


def layouts_of(scenario: Scenario, effect: PlacesLayout) -> list[str]:
    """Return the layouts that may be placed: of a draw all among which it decides."""
    return [str(value) for value in scenario.draws[effect.layout].values] if effect.is_drawn else [effect.layout]


def alternatives(scenario: Scenario, effect: Places | PlacesLayout) -> list[list[Places]]:
    """Return the alternative placements: of a layout all its entries, of which a mirror of the whole is the last."""
    if isinstance(effect, Places):
        return [[effect]]
    layouts = (scenario.placements[name] for name in layouts_of(scenario, effect))
    return [[places(one, effect.mirror) for one in layout] for layout in layouts]


def names_other(rule: Rule, scenario: Scenario) -> bool:
    """Return whether a rule of touches asks about what was touched, acts on it or names it in a text."""
    if not has_other(rule):
        return False
    models = [one for one, _ in walk((rule.conditions, rule.actions))]
    scored = (getattr(one, name) for one in models for name, _, ref in refs_of(type(one)) if ref == SCORED)
    return (
        (OTHER not in scenario.entrants and OTHER in scored)
        or OTHER in placeholders_in(rule.says)
        or for_other(rule, "") != rule
        or any(isinstance(one, Word) and one.stands_for(OTHER) for one in models)
    )


def written_others(rule: Rule) -> tuple[str, ...]:
    """Return the names behind ``other`` as the rule's triggers write them: groups as groups."""
    return tuple(dict.fromkeys(name for one in rule.moments(Touch) for name in with_each(one.other, rule.for_each)))


def for_other(rule: Rule, other: str) -> Rule:
    """Return a rule with one name for ``other`` in its limits, conditions and actions."""
    named = ("triggers", "cooldown_s", "conditions", "actions")
    return rule.model_copy(update={key: with_names(getattr(rule, key), {OTHER: other}) for key in named})


def with_names(value: Any, names: Mapping[str, str]) -> Any:
    """Return a part of a rule with names in the place of others.

    An entrant that is ``other`` stays: who drives a robot is known where it is read.
    """
    if isinstance(value, Strict):
        renamed = {name: _field(value, name, names) for name in type(value).model_fields}
        return value.model_copy(update={name: new for name, new in renamed.items() if new != getattr(value, name)})
    if isinstance(value, tuple):
        return tuple(with_names(part, names) for part in value)
    if isinstance(value, dict):
        return {key: with_names(part, names) for key, part in value.items()}
    return value


def _field(model: Strict, name: str, names: Mapping[str, str]) -> Any:
    value, reference = getattr(model, name), ref_of(type(model), name)
    if isinstance(reference, SectionRef) and EACH in reference.words:
        names = {old: new for old, new in names.items() if old != OTHER}
    elif drawn_value(type(model), name) is None and not (isinstance(reference, Ref) and reference.takes_roles):
        return with_names(value, names)
    if isinstance(value, tuple) and any(isinstance(part, str) and part in names for part in value):
        return tuple(names.get(part, part) if isinstance(part, str) else part for part in value)
    return names.get(value, value) if isinstance(value, str) else with_names(value, names)


def roles_in(word: Any, roles: Mapping[str, Any]) -> tuple[str, ...]:
    """Return the roles that a word names, in order; conditions in it, and values by key, find theirs by themselves."""
    found: list[str] = []
    for name in type(word).model_fields:
        value, reference = getattr(word, name), ref_of(type(word), name)
        is_thing = isinstance(reference, Ref) and reference.takes_roles
        if is_thing or (isinstance(reference, SectionRef) and EACH in reference.words):
            names = value if isinstance(value, tuple) else (value,)
            found += [one for one in names if isinstance(one, str) and one in roles]
        for part in value if isinstance(value, tuple) else (value,):
            if isinstance(part, Strict) and not isinstance(part, Condition):
                found += roles_in(part, roles)
    return tuple(dict.fromkeys(found))
