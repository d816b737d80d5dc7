"""Lint of comparisons with the others, where there are none."""

from __future__ import annotations

from collections.abc import Iterator

from rcj_challenges.scenario.lint.suspect import Subject, Suspect
from rcj_challenges.scenario.models.state import HighestOfOthers, LowestOfOthers


def check_others(subject: Subject) -> Iterator[Suspect]:
    """The lowest or highest of a counter that is kept for one thing only."""
    for model, path in subject.models:
        match model:
            case LowestOfOthers(lowest=name):
                key = "lowest"
            case HighestOfOthers(highest=name):
                key = "highest"
            case _:
                continue
        owners = subject.roster.expand(subject.scenario.counters[name].per or ())
        if len(owners) == 1:
            yield Suspect(
                "no_others_to_compare_with",
                (*path, key),
                f"counter '{name}' is kept for {owners[0]} alone, so that there are no others",
                f"keep it per: robots, or write {{counter: {name}, entity: {owners[0]}}}",
            )
