"""Lint of what the referee listens to: whether the robots in question can tell it anything."""

from __future__ import annotations

from collections.abc import Iterator

from rcj_challenges.scenario.heard import as_said, can_be_heard, fits, has_channel, robots_that_speak, wanted
from rcj_challenges.scenario.lint.suspect import Subject, Suspect
from rcj_challenges.scenario.models.conditions import Message, Told
from rcj_challenges.scenario.models.state import ToldValue
from rcj_challenges.scenario.models.triggers import Tells
from rcj_challenges.scenario.tree import Path
from rcj_challenges.scenario.visiting import visit


def check_heard(subject: Subject) -> Iterator[Suspect]:
    """Messages that never come: no robot that is listened to can tell anything, or nothing that it tells is right."""
    speaking = frozenset(robots_that_speak(subject.scenario))
    deaf = not has_channel(subject.scenario)
    for name, rule in subject.scenario.rules.items():
        for model, path in visit(rule, ("rules", name)):
            if isinstance(model, Tells | Told):
                key, names = "entity", model.entity
            elif isinstance(model, ToldValue):
                key, names = "told", model.told
            else:
                continue
            if deaf or not subject.members(names, rule) & speaking:
                yield _nobody(names, (*path, key), deaf=deaf)
            elif isinstance(model, Message):
                yield from _nothing(model, path, subject)
    for model, path in visit(subject.scenario.broadcast, ("broadcast",)):
        if isinstance(model, ToldValue) and (deaf or model.told not in speaking):
            yield _nobody(model.told, (*path, "told"), deaf=deaf)


def _nobody(names: str | tuple[str, ...], path: Path, *, deaf: bool) -> Suspect:
    if deaf:
        reason = "the referee has no channel: no robot and no kit has a supervisor_receiver"
        return Suspect("never_heard", path, reason, "give one of them one under devices")
    return Suspect(
        "never_heard",
        path,
        f"none of {_shown(names)} can tell the referee anything: no program, or no team_emitter on board",
        "listen to robots that have both, or give them a team_emitter under devices",
    )


def _shown(names: str | tuple[str, ...]) -> str:
    return f"'{names}'" if isinstance(names, str) else ", ".join(f"'{name}'" for name in names)


def _nothing(message: Message, path: Path, subject: Subject) -> Iterator[Suspect]:
    """Yield a text that no message can be: it is not of the kind that is asked for, or is never heard as it stands."""
    asked = wanted(message, subject.scenario) or ()
    if not asked or any(can_be_heard(one) and fits(one, message, subject.scenario) for one in asked):
        return
    shown = ", ".join(f"'{one}'" if isinstance(one, str) else as_said(one) for one in asked)
    who = shown if len(asked) == 1 else f"none of {shown}"
    no = "no" if len(asked) == 1 else "a"
    if message.is_a is not None and not any(fits(one, message, subject.scenario) for one in asked if can_be_heard(one)):
        reason = f"{who} is {no} {message.is_a}"
    elif all(isinstance(one, int | float) for one in asked):
        reason = f"{who} is too large to be heard as a number"
    else:
        reason = f"{who} is {'never' if len(asked) == 1 else 'ever'} heard"
    remedy = "correct it; a message has single blanks between its words, and numbers are no larger than 1e9"
    yield Suspect("never_heard", (*path, "text"), f"{reason}, and so no message says it", remedy)
