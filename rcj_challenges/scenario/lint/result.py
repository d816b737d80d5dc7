"""Lint of ``result``: counters and times that are the same for every entrant."""

from __future__ import annotations

from collections.abc import Iterator

from rcj_challenges.scenario.lint.suspect import Subject, Suspect
from rcj_challenges.scenario.models.scenario import RankByCounter, RankByTime
from rcj_challenges.scenario.tree import Path


def check_ranking(subject: Subject) -> Iterator[Suspect]:
    """Criteria that can tell no entrants apart: a ranking adds up what was counted for the robots of each."""
    for counter, path in _ranked_by(subject):
        reason = _why_equal(counter, subject)
        if reason:
            yield Suspect(
                "criterion_always_equal",
                path,
                f"counter '{counter}' {reason}",
                "keep it {per: robots} and count it for the robot that it is about, or leave it out",
            )
    yield from _one_time_for_all(subject)


def _one_time_for_all(subject: Subject) -> Iterator[Suspect]:
    """A half ends for all who play in it: without penalties of their own its time tells nobody apart."""
    if len(subject.scenario.entrants) < 2:
        return
    for index, criterion in enumerate(subject.scenario.result.rank):
        if isinstance(criterion, RankByTime) and not criterion.plus:
            yield Suspect(
                "criterion_always_equal",
                ("result", "rank", index),
                "a half ends for all at the same time: it is the same for every entrant",
                "set a counter {per: robots} when a robot arrives, to {word: time_s} or, with its fraction, to "
                "{word: measured} of sequence_completed, and rank by that counter; or leave it out",
            )


def _ranked_by(subject: Subject) -> Iterator[tuple[str, Path]]:
    for index, criterion in enumerate(subject.scenario.result.rank):
        path: Path = ("result", "rank", index)
        if isinstance(criterion, RankByCounter):
            yield criterion.counter, (*path, "counter")
        elif isinstance(criterion, RankByTime):
            for number, part in enumerate(criterion.plus):
                yield part.counter, (*path, "plus", number, "counter")


def _why_equal(counter: str, subject: Subject) -> str:
    """Return why a counter is the same for every entrant, or an empty text if it need not be."""
    entrants, per = subject.scenario.entrants, subject.scenario.counters[counter].per
    if per is None:
        # A single entrant has nobody to be told apart from: its runs are compared with those of others.
        return "is one for all: it is the same number for every entrant" if len(entrants) > 1 else ""
    driven = {robot for entrant in entrants.values() for robot in entrant.robots}
    if driven.isdisjoint(subject.roster.expand(per)):
        return f"is kept per {per}, which nobody drives: it is 0 for every entrant"
    return ""
