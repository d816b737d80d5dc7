"""Lint of who stays in a zone for too long and is put back to its start, which lies in that very zone."""

from __future__ import annotations

from collections.abc import Iterator

from rcj_challenges.scenario.errors import listing
from rcj_challenges.scenario.floor_shapes import lies_in
from rcj_challenges.scenario.lint.suspect import Subject, Suspect, lives_in
from rcj_challenges.scenario.models.actions import End, Place, Remove, SetPhase
from rcj_challenges.scenario.models.conditions import HalfIs, InZone
from rcj_challenges.scenario.models.places import Placing, Start
from rcj_challenges.scenario.models.scenario import Rule
from rcj_challenges.scenario.models.triggers import Holds, StaysIn, Trigger
from rcj_challenges.scenario.starting import start_pose
from rcj_challenges.scenario.tree import Path


def check_put_back(subject: Subject) -> Iterator[Suspect]:
    """Rules that put who stays in a zone to a start in it: whoever does not drive off is put back again and again."""
    for name, rule in subject.standing():
        if _is_limited(rule):
            continue
        put_back = _put_to_start(rule, subject)
        for index, trigger in enumerate(rule.triggers):
            inside = _starting_inside(trigger, rule, put_back, subject)
            if inside:
                path: Path = ("rules", name, "triggers", index)
                who, zone = next(iter(inside.items()))
                more = "" if len(inside) == 1 else f" (and those of {listing(list(inside)[1:])} in theirs)"
                yield Suspect(
                    "put_back_into_the_zone",
                    path,
                    f"the start of '{who}' lies in '{zone}'{more}, and the rule puts it there: who does not drive off "
                    "is in the zone again, and the rule fires again and again",
                    "give the zone or the start another place, put it elsewhere, or limit the rule: max_executions, "
                    "cooldown_s, a condition",
                )


def _is_limited(rule: Rule) -> bool:
    """Return whether something may keep a rule from firing again and again."""
    asks = any(not isinstance(condition, HalfIs) for condition in rule.conditions)
    # In another phase it does not live: it has ended a round, and rounds come again and begin at the starts.
    leaves = any(isinstance(action, SetPhase) and not lives_in(rule, action.phase) for action in rule.actions)
    ends = any(isinstance(action, End) for action in rule.actions)
    return asks or leaves or ends or rule.max_executions is not None or rule.cooldown_s is not None


def _put_to_start(rule: Rule, subject: Subject) -> frozenset[str]:
    """Return the entities that a rule puts to their start, at once or after a time off the field."""
    found: set[str] = set()
    for action in rule.actions:
        if isinstance(action, Remove):
            comes_back = action.for_s is not None and _is_start(action.back_at)
            found |= subject.members(action.entity, rule) if comes_back else set()
        elif isinstance(action, Place) and action.mirror is None:
            layout = subject.scenario.placements.get(action.layout, ()) if isinstance(action.layout, str) else ()
            placings: tuple[Place | Placing, ...] = (action, *layout)
            for one in placings:
                if one.entity is not None and _is_start(one.at) and one.mirror is None:
                    found |= subject.members(one.entity, rule)
    return frozenset(found)


def _is_start(at: object) -> bool:
    return at == "start" or isinstance(at, Start)


def _starting_inside(trigger: Trigger, rule: Rule, put_back: frozenset[str], subject: Subject) -> dict[str, str]:
    """Return whom a trigger finds and the rule puts to a start in a zone that the trigger watches, and that zone."""
    stay = trigger.condition if isinstance(trigger, Holds) and (trigger.for_s or trigger.every_s) else trigger
    if not isinstance(stay, StaysIn | InZone) or (isinstance(stay, InZone) and (stay.negate or stay.of == "none")):
        return {}
    found: dict[str, str] = {}
    zones = sorted(subject.members(stay.zone, rule))
    entities = subject.members(stay.entity, rule) & put_back & set(subject.roster.entities)
    for who in sorted(entities):
        x_m, y_m, _ = start_pose(subject.scenario, who)
        inside = next((name for name in zones if lies_in((x_m, y_m), subject.scenario.zones[name])), None)
        if inside is not None:
            found[who] = inside
    return found
