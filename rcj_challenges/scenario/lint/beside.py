"""Lint of what is put beside something that moves, and so near to it that it would stand in it."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from math import hypot

from rcj_challenges.scenario.errors import listing
from rcj_challenges.scenario.lint.ground import no_room
from rcj_challenges.scenario.lint.suspect import Subject, Suspect
from rcj_challenges.scenario.models.actions import Place
from rcj_challenges.scenario.models.field import Box, Cylinder
from rcj_challenges.scenario.models.places import RelativeTo
from rcj_challenges.scenario.models.scenario import Rule, Scenario

_TOUCHING_M = 0.001
"""Bodies that overlap by less are taken for two that touch."""


def check_beside(subject: Subject) -> Iterator[Suspect]:
    """Actions that put something where the thing stands beside which it is put."""
    away = {name for _, rule in subject.standing() for name in subject.taken_off(rule)}
    for name, rule in subject.standing():
        for index, action in enumerate(rule.actions):
            if isinstance(action, Place) and isinstance(action.at, RelativeTo) and action.entity is not None:
                beside = subject.members(action.at.relative_to, rule)
                # Where it stood there is room if it is off the field, or put elsewhere in the same tick.
                stays = not beside & (away | _put_as_well(rule, action, subject))
                if stays and _is_always_in(action, action.at, rule, subject):
                    what = listing((action.entity,) if isinstance(action.entity, str) else action.entity)
                    problem = f"'{what}' would stand in '{action.at.relative_to}', beside which it is put"
                    yield no_room(("rules", name, "actions", index), problem, "write a larger offset_m", action)


def _put_as_well(rule: Rule, action: Place, subject: Subject) -> frozenset[str]:
    """Return what the other actions of a rule, and rules that wait for the same, put somewhere."""
    others = tuple(one for one in rule.actions if one is not action)
    same = (one for _, one in subject.standing() if one is not rule and any(t in rule.triggers for t in one.triggers))
    put = (subject.put(one) for one in (rule.model_copy(update={"actions": others}), *same))
    return frozenset(name for names in put for name in names)


def _is_always_in(action: Place, at: RelativeTo, rule: Rule, subject: Subject) -> bool:
    """Return whether a thing would overlap the one beside which it is put, whichever of them are meant."""
    pairs = list(product(subject.members(action.entity or (), rule), subject.members(at.relative_to, rule)))
    apart_m = hypot(*at.offset_m) + hypot(*action.noise_m)
    return bool(pairs) and all(
        one != other and apart_m < _inner_m(one, subject.scenario) + _inner_m(other, subject.scenario) - _TOUCHING_M
        for one, other in pairs
    )


def _inner_m(name: str, scenario: Scenario) -> float:
    """Return the radius of a circle that a thing covers in any case, in m; of a spot none."""
    if name in scenario.balls:
        return scenario.balls[name].radius_m
    if name in scenario.robots:
        return scenario.kits[scenario.robots[name].kit].chassis.size_m / 2
    obstacle = scenario.obstacles.get(name)
    if isinstance(obstacle, Cylinder):
        return obstacle.radius_m
    return min(obstacle.size_m) / 2 if isinstance(obstacle, Box) else float("-inf")
