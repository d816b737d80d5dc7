"""Lint of what the referee listens to: whether the robots in question can tell it anything."""

from __future__ import annotations

from collections.abc import Iterator

from rcj_challenges.scenario.heard import robots_that_speak
from rcj_challenges.scenario.lint_suspect import Subject, Suspect
from rcj_challenges.scenario.models.conditions import Told
from rcj_challenges.scenario.models.state import ToldValue
from rcj_challenges.scenario.models.triggers import Tells
from rcj_challenges.scenario.visiting import visit


def check_heard(subject: Subject) -> Iterator[Suspect]:
    """Messages that never come: no robot that is listened to has a program and an emitter."""
    speaking = frozenset(robots_that_speak(subject.scenario))
    for name, rule in subject.scenario.rules.items():
        for model, path in visit(rule, ("rules", name)):
            if isinstance(model, Tells | Told):
                key, names = "entity", model.entity
            elif isinstance(model, ToldValue):
                key, names = "told", model.told
            else:
                continue
            if not subject.members(names, rule) & speaking:
                yield Suspect(
                    "never_heard",
                    (*path, key),
                    f"none of {_shown(names)} can tell the referee anything: no program, or no team_emitter on board",
                    "listen to robots that have both, or give them a team_emitter under devices",
                )


def _shown(names: str | tuple[str, ...]) -> str:
    return f"'{names}'" if isinstance(names, str) else ", ".join(f"'{name}'" for name in names)
