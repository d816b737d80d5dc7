"""Charges one program's time in a half: CPU time and idle time, but never delays caused by others.

An interval lasts from a program's release to its answer (the first one from its launch). In it the program is charged

- the CPU time of all its threads, and
- idle time: wall time less the longest running plus ready time of any single thread.

So a program pays for computing and for real waits, and a busy computer changes nothing. All numbers come from the
kernel, so a program cannot fake them. Reading them costs more than most programs compute, so an interval is measured
only from `MEASURED_AFTER_S` on. Until then it is charged the CPU time that was used since the last reading, at most
`MEASURED_AFTER_S` for each interval.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Mapping
from typing import NamedTuple

MEASURED_AFTER_S = 0.002 if sys.platform == "linux" else 0.25
"""How long an interval lasts before it is measured. On macOS a reading takes 10 ms."""

_QUIET_S = 5.0
_QUIET_SHARE = 0.01
"""Without ready times (Windows, macOS), a program is idle if in so many seconds its CPU time rose by less than that."""


class ThreadTimes(NamedTuple):
    """The kernel's counts for one thread until now: time of computing, times of waiting for a processor, turns.

    The current wait is not in ``ready_s``.
    """

    running_s: float = 0.0
    ready_s: float = 0.0
    runs: int = 0


class ProcessTimes(NamedTuple):
    """The kernel's counts for one process until now, ended threads included; no threads if ready times are unknown."""

    cpu_s: float
    threads: Mapping[int, ThreadTimes] | None


class TimeLimits(NamedTuple):
    """What a program may be charged, in s: until its first step, in one step, and in all later steps together."""

    start_s: float
    step_s: float
    half_s: float


class TimeBudget:
    """The time of one half that one program is charged.

    Attributes:
        exceeded: the limit that was reached, as the kind of a fault; None: none was.
        started_s: what it was charged until its first step, in s.
        charged_s: what it was charged in its later steps, in s; exact after `close`.
        slowest_s: the most that it was charged in one of them, in s; 0 if no answer had to be waited for.
        quick_answers: how many answers were here at once since the last reading; the caller that receives them counts.
        background_s: CPU time that it used outside its intervals, in s.
        waited_s: wall time in which it was waited for, in s, up to the last look.
    """

    def __init__(
        self, limits: TimeLimits, read: Callable[[], ProcessTimes | None], is_runnable: Callable[[int], bool]
    ) -> None:
        """Open a budget before the program is launched.

        ``read`` returns the kernel's counts, None if they are unknown; ``is_runnable`` whether a thread runs or waits
        for a processor at this moment.
        """
        self._limits = limits
        self._read = read
        self._is_runnable = is_runnable
        self._quiet = _QuietTime()
        self._has_started = self._is_closed = False
        self._looked_s = 0.0
        self._last = ProcessTimes(0.0, {})
        self._unmeasured_s = 0.0
        self.quick_answers = 0
        self._measured: _Measurement | None = None
        self.exceeded: str | None = None
        self.started_s = self.charged_s = self.slowest_s = self.background_s = self.waited_s = 0.0

    @property
    def cpu_s(self) -> float:
        """CPU time that the process was last seen to have used, in s."""
        return (self._last if self._measured is None else self._measured.last).cpu_s

    def answered(self, now_s: float, lost_s: float = 0.0) -> None:
        """End an interval that is measured, or the first one: the program has answered.

        ``now_s`` is that of ``time.perf_counter``; in ``lost_s`` since the last look the match itself stood still or
        waited for a processor.
        """
        if self._is_closed:
            return
        if self._measured is not None:
            self._look(now_s, lost_s)
            self._end_measurement()
        else:
            self.quick_answers += 1
        if not self._has_started:
            self.settle()
            self._has_started = True
            self.started_s, self.charged_s, self.slowest_s = self.charged_s, 0.0, 0.0

    def answered_within(self, wall_s: float) -> None:
        """End an interval that was waited for but not measured."""
        wall_s = min(wall_s, MEASURED_AFTER_S)  # beyond that it was the match that stood still
        self.waited_s += wall_s
        self._unmeasured_s += wall_s
        self.slowest_s = max(self.slowest_s, wall_s)
        if self._unmeasured_s >= _QUIET_S:
            self.settle()

    def look(self, now_s: float, lost_s: float = 0.0) -> None:
        """Measure an interval that is not over, and set `exceeded`. See `answered` for the arguments."""
        if self._is_closed:
            return
        self._look(now_s, lost_s)
        if self._over() is not None and self._measured is not None:
            # The kernel counts a wait for a processor when it is over.
            self._measured.credit_ready(self._is_runnable)
            self.exceeded = self._over()

    def settle(self) -> None:
        """Charge intervals that were not measured."""
        if self._is_closed or self._measured is not None:
            return
        now = self._read()
        wall_s, self._unmeasured_s = self._unmeasured_s, 0.0
        most_s = wall_s + MEASURED_AFTER_S * self.quick_answers if self._has_started else math.inf
        self.quick_answers = 0
        if now is None or now.cpu_s < self._last.cpu_s:  # it has ended, and another process was asked
            self.charged_s += wall_s
        else:
            cpu_s = now.cpu_s - self._last.cpu_s
            self.charged_s += min(most_s, cpu_s)
            self.background_s += max(0.0, cpu_s - most_s)
            if now.threads is None:
                self.charged_s += self._quiet.idle_s(wall_s, cpu_s)
            self._last = now
        self.exceeded = self._over()

    def close(self) -> None:
        """Charge what is left while the process exists; what comes later is free."""
        if self._measured is not None:
            self._end_measurement()
        self.settle()
        self._is_closed = True

    def _look(self, now_s: float, lost_s: float) -> None:
        since_s, self._looked_s = self._looked_s, now_s
        if self._measured is None:
            self.waited_s += MEASURED_AFTER_S
            self._unmeasured_s += MEASURED_AFTER_S
            self.settle()
            self._measured = _Measurement(self._last, self._quiet)
        else:
            wall_s = max(0.0, now_s - since_s - lost_s)
            self.waited_s += wall_s
            self._measured.add(wall_s, self._read())

    def _end_measurement(self) -> None:
        measured = self._measured
        assert measured is not None  # noqa: S101 - only called while one is measured
        self.exceeded = self._over()
        self.charged_s += measured.charge_s
        self.slowest_s = max(self.slowest_s, MEASURED_AFTER_S + measured.charge_s)
        self._last, self._measured = measured.last, None

    def _over(self) -> str | None:
        limits, charge_s = self._limits, 0.0 if self._measured is None else self._measured.charge_s
        if self.exceeded is not None:
            return self.exceeded
        if not self._has_started:
            return "start_timeout" if self.charged_s + charge_s >= limits.start_s else None
        if self._measured is not None and MEASURED_AFTER_S + charge_s >= limits.step_s:
            return "step_timeout"
        return "half_timeout" if self.charged_s + charge_s >= limits.half_s else None


