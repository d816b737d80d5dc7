"""Changes in a tick: phase, score, counters, held robots. The only source of them for records and views."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from rcj_challenges.core.amounts import Score


@dataclass(frozen=True, slots=True)
class PhaseChange:
    """Another phase, or the first one of a half."""

    tick: int
    phase: str
    waiting_for_kickoff: bool


@dataclass(frozen=True, slots=True)
class ScoreChange:
    """Another score.

    Attributes:
        scores: points of the match by entrant, as seated in this half.
    """

    tick: int
    scores: Mapping[str, Score]


@dataclass(frozen=True, slots=True)
class CountersChange:
    """Other counters that the scenario's ``result`` ranks by, or those at the start of a half.

    Attributes:
        counters: by name; of one kept per entity, by entity.
    """

    tick: int
    counters: Mapping[str, Any]


@dataclass(frozen=True, slots=True)
class HeldChange:
    """Other robots held by rules; a half begins with none.

    Attributes:
        robots: names of all that are held now, in the roster's order.
    """

    tick: int
    robots: tuple[str, ...]


Change = PhaseChange | ScoreChange | CountersChange | HeldChange


class ChangeTracker:
    """Compares the state of a referee with that of the tick before."""

    def __init__(self, scores: Mapping[str, Score]) -> None:
        """Begin a half.

        Args:
            scores: points by entrant as it begins.
        """
        self._phase: tuple[str, bool] | None = None
        self._scores = dict(scores)
        self._counters: Mapping[str, Any] = {}
        self._held: tuple[str, ...] = ()

    def update(
        self,
        tick: int,
        *,
        phase: tuple[str, bool],
        scores: Mapping[str, Score],
        counters: Mapping[str, Any],
        held: tuple[str, ...],
    ) -> tuple[Change, ...]:
        """Return the differences.

        Args:
            tick: of the half.
            phase: its name, and whether a kick-off is awaited.
            scores: points by entrant.
            counters: those that the ranking compares; the caller does not change them afterwards.
            held: names of the robots that rules hold.
        """
        changes: list[Change] = []
        if phase != self._phase:
            self._phase = phase
            changes.append(PhaseChange(tick, *phase))
        if scores != self._scores:
            self._scores = dict(scores)
            changes.append(ScoreChange(tick, self._scores))
        if counters != self._counters:
            self._counters = counters
            changes.append(CountersChange(tick, counters))
        if held != self._held:
            self._held = held
            changes.append(HeldChange(tick, held))
        return tuple(changes)
