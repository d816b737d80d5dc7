"""Lint of floors and ceilings that change nothing: of a plain number, or on a way that it does not go."""

from __future__ import annotations

from collections.abc import Iterator

from rcj_challenges.scenario.lint.suspect import Subject, Suspect
from rcj_challenges.scenario.models.actions import Bounded, Score
from rcj_challenges.scenario.tree import Path

_KIND = "bound_without_effect"


def check_bounds(subject: Subject) -> Iterator[Suspect]:
    """Bounds of numbers that stand in the file: they are always met, always missed, or on the other side."""
    for model, path in subject.models:
        if not isinstance(model, Bounded):
            continue
        key, amount = _amount(model)
        if isinstance(amount, int | float):
            total = "score" if isinstance(model, Score) else "counter"
            yield from _of_a_number(model, path, key, amount, total)
            yield from _on_the_other_side(model, path, key, amount, total)


def _amount(model: Bounded) -> tuple[str, object]:
    """Return what is paid or counted, with the key under which it stands."""
    if isinstance(model, Score):
        return "points", model.points
    if model.to is not None:
        return "to", model.to
    return "by", 1 if model.by is None else model.by


def _of_a_number(model: Bounded, path: Path, key: str, amount: float, total: str) -> Iterator[Suspect]:
    for bound, limit in (("at_least", model.at_least), ("at_most", model.at_most)):
        if limit is None:
            continue
        misses = amount < limit if bound == "at_least" else amount > limit
        becomes = f"always makes {limit:g}" if misses else "changes nothing"
        instead = "" if key == "to" else f"; what keeps the {total} in bounds is keeps_{bound}: {limit:g}"
        yield Suspect(
            _KIND,
            (*path, bound),
            f"{key} is the number {amount:g}, of which {bound}: {limit:g} {becomes}",
            f"leave it out{instead}",
            at_key=True,
        )


def _on_the_other_side(model: Bounded, path: Path, key: str, amount: float, total: str) -> Iterator[Suspect]:
    falls = ("keeps_at_least", model.keeps_at_least, amount >= 0, "falls", "keeps_at_most")
    rises = ("keeps_at_most", model.keeps_at_most, amount <= 0, "rises", "keeps_at_least")
    for bound, limit, is_other_way, how, other in (falls, rises):
        if limit is not None and is_other_way:
            reason = f"{key} is the number {amount:g}, by which the {total} never {how}"
            yield Suspect(_KIND, (*path, bound), reason, f"leave it out, or write {other}", at_key=True)
