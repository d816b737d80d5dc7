"""Lint of what rules remember: counters never read, timers never started, things that nobody names."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from rcj_challenges.scenario.blanks import BLANKS, in_braces
from rcj_challenges.scenario.catalogue import BOUND
from rcj_challenges.scenario.drawn import series_of
from rcj_challenges.scenario.errors import listing, nearest
from rcj_challenges.scenario.lint.suspect import Subject, Suspect, Use, on_field
from rcj_challenges.scenario.models.actions import (
    Count,
    DrawAction,
    SequenceAction,
    SetFlag,
    SetSpot,
    TimerAction,
    ToggleFlag,
)
from rcj_challenges.scenario.models.conditions import Drawn
from rcj_challenges.scenario.models.scenario import Expectation, Given, Keyframe
from rcj_challenges.scenario.references import Named
from rcj_challenges.scenario.remembered import remembered_spots
from rcj_challenges.scenario.set_draws import drawn_from_the_start, set_from_the_start
from rcj_challenges.scenario.tree import Entries, Items, Leaf, Node, file_of
from rcj_challenges.scenario.visiting import visit

_TESTS = (Expectation, Given, Keyframe)
_WRITERS: dict[str, tuple[type[Any], ...]] = {
    "counters": (Count,),
    "flags": (SetFlag, ToggleFlag),
    "timers": (TimerAction,),
    "draws": (DrawAction,),
}


def check_state(subject: Subject) -> Iterator[Suspect]:
    """Counters, flags, timers and draws that are only written, only read, or neither."""
    scenario = subject.scenario
    for section, writers in _WRITERS.items():
        noun = section[:-1]
        for name in getattr(scenario, section):
            uses = [use for use in subject.uses if use.name == name and _may_name(use, section)]
            written = any(use.model in writers for use in uses)
            read = any(use.model not in (*writers, *_TESTS) for use in uses)
            if not read:
                changed = " changes and" if written else ""
                yield Suspect(
                    f"{noun}_never_read",
                    (section, name),
                    f"{noun} '{name}'{changed} is never read",
                    _how_to_read(noun, name),
                    at_key=True,
                )
            elif _needs_writing(section, getattr(scenario, section)[name]) and not (
                written and _is_set_going(section, name, subject)
            ):
                verb, how = _WRITING[section]
                held = ", only stopped or reset" if written else ""
                yield Suspect(
                    f"{noun}_never_{verb}",
                    (section, name),
                    f"{noun} '{name}' is read and never {verb}{held}",
                    f"add {{action: {how.format(name=name)}}} to a rule, or remove it",
                    at_key=True,
                )


def check_draws(subject: Subject) -> Iterator[Suspect]:
    """Draws without repetition, or that a test decides several times, that are drawn only once, or set by a rule."""
    scenario = subject.scenario
    again = {model.draw for model, _ in subject.models if isinstance(model, DrawAction) and model.as_ is None}
    for name, draw in scenario.draws.items():
        # Otherwise each half draws, and a match may have several.
        once = draw.not_again == "half" or draw.keep == "match" or scenario.match.halves == 1
        if draw.not_again is not None and once and name not in again:
            yield Suspect(
                "draw_never_repeated",
                ("draws", name, "not_again"),
                f"it is drawn once in a {draw.not_again}: nothing can come again",
                f"add {{action: draw, draw: {name}}} to a rule, or leave not_again out",
            )
    is_set, is_drawn = set_from_the_start(scenario), drawn_from_the_start(scenario)
    for test, expected in scenario.expect.items():
        for name, decided in expected.draws.items():
            if name in is_set:
                yield Suspect(
                    "draw_decided_in_vain",
                    ("expect", test, "draws", name),
                    f"a rule sets '{name}' as the half starts, whatever was decided here",
                    "let the test lead up to that value, or keep what 'given' can set: a counter or a flag",
                )
            elif name in is_drawn and len(series := series_of(decided)) == 1:
                yield Suspect(
                    "draw_decided_in_vain",
                    ("expect", test, "draws", name),
                    f"a rule draws '{name}' anew as the half starts, and nothing asks before what was decided here",
                    f"write a list whose second value is for that rule, '{name}: [{series[0]}, {series[0]}]', or take "
                    "the draw out of the rule: each half draws as it starts",
                )
            elif isinstance(decided, tuple) and len(decided) > 1 and name not in again:
                yield Suspect(
                    "draw_never_repeated",
                    ("expect", test, "draws", name),
                    f"no rule draws '{name}' anew: only the first of these values comes",
                    f"write '{name}: {decided[0]}', or add {{action: draw, draw: {name}}} to a rule",
                )


def check_drawn_names(subject: Subject) -> Iterator[Suspect]:
    """Draws whose values stand for somebody (rules ask whether it is `each`), and one of them for nobody."""
    compared = (Drawn, DrawAction)
    asked: dict[str, set[str]] = {}
    for name, rule in subject.scenario.rules.items():
        for model, _ in visit(rule, ("rules", name)):
            value = getattr(model, "equals", None) if isinstance(model, Drawn) else getattr(model, "as_", None)
            if isinstance(model, compared) and isinstance(value, str) and value in BOUND:
                asked.setdefault(model.draw, set()).update(subject.members(value, rule))
    things = ("robots", "balls", "obstacles")
    taken_away = {path[1] for path in subject.removed if len(path) == 2 and path[0] in things}
    for draw, members in asked.items():
        for index, value in enumerate(subject.scenario.draws[draw].values):
            if not isinstance(value, str) or value in members or value in subject.roster.index:
                continue
            # A value that is meant for nobody, such as `nobody`, is no mistake.
            hint = nearest(value, members, _LIKE_A_NAME)
            if value in taken_away or hint:
                gone = f"'{value}' was taken away" if value in taken_away else f"'{value}' is nobody's name{hint}"
                yield Suspect(
                    "drawn_name_of_nobody",
                    ("draws", draw, "values", index),
                    f"{gone}, and rules ask for whom it is drawn" if value in taken_away else gone,
                    f"write the values of '{draw}' anew without it" if value in taken_away else "correct it",
                )


_LIKE_A_NAME = 0.75
"""How like a name on the field a value must be to be taken for it, misspelt."""


def check_spots(subject: Subject) -> Iterator[Suspect]:
    """Spots that rules set and nothing reads."""
    draws, uses = subject.scenario.draws, (use for use in subject.uses if on_field(use) and use.model not in _TESTS)
    read = {use.name for use in uses if not (use.model is SetSpot and use.path[-1] == "spot")}
    # A draw may decide among spots.
    read |= {str(value) for name in read & draws.keys() for value in draws[name].values}
    members = subject.roster.expand(tuple(read))
    for name in remembered_spots(subject.scenario):
        if name not in members:
            yield Suspect(
                "spot_never_read",
                ("spots", name),
                f"spot '{name}' is set and nothing asks where it is",
                "put something there, measure a distance to it, or remove the action set_spot",
                at_key=True,
            )


_WRITING = {
    "counters": ("counted", "count, counter: {name}"),
    "flags": ("set", "set_flag, flag: {name}"),
    "timers": ("started", "timer, timer: {name}"),
}


def _may_name(use: Use, section: str) -> bool:
    if isinstance(use.reference, Named):
        return section in use.reference.sections
    return section == "draws" and use.reference.drawn


def _needs_writing(section: str, entry: Any) -> bool:
    """Draws are drawn at the start, and a timer may start by itself; a counter or flag that stays is a constant."""
    return section in _WRITING and not (section == "timers" and entry.starts)


def _is_set_going(section: str, name: str, subject: Subject) -> bool:
    """Return whether one of the actions that name an entry makes it change: to stop a timer does not."""
    return section != "timers" or any(
        isinstance(model, TimerAction) and model.timer == name and model.do in ("restart", "start")
        for model, _ in subject.models
    )


def _how_to_read(noun: str, name: str) -> str:
    read = {
        "counter": f"read it in a condition, in points:, in broadcast: or in result:, or remove '{name}'",
        "flag": f"read it in {{condition: flag, flag: {name}}}, in points: or in mirror:, or remove it",
        "timer": f"wait for {{trigger: timer_expired, timer: {name}}}, read it in a condition, or remove it",
        "draw": f"read it as {{draw: {name}}} or in {{condition: drawn}}, or remove it",
    }
    return read[noun]


def check_params(subject: Subject) -> Iterator[Suspect]:
    """Params of the author's own file for which nothing stands. What a base brought is not the author's to tidy up."""
    used = set(_params_in(subject.tree))
    told = {name for rule in subject.scenario.rules.values() for name in in_braces(rule.says)} - set(BLANKS)
    for name in subject.scenario.params:
        if name in told or name in used:
            continue
        if subject.tree.mark.file == file_of(subject.tree, "params", name):
            yield Suspect(
                "param_never_used",
                ("params", name),
                f"param '{name}' is never used: to change it changes nothing",
                f"write {{param: {name}}} where the value belongs, or remove it",
                at_key=True,
            )


def _params_in(node: Node) -> Iterator[str]:
    if isinstance(node, Leaf):
        yield node.param
    for inner in node.entries.values() if isinstance(node, Entries) else node.items if isinstance(node, Items) else ():
        yield from _params_in(inner)


def check_unused(subject: Subject) -> Iterator[Suspect]:
    """Zones, gates, spots, groups, sequences and layouts of the author's own file that nothing names."""
    scenario = subject.scenario
    written = {use.name for use in subject.uses if on_field(use)}
    written |= {str(value) for name in written & scenario.draws.keys() for value in scenario.draws[name].values}
    named = written | {member for name in written for member in subject.roster.expand(name)}
    remembered = remembered_spots(scenario)
    yield from _unused_groups(subject, written)
    for section, noun in _NAMED_SECTIONS.items():
        for name, entry in getattr(scenario, section).items():
            if section in ("gates", "zones", "spots"):
                # Of a spot that rules set, `check_spots` says whether something reads it.
                used = name in named or bool(getattr(entry, "drawn", False)) or name in remembered
            else:
                used = _is_named(name, section, subject)
            if not used and subject.tree.mark.file == file_of(subject.tree, section, name):
                reason, remedy = (
                    f"{noun} '{name}' is never used",
                    f"name it in a rule, or {_away(section, name, subject)}{_with_groups(name, subject)}",
                )
                if section == "sequences" and any(use.name == name for use in subject.uses if _resets(use)):
                    reason = f"sequence '{name}' only begins anew: its steps decide nothing"
                    remedy = (
                        f"wait for {{trigger: sequence_completed, sequence: {name}}}, or remove it together with "
                        "the action that names it"
                    )
                yield Suspect(f"{noun}_never_used", (section, name), reason, remedy, at_key=True)


