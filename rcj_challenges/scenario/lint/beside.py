"""Lint of what is put beside something that moves, and so near to it that it would stand in it."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from math import hypot
from typing import NamedTuple

from rcj_challenges.scenario.errors import listing
from rcj_challenges.scenario.lint.ground import no_room
from rcj_challenges.scenario.lint.suspect import Subject, Suspect, layouts_of
from rcj_challenges.scenario.models.actions import Action, Place
from rcj_challenges.scenario.models.field import Box, Cylinder
from rcj_challenges.scenario.models.places import Placing, RelativeTo
from rcj_challenges.scenario.models.scenario import Rule, Scenario
from rcj_challenges.scenario.roster import row_of
from rcj_challenges.scenario.tree import Path

_TOUCHING_M = 0.001
"""Bodies that overlap by less are taken for two that touch."""


class _Put(NamedTuple):
    """Something that an action puts somewhere.

    Attributes:
        path: where that stands.
        placing: how it is put; of an action that places a layout one of that layout's.
        as_well: what else of that layout is put somewhere.
    """

    path: Path
    placing: Place | Placing
    as_well: frozenset[str] = frozenset()


def check_beside(subject: Subject) -> Iterator[Suspect]:
    """Actions, and placements of layouts, that put something where the thing stands beside which it is put."""
    away = {name for _, rule in subject.standing() for name in subject.taken_off(rule)}
    told: set[Path] = set()  # two rules may place one layout
    for name, rule in subject.standing():
        for index, action in enumerate(rule.actions):
            for path, placing, as_well in _puts(action, ("rules", name, "actions", index), rule, subject):
                at, entity = placing.at, placing.entity
                if not isinstance(at, RelativeTo) or entity is None or path in told:
                    continue
                beside = subject.members(at.relative_to, rule)
                # Where it stood there is room if it is off the field, or put elsewhere in the same tick.
                stays = not beside & (away | as_well | _put_as_well(rule, action, subject))
                if stays and _is_always_in(placing, at, rule, subject):
                    told.add(path)
                    what = listing(row_of(entity))
                    problem = f"'{what}' would stand in '{at.relative_to}', beside which it is put"
                    yield no_room(path, problem, "write a larger offset_m", placing)


def _puts(action: Action, path: Path, rule: Rule, subject: Subject) -> Iterator[_Put]:
    if not isinstance(action, Place):
        return
    yield _Put(path, action)
    for layout in () if action.layout is None else layouts_of(action.layout, subject.scenario):
        placings = subject.scenario.placements.get(layout, ())
        for index, placing in enumerate(placings):
            others = (one.entity for at, one in enumerate(placings) if at != index)
            as_well = frozenset(name for names in others for name in subject.members(names, rule))
            yield _Put(("placements", layout, index), placing, as_well)


def _put_as_well(rule: Rule, action: Action, subject: Subject) -> frozenset[str]:
    """Return what the other actions of a rule, and rules that wait for the same, put somewhere."""
    others = tuple(one for one in rule.actions if one is not action)
    same = (one for _, one in subject.standing() if one is not rule and any(t in rule.triggers for t in one.triggers))
    put = (subject.put(one) for one in (rule.model_copy(update={"actions": others}), *same))
    return frozenset(name for names in put for name in names)


def _is_always_in(placing: Place | Placing, at: RelativeTo, rule: Rule, subject: Subject) -> bool:
    """Return whether a thing would overlap the one beside which it is put, whichever of them are meant."""
    pairs = list(product(subject.members(placing.entity or (), rule), subject.members(at.relative_to, rule)))
    apart_m = hypot(*at.offset_m) + hypot(*placing.noise_m)
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
