"""Rules that hear how a half starts, in their turn: which surely fire, and which others have kept from it by then."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from rcj_challenges.rules.actions.set_phase import SetPhase
from rcj_challenges.rules.triggers.half_started import HalfStarted
from rcj_challenges.scenario.models.scenario import Scenario


class Turn(NamedTuple):
    """A rule that hears how a half starts, when its turn comes.

    Attributes:
        name: of the rule.
        phases: in one of these it is by then: a rule before may have left the first.
        lives: in these of them the rule lives.
        surely: whether it fires in every half, whatever else is so.
    """

    name: str
    phases: frozenset[str]
    lives: frozenset[str]
    surely: bool


def turns(scenario: Scenario) -> Iterator[Turn]:
    """Yield the rules that hear how a half starts, in the order in which they fire."""
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


def starting_each_half(scenario: Scenario) -> frozenset[str]:
    """Return the rules that fire as each half starts, whatever else is so."""
    return frozenset(turn.name for turn in turns(scenario) if turn.surely)
