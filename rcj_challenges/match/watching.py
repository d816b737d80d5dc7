"""What those who watch are told: one protocol for scoreboard, plain lines, live view and tests."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Protocol

from rcj_challenges.facts.play import Event, Fault, HalfInfo, Snapshot, Verdict


@dataclass(frozen=True, slots=True)
class Progress:
    """How far a match is.

    Attributes:
        half: what is being played.
        tick: ticks of this half that are judged.
        scores: by seat.
        phase: phase of the referee.
        factor: simulated time over wall time, since the half began.
        remaining_s: estimated wall time to the end of the match in s.
    """

    half: HalfInfo
    tick: int
    scores: dict[str, int | float]
    phase: str
    factor: float
    remaining_s: float


class Watcher(Protocol):
    """Someone who watches a match. Calls must return fast: the match waits for them."""

    progress_every_ticks: int

    def half_started(self, half: HalfInfo) -> None:
        """A half begins."""

    def progressed(self, progress: Progress) -> None:
        """Another ``progress_every_ticks`` ticks are played."""

    def event(self, event: Event, half: HalfInfo) -> None:
        """An event was emitted."""

    def fault(self, fault: Fault) -> None:
        """A program failed."""

    def printed(self, robot: str, text: str) -> None:
        """A program whose output is shown has printed something."""

    def ticked(self, snapshot: Snapshot, verdict: Verdict) -> None:
        """A tick was judged."""

    def finished(self, result: dict[str, Any]) -> None:
        """The match is over and its record is closed."""


class Silent:
    """A watcher that does nothing; the base of those who want only some of the calls."""

    progress_every_ticks = 625

    def half_started(self, half: HalfInfo) -> None:
        """Do nothing."""

    def progressed(self, progress: Progress) -> None:
        """Do nothing."""

    def event(self, event: Event, half: HalfInfo) -> None:
        """Do nothing."""

    def fault(self, fault: Fault) -> None:
        """Do nothing."""

    def printed(self, robot: str, text: str) -> None:
        """Do nothing."""

    def ticked(self, snapshot: Snapshot, verdict: Verdict) -> None:
        """Do nothing."""

    def finished(self, result: dict[str, Any]) -> None:
        """Do nothing."""
