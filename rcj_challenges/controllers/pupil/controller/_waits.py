"""Waits with a limit: for locks, queues and events of ``asyncio``.

A wait of the thread that steps which ends because its time is over takes that time of the simulated clock, as ``sleep``
does. Where the program has no other thread, nobody could have ended it: then it takes no real time. With other threads
it really waits, for only so much time may they take. Those measure their own limits by the match (`Clock.others_s`).
"""

from __future__ import annotations

import sys

from ._clock import Clock, real_monotonic, real_process_time

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from ._hooks import Patch

    Wait = Callable[[Any, Any], Any]
    """A method with a limit in s, or None, that returns what is true if what was waited for came."""


_SHORT_S = 0.032
_SLICE_S = 0.001
_SLICE_BESIDE_S = 0.002
_IDLE_SHARE = 0.2


class Waits:
    """The waits of the standard library, as one program sees them."""

    def __init__(self, clock: Clock) -> None:
        self._clock = clock
        clock.count_our_threads()

    def patches(self) -> dict[str, Patch]:
        """Return what makes them show the clock, by module."""
        return {
            "threading": self._of_threading,
            "queue": self._of_queue,
            "selectors": self._of_selectors,
            "asyncio.windows_events": self._of_windows,
        }

    def _of_threading(self, module: Any) -> None:
        module._time = self._now_s  # noqa: SLF001 - as the library calls it
        module.Condition.wait = self._patient(module.Condition.wait)

    def _of_queue(self, module: Any) -> None:
        module.time = self._now_s

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
        clock = self._clock

        def wait(self: Any, timeout: Any = None) -> Any:
            if timeout is None or timeout <= 0:
                return real(self, timeout)
            if not clock.steps_here():
                return _beside(clock, real, self, timeout)
            came = _for_others(real, self, timeout) if clock.has_other_threads() else real(self, 0)
            if not came and clock.steps_here():  # another thread may have begun to step
                clock.pass_time(timeout)
            return came

        return wait


def _beside(clock: Clock, real: Wait, waiting: Any, timeout: float) -> Any:
    """Wait in a thread that does not step, until so much time of the match has passed."""
    due_s = clock.others_s() + timeout
    while True:
        left_s = due_s - clock.others_s()
        came = real(waiting, max(0.0, min(left_s, _SLICE_BESIDE_S)))
        if came or left_s <= 0:
            return came


def _for_others(real: Wait, waiting: Any, timeout: float) -> Any:
    """Really wait for other threads.

    Who waits for less than a tick in every step, beside threads that themselves wait for work, would use up a half's
    time for nothing: such a wait is over when nobody computes.
    """
    if timeout > _SHORT_S or sys.platform == "win32":  # there what was computed is told every 16 ms only
        return real(waiting, timeout)
    end_s = real_monotonic() + timeout
    while True:
        began_s, computed_s = real_monotonic(), real_process_time()
        came = real(waiting, min(_SLICE_S, timeout))
        now_s = real_monotonic()
        if came or now_s >= end_s or real_process_time() - computed_s < _IDLE_SHARE * (now_s - began_s):
            return came