_NAMED_SECTIONS = {"gates": "gate", "zones": "zone", "spots": "spot", "sequences": "sequence", "placements": "layout"}


def _unused_groups(subject: Subject, written: set[str]) -> Iterator[Suspect]:
    """Groups that nothing names, not even another group."""
    groups = subject.scenario.groups
    nested = {member for members in groups.values() for member in members}
    for name in groups:
        if name not in written | nested and subject.tree.mark.file == file_of(subject.tree, "groups", name):
            reason = f"group '{name}' is never used"
            remedy = f"name it in a rule, or {_away('groups', name, subject)}"
            yield Suspect("group_never_used", ("groups", name), reason, remedy, at_key=True)


def _away(section: str, name: str, subject: Subject) -> str:
    """Return how something goes: left out, what the base brings would be there again with its own numbers."""
    if (section, name) in subject.overridden:
        return f"take away what the base brings by '{name}: null'"
    return "remove it"


def _with_groups(name: str, subject: Subject) -> str:
    """Return the groups that name something and have no use either: without it they would name what is not there."""
    groups = [group for group, members in subject.scenario.groups.items() if name in members]
    which = "group that names" if len(groups) == 1 else "groups that name"
    return f" together with the {which} it: {listing(groups)}" if groups else ""


def _resets(use: Use) -> bool:
    return use.model is SequenceAction


def _is_named(name: str, section: str, subject: Subject) -> bool:
    # To begin a sequence anew is no use of it if nothing asks how far it is.
    uses = (use for use in subject.uses if not _resets(use))
    if any(use.name == name and _may_name(use, section) for use in uses):
        return True
    # A layout may be one of the values of a draw.
    return section == "placements" and any(name in draw.values for draw in subject.scenario.draws.values())


def check_inherited_tests(subject: Subject) -> Iterator[Suspect]:
    """Tests of what the scenario extends that were left out, because they do not fit it."""
    left_out = subject.left_out
    if not left_out:
        return
    names = list(left_out)
    first = left_out[names[0]]
    told = f"one test of {first.file} does" if len(names) == 1 else f"{len(names)} tests of {first.file} do"
    yield Suspect(
        "inherited_test_left_out",
        (),
        f"{told} not fit this scenario and {'is' if len(names) == 1 else 'are'} left out: {', '.join(names)} "
        f"(line {first.line}: {first.message})",
        "remove each with 'NAME: null' under expect, or all inherited tests with 'inherited: null' there, "
        "and test what you changed with tests of your own",
    )
