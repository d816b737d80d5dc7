"""Lint of what is measured: a sentence or a payload that tells it in another unit than the trigger measures."""

from __future__ import annotations

import re
from collections.abc import Iterator

from rcj_challenges.scenario.errors import listing
from rcj_challenges.scenario.lint.suspect import Subject, Suspect
from rcj_challenges.scenario.models import triggers
from rcj_challenges.scenario.models.actions import Count, Emit, Score
from rcj_challenges.scenario.models.conditions import Distance, Speed, WayIs
from rcj_challenges.scenario.models.scenario import Rule
from rcj_challenges.scenario.models.state import WordValue
from rcj_challenges.scenario.tree import Path
from rcj_challenges.scenario.visiting import visit

_UNITS: dict[type[object], str] = {
    triggers.Displaced: "m",
    triggers.NoProgress: "m",
    triggers.TipsOver: "rad",
    triggers.StaysIn: "s",
    triggers.Holds: "s",
    triggers.TimeReached: "s",
    triggers.TimerExpired: "s",
    triggers.SequenceCompleted: "s",
    triggers.SequenceBroken: "s",
}
"""What each trigger measures in; others measure nothing."""
_SAID = {
    **dict.fromkeys(("m", "metre", "metres", "meter", "meters"), "m"),
    **dict.fromkeys(("s", "sec", "second", "seconds"), "s"),
    **dict.fromkeys(("rad", "radian", "radians"), "rad"),
    **dict.fromkeys(("mm", "cm", "km", "ms", "min", "minute", "minutes", "degree", "degrees", "°", "m/s", "km/h"), ""),
}
"""Units that authors write behind a number, and that in which a trigger may measure it; most are none."""
_BLANK_AND_UNIT = re.compile(r"\{(measured|limit)\}\s*(m/s|km/h|°|[A-Za-z]+)")
_OF_LENGTH = frozenset({"m", "cm", "mm", "mps", "distance", "way", "speed", "metres", "meters"})
"""Parts of a payload's key that promise a distance, a way or a speed."""
_MEASURED = frozenset({"measured", "limit"})
_IN_HOLDS = "holds measures how long the condition has held, in s, whatever it compares"


def check_units(subject: Subject) -> Iterator[Suspect]:
    """What is measured, told as if it were something else."""
    for name, rule in subject.scenario.rules.items():
        measured = {unit: trigger for trigger in rule.triggers if (unit := _UNITS.get(type(trigger)))}
        if not measured:
            continue
        for blank, said in dict.fromkeys(_BLANK_AND_UNIT.findall(rule.says)):
            if said in _SAID and _SAID[said] not in measured:
                yield Suspect(
                    "measured_in_another_unit",
                    ("rules", name, "says"),
                    f"{{{blank}}} is told in {said}, and this rule measures in {listing(measured)}{_why(rule)}",
                    f"write {{{blank}}} {next(iter(measured))}, or leave it out",
                )
        if set(measured) == {"s"}:
            yield from _taken_for_a_length(name, rule)


def _why(rule: Rule) -> str:
    return f": {_IN_HOLDS}" if any(isinstance(trigger, triggers.Holds) for trigger in rule.triggers) else ""


def _taken_for_a_length(name: str, rule: Rule) -> Iterator[Suspect]:
    """Find words in payloads and points that a time fills, and that promise a distance or a speed."""
    # A rule that fires once has held for a time that stands in the file: as points it can only be a mistake.
    once = all(isinstance(one, triggers.Holds) and one.every_s is None and _compares(one) for one in rule.triggers)
    for index, action in enumerate(rule.actions):
        for model, path in visit(action, ("rules", name, "actions", index)):
            if not isinstance(model, WordValue) or model.word not in _MEASURED:
                continue
            promised = isinstance(action, Emit) and _OF_LENGTH & set(_key(path).lower().split("_"))
            if promised or (once and isinstance(action, Score | Count)):
                yield Suspect(
                    "measured_in_another_unit",
                    (*path, "word"),
                    f"'{model.word}' is a time here, in s{_why(rule)}",
                    "tell how far it is by {distance: [ONE, OTHER]}, how far it came by {way: ONE}, or leave it out",
                )


def _key(path: Path) -> str:
    at = path.index("payload") if "payload" in path else len(path) - 1
    return str(path[at + 1]) if at + 1 < len(path) else ""


def _compares(trigger: triggers.Holds) -> bool:
    """Return whether a condition is about a distance, a way or a speed."""
    return any(isinstance(model, Distance | WayIs | Speed) for model, _ in visit(trigger))
