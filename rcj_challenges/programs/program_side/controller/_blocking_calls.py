"""Waits with a limit: for threads, conditions, queues, files and events of ``asyncio``.

When a wait of the stepping thread times out, that time passes on the simulated clock, as with ``sleep``. If the program
has no other thread, nothing can end the wait early, so it takes no real time. With other threads it really waits, for
at most that time. Their own timeouts are measured in match time (`Clock.others_s`). Locks themselves are not among
them: ``Lock.acquire(timeout=…)`` is a method of a class that cannot be changed.
"""

from __future__ import annotations

import sys
from _thread import get_ident

from ._background_clock import others_would_run
from ._clock import Clock, real_monotonic, real_process_time
from ._hooks import Unbound

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from ._hooks import Patch

    Wait = Callable[[Any, Any], Any]
    """A method with a timeout in s, or None, that returns something true if the wait succeeded."""


_SHORT_S = 0.032
_SLICE_S = 0.001
_HELD_UP_S = 0.003
"""A thread that returns this late from waiting 0.001 s had no processor: this says nothing about the other threads."""
_SLICE_BESIDE_S = 0.002
_IDLE_SHARE = 0.2


class BlockingCalls:
    """The waits of the standard library, as one program sees them."""

    def __init__(self, clock: Clock) -> None:
        self._clock = clock
        self._waiting: set[int] = set()  # threads: one wait may be made of another of the same thread
        clock.count_our_threads()

    def patches(self) -> dict[str, Patch]:
        """Return the patches that make them use the clock, by module."""
        return {
            "threading": self._of_threading,
            "queue": self._of_queue,
            "select": self._of_select,
            "selectors": self._of_selectors,
            "asyncio.windows_events": self._of_windows,
        }

    def _of_threading(self, module: Any) -> None:
        module._time = self._now_s  # noqa: SLF001 - as the library calls it
        module.Condition.wait = self._patient(module.Condition.wait)
        real_join = module.Thread.join

        def ends(thread: Any, timeout: float | None) -> bool:
            real_join(thread, timeout)
            return not thread.is_alive()

        patient = self._patient(ends)

        def join(self: Any, timeout: float | None = None) -> None:
            patient(self, timeout)

        module.Thread.join = join

    def _of_queue(self, module: Any) -> None:
        module.time = self._now_s
        real: Any = module.SimpleQueue
        if real.__module__ == "_queue":  # else it is made of what waits already
            module.SimpleQueue = self._patient_queue(real, module.Empty)

    def _patient_queue(self, real: Any, empty: type[Exception]) -> type:
        def first(queue: Any, timeout: float | None) -> tuple[Any] | None:
            try:
                return (real.get(queue, True, timeout),)
            except empty:
                return None

        patient = self._patient(first)

        def get(self: Any, block: bool = True, timeout: float | None = None) -> Any:
            if not block:
                return real.get(self, block, timeout)
            found = patient(self, timeout)
            if found is None:
                raise empty
            return found[0]

        return type("SimpleQueue", (real,), {"__module__": "_queue", "__slots__": (), "get": get})

    def _of_select(self, module: Any) -> None:
        real = module.select

        def ready(files: Any, timeout: float | None) -> Any:
            found = real(*files, timeout)
            return found if any(found) else None

        patient = self._patient(ready)

        def select(rlist: Any, wlist: Any, xlist: Any, timeout: float | None = None, /) -> Any:
            return patient((rlist, wlist, xlist), timeout) or ([], [], [])

        module.select = Unbound(select, "select")

    def _of_selectors(self, module: Any) -> None:
        # One of them has two names: DefaultSelector is the best of the others.
        kinds = {kind for kind in vars(module).values() if isinstance(kind, type)}
        for kind in kinds:
            if issubclass(kind, module.BaseSelector) and "select" in vars(kind):
                setattr(kind, "select", self._patient(vars(kind)["select"]))  # noqa: B010 - of whatever class it is

    def _of_windows(self, module: Any) -> None:
        module.IocpProactor.select = self._patient(module.IocpProactor.select)

    def _now_s(self) -> float:
        return self._clock.now_s() if self._clock.steps_here() else self._clock.others_s()

    def _patient(self, real: Wait) -> Wait:
        clock, waiting = self._clock, self._waiting

        def wait(self: Any, timeout: Any = None) -> Any:
            if timeout is None or timeout <= 0:
                return real(self, timeout)
            if not clock.steps_here():
                return _wait_beside_others(clock, real, self, timeout)
            here = get_ident()
            if here in waiting:
                return real(self, timeout)
            waiting.add(here)
            try:
                came = _for_others(real, self, timeout) if clock.has_other_threads() else real(self, 0)
            finally:
                waiting.discard(here)
            if not came and clock.steps_here():  # another thread may have begun to step
                clock.pass_time(timeout)
            return came

        return wait


def _wait_beside_others(clock: Clock, real: Wait, waiting: Any, timeout: float) -> Any:
    """Wait in a thread that does not step, until so much time of the match has passed."""
    due_s = clock.others_s() + timeout
    while True:
        left_s = due_s - clock.others_s()
        place = clock.beside.place()
        came = real(waiting, max(0.0, min(left_s, _SLICE_BESIDE_S)))
        if came or left_s <= 0:
            return came
        clock.beside.compare(place)


def _for_others(real: Wait, waiting: Any, timeout: float) -> Any:
    """Really wait for other threads.

    A program that waits for less than a tick in every step, while its threads themselves wait for work, would waste its
    time budget: such a wait ends when no thread computes or is ready to. Time in which other programs had the processor
    does not count, because the awaited thread could not use it.
    """
    if timeout > _SHORT_S or sys.platform == "win32":  # Windows updates CPU times only every 16 ms
        return real(waiting, timeout)
    left_s = timeout
    while True:
        began_s, computed_s = real_monotonic(), real_process_time()
        came = real(waiting, min(_SLICE_S, timeout))
        passed_s, computed_s = real_monotonic() - began_s, real_process_time() - computed_s
        is_idle = computed_s < _IDLE_SHARE * passed_s
        would_run = others_would_run() if is_idle else None
        left_s -= computed_s if would_run else min(passed_s, _SLICE_S + computed_s)
        if would_run is None:  # if that is unknown, assume that others are delayed if this one has just been
            would_run = passed_s >= _HELD_UP_S
        if came or left_s <= 0 or (is_idle and not would_run):
            return came
