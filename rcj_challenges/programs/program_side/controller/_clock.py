"""The simulated clock: what ``time`` and ``datetime`` show to a program.

The clock stands still between two steps, except that each reading by the thread that steps advances it by 1 µs (by
50 µs where it only waits for time to pass), and that its ``time.sleep`` advances it by what was asked for. Time that
passed this way beyond whole ticks is what the program missed: its next ``step`` says so. Until the first ``step`` that
thread is the main one, if it is the only one.

Other threads wait for simulated time. While no tick begins, because the stepping thread computes or waits for them,
their clock goes on by itself (`BackgroundClock`), so that no thread waits for ever.
"""

from __future__ import annotations

import sys
import time
from _thread import LockType, _count, allocate_lock, get_ident

from ._background_clock import BackgroundClock, real_monotonic, real_process_time
from ._hooks import Unbound

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

EPOCH_NS = 1_704_067_200_000_000_000
"""Every half begins at 2024-01-01T00:00:00Z: an arbitrary fixed, plausible date."""

_READING_NS = 1_000
_WAITS_FROM_NS = 100_000
"""A program that has read the clock a hundred times since the last step is waiting, and need not read it a million
times a second: with ``datetime.now`` that would take longer than a step may. Similarly, a loop that plans until 10 ms
have passed need not run a thousand times: that would exceed the 6 ms that a step may take in the long run."""
_WAITING_NS = 50_000
_MAX_MISSED = 2**31 - 1
_ENDLESS_S = float("inf")
_LEAST_SLICE_S, _FIRST_SLICE_S, _LONGEST_SLICE_S = 0.001, 0.002, 0.1

__all__ = ["Clock", "dates_of", "real_monotonic", "real_process_time", "show_simulated_time"]

_real_sleep = time.sleep


class Clock:
    """Simulated time of one program; ``beside`` is the lead of the clock of its other threads."""

    def __init__(self, tick_ns: int) -> None:
        self._tick_ns = tick_ns
        self._tick_began_ns = 0
        self._since_ns = 0
        self._stepping = self._main = get_ident()
        self._has_stepped = False
        self._our_threads = _count()
        self._sleepers: list[tuple[float, LockType]] = []
        self.beside = BackgroundClock()
        self.step_began = self.beside.step_began

    def count_our_threads(self) -> None:
        """Record the existing threads: the program has started none of them."""
        self._our_threads = _count()

    def has_other_threads(self) -> bool:
        """Return whether the program has started threads that have not ended."""
        return _count() > self._our_threads

    def now_ns(self) -> int:
        """Return simulated nanoseconds since the half began; the reading itself takes time of the thread that steps."""
        if get_ident() == self._stepping or self._steps_again():
            self._since_ns += _READING_NS if self._since_ns < _WAITS_FROM_NS else _WAITING_NS
            return self._tick_began_ns + self._since_ns
        return self._tick_began_ns + self._since_ns + self.beside.read_ns()

    def unix_ns(self) -> int:
        """Return simulated nanoseconds since 1970."""
        return EPOCH_NS + self.now_ns()

    def unix_s(self) -> float:
        """Return simulated seconds since 1970."""
        return (EPOCH_NS + self.now_ns()) / 1e9

    def now_s(self) -> float:
        """Return simulated seconds since the half began."""
        return self.now_ns() / 1e9

    def steps_here(self) -> bool:
        """Return whether the calling thread is the one that steps."""
        here = get_ident() == self._stepping or self._steps_again()
        return here and (self._has_stepped or not self.has_other_threads())

    def _steps_again(self) -> bool:
        """Return whether the main thread asks, and the one that stepped last has ended: it then takes its place."""
        if get_ident() != self._main or self._stepping in sys._current_frames():  # noqa: SLF001 - it is documented
            return False
        self._stepping = self._main
        return True

    def others_s(self) -> float:
        """Return the time by which threads that do not step measure waits, in s."""
        return (self._tick_began_ns + self._since_ns + self.beside.ahead_ns()) / 1e9

    def sleep(self, seconds: float) -> None:
        """Let simulated time pass for the thread that steps; other threads wait until it has."""
        _real_sleep(0 if 0 < seconds < _ENDLESS_S else seconds)  # the original's errors for non-durations
        if self.steps_here():
            self.pass_time(seconds)
        elif seconds > 0:
            self._sleep_beside(seconds)

    def _sleep_beside(self, seconds: float) -> None:
        due_s, alarm = self.others_s() + seconds, allocate_lock()
        alarm.acquire()
        sleeper = (due_s, alarm)
        self._sleepers.append(sleeper)
        slice_s = _FIRST_SLICE_S
        try:
            while (left_s := due_s - self.others_s()) > 0:
                place = self.beside.place()
                alarm.acquire(timeout=min(max(left_s, _LEAST_SLICE_S), slice_s))
                self.beside.compare(place)
                slice_s = min(2 * slice_s, _LONGEST_SLICE_S)
        finally:
            self._sleepers.remove(sleeper)

    def pass_time(self, seconds: float) -> None:
        """Let simulated time pass for the thread that steps."""
        passed_ns = int(min(seconds * 1e9, _MAX_MISSED * self._tick_ns))
        self._since_ns = min(self._since_ns + passed_ns, _MAX_MISSED * self._tick_ns)
        self.beside.caught_up(passed_ns)

    def missed_ticks(self) -> int:
        """Return the number of whole ticks that passed since the last observation by sleeping and reading."""
        return self._since_ns // self._tick_ns

    def tick_began(self, tick: int) -> None:
        """A new observation came: it is now the beginning of the time after ``tick``; the clock never runs back."""
        began, shown = tick * self._tick_ns, self._tick_began_ns + self._since_ns
        self._tick_began_ns = began if began > shown else shown  # noqa: FURB136 - called in every tick
        self._since_ns = 0
        self._stepping = get_ident()
        self._has_stepped = True
        self.beside.tick_began(self._tick_began_ns - shown)
        if self._sleepers:
            self._wake_sleepers()

    def _wake_sleepers(self) -> None:
        reached_s = self.others_s()
        for due_s, alarm in self._sleepers[:]:
            if due_s <= reached_s and alarm.locked():
                alarm.release()


