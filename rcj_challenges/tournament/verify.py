"""Plays matches again and compares digests: on the same kind of machine the same match gives the same digest."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

from rcj_challenges.records.result import deciding, has_time_fault
from rcj_challenges.tournament.executor import Executor, JobOutcome
from rcj_challenges.tournament.jobs import MatchJob

Verdict = Literal["same", "differs", "not_comparable", "not_played"]


@dataclass(frozen=True)
class Verified:
    """One match that was played again: its fixture, or its record's folder, and the verdict.

    The reason is why it cannot be compared, or was not played; or that another version of Python was used; else empty.
    """

    name: str
    verdict: Verdict
    reason: str = ""


@dataclass(frozen=True)
class Recorded:
    """A match to be verified.

    Attributes:
        digest: that was recorded.
        versions: on which it was played.
        is_timed: whether a time limit decided something in it.
    """

    name: str
    job: MatchJob
    digest: str
    versions: Mapping[str, str]
    is_timed: bool


def compare(recorded: Recorded, result: Mapping[str, Any]) -> Verified:
    """Compare the result of a match that was played again with what was recorded."""
    now = result["versions"]
    other = [name for name, value in now.items() if recorded.versions.get(name) != value]
    was = ", ".join(f"{name} {recorded.versions.get(name, 'unknown')}" for name in other)
    reason = f"it was played with {was}" if other else ""
    if result["digest"] == recorded.digest:
        return Verified(recorded.name, "same", reason)
    if deciding(recorded.versions) != deciding(now):
        return Verified(recorded.name, "not_comparable", reason)
    if recorded.is_timed or has_time_fault(result):
        return Verified(recorded.name, "not_comparable", "a time limit decided something in it")
    return Verified(recorded.name, "differs", reason and f"{reason}, on whose version a program may depend")


def verify_all(
    matches: Sequence[Recorded],
    executor: Executor,
    on_done: Callable[[Verified], None],
    on_played: Callable[[Recorded, JobOutcome, Verified], None] | None = None,
) -> list[Verified]:
    """Play matches, no job twice, again and compare them, in the order in which they are done.

    ``on_played`` is called with each match that was played before its record is removed.
    """
    waiting = {one.job.id: one for one in matches}
    verified: list[Verified] = []
    with executor:
        for one in matches:
            executor.submit(one.job)
        while waiting:
            for outcome in executor.poll():
                one = waiting.pop(outcome.job.id)
                failed = Verified(one.name, "not_played", outcome.complaint)
                verified.append(failed if outcome.result is None else compare(one, outcome.result))
                if on_played is not None:
                    on_played(one, outcome, verified[-1])
                if outcome.folder is not None:
                    shutil.rmtree(outcome.folder, ignore_errors=True)
                on_done(verified[-1])
    return verified
