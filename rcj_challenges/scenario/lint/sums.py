"""Lint of parts of a list that is added up: what each of several has, read as that of all of them."""

from __future__ import annotations

from collections.abc import Iterator

from rcj_challenges.scenario.lint.suspect import Subject, Suspect
from rcj_challenges.scenario.models.state import WeightedCounter, WeightedFlag, WeightedTimer
from rcj_challenges.scenario.visiting import visit

_READ_AS = {
    "counter": "the sum of those of all of '{per}'",
    "flag": "1 if that of any of '{per}' is set",
    "timer": "the longest of those of all of '{per}'",
}


def check_sums(subject: Subject) -> Iterator[Suspect]:
    """Parts without ``entity`` in a rule for each of those who have one of their own."""
    scenario, roster = subject.scenario, subject.roster
    for name, rule in scenario.rules.items():
        each = frozenset() if rule.for_each is None else subject.members("each", rule)
        for model, path in visit(rule, ("rules", name)) if each else ():
            if not isinstance(model, WeightedCounter | WeightedFlag | WeightedTimer) or model.entity is not None:
                continue
            kind = type(model).__name__.removeprefix("Weighted").lower()
            kept = getattr(model, kind)
            per = getattr(getattr(scenario, f"{kind}s").get(kept), "per", None)  # a score is nobody's in particular
            if per is None or len(roster.expand(per)) < 2 or each.isdisjoint(roster.expand(per)):
                continue
            yield Suspect(
                "each_has_its_own",
                (*path, kind),
                f"the rule is for each of '{rule.for_each}', and {kind} '{kept}' is read here as "
                + _READ_AS[kind].format(per=per),
                "write entity: each, or a part for each of those who are meant; all of them are counted in a rule "
                "without for_each",
            )