def show_simulated_time(clock: Clock) -> None:
    """Make the ``time`` module show ``clock``."""
    for name in ("time", "time_ns"):
        setattr(time, name, clock.unix_s if name == "time" else clock.unix_ns)
    for name in ("monotonic", "perf_counter", "process_time", "thread_time"):
        setattr(time, name, clock.now_s)
        setattr(time, name + "_ns", clock.now_ns)
    setattr(time, "sleep", clock.sleep)  # noqa: B010 - no other type of sleep is foreseen
    for name in ("gmtime", "localtime", "ctime"):
        setattr(time, name, _with_default_now(getattr(time, name), clock))
    _patch_of_broken_down_time(clock)
    _patch_of_named_clocks(clock)


def _with_default_now(real: Callable[[float], Any], clock: Clock) -> Callable[..., Any]:
    def shown(seconds: float | None = None, /) -> Any:
        return real(clock.unix_s() if seconds is None else seconds)

    return Unbound(shown, real.__name__)


def _patch_of_broken_down_time(clock: Clock) -> None:
    """``asctime`` and ``strftime`` take the present time where none is given."""
    real_asctime, real_strftime, localtime = time.asctime, time.strftime, time.localtime

    def asctime(moment: Any = None, /) -> str:
        return real_asctime(localtime(clock.unix_s()) if moment is None else moment)

    def strftime(form: str, moment: Any = None, /) -> str:
        return real_strftime(form, localtime(clock.unix_s()) if moment is None else moment)

    time.asctime, time.strftime = Unbound(asctime, "asctime"), Unbound(strftime, "strftime")


def _patch_of_named_clocks(clock: Clock) -> None:
    """``clock_gettime`` (POSIX) shows simulated time for every clock."""
    if not hasattr(time, "clock_gettime"):
        return
    wall = time.CLOCK_REALTIME

    def clock_gettime_ns(clock_id: int, /) -> int:
        return clock.unix_ns() if clock_id == wall else clock.now_ns()

    def clock_gettime(clock_id: int, /) -> float:
        return clock_gettime_ns(clock_id) / 1e9

    time.clock_gettime = Unbound(clock_gettime, "clock_gettime")
    time.clock_gettime_ns = Unbound(clock_gettime_ns, "clock_gettime_ns")


def dates_of(clock: Clock) -> Callable[[Any], None]:
    """Return a patch that replaces the classes of the module ``datetime`` by ones that show ``clock``.

    The classes stay interchangeable with the real ones: instances of either pass for instances of both.
    """

    def replace(module: Any) -> None:
        real_datetime, real_date = module.datetime, module.date
        utc = module.timezone.utc

        def kind_of(real: type) -> type:
            def passes(cls: type, thing: object) -> bool:
                return isinstance(thing, real) if cls.__bases__ == (real,) else type.__instancecheck__(cls, thing)

            def descends(cls: type, other: type) -> bool:
                return issubclass(other, real) if cls.__bases__ == (real,) else type.__subclasscheck__(cls, other)

            return type("ClockedType", (type,), {"__instancecheck__": passes, "__subclasscheck__": descends})

        def now(cls: Any, tz: Any = None) -> Any:
            micros = clock.unix_ns() // 1_000
            moment = cls.fromtimestamp(micros // 1_000_000, utc).replace(microsecond=micros % 1_000_000)
            return moment.replace(tzinfo=None) if tz is None else moment.astimezone(tz)

        def utcnow(cls: Any) -> Any:
            return now(cls)

        def today(cls: Any) -> Any:
            moment = now(module.datetime)
            return cls(moment.year, moment.month, moment.day)

        def replaced(real: type, extra: dict[str, Any]) -> type:
            names = {"__module__": "datetime", "__qualname__": real.__name__, "__doc__": real.__doc__, **extra}
            return kind_of(real)(real.__name__, (real,), names)  # type: ignore[no-any-return]

        module.date = replaced(real_date, {"today": classmethod(today)})
        methods = {"now": classmethod(now), "utcnow": classmethod(utcnow), "today": classmethod(utcnow)}
        module.datetime = replaced(real_datetime, methods)

    return replace
