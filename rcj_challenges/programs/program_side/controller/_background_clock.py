"""The clock of the threads that do not step: how far it is ahead of the stepping thread's clock.

They wait for match time, which stands still while the stepping thread computes, or waits for one of them (for a result,
or for its end). To prevent a deadlock, their clock then goes on by itself:

* in real time, from the moment at which the stepping thread is found to be stuck: it is at the same place as before,
  and no thread of the program computes; or else when no tick has begun for a while;
* by each of their readings, while it is stuck: a loop that reads the clock is a wait.

The lead shrinks as the match catches up, so that the clock is never wrong for long, and never runs backwards. While the
program is inside ``step``, the next tick comes by itself: how long the match takes to bring it, because other programs
start or compute, does not count.
"""

from __future__ import annotations

import os
import sys
import time
from _thread import get_ident, get_native_id

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

_STANDSTILL_S = 0.1
"""If no tick has begun for this long, real time counts. In a match played in real time, one begins every 0.032 s."""
_READINGS = 100
"""A thread that has read the clock this often since the tick began is waiting."""
_READING_NS = 50_000
"""How far each reading advances the clock while the stepping thread is stuck."""
_GLANCE_S = 0.000_2
_IDLE_SHARE = 0.2
"""Share of the elapsed time: a program that used less CPU time does not compute."""

real_monotonic = time.perf_counter  # on Windows `monotonic` goes on every 16 ms only, up to Python 3.12
real_process_time = time.process_time
_real_sleep = time.sleep
_HAS_FINE_CPU_TIMES = sys.platform != "win32"  # Windows updates CPU times only every 16 ms


class BackgroundClock:
    """How far the clock of the threads that do not step is ahead; ``in_match``: whether the program is in ``step``."""

    def __init__(self) -> None:
        self.in_match = False
        self._stepping, self._known_to_system = get_ident(), get_native_id()
        self._ticks = 0
        self._ahead_ns = 0
        self._counts_from_s: float | None = None  # in real time; None: not read since the tick began
        self._is_stuck = False
        self._readings = 0

    def read_ns(self) -> int:
        """Return its lead in ns; this counts as a reading."""
        if not self.in_match:
            self._readings += 1
            if self._readings % _READINGS == 0:
                place = self.place()
                _real_sleep(_GLANCE_S)  # lets the others go on, if they can
                self.compare(place)
            if self._is_stuck:
                self._ahead_ns += _READING_NS
        return self.ahead_ns()

    def ahead_ns(self) -> int:
        """Return its lead in ns."""
        return self._ahead_ns + self._standing_ns()

    def _standing_ns(self) -> int:
        """Return the real time that counts and is not added up yet, in ns."""
        if self.in_match:
            return 0
        now_s = real_monotonic()
        if self._counts_from_s is None:
            self._counts_from_s = now_s + _STANDSTILL_S
        return max(0, int((now_s - self._counts_from_s) * 1e9))

    def place(self) -> tuple[Any, ...]:
        """Return the present place of the thread that steps, for `compare`, after a real wait.

        It is: ticks begun, its frame and the instruction in it, real time in s, processor time of the process in s.
        """
        frame = sys._current_frames().get(self._stepping)  # noqa: SLF001 - it is documented
        at = None if frame is None else frame.f_lasti
        return self._ticks, frame, at, real_monotonic(), real_process_time()

    def compare(self, before: tuple[Any, ...]) -> None:
        """Find out whether the thread that steps has been stuck since it was at a place."""
        *now_at, seen_s, computed_s = self.place()
        *was_at, was_seen_s, had_computed_s = before
        is_idle = not _HAS_FINE_CPU_TIMES or computed_s - had_computed_s < _IDLE_SHARE * (seen_s - was_seen_s)
        is_stuck = now_at == was_at and is_idle and not self.in_match
        is_stuck = is_stuck and not _would_run(self._known_to_system)
        if is_stuck and not self._is_stuck:
            counts_from_s = self._counts_from_s
            self._counts_from_s = was_seen_s if counts_from_s is None else min(was_seen_s, counts_from_s)
        elif self._is_stuck and not is_stuck:
            self._add_up()
        self._is_stuck = is_stuck

    def _add_up(self) -> None:
        standing_ns, self._counts_from_s = self._standing_ns(), None
        self._ahead_ns += standing_ns

    def step_began(self) -> None:
        """The program is inside ``step``, in this thread: the next tick comes by itself."""
        if self._counts_from_s is not None:
            self._add_up()
        self.in_match = True
        if get_ident() != self._stepping:
            self._stepping, self._known_to_system = get_ident(), get_native_id()

    def tick_began(self, passed_ns: int) -> None:
        """A tick began, by which the clock of the thread that steps went on by so many ns."""
        self.in_match = False
        self._readings = 0
        self._ticks += 1
        if self._ahead_ns or self._is_stuck:
            self.caught_up(passed_ns)

    def caught_up(self, passed_ns: int) -> None:
        """The clock of the thread that steps went on by so many ns."""
        if self._counts_from_s is not None:
            self._add_up()
        self._is_stuck = False
        self._ahead_ns = max(0, self._ahead_ns - passed_ns)


def others_would_run() -> bool | None:
    """Return whether another thread of the program has a processor or waits for one; None if that is unknown."""
    if sys.platform != "linux":
        return None
    own = str(get_native_id())
    try:
        threads = os.listdir("/proc/self/task")  # noqa: PTH208 - pathlib would cost each program its import
    except OSError:
        return None
    # These calls release Python's lock, so they wake a thread that waits for it, which then also counts.
    return any(thread != own and _would_run(int(thread)) for thread in threads)


def _would_run(thread: int) -> bool:
    """Return whether a thread only waits for a processor; False where the system does not show it (all but Linux)."""
    if sys.platform != "linux":
        return False
    try:
        file = os.open(f"/proc/self/task/{thread}/stat", os.O_RDONLY | os.O_CLOEXEC)
        try:
            return os.read(file, 512).rpartition(b") ")[2][:1] == b"R"
        finally:
            os.close(file)
    except OSError:  # it has ended
        return False
