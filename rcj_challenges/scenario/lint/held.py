"""Lint of phases and rules that hold robots."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from math import inf
from typing import NamedTuple

from rcj_challenges.scenario.errors import listing
from rcj_challenges.scenario.halves import longest_half_s
from rcj_challenges.scenario.lint.suspect import Subject, Suspect, lengths_s, lives_in
from rcj_challenges.scenario.models.actions import End, Hold, Release, SetPhase
from rcj_challenges.scenario.models.base import Strict
from rcj_challenges.scenario.models.conditions import IsHeld
from rcj_challenges.scenario.models.scenario import Rule
from rcj_challenges.scenario.models.state import HeldValue
from rcj_challenges.scenario.models.triggers import (
    Crosses,
    Displaced,
    Enters,
    Leaves,
    NoProgress,
    SequenceBroken,
    SequenceCompleted,
    TipsOver,
    Touches,
)
from rcj_challenges.scenario.tree import Path
from rcj_challenges.scenario.visiting import visit

_NO_PROGRAM = "no robot has a program, and so none drives"
_WHO_DRIVES = "leave it out, or name who drives under entrants:"
_OF_MOTION = (Enters, Leaves, Crosses, Touches, Displaced, TipsOver, SequenceCompleted, SequenceBroken)
"""What never comes where nothing moves."""


def check_held(subject: Subject) -> Iterator[Suspect]:
    """Phases that hold robots in vain or for ever, and rules that expect held robots to move."""
    held = _holding_phases(subject)
    driven = _driven(subject)
    if held and not driven:
        yield Suspect("hold_without_effect", ("phases", held[0], "robots"), _NO_PROGRAM, _WHO_DRIVES)
    elif held and subject.reached == set(held):
        yield Suspect(
            "robots_never_free",
            ("phases", held[0], "robots"),
            f"robots are held in every phase that is ever entered, {listing(held)}, so that none ever drives",
            "enter a phase in which they are free: give this one lasts_s, or a rule that sets another",
        )
    else:
        for phase in held:
            yield from _never_left(phase, subject)
        for name, rule in subject.standing():
            yield from _expected_to_move(name, rule, held, driven, subject)


def _holding_phases(subject: Subject) -> list[str]:
    phases = subject.scenario.phases.items()
    return [name for name, phase in phases if phase.robots == "held" and name in subject.reached]


def _driven(subject: Subject) -> set[str]:
    """Return the robots that have a program."""
    return {robot for entrant in subject.scenario.entrants.values() for robot in entrant.robots}


def _never_left(phase: str, subject: Subject) -> Iterator[Suspect]:
    """A phase that holds all robots and that neither its length nor a rule ends."""
    if subject.scenario.phases[phase].lasts_s is not None:
        return
    rules = {name: rule for name, rule in subject.standing() if lives_in(rule, phase)}
    ways_out = {name: rule for name, rule in rules.items() if _leaves(rule, phase)}
    still = _is_still(phase, rules.values(), subject)
    if any(not still or not _waits_for_motion(rule) for rule in ways_out.values()):
        return
    why = "no rule that lives in it sets another phase or ends the half"
    if ways_out:
        why = f"{listing([repr(name) for name in ways_out])} would leave it once something moves, and nothing does"
    yield Suspect(
        "phase_never_left",
        ("phases", phase, "robots"),
        f"robots are held to the end of the half: '{phase}' has no lasts_s, and {why}",
        f"give it lasts_s, or a rule with phases: [{phase}] and {{action: set_phase, …}}; where all is over, write "
        "{action: end} in place of the phase",
    )


def _leaves(rule: Rule, phase: str) -> bool:
    return any(
        isinstance(action, End) or (isinstance(action, SetPhase) and action.phase != phase) for action in rule.actions
    )


def _is_still(phase: str, rules: Iterable[Rule], subject: Subject) -> bool:
    """Return whether nothing moves in a phase that holds all: a half begins in it, and no rule of it puts anything."""
    comes_back = any(to == phase for _, to in subject.transitions)
    return phase == subject.scenario.first_phase and not comes_back and not any(map(subject.put, rules))


def _waits_for_motion(rule: Rule) -> bool:
    return all(isinstance(trigger, _OF_MOTION) for trigger in rule.triggers)


def _expected_to_move(name: str, rule: Rule, held: list[str], driven: set[str], subject: Subject) -> Iterator[Suspect]:
    for index, trigger in enumerate(rule.triggers):
        if not isinstance(trigger, NoProgress) or not subject.members(trigger.entity, rule) & driven:
            continue
        for phase in held:
            if lives_in(rule, phase) and _longest_s(phase, subject) >= trigger.within_s:
                yield Suspect(
                    "held_robot_makes_no_progress",
                    ("rules", name, "triggers", index),
                    f"phase '{phase}' holds the robots for as long as the {trigger.within_s:g} s of this window or "
                    "longer, and the rule lives in it: it finds robots that may not move",
                    f"leave '{phase}' out of its phases",
                )


def _longest_s(phase: str, subject: Subject) -> float:
    lasts_s = subject.scenario.phases[phase].lasts_s
    return inf if lasts_s is None else max(lengths_s(lasts_s, subject.scenario), default=0.0)


# --- rules that hold robots -------------------------------------------------------------------------------------------


class _Naming(NamedTuple):
    """A part of a rule that holds robots, lets them go, or asks whether they are held, and whom it names."""

    model: Strict
    path: Path
    robots: frozenset[str]


def check_holds(subject: Subject) -> Iterator[Suspect]:
    """Rules that hold robots in vain or for ever, let go whom no rule holds, or ask for what never is."""
    named = list(_named(subject))
    held = {robot for one in named if isinstance(one.model, Hold) for robot in one.robots}
    freed = {robot for one in named if isinstance(one.model, Release) for robot in one.robots}
    driven, phases = _driven(subject), _holding_phases(subject)
    for one in named:
        match one.model:
            case Hold(for_s=for_s):
                yield from _hold(one, driven, freed, subject, lasts=for_s is None)
            case Release() if not one.robots & held:
                yield _release(one, phases)
            case IsHeld() | HeldValue() if not one.robots & held and not phases:
                are = "are" if len(one.robots) > 1 else "is"
                yield Suspect(
                    "never_held",
                    one.path,
                    f"it asks whether {listing(sorted(one.robots))} {are} held, and no rule or phase does that",
                    "write a rule that does: {action: hold, entity: …}, or leave it out",
                )


def _named(subject: Subject) -> Iterator[_Naming]:
    for name, rule in subject.standing():
        for model, path in visit(rule, ("rules", name)):
            if isinstance(model, Hold | Release | IsHeld):
                yield _Naming(model, path, subject.members(model.entity, rule))
            elif isinstance(model, HeldValue):
                yield _Naming(model, path, subject.members(model.held, rule))
    for model, path in visit(subject.scenario.broadcast, ("broadcast",)):
        if isinstance(model, HeldValue):
            yield _Naming(model, path, frozenset(subject.roster.expand(model.held)))


def _hold(one: _Naming, driven: set[str], freed: set[str], subject: Subject, *, lasts: bool) -> Iterator[Suspect]:
    if not one.robots & driven:
        who = listing(sorted(one.robots))
        reason = f"no program drives {who}: nothing but a push moves {'it' if len(one.robots) == 1 else 'them'} anyway"
        yield Suspect("hold_without_effect", one.path, reason, _WHO_DRIVES)
        return
    for_ever = one.robots & driven - freed
    if lasts and for_ever:
        half_s = longest_half_s(subject.scenario.match)
        yield Suspect(
            "held_for_ever",
            one.path,
            f"it has no for_s, and no rule lets {listing(sorted(for_ever))} go again",
            f"give it for_s, or write a rule with {{action: release, entity: …}}; to the end of the half is for_s: "
            f"{half_s:g}",
        )


def _release(one: _Naming, phases: list[str]) -> Suspect:
    also = f"; what phase '{phases[0]}' holds is held until it is over, whatever rules do" if phases else ""
    return Suspect(
        "release_without_effect",
        one.path,
        f"no rule holds {listing(sorted(one.robots))}{also}",
        "leave it out, or hold them by a rule: {action: hold, entity: …}",
    )
