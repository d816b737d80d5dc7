"""What a program is charged for in a half: the time that the match waited for it, unless others held it up.

Programs think at the same time, on as many processors as there are, and whoever is waited for last would pay for all.
So when the wall time comes near a limit, it is compared with what the program's process did meanwhile: computed, or
was ready to compute without a processor. A program that sleeps, or waits for something else, has no such excuse. Nor is
anybody charged for what the match itself waited for a processor: then the answer may have been here for long.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

_LEAST_S = 0.05
"""When its limit is reached and it may go on, it is asked about again after so long at the earliest."""
_MOST_BESIDE = 7
"""Where the system does not tell for how long a process waited for a processor: at most so many others, each as long as
it computed itself."""


class Usage(NamedTuple):
    """What a process did until now.

    Attributes:
        computed_s: processor time of all its threads in s.
        held_up_s: for how long they were ready and had no processor, in s; None: the system does not tell.
    """

    computed_s: float
    held_up_s: float | None


class Account:
    """The time of one half that one program is charged.

    Attributes:
        waited_s: wall time that the match waited for it since `begin`, in s.
        slowest_s: the longest of these waits in s.
        limit_s: of `waited_s`; when it is reached, `may_go_on` is to be asked.
    """

    def __init__(
        self, half_s: float, usage: Callable[[], Usage | None], match_held_up_s: Callable[[], float] = float
    ) -> None:
        """Open an account.

        Args:
            half_s: what it may be charged in all, in s.
            usage: tells what its process did until now; None if that cannot be told.
            match_held_up_s: tells for how long the match was ready to go on and had no processor until now, in s; also
                while it waited for nobody: to tell these times apart would cost more than it is worth.
        """
        self._half_s = half_s
        self._usage = usage
        self._match_held_up_s = match_held_up_s
        self._first: Usage | None = None
        self._first_held_up_s = 0.0
        self._charged_s: float | None = None
        self.waited_s = self.slowest_s = 0.0
        self.limit_s = half_s

    def begin(self) -> None:
        """Begin to charge: it has started."""
        self._first, self._first_held_up_s = self._usage(), self._match_held_up_s()

    def wait_was(self, lasted_s: float) -> None:
        """Note a wait that is over, of so many seconds of wall time."""
        self.waited_s += lasted_s
        self.slowest_s = max(self.slowest_s, lasted_s)

    def may_go_on(self, waiting_s: float) -> bool:
        """Return whether it may still be waited for when the limit is reached; the limit is moved then.

        Args:
            waiting_s: how long the wait has lasted that is not over, in s of wall time.
        """
        waited_s = self.waited_s + waiting_s
        left_s = self._half_s - self._charge_of(waited_s)
        if left_s <= 0:
            return False
        self.limit_s = waited_s + max(left_s, _LEAST_S)
        return True

    def close(self) -> None:
        """Work out what it is charged, as long as its process can tell what it did; what comes later is free."""
        if self._charged_s is None:
            self._charged_s = self._charge_of(self.waited_s)

    @property
    def charged_s(self) -> float:
        """What it is charged in s, from 0 to `waited_s`."""
        return self._charge_of(self.waited_s) if self._charged_s is None else self._charged_s

    def _charge_of(self, waited_s: float) -> float:
        first, now = self._first, None if self._first is None else self._usage()
        if first is None or now is None:
            return waited_s
        computed_s = now.computed_s - first.computed_s
        if computed_s < 0:  # no process takes back what it computed: it has ended, and another one was asked
            return waited_s
        held_up_s = _MOST_BESIDE * computed_s
        if now.held_up_s is not None and first.held_up_s is not None:
            held_up_s = max(0.0, now.held_up_s - first.held_up_s)  # threads that have ended count no more
        held_up_s += self._match_held_up_s() - self._first_held_up_s
        return max(waited_s - held_up_s, min(waited_s, computed_s))
