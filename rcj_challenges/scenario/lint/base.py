"""The form of a check, and what it reads: the scenario, its names, their uses, and the phases that can be reached."""

from __future__ import annotations

import inspect
from collections.abc import Iterator
from functools import cached_property
from typing import Any, ClassVar, NamedTuple, TypeVar

from rcj_challenges.core.code import Code
from rcj_challenges.core.diagnostics import Diagnostic, issue
from rcj_challenges.rules.effects import Effect, Places, PlacesLayout, Removes, SetsPhase
from rcj_challenges.rules.fields import Strict
from rcj_challenges.rules.refs import Ref, Reference, refs_of
from rcj_challenges.scenario.load import Loaded
from rcj_challenges.scenario.models.scenario import Rule
from rcj_challenges.scenario.rule_effects import alternatives
from rcj_challenges.scenario.tree import Entries, Path, mark_of
from rcj_challenges.scenario.walk import effects_in, walk

_E = TypeVar("_E", bound=Effect)


class Use(NamedTuple):
    """A place where something that is defined elsewhere is named."""

    model: type[Strict]
    path: Path
    name: str
    reference: Reference

    @property
    def is_on_field(self) -> bool:
        """Whether it names an entity, a zone, a gate, a spot, or a group."""
        return isinstance(self.reference, Ref)


class LintContext:
    """A scenario with what checks ask about it, computed once."""

    def __init__(self, loaded: Loaded, tree: Entries) -> None:
        self.loaded = loaded
        self.tree = tree
        self.scenario = loaded.scenario
        self.roster = loaded.roster

    @cached_property
    def models(self) -> list[tuple[Strict, Path]]:
        """All models of the scenario with their paths."""
        return list(walk(self.scenario))

    @cached_property
    def uses(self) -> list[Use]:
        """All places where something that is defined elsewhere is named."""
        return [
            Use(type(model), (*path, key), text, reference)
            for model, path in self.models
            for name, key, reference in refs_of(type(model))
            for text in _names(getattr(model, name), reference)
        ]

    @cached_property
    def entered_phases(self) -> frozenset[str]:
        """The phases that another phase or a rule enters: the first one only if something returns to it."""
        scenario, entered, todo = self.scenario, set[str](), [self.scenario.first_phase]
        for here in todo:
            model = scenario.phases.get(here)
            onward = [model.next] if model is not None and model.lasts_s is not None else []
            for rule in scenario.rules.values():
                if rule.is_active_in(here):
                    onward += [one.phase for one in rule.effects(SetsPhase)]
            entered.update(onward)
            todo += [phase for phase in dict.fromkeys(onward) if phase not in todo]
        return frozenset(entered)

    @cached_property
    def reachable_phases(self) -> frozenset[str]:
        """The phases that a half can ever be in."""
        return self.entered_phases | {self.scenario.first_phase}

    def is_reachable(self, rule: Rule) -> bool:
        """Return whether a rule is active in a phase that can be entered."""
        return any(rule.is_active_in(phase) for phase in self.reachable_phases)

    def reachable_rules(self) -> Iterator[tuple[str, Rule]]:
        """Yield the rules that can fire as far as phases go."""
        return ((name, rule) for name, rule in self.scenario.rules.items() if self.is_reachable(rule))

    def reachable_effects(self, kind: type[_E]) -> Iterator[tuple[_E, Rule, Path]]:
        """Yield the effects of one kind that these rules have, each with the path of its action."""
        for name, rule in self.reachable_rules():
            yield from ((effect, rule, path) for effect, path in effects_in(name, rule, kind))

    def members(self, names: str | tuple[str, ...], rule: Rule) -> frozenset[str]:
        """Return the members that names in a rule may stand for; ``each``, ``other`` and draws: all of theirs."""
        return frozenset(self.roster.may_be(names, rule))

    def moved(self, rule: Rule) -> frozenset[str]:
        """Return the entities that a rule may place or remove."""
        moving: list[Removes | Places] = [*rule.effects(Removes), *rule.effects(Places)]
        laid = [alternatives(self.scenario, one) for one in rule.effects(PlacesLayout) if not one.is_drawn]
        moving += [one for layouts in laid for layout in layouts for one in layout]
        return frozenset(name for one in moving for name in self.members(one.names, rule))

    def is_own(self, path: Path) -> bool:
        """Return whether a value or an entry stands in the author's own file, not in a base."""
        return mark_of(self.tree, path, at_key=True).file == self.tree.mark.file


def _names(value: Any, reference: Reference) -> Iterator[str]:
    if isinstance(value, str):
        yield value
    elif isinstance(value, dict) and reference.keys:
        yield from value
    elif isinstance(value, tuple):
        for part in value:
            yield from _names(part, reference)


class LintRule:
    """A check, ``class X(LintRule, code="…")``. Its docstring is the page of its code.

    ``message`` and ``help`` are filled in where it reports.

    Attributes:
        at_key: whether the key is reported, not its value.
    """

    code: ClassVar[Code]
    message: ClassVar[str]
    help: ClassVar[str]
    at_key: ClassVar[bool] = False

    def __init_subclass__(cls, code: str) -> None:
        texts = f"warning: {cls.message}\nhelp: {cls.help}".replace("{{", "{").replace("}}", "}")
        cls.code = Code(code, f"{inspect.getdoc(cls)}\n{texts}", "warning")

    def check(self, ctx: LintContext) -> Iterator[Diagnostic]:
        """Yield what is suspicious."""
        raise NotImplementedError

    def at(self, path: Path, *, help: str = "", **values: object) -> Diagnostic:  # noqa: A002 - as it is printed
        """Return an issue at a path, with the templates filled in; ``help`` replaces the check's own."""
        return issue(self.code, path, self.message.format(**values), (help or self.help).format(**values), self.at_key)
