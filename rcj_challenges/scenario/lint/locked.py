"""Lint of flags that lock themselves: only rules that find them changed already would change them."""

from __future__ import annotations

from collections.abc import Iterator

from rcj_challenges.scenario.errors import listing
from rcj_challenges.scenario.lint.suspect import Subject, Suspect
from rcj_challenges.scenario.lint.unheard import asks_for_some, turns_flag
from rcj_challenges.scenario.models.conditions import AllOf, AnyOf, Condition, FlagIs
from rcj_challenges.scenario.models.scenario import Rule
from rcj_challenges.scenario.models.triggers import Holds
from rcj_challenges.scenario.tree import Path


def check_locked(subject: Subject) -> Iterator[Suspect]:
    """Rules that ask for a flag as nobody makes it but they themselves."""
    for flag, model in subject.scenario.flags.items():
        changed = not model.initial
        asking = {
            name: _where_it_asks(rule, flag, for_set=changed)
            for name, rule in subject.standing()
            if any(turns_flag(action, flag, to=changed) for action in rule.actions)
        }
        if None in asking.values():
            continue
        state, does = ("set", "sets") if changed else ("not set", "clears")
        only = f"no other rule {does} it"
        if len(asking) > 1:
            only = f"only rules that ask the same {does.removesuffix('s')} it: {listing(asking)}"
        opposite = (
            "negate: true asks that it is not set yet" if changed else "without negate it asks that it is still set"
        )
        remedy = f"{opposite}; else {does.removesuffix('s')} it in a rule without this condition"
        for name, where in asking.items():
            reason = f"it asks that flag '{flag}' is {state}, and {only}"
            yield Suspect("rule_never_fires", ("rules", name, *(where or ())), reason, remedy)


def _where_it_asks(rule: Rule, flag: str, *, for_set: bool) -> Path | None:
    """Return which part of a rule holds only if the flag, of whomever, is set or is not; None: none of them."""
    for index, condition in enumerate(rule.conditions):
        if _asks(condition, flag, for_set=for_set):
            return "conditions", index
    waits = all(isinstance(one, Holds) and _asks(one.condition, flag, for_set=for_set) for one in rule.triggers)
    return ("triggers", 0) if waits else None


def _asks(condition: Condition, flag: str, *, for_set: bool) -> bool:
    """Return whether a condition holds only if the flag, of whomever, is set or is not."""
    match condition:
        case FlagIs():
            return condition.flag == flag and asks_for_some(condition) == for_set
        case AllOf(negate=False, conditions=several):
            return any(_asks(one, flag, for_set=for_set) for one in several)
        case AnyOf(negate=False, conditions=several):
            return all(_asks(one, flag, for_set=for_set) for one in several)
    return False
