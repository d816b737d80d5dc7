"""Rules that fire as a half starts, in their order: which of them always do, and in which phases."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import groupby
from typing import NamedTuple

from rcj_challenges.rules.actions.set_phase import SetPhase
from rcj_challenges.rules.triggers.half_started import HalfStarted
from rcj_challenges.scenario.models.scenario import Scenario


class Turn(NamedTuple):
    """A rule with the trigger ``half_started``, when its turn comes.

    Attributes:
        name: of the rule.
        phases: one of these is on by then: a rule of a lower priority may have left the first phase.
        lives: those of them in which the rule is active.
        surely: whether it fires in every half.
    """

    name: str
    phases: frozenset[str]
    lives: frozenset[str]
    surely: bool


def rules_at_start(scenario: Scenario) -> Iterator[Turn]:
    """Yield the rules with the trigger ``half_started``, in the order in which they fire."""
    first = frozenset({scenario.first_phase})
    phases = first
    starting = [one for one in scenario.rules.items() if any(isinstance(two, HalfStarted) for two in one[1].triggers)]
    for _, group in groupby(sorted(starting, key=lambda one: one[1].priority), key=lambda one: one[1].priority):
        then = phases  # a phase that a rule sets begins after the rules of its priority
        for name, rule in group:
            own = phases | first if rule.phases == "any" else frozenset(rule.phases)
            if not first <= own:
                continue
            surely = phases <= own and not rule.conditions and rule.exclusive is None
            yield Turn(name, phases, phases & own, surely)
            entered = [action.phase for action in rule.actions if isinstance(action, SetPhase)][:1]
            if entered and phases & own and then == phases:
                then = frozenset(entered) if surely else then.union(entered)
            elif entered and phases & own:
                then = then.union(entered)
        phases = then


def firing_each_half(scenario: Scenario) -> frozenset[str]:
    """Return the rules that fire as each half starts, in any case."""
    return frozenset(turn.name for turn in rules_at_start(scenario) if turn.surely)
