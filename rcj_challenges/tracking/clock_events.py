"""Triggers that no tracker follows: start and end of a half, phases, times, events, faults and messages of programs."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import NamedTuple

from rcj_challenges.core.timing import ticks_from_s
from rcj_challenges.tracking.bound_rules import TriggerBinding

_DECIMALS = 9
"""Of times that are reported: 3 times 0.1 s are 0.3 s."""


class Alarm(NamedTuple):
    """A time, or a row of times, of the half's clock for which a rule waits.

    Attributes:
        every_s: how long after one the next comes; None: there is no other.
        past: how many have come.
    """

    binding: TriggerBinding
    at_s: float
    every_s: float | None
    past: int = 0

    @property
    def next_s(self) -> float:
        """The next time, counted from the first: times that are no whole ticks do not add up to a delay."""
        return self.at_s if self.every_s is None else round(self.at_s + self.past * self.every_s, _DECIMALS)


@dataclass
class ClockEvents:
    """Bindings by what they wait for; of an event also by what it is about, None: anything."""

    half_started: list[TriggerBinding] = field(default_factory=list)
    half_ended: list[tuple[str | None, TriggerBinding]] = field(default_factory=list)
    entered: dict[str, list[tuple[str | None, TriggerBinding]]] = field(default_factory=dict)
    events: dict[tuple[str, str | None], list[TriggerBinding]] = field(default_factory=dict)
    alarms: list[Callable[[], Alarm]] = field(default_factory=list)
    times: dict[int, list[Alarm]] = field(default_factory=dict)
    faults: dict[str, list[TriggerBinding]] = field(default_factory=dict)
    messages: dict[str, list[tuple[Callable[[str], bool], TriggerBinding]]] = field(default_factory=dict)

    def start(self) -> None:
        """Set all alarms, as a half starts: their times may be values."""
        for alarm in self.alarms:
            self.wait_for(alarm())

    def wait_for(self, alarm: Alarm, after: int = 0) -> None:
        """Set an alarm to its next time, later than a tick of the half's clock."""
        self.times.setdefault(max(after + 1, ticks_from_s(alarm.next_s)), []).append(alarm)

    def due_at(self, clock: int) -> list[Alarm]:
        """Return the alarms that are due now; those that repeat are set again."""
        due = self.times.pop(clock, [])
        for one in due:
            if one.every_s is not None:
                self.wait_for(one._replace(past=one.past + 1), after=clock)
        return due
