"""Notes on rules that did not fire in a test: a condition did not hold, or nothing happened that they wait for."""

from __future__ import annotations

from collections.abc import Container, Iterable, Mapping
from typing import assert_never

from rcj_challenges.core.timing import s_from_ticks
from rcj_challenges.rules import effects
from rcj_challenges.rules.base import Condition, Trigger
from rcj_challenges.scenario.errors import listing
from rcj_challenges.scenario.models.scenario import Rule, Scenario
from rcj_challenges.scenario.reading.yaml_strict import on_one_line
from rcj_challenges.scenario.roster import EACH, ENTRANTS, OTHER, OTHERS
from rcj_challenges.tracking.bound_rules import Denied
from rcj_challenges.tracking.trackers import Missed

Lacks = Mapping[tuple[str, ...], float | None]
"""What a test lacks (`Difference.lacks`), with the time in s at which it was expected, if at any."""

_MAX_NOTES = 3
"""At most so many rules are noted for a failed test."""
_OPPOSITE = {"below": "at_least", "above": "at_most"}
_YET = " yet: a rule made it true in that tick, which other rules see one tick later, like an emitted event"


def silent_rules(scenario: Scenario, lacks: Lacks, fired: Container[str]) -> dict[str, Rule]:
    """Return the rules that never fired, but would have given something of what a test lacks."""
    return {
        name: rule
        for name, rule in scenario.rules.items()
        if name not in fired
        and (("event", f"rule {name}") in lacks or any(_changes(one, lacks) for one in rule.all_effects()))
    }


def denied_condition_notes(denied: Denied, silent: Mapping[str, Rule], lacks: Lacks) -> Iterable[str]:
    """Return notes on `silent_rules` of which a condition did not hold."""
    for name, ticks in [named for named in denied.items() if named[0] in silent][:_MAX_NOTES]:
        rule = silent[name]
        given = [("event", one) for one in (f"rule {name}", *(emits.event for emits in rule.effects(effects.Emits)))]
        tick = _nearest(ticks, next((lacks[one] for one in given if one in lacks), None))
        condition, held_after = ticks[tick]
        which = _as_written(rule.conditions[condition])
        yet = _YET if held_after else ""
        yield f"note: {name} was triggered at {s_from_ticks(tick):g} s, and {which} did not hold{yet}"


def missed_notes(missed: Iterable[tuple[str, Missed]], scenario: Scenario, silent: Container[str]) -> Iterable[str]:
    """Return notes on what set off no rule, by entity: it is no entry, the other direction, or held already.

    A rule that waits for a condition to come true, beside one that waits for the opposite, is meant for changes.
    """
    triggers = {name: [_watched(one) for one in rule.triggers] for name, rule in scenario.rules.items()}
    watched = {one for listed in triggers.values() for one in listed}
    noted: set[tuple[str, str]] = set()
    for entity, one in sorted(missed, key=lambda about: about[1].tick):
        at = f"at {s_from_ticks(one.tick):g} s"
        rules = dict.fromkeys(binding.rule.name for binding in one.bindings)
        if one.kind == "crossed":
            why = f"not counted by {listing(rules)}, with the other direction" if rules else "no step of a sequence"
            note = f"note: {entity} crossed {one.what} {at}: {why}"
            if (note, one.kind) not in noted:
                yield note
            noted.add((note, one.kind))
            continue
        for name in rules:
            if (name, one.kind) in noted or name not in silent:
                continue
            noted.add((name, one.kind))
            if one.kind == "placed":
                yield (
                    f"note: {entity} was put into {one.what} {at}, which does not trigger {name}: a placed thing has "
                    f"not entered the zone; use 'holds' with {{entity: {entity}, in: {one.what}}} and for_s: 0.05"
                )
            elif not any((what, not is_so) in watched for what, is_so in triggers[name] if what):
                yield (
                    f"note: {name} waits for a condition to come true that held already {at}; "
                    "with for_s: 0.05 that counts too"
                )


def _watched(trigger: Trigger) -> tuple[str, bool]:
    """Return the one condition that a trigger waits for, without its negation, and whether it waits for it to hold."""
    conditions: tuple[Condition, ...] = getattr(trigger, "conditions", ())
    if len(conditions) != 1:
        return "", True
    data = conditions[0].model_dump(mode="json", by_alias=True, exclude_unset=True)
    is_so = not data.pop("negate", False)
    bounds = data.keys() & {"at_least", "at_most", *_OPPOSITE}
    if len(bounds) == 1 and (opposite := _OPPOSITE.get(next(iter(bounds)))):
        data[opposite], is_so = data.pop(next(iter(bounds))), not is_so
    return repr(sorted(data.items())), is_so


def _as_written(condition: Condition) -> str:
    """Return a condition as an author writes it."""
    data = condition.model_dump(mode="json", by_alias=True, exclude_unset=True)
    data = {condition.name(): data.pop(condition.name()), **data}
    return on_one_line(data)


def _changes(effect: effects.Effect, lacks: Lacks) -> bool:  # noqa: PLR0911 - one for each kind
    """Return whether an effect is on what a test lacks."""
    match effect:
        case effects.Emits(event):
            return ("event", event) in lacks
        case effects.Scores(entrant) if entrant in (None, EACH, OTHER, OTHERS, ENTRANTS):
            return has_kind(lacks, "score")  # these, and the last to touch something, may be any of them
        case effects.Scores(entrant):
            return ("score", entrant) in lacks
        case effects.Writes(section, name):
            return (section, name) in lacks
        case effects.SetsPhase(phase):
            return ("phase", phase) in lacks
        case effects.Ends():
            return ("ended", "half") in lacks or ("ended", "match") in lacks
        case effects.Holds() | effects.Releases():
            return has_kind(lacks, "held")
        case effects.Places() | effects.PlacesLayout() | effects.Removes() | effects.Draws() | effects.SetsSpot():
            return False
        case _:
            assert_never(effect)


def has_kind(lacks: Lacks, kind: str) -> bool:
    """Return whether a test lacks something of a kind."""
    return any(one[:1] == (kind,) for one in lacks)


def _nearest(ticks: Iterable[int], at_s: float | None) -> int:
    """Return the tick nearest to a time; the last one if there is none."""
    return max(ticks) if at_s is None else min(ticks, key=lambda tick: abs(s_from_ticks(tick) - at_s))
