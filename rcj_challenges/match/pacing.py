"""Side effects of a tick: recording, observers, the pace of the clock. They never affect the result."""

from __future__ import annotations

import time
from collections.abc import Collection
from dataclasses import InitVar, dataclass
from typing import TYPE_CHECKING

from rcj_challenges.core.play import HalfInfo, RefereeOutput, Snapshot
from rcj_challenges.core.timing import TICK_S
from rcj_challenges.match.observers import Observer, Progress
from rcj_challenges.programs.pool import ProgramPool
from rcj_challenges.records.writer import RecordWriter

if TYPE_CHECKING:
    from rcj_challenges.referee.engine import Referee

_OUTPUT_EVERY_TICKS = 16


@dataclass
class TickEffects:
    """Writes the record of a half, calls observers, shows programs' output, and keeps the pace of the clock.

    Attributes:
        later_ticks: of the halves after it.
        show_output: robots of the pool whose output is shown.
        real_time: True: no tick is judged before its time on a clock that starts with the first one.
    """

    half: HalfInfo
    later_ticks: int
    referee: Referee
    record: RecordWriter
    observer: Observer
    pool: InitVar[ProgramPool]
    show_output: InitVar[Collection[str]]
    real_time: bool

    def __post_init__(self, pool: ProgramPool, show_output: Collection[str]) -> None:
        self._shown = [program for name, program in pool.programs.items() if name in show_output]
        self._every_ticks = max(1, self.observer.progress_every_ticks)
        self._began_s = time.perf_counter()

    def after_tick(self, snapshot: Snapshot, output: RefereeOutput, state: bytes, poses: bytes) -> None:
        """Take a judged tick, while the programs compute the next."""
        self.record.tick(snapshot, output, state, poses)
        tick = snapshot.tick
        if tick <= 1:  # after tick 0 the match waits until all programs have started
            self._began_s = time.perf_counter()
        self.observer.after_tick(snapshot, output)
        for event in output.events:
            self.observer.event(event, self.half)
        if tick % self._every_ticks == 0 and tick:
            self.observer.progressed(self._progress(tick, output))
        if self._shown and tick % _OUTPUT_EVERY_TICKS == 0:
            self._show_output()
        if self.real_time and (ahead_s := self._began_s + tick * TICK_S - time.perf_counter()) > 0:
            time.sleep(ahead_s)

    def closed(self, closing: RefereeOutput) -> None:
        """Pass on the output of the rules after the last tick, and show the programs' last output."""
        self.observer.after_last_tick(closing, self.half)
        for event in closing.events:
            self.observer.event(event, self.half)
        self._show_output()

    def _progress(self, tick: int, output: RefereeOutput) -> Progress:
        half = self.half
        spent_s = max(time.perf_counter() - self._began_s, 1e-9)
        clock_ticks = self.referee.clock_ticks
        ticks_left = half.ticks - clock_ticks + self.later_ticks
        timed = max(tick - 1, 1)  # since the first one
        return Progress(
            half=half,
            tick=tick,
            clock_ticks=clock_ticks,
            scores=dict(self.referee.scores),
            phase=output.phase,
            factor=timed * TICK_S / spent_s if tick > 1 else 0.0,
            remaining_s=ticks_left * spent_s / timed,
        )

    def _show_output(self) -> None:
        for program in self._shown:
            if text := program.new_output():
                self.observer.printed(program.name, text)
