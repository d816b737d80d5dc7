"""Observers of a match: one base for scoreboard, plain lines, live view and tests."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from rcj_challenges.core.amounts import add_up
from rcj_challenges.core.play import Event, Fault, HalfInfo, RefereeOutput, Snapshot
from rcj_challenges.records.sensors import SensedRobot, SensorListener


@dataclass(frozen=True, slots=True)
class Progress:
    """How far a match is.

    Attributes:
        tick: ticks of this half that are judged.
        clock_ticks: those of them that count for its length; the clock stops in some phases.
        scores: by seat.
        factor: simulated time over wall time, since the first tick of the half; 0 if that is not known yet.
        remaining_s: estimated wall time to the end of the match in s.
    """

    half: HalfInfo
    tick: int
    clock_ticks: int
    scores: dict[str, int | float]
    phase: str
    factor: float
    remaining_s: float


@dataclass(frozen=True, slots=True)
class ProgramTimes:
    """The time charged to one program in a half (`TimeBudget`); it differs from run to run.

    Attributes:
        steps: how many times it called ``step``.
        started_s: until its first ``step``, in s; 0: it never called it.
        waited_s: for all its later steps together, in s.
        slowest_s: for the slowest of them, in s.
    """

    robot: str
    steps: int
    started_s: float
    waited_s: float
    slowest_s: float


class Observer:
    """Observes a match; what is not overridden does nothing. Calls must be fast: the match waits for them."""

    progress_every_ticks = 625

    def half_started(self, half: HalfInfo) -> None:
        """A half begins."""

    def sensing(self, half: HalfInfo, robots: Sequence[SensedRobot]) -> Sequence[SensorListener]:
        """A half begins; return the listeners that receive the recorded data of its programs."""
        return ()

    def progressed(self, progress: Progress) -> None:
        """Another ``progress_every_ticks`` ticks are played."""

    def event(self, event: Event, half: HalfInfo) -> None:
        """An event was emitted."""

    def fault(self, fault: Fault) -> None:
        """A program failed."""

    def printed(self, robot: str, text: str) -> None:
        """A program whose output is shown has printed something."""

    def after_tick(self, snapshot: Snapshot, output: RefereeOutput) -> None:
        """A tick was judged."""

    def before_tick(self, tick: int) -> float:
        """A tick is about to be simulated. The one call that may wait: programs that are due have all answered.

        Return the time in s that it waited, which does not count as time of the match.
        """
        return 0.0

    def after_last_tick(self, output: RefereeOutput, half: HalfInfo) -> None:
        """The output of the rules after the last tick of a half; its events are also passed to `event`."""

    def half_ended(self, half: HalfInfo, waits: tuple[ProgramTimes, ...]) -> None:
        """A half is over, and its programs are gone."""

    def finished(self, result: dict[str, Any]) -> None:
        """The match is over or was interrupted (the result is not ``complete``), and its record is closed."""


def _call_all(name: str) -> Any:
    """Return a method of a group that calls the method of this name on each observer."""

    def call(group: ObserverGroup, *args: Any) -> None:
        for observer in group.observers:
            getattr(observer, name)(*args)

    return call


class ObserverGroup(Observer):
    """Combines several observers; the first decides how often the progress is reported."""

    def __init__(self, *observers: Observer) -> None:
        self.observers = observers
        self.progress_every_ticks = observers[0].progress_every_ticks

    half_started, progressed, event, fault, printed = map(
        _call_all, ("half_started", "progressed", "event", "fault", "printed")
    )
    after_tick, after_last_tick, half_ended, finished = map(
        _call_all, ("after_tick", "after_last_tick", "half_ended", "finished")
    )

    def sensing(self, half: HalfInfo, robots: Sequence[SensedRobot]) -> Sequence[SensorListener]:
        return [listener for observer in self.observers for listener in observer.sensing(half, robots)]

    def before_tick(self, tick: int) -> float:
        return add_up([observer.before_tick(tick) for observer in self.observers])
