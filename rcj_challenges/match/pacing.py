"""Side effects of a tick: recording, observers, the pace of the clock. They never affect the result."""

from __future__ import annotations

import time
from collections.abc import Collection
from typing import TYPE_CHECKING

from rcj_challenges.core.play import HalfInfo, RefereeOutput, Snapshot
from rcj_challenges.core.timing import TICK_S
from rcj_challenges.match.observers import Observer, Progress
from rcj_challenges.programs.pool import ProgramPool
from rcj_challenges.records.writer import RecordWriter

if TYPE_CHECKING:
    from rcj_challenges.referee.engine import Referee

_OUTPUT_EVERY_TICKS = 16


class TickEffects:
    """Writes the record of a half, calls observers, shows programs' output, and keeps the pace of the clock.

    Args:
        half: what is played.
        later_ticks: how long the halves after it are.
        referee: for the scores and the clock.
        record: of the run.
        observer: that is called.
        pool: whose output is shown.
        show_output: robots whose output is shown.
        real_time: True: no tick is judged before its time on a clock that starts with the first one.
    """

    def __init__(
        self,
        half: HalfInfo,
        later_ticks: int,
        referee: Referee,
        record: RecordWriter,
        observer: Observer,
        pool: ProgramPool,
        show_output: Collection[str],
        *,
        real_time: bool,
    ) -> None:
        self._half = half
        self._later_ticks = later_ticks
        self._referee = referee
        self._record = record
        self._observer = observer
        self._shown = [program for name, program in pool.programs.items() if name in show_output]
        self._real_time = real_time
        self._every_ticks = max(1, observer.progress_every_ticks)
        self._began_s = time.perf_counter()

    def after_tick(self, snapshot: Snapshot, output: RefereeOutput, state: bytes, poses: bytes) -> None:
        """Take a judged tick, while the programs compute the next."""
        self._record.tick(snapshot, output, state, poses)
        tick = snapshot.tick
        if tick <= 1:  # after tick 0 the match waits until all programs have started
            self._began_s = time.perf_counter()
        self._observer.after_tick(snapshot, output)
        for event in output.events:
            self._observer.event(event, self._half)
        if tick % self._every_ticks == 0 and tick:
            self._observer.progressed(self._progress(tick, output))
        if self._shown and tick % _OUTPUT_EVERY_TICKS == 0:
            self._show_output()
        if self._real_time:
            ahead_s = self._began_s + tick * TICK_S - time.perf_counter()
            if ahead_s > 0:
                time.sleep(ahead_s)

    def closed(self, closing: RefereeOutput) -> None:
        """Pass on the output of the rules after the last tick, and show the programs' last output."""
        self._observer.after_last_tick(closing, self._half)
        for event in closing.events:
            self._observer.event(event, self._half)
        self._show_output()

    def _progress(self, tick: int, output: RefereeOutput) -> Progress:
        half = self._half
        spent_s = max(time.perf_counter() - self._began_s, 1e-9)
        clock_ticks = self._referee.clock_ticks
        ticks_left = half.ticks - clock_ticks + self._later_ticks
        timed = max(tick - 1, 1)  # since the first one
        return Progress(
            half=half,
            tick=tick,
            clock_ticks=clock_ticks,
            scores=dict(self._referee.scores),
            phase=output.phase,
            factor=timed * TICK_S / spent_s if tick > 1 else 0.0,
            remaining_s=ticks_left * spent_s / timed,
        )

    def _show_output(self) -> None:
        for program in self._shown:
            text = program.new_output()
            if text:
                self._observer.printed(program.name, text)
