"""Lint of phases that hold the robots."""

from __future__ import annotations

from collections.abc import Iterator
from math import inf

from rcj_challenges.scenario.errors import listing
from rcj_challenges.scenario.lint_suspect import Subject, Suspect, lengths_s, lives_in
from rcj_challenges.scenario.models.scenario import Rule
from rcj_challenges.scenario.models.triggers import NoProgress


def check_held(subject: Subject) -> Iterator[Suspect]:
    """Phases that hold robots in vain or for ever, and rules that expect held robots to move."""
    scenario = subject.scenario
    held = [name for name, phase in scenario.phases.items() if phase.robots == "held" and name in subject.reached]
    driven = {robot for entrant in scenario.entrants.values() for robot in entrant.robots}
    if held and not driven:
        yield Suspect(
            "hold_without_effect",
            ("phases", held[0], "robots"),
            "no robot has a program, and so none drives",
            "leave it out, or name who drives under entrants:",
        )
    elif held and subject.reached == set(held):
        yield Suspect(
            "robots_never_free",
            ("phases", held[0], "robots"),
            f"robots are held in every phase that is ever entered, {listing(held)}, so that none ever drives",
            "enter a phase in which they are free: give this one lasts_s, or a rule that sets another",
        )
    else:
        for name, rule in subject.standing():
            yield from _expected_to_move(name, rule, held, driven, subject)


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
    return inf if lasts_s is None else max(lengths_s(lasts_s, subject.scenario))
