"""Rules that fire as a half starts, in their order: which of them always do, and in which phases."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from rcj_challenges.rules.actions.set_phase import SetPhase
from rcj_challenges.rules.triggers.half_started import HalfStarted
from rcj_challenges.scenario.models.scenario import Scenario


class Turn(NamedTuple):
    """A rule with the trigger ``half_started``, when its turn comes.

    Attributes:
        name: of the rule.
        phases: one of these is on by then: a rule before may have left the first phase.
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
    for name, rule in sorted(scenario.rules.items(), key=lambda named: named[1].priority):
        own = phases | first if rule.phases == "any" else frozenset(rule.phases)
        if first <= own and any(isinstance(trigger, HalfStarted) for trigger in rule.triggers):
            surely = phases <= own and not rule.conditions and rule.exclusive is None
            yield Turn(name, phases, phases & own, surely)
            entered = [action.phase for action in rule.actions if isinstance(action, SetPhase)][-1:]
            if entered and phases & own:
                phases = frozenset(entered) if surely else phases.union(entered)


def firing_each_half(scenario: Scenario) -> frozenset[str]:
    """Return the rules that fire as each half starts, in any case."""
    return frozenset(turn.name for turn in rules_at_start(scenario) if turn.surely)
