"""Lint of lists that are added up: of numbers alone, or with what each of several has, read as that of all."""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal

from rcj_challenges.scenario.lint.suspect import Subject, Suspect
from rcj_challenges.scenario.models.actions import Count, Score
from rcj_challenges.scenario.models.state import WeightedCounter, WeightedFlag, WeightedTimer
from rcj_challenges.scenario.tree import Items, Leaf, node_at
from rcj_challenges.scenario.visiting import visit

_READ_AS = {
    "counter": "the sum of those of all of '{per}'",
    "flag": "1 if that of any of '{per}' is set",
    "timer": "the longest of those of all of '{per}'",
}


_OF = {"points": "of points", "by": "under 'by'", "to": "under 'to'"}


def check_numbers_alone(subject: Subject) -> Iterator[Suspect]:
    """Points and counts that are several plain numbers: 5 for the first and 3 for the second are added up too."""
    for model, path in subject.models:
        for key in ("points",) if isinstance(model, Score) else ("by", "to") if isinstance(model, Count) else ():
            parts = node_at(subject.tree, (*path, key))
            written = parts.items if isinstance(parts, Items) else []
            # A note says that a param stands there: a sum of params may be meant.
            plain = [part.value for part in written if isinstance(part, Leaf) and not part.note]
            numbers = [one for one in plain if isinstance(one, int | float)]
            if len(numbers) < 2 or len(numbers) < len(written):
                continue
            total = f"{sum(map(Decimal, map(str, numbers))):f}"
            if "." in total:
                total = total.rstrip("0").rstrip(".")
            yield Suspect(
                "numbers_added_up",
                (*path, key),
                f"a list {_OF[key]} is added up, and all its parts are numbers: it is always {total}",
                f"write {total}; where it depends on something, a part such as {{counter: NAME, weight: -2}}, or a "
                "rule for each case",
            )


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
