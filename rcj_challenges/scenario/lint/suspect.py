"""What lint looks at, and what it finds: shared by its checks."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from collections.abc import Set as AbstractSet
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, NamedTuple

from rcj_challenges.scenario.errors import Problem
from rcj_challenges.scenario.models.actions import Place, Remove, SetPhase
from rcj_challenges.scenario.models.base import Strict
from rcj_challenges.scenario.models.scenario import Rule, Scenario
from rcj_challenges.scenario.models.state import CounterValue, DrawnDuration, DrawValue
from rcj_challenges.scenario.other import meant_in
from rcj_challenges.scenario.reading.merge import Repeated
from rcj_challenges.scenario.references import REFERENCES, Field, Reference
from rcj_challenges.scenario.roster import Roster, row_of
from rcj_challenges.scenario.tree import Entries, Leaf, Mark, Path
from rcj_challenges.scenario.visiting import visit


class Suspect(NamedTuple):
    """Something that is legal and hardly meant.

    Attributes:
        kind: the check's word for it.
        path: where it is.
        reason: why it is suspicious.
        remedy: what to do.
        at_key: whether the key is meant, not its value.
    """

    kind: str
    path: Path
    reason: str
    remedy: str
    at_key: bool = False


class Use(NamedTuple):
    """A place where something is named."""

    model: type[Strict]
    path: Path
    name: str
    reference: Reference


@dataclass
class Subject:
    """A scenario under the lens.

    Attributes:
        scenario: the models, all references checked.
        roster: names to indices.
        tree: the scenario as it was written.
        left_out: inherited tests that do not fit it, with what is wrong with each.
        removed: where entries of a base were removed.
        replaced: what params that are set anew were in the base.
        repeated: where each rule comes from that is one of a repeated one.
        overridden: the entries of sections that the base has as well, by section and name.
    """

    scenario: Scenario
    roster: Roster
    tree: Entries
    left_out: Mapping[str, Problem] = field(default_factory=dict)
    removed: Mapping[Path, Mark] = field(default_factory=dict)
    replaced: Mapping[str, Leaf] = field(default_factory=dict)
    repeated: Mapping[str, Repeated] = field(default_factory=dict)
    overridden: AbstractSet[Path] = frozenset()

    @cached_property
    def models(self) -> list[tuple[Strict, Path]]:
        """All models of the scenario with their paths."""
        return list(visit(self.scenario))

    @cached_property
    def uses(self) -> list[Use]:
        """All places where something that is defined elsewhere is named."""
        found = []
        for model, path in self.models:
            for name, info in type(model).model_fields.items():
                key = info.alias or name
                reference = REFERENCES.get((type(model), key))
                if reference is not None:
                    at = (*path, key)
                    found += [Use(type(model), at, text, reference) for text in _names(getattr(model, name), reference)]
        return found

    @cached_property
    def transitions(self) -> frozenset[tuple[str, str]]:
        """From which phase which other may be entered, as far as phases can be reached at all."""
        scenario = self.scenario
        edges: set[tuple[str, str]] = set()
        reached = {scenario.first_phase}
        todo = [scenario.first_phase]
        while todo:
            here = todo.pop()
            model = scenario.phases.get(here)
            onward = [model.next] if model is not None and model.lasts_s is not None else []
            for rule in scenario.rules.values():
                if lives_in(rule, here):
                    onward += [action.phase for action in rule.actions if isinstance(action, SetPhase)]
            for phase in onward:
                edges.add((here, phase))
                if phase not in reached:
                    reached.add(phase)
                    todo.append(phase)
        return frozenset(edges)

    @cached_property
    def reached(self) -> frozenset[str]:
        """The phases that can ever be entered."""
        return frozenset({self.scenario.first_phase, *(to for _, to in self.transitions)})

    def can_live(self, rule: Rule) -> bool:
        """Return whether a rule lives in a phase that can be entered."""
        return any(lives_in(rule, phase) for phase in self.reached)

    def standing(self) -> Iterator[tuple[str, Rule]]:
        """Yield the rules that can fire as far as phases go."""
        return ((name, rule) for name, rule in self.scenario.rules.items() if self.can_live(rule))

    def members(self, names: str | tuple[str, ...], rule: Rule) -> frozenset[str]:
        """Return what names in a rule may stand for; ``each``, ``other`` and draws are any that they may ever be."""
        return meant_in(names, rule, self.roster)

    def surely(self, names: str | tuple[str, ...], rule: Rule) -> frozenset[str]:
        """Return the same without what only a draw's name may stand for."""
        return self.members(tuple(name for name in row_of(names) if name not in self.roster.drawn), rule)

    def moved(self, rule: Rule) -> frozenset[str]:
        """Return the entities that a rule may put elsewhere or take off."""
        return self.put(rule) | self.taken_off(rule)

    def taken_off(self, rule: Rule) -> frozenset[str]:
        """Return the entities that a rule may take off the field."""
        removals = (action for action in rule.actions if isinstance(action, Remove))
        return frozenset(name for action in removals for name in self.members(action.entity, rule))

    def put(self, rule: Rule) -> frozenset[str]:
        """Return the entities that a rule may put elsewhere."""
        moved: set[str] = set()
        for action in rule.actions:
            if isinstance(action, Place) and action.entity is not None:
                moved |= self.members(action.entity, rule)
            if isinstance(action, Place) and action.layout is not None:
                for layout in layouts_of(action.layout, self.scenario):
                    for placing in self.scenario.placements.get(layout, ()):
                        moved |= self.members(placing.entity, rule)
        return frozenset(moved)


def layouts_of(layout: str | DrawValue, scenario: Scenario) -> tuple[str, ...]:
    """Return the layouts that an action may place: the one that it names, or all that a draw may decide."""
    if isinstance(layout, str):
        return (layout,)
    draw = scenario.draws.get(layout.draw)
    return tuple(str(value) for value in draw.values) if draw is not None else ()


def lives_in(rule: Rule, phase: str) -> bool:
    """Return whether a rule lives in a phase."""
    return rule.phases == "any" or phase in rule.phases


def lengths_s(lasts_s: float | DrawnDuration | CounterValue, scenario: Scenario) -> tuple[float, ...]:
    """Return how long something may last, in s: one duration, or all that a draw may decide.

    Of a counter nobody knows: none.
    """
    if isinstance(lasts_s, CounterValue):
        return ()
    if isinstance(lasts_s, DrawnDuration):
        return tuple(float(value) for value in scenario.draws[lasts_s.draw].values)
    return (lasts_s,)


def _names(value: Any, reference: Reference) -> Iterator[str]:
    if isinstance(value, str):
        yield value
    elif isinstance(value, dict) and reference.keys:
        yield from value
    elif isinstance(value, tuple):
        for part in value:
            yield from _names(part, reference)


def on_field(use: Use) -> bool:
    """Return whether a use names something on the field: an entity, a zone, a gate, a spot, or a group."""
    return isinstance(use.reference, Field)
