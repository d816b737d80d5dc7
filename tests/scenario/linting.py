"""Sound scenarios with something added, for the tests of lint."""

from __future__ import annotations

from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.scenario.lint.registry import lint
from rcj_challenges.scenario.load import load_text

SOUND = """schema_version: 1
id: sound
title: Sound
extends: soccersim_v2
match: {half_s: 60}
"""


GOAL = """  goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    actions: [{action: score, entrant: yellow}]
    says: A goal.
"""


def lint_of(*sections: str, rules: str = "", halves: int | None = None) -> list[Diagnostic]:
    """Return the warnings about a sound scenario with more sections and rules."""
    sound = SOUND if halves is None else SOUND.replace("half_s: 60", f"half_s: 60, halves: {halves}")
    text = sound + "".join(f"{section}\n" for section in sections) + "rules:\n" + GOAL + rules
    return lint(load_text(text, file="it.yaml"))


def codes(*sections: str, rules: str = "", halves: int | None = None) -> list[str]:
    """Return the codes of these warnings."""
    return [one.code for one in lint_of(*sections, rules=rules, halves=halves)]


def rule(name: str, trigger: str, actions: str = "{action: emit, event: TOLD}", more: str = "") -> str:
    """Return a rule with a sentence."""
    return f"  {name}: {{triggers: [{trigger}], actions: [{actions}], says: It is so.{more}}}\n"
