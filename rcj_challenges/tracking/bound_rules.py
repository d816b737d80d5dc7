"""A rule bound to one entity, its triggers, and its firings."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from rcj_challenges.core.amounts import Score

Test = Callable[[], bool]
"""A compiled condition: whether it holds now."""
Act = Callable[["Firing"], None]
"""A compiled action."""
Reader = Callable[["Firing"], Any]
"""Reads a value at the moment of a firing."""


@dataclass(slots=True)
class RuleHistory:
    """What a rule has done; shared by all things that ``other`` stands for.

    Attributes:
        rests_until: first tick at which it may fire again.
    """

    rests_until: int = 0
    executions: int = 0


@dataclass(eq=False)
class BoundRule:
    """A rule of the scenario, for one member of its ``for_each`` if it has one.

    Attributes:
        about: ``each`` if it is an entity or an obstacle; else None, and the trigger finds the entity.
        other: what ``other`` stands for; the rule fires only if that is touched. None: the rule does not name it.
        entrant: the entrant that ``each`` is, or for which it plays; else None.
        others: the rest of its group.
        phases: in which it is active; None: in all.
        exclusive: the group of which only one fires a tick, per entity.
        cooldown_s: how long it rests after firing, in s.
        says: the sentence; what is known only when it fires is not filled in yet.
        priority: rules with a lower one fire in an earlier round.
        rank: place in the order of firing, over all bound rules.
    """

    name: str
    each: str | None = None
    phases: frozenset[str] | None = None
    exclusive: tuple[str, str | None] | None = None
    cooldown_s: Reader | None = None
    max_executions: int | None = None
    says: str = ""
    priority: int = 0
    rank: int = 0
    tests: tuple[Test, ...] = ()
    actions: tuple[Act, ...] = ()
    past: RuleHistory = field(default_factory=RuleHistory)
    other: str | None = None
    about: str | None = None
    entrant: str | None = None
    others: tuple[str, ...] = ()

    def is_active_in(self, phase: str) -> bool:
        """Return whether the rule is active in a phase."""
        return self.phases is None or phase in self.phases


class Denial(NamedTuple):
    """Why a triggered rule did not fire in a tick.

    Attributes:
        condition: the place of the first of its conditions that did not hold.
        held_after: whether it held after the rules of that tick had acted.
    """

    condition: int
    held_after: bool


Denied = dict[str, dict[int, Denial]]
"""By rule and tick, why it did not fire."""


@dataclass(slots=True)
class Firing:
    """One firing while it happens: what the actions can name.

    Attributes:
        entity: what the trigger found (the name of an entity or an obstacle), or None.
        scored: points given so far, by entrant.
    """

    rule: BoundRule
    entity: str | None
    trigger: str
    measured: float | None = None
    limit: float | None = None
    scored: dict[str, Score] = field(default_factory=dict)

    @property
    def subject(self) -> str | None:
        """What the firing is about: the entity or obstacle that ``each`` is, else the one that the trigger found."""
        return self.rule.about if self.rule.about is not None else self.entity

    @property
    def place(self) -> str | None:
        """The zone, gate or entrant that ``each`` is, else None."""
        return self.rule.each if self.rule.about is None else None


NO_FIRING = Firing(BoundRule(""), None, "")
"""What belongs to no rule and to no entity reads values with it: the broadcast, lengths of timers and phases."""


@dataclass(frozen=True, slots=True)
class TriggerBinding:
    """Binds a rule to one of its triggers.

    Attributes:
        entity: the entity or obstacle it is about, or None.
        key: order among all bindings: the rule's rank, the trigger's place in the rule, the index of what it is about.
        by_time: whether a time sets it off, so that it fires after all else of its priority.
        applies: whether it counts now: it may be about one of the members of a role; None: it always does.
    """

    rule: BoundRule
    entity: str | None
    trigger: str
    key: tuple[int, int, int]
    by_time: bool = False
    applies: Test | None = None


@dataclass(frozen=True, slots=True)
class TriggerHit:
    """A trigger that fired in this tick; ``is_past``: whether an earlier round has undone it, None: nothing can."""

    binding: TriggerBinding
    measured: float | None = None
    limit: float | None = None
    is_past: Test | None = None

    @property
    def round(self) -> tuple[int, bool]:
        """The round in which it fires: its rule's priority, and whether a time set it off."""
        return self.binding.rule.priority, self.binding.by_time


class HitBuffer(list[TriggerHit]):
    """The triggers that fired in this tick."""

    def report(
        self,
        bindings: list[TriggerBinding],
        measured: float | None = None,
        limit: float | None = None,
        is_past: Test | None = None,
    ) -> None:
        """Add a hit for each of the bindings."""
        for binding in bindings:
            self.append(TriggerHit(binding, measured, limit, is_past))

    def first_by_rule(self) -> list[TriggerHit]:
        """Return one hit for each bound rule, in the order of firing; of several, the first trigger's of its round."""
        first: dict[int, TriggerHit] = {}
        for hit in sorted(self, key=lambda hit: (hit.round, hit.binding.key)):
            if hit.binding.applies is None or hit.binding.applies():
                first.setdefault(hit.binding.key[0], hit)
        return list(first.values())
