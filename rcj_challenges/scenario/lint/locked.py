"""Lint of flags that lock themselves: only rules that find them changed already would change them."""

from __future__ import annotations

from collections.abc import Iterator

from rcj_challenges.scenario.errors import listing
from rcj_challenges.scenario.lint.suspect import Subject, Suspect
from rcj_challenges.scenario.lint.unheard import asks_for_some, turns_flag
from rcj_challenges.scenario.models.conditions import FlagIs
from rcj_challenges.scenario.models.scenario import Rule


def check_locked(subject: Subject) -> Iterator[Suspect]:
    """Rules that ask for a flag as nobody makes it but they themselves."""
    for flag, model in subject.scenario.flags.items():
        changed = not model.initial
        asking = {
            name: _asks(rule, flag, for_set=changed)
            for name, rule in subject.standing()
            if any(turns_flag(action, flag, to=changed) for action in rule.actions)
        }
        if any(index is None for index in asking.values()):
            continue
        state, does = ("set", "sets") if changed else ("not set", "clears")
        only = f"no other rule {does} it"
        if len(asking) > 1:
            only = f"only rules that ask the same {does.removesuffix('s')} it: {listing(asking)}"
        opposite = (
            "negate: true asks that it is not set yet" if changed else "without negate it asks that it is still set"
        )
        remedy = f"{opposite}; else {does.removesuffix('s')} it in a rule without this condition"
        for name, index in asking.items():
            reason = f"it asks that flag '{flag}' is {state}, and {only}"
            yield Suspect("rule_never_fires", ("rules", name, "conditions", index or 0), reason, remedy)


def _asks(rule: Rule, flag: str, *, for_set: bool) -> int | None:
    """Return which condition of a rule holds only if the flag, of whomever, is set or is not; None: none of them."""
    for index, condition in enumerate(rule.conditions):
        if isinstance(condition, FlagIs) and condition.flag == flag and asks_for_some(condition) == for_set:
            return index
    return None
