"""Lint of what is written once for several: values that nothing uses, rules that do not differ, groups of groups."""

from __future__ import annotations

from collections.abc import Iterator

from rcj_challenges.scenario.errors import listing
from rcj_challenges.scenario.lint.suspect import Subject, Suspect
from rcj_challenges.scenario.reading.params import THIS
from rcj_challenges.scenario.tree import file_of


def check_repeated(subject: Subject) -> Iterator[Suspect]:
    """Values of the author's own ``repeat_for`` for which nothing in the rule stands, or none at all."""
    for name, repeated in subject.repeated.items():
        if subject.tree.mark.file != file_of(subject.tree, "rules", name):
            continue
        if set(repeated.unused) == set(repeated.known):
            yield Suspect(
                "repeated_in_vain",
                ("rules", name),
                "it is repeated, and nothing in it differs from one time to the next: all do the same",
                f"write {{param: {THIS}}} where the name belongs, or leave repeat_for out",
                at_key=True,
            )
            continue
        keys = [key for key in repeated.unused if key != THIS]
        if keys:
            what, them = (f"'{keys[0]}' stands", "it") if len(keys) == 1 else (f"{listing(keys)} stand", "them")
            yield Suspect(
                "repeated_value_never_used",
                ("rules", name),
                f"{what} beside the names in repeat_for, and nothing in the rule uses {them}",
                f"write {{param: {keys[0]}}} where the value belongs, or remove it from repeat_for",
                at_key=True,
            )


def check_groups_of_groups(subject: Subject) -> Iterator[Suspect]:
    """Rules for each, or things kept for each, of a group of groups that share members: one for each group is meant.

    Where no member is in two of them, the group of groups may be a way to write one large group.
    """
    scenario = subject.scenario
    named = [(("rules", name, "for_each"), rule.for_each) for name, rule in scenario.rules.items()]
    for section in ("counters", "flags", "timers"):
        named += [((section, name, "per"), entry.per) for name, entry in getattr(scenario, section).items()]
    for path, group in named:
        parts = [part for part in scenario.groups.get(group or "", ()) if part in subject.roster.groups]
        members = [member for part in parts for member in subject.roster.expand(part)]
        shared = next((member for member in members if members.count(member) > 1), None)
        if shared is None or subject.tree.mark.file != file_of(subject.tree, path[0], path[1]):
            continue
        what = "the rule is there" if path[0] == "rules" else "there is one"
        remedy = (
            f"a rule for each group is repeat_for: [{listing(parts)}], where {{param: {THIS}}} is the group"
            if path[0] == "rules"
            else f"give each of {listing(parts)} one of its own"
        )
        yield Suspect(
            "each_of_a_group_of_groups",
            path,
            f"'{group}' is made of groups, and {what} for each of their members, not for each of the groups "
            f"('{shared}' is in several)",
            f"{remedy}; or name a group without repeats",
        )
