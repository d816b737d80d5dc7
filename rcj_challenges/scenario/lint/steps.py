"""Lint of sequences that shall keep their steps, and lose them in a phase in which nobody follows them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from rcj_challenges.scenario.followed import followed, phases_of
from rcj_challenges.scenario.lint.suspect import Subject, Suspect, lives_in
from rcj_challenges.scenario.models.actions import SetPhase
from rcj_challenges.scenario.models.scenario import Rule
from rcj_challenges.scenario.models.triggers import HalfEnded, HalfStarted, PhaseEntered


class _Placed(NamedTuple):
    """A rule that puts somebody somewhere or takes him off.

    Attributes:
        rule: its name.
        lost_in: the phase in which his steps are lost all the same; None: they are kept.
    """

    rule: str
    lost_in: str | None


def check_kept_steps(subject: Subject) -> Iterator[Suspect]:
    """Sequences with ``when_placed: goes_on`` whose entity is only ever placed where the steps are lost anyway."""
    for name, sequence in subject.scenario.sequences.items():
        follows = phases_of(subject.scenario, name)
        if sequence.when_placed != "goes_on" or not follows:
            continue
        whose = frozenset(subject.roster.expand(followed(sequence)))
        placed = list(_placed(subject, follows, whose))
        lost = next((one for one in placed if one.lost_in is not None), None)
        if lost is None or any(one.lost_in is None for one in placed):
            continue
        yield Suspect(
            "steps_kept_in_vain",
            ("sequences", name, "when_placed"),
            f"when rule '{lost.rule}' has placed its entity the steps are lost all the same: no rule that names this "
            f"sequence lives in phase '{lost.lost_in}', and it begins anew after that",
            f"add '{lost.lost_in}' to the phases of one of the rules that name it, or write phases: any there",
        )


def _placed(subject: Subject, follows: frozenset[str], whose: frozenset[str]) -> Iterator[_Placed]:
    """Yield the rules that place one of those whose steps could be kept, once for each phase in which they do."""
    for name, rule in subject.standing():
        if not subject.moved(rule) & whose:
            continue
        entered = [action.phase for action in rule.actions if isinstance(action, SetPhase)]
        for phase in _fires_in(rule, subject):
            if phase not in follows:
                # Before a half is under way there is no step to lose.
                if any((before, phase) in subject.transitions for before in follows):
                    yield _Placed(name, phase)
            else:
                yield _Placed(name, None if not entered or entered[-1] in follows else entered[-1])


def _fires_in(rule: Rule, subject: Subject) -> frozenset[str]:
    """Return the phases in which a rule may fire while steps may be made."""
    if all(isinstance(trigger, HalfStarted | HalfEnded) for trigger in rule.triggers):
        return frozenset()
    phases = frozenset(phase for phase in subject.reached if lives_in(rule, phase))
    if all(isinstance(trigger, PhaseEntered) for trigger in rule.triggers):
        return phases & {trigger.phase for trigger in rule.triggers if isinstance(trigger, PhaseEntered)}
    return phases
