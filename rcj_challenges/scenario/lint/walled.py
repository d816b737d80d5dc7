"""Lint of goals that a scenario took away, and for which its rules wait all the same."""

from __future__ import annotations

from collections.abc import Iterator

from rcj_challenges.scenario.errors import listing
from rcj_challenges.scenario.lint.suspect import Subject, Suspect
from rcj_challenges.scenario.lint.variants import BEFORE_END_M
from rcj_challenges.scenario.models.conditions import InZone
from rcj_challenges.scenario.models.places import RectZone
from rcj_challenges.scenario.models.scenario import Rule
from rcj_challenges.scenario.models.triggers import Enters, StaysIn
from rcj_challenges.scenario.visiting import visit


def check_walled_zones(subject: Subject) -> Iterator[Suspect]:
    """Zones of goals that are gone: the wall is closed there, and nothing comes in."""
    goals = subject.scenario.field.goals
    closed = {
        str(path[-1]): path
        for path, mark in subject.removed.items()
        if path[:2] == ("field", "goals") and path[-1] not in goals and mark.file == subject.tree.mark.file
    }
    behind = frozenset(name for name in closed if _is_behind_the_wall(name, subject))
    rules = {name: _waits_for(rule, behind, subject) for name, rule in subject.scenario.rules.items() if behind}
    for name in (name for name in closed if name in behind):
        waiting = [rule for rule, zones in rules.items() if name in zones]
        waiting += [
            way
            for way, sequence in subject.scenario.sequences.items()
            if any(name in places and behind.issuperset(places) for places in sequence.places())
        ]
        if waiting:
            yield Suspect(
                "goal_is_gone",
                ("field", "goals"),
                f"goal '{name}' is taken away and the wall closed there, and its zone is still waited for, where "
                f"nothing comes in, by {listing(waiting)}",
                f"keep the goal, give zones.{name} another place, or take the zone away too (zones: {{{name}: null}}) "
                "and what waits for it",
                at_key=True,
            )


def _is_behind_the_wall(name: str, subject: Subject) -> bool:
    zone, end_m = subject.scenario.zones.get(name), subject.scenario.field.length_m / 2
    if not isinstance(zone, RectZone) or zone.inverted:
        return False
    beyond = zone.y_min_m is not None and zone.y_min_m >= end_m - BEFORE_END_M
    return beyond or (zone.y_max_m is not None and zone.y_max_m <= BEFORE_END_M - end_m)


def _waits_for(rule: Rule, behind: frozenset[str], subject: Subject) -> frozenset[str]:
    """Return the zones behind a wall into which something must come for a rule to fire."""
    found: set[str] = set()
    for model, _ in visit(rule):
        if isinstance(model, Enters | StaysIn) or (isinstance(model, InZone) and _asks_inside(model)):
            zones = subject.members(model.zone, rule)
            found |= zones if zones <= behind else set()
    return frozenset(found)


def _asks_inside(condition: InZone) -> bool:
    return (condition.of == "none") == condition.negate
