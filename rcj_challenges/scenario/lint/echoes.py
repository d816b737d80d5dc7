"""Lint of rules that set each other off by events, on and on."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from rcj_challenges.scenario.catalogue import EACH
from rcj_challenges.scenario.errors import listing
from rcj_challenges.scenario.lint.suspect import Subject, Suspect, lives_in
from rcj_challenges.scenario.models.actions import Emit, End, SetPhase
from rcj_challenges.scenario.models.scenario import Rule
from rcj_challenges.scenario.models.triggers import OnEvent


def check_echoes(subject: Subject) -> Iterator[Suspect]:
    """Rules that hear what they have set off themselves, and that nothing keeps from firing again."""
    rules = {name: rule for name, rule in subject.standing() if not _is_limited(rule)}
    sets_off = {name: _heard_by(rule, rules, subject) for name, rule in rules.items()}
    told: set[str] = set()
    for name, rule in rules.items():
        way = _way_back(name, sets_off)
        if way is None or told & set(way):
            continue
        told.update(way)
        heard = {trigger.event for trigger in rule.triggers if isinstance(trigger, OnEvent)}
        event = next(event for event in _emitted(rules[way[-1]]) if event in heard)
        by = f", by way of {listing([repr(one) for one in way[1:]])}" if len(way) > 1 else ""
        ticks = "in every tick" if len(way) == 1 else f"every {len(way)} ticks"
        yield Suspect(
            "rule_sets_itself_off",
            ("rules", name),
            f"it waits for {event}, which it sets off itself{by}: once it has fired it fires {ticks}, to the end",
            "wait for another event, or let something keep it from it: a condition, cooldown_s, max_executions",
            at_key=True,
        )


def _is_limited(rule: Rule) -> bool:
    """Return whether something may keep a rule from firing again, be it that it leaves its phase."""
    limited = rule.conditions or rule.cooldown_s is not None or rule.max_executions is not None
    return bool(limited) or any(isinstance(action, SetPhase | End) for action in rule.actions)


def _emitted(rule: Rule) -> list[str]:
    return [action.event for action in rule.actions if isinstance(action, Emit)]


def _heard_by(rule: Rule, rules: Mapping[str, Rule], subject: Subject) -> list[str]:
    """Return the rules that surely hear what a rule emits, in a phase in which both live."""
    emitted = _emitted(rule)
    return [
        name
        for name, other in rules.items()
        if any(isinstance(one, OnEvent) and one.event in emitted and _hears(one, other, rule) for one in other.triggers)
        and any(lives_in(rule, phase) and lives_in(other, phase) for phase in subject.reached)
    ]


def _hears(trigger: OnEvent, rule: Rule, emitting: Rule) -> bool:
    """Return whether a trigger hears the event of another rule: one about anybody, or about each of the same group."""
    about_each = trigger.entity == EACH and rule.for_each is not None and rule.for_each == emitting.for_each
    return trigger.entity is None or about_each


def _way_back(name: str, sets_off: Mapping[str, list[str]]) -> list[str] | None:
    """Return the shortest way from a rule back to itself, the rule first; None: there is none."""
    ways, seen = [[name]], {name}
    for way in ways:
        for after in sets_off[way[-1]]:
            if after == name:
                return way
            if after not in seen:
                seen.add(after)
                ways.append([*way, after])
    return None