class _Measurement:
    """CPU and idle time of a program since this was made; ``charge_s`` is their sum."""

    def __init__(self, first: ProcessTimes, quiet: _QuietTime) -> None:
        self._first = first
        self._quiet = quiet
        self._seen: dict[int, ThreadTimes] = dict(first.threads or {})
        self._unchanged_s: dict[int, float] = {}
        self._wall_s = self._quiet_s = 0.0
        self.last = first
        self.charge_s = 0.0

    def add(self, wall_s: float, now: ProcessTimes | None) -> None:
        """Go on for so much wall time. What is unknown of the process counts as idle."""
        if now is None or now.cpu_s < self._first.cpu_s:
            now = self.last
        self._wall_s += wall_s
        before, self.last = self.last, now
        cpu_s = now.cpu_s - self._first.cpu_s
        if now.threads is None:
            self._quiet_s += self._quiet.idle_s(wall_s, max(0.0, now.cpu_s - before.cpu_s))
            self.charge_s = cpu_s + self._quiet_s
            return
        for thread, times in now.threads.items():
            is_same = self._seen.get(thread) == times
            self._unchanged_s[thread] = self._unchanged_s.get(thread, 0.0) + wall_s if is_same else 0.0
            self._seen[thread] = times
        self.charge_s = cpu_s + max(0.0, self._wall_s - self._longest_s(cpu_s))

    def credit_ready(self, is_runnable: Callable[[int], bool]) -> None:
        """Count the present waits of threads for a processor, as far as looks have seen nothing else."""
        for thread, unchanged_s in self._unchanged_s.items():
            if unchanged_s > 0 and is_runnable(thread):
                times = self._seen[thread]
                self._seen[thread] = times._replace(ready_s=times.ready_s + unchanged_s)
        if self.last.threads is not None:
            cpu_s = self.last.cpu_s - self._first.cpu_s
            self.charge_s = cpu_s + max(0.0, self._wall_s - self._longest_s(cpu_s))
        self._seen.update(self.last.threads or {})

    def _longest_s(self, cpu_s: float) -> float:
        """Return the time in which at least one thread ran or was ready."""
        firsts = self._first.threads or {}
        longest_s = seen_s = 0.0
        for thread, times in self._seen.items():
            first = firsts.get(thread, ThreadTimes())
            if times.running_s < first.running_s:  # another thread that got its number
                first = ThreadTimes()
            running_s = times.running_s - first.running_s
            seen_s += running_s
            longest_s = max(longest_s, running_s + times.ready_s - first.ready_s)
        # Of threads that ended between two looks only the CPU time is left: that one of them ran is charged already.
        return max(longest_s, cpu_s - seen_s)


class _QuietTime:
    """Idle time on systems that report no ready times: stretches with almost no rise of CPU time."""

    def __init__(self) -> None:
        self._wall_s = self._cpu_s = 0.0

    def idle_s(self, wall_s: float, cpu_s: float) -> float:
        """Add a stretch of wall time with its CPU time; return the idle time that is certain now."""
        self._wall_s += wall_s
        self._cpu_s += cpu_s
        if self._wall_s < _QUIET_S:
            return 0.0
        idle_s = self._wall_s if self._cpu_s < _QUIET_SHARE * self._wall_s else 0.0
        self._wall_s = self._cpu_s = 0.0
        return idle_s
