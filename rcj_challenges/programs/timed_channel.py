"""A channel to a program that charges the time until each answer, and waiting for several of them at once."""

from __future__ import annotations

import time
from collections.abc import Sequence

from rcj_challenges.core.errors import HostError
from rcj_challenges.programs import pipes, process_stats
from rcj_challenges.programs.codes import HOST_TOO_BUSY
from rcj_challenges.programs.pipes import Channel, ChannelClosedError, FrameTooLongError
from rcj_challenges.programs.time_budget import MEASURED_AFTER_S, TimeBudget


class TimedChannel:
    """A channel to one program, with the budget that its answers are charged to."""

    def __init__(self, channel: Channel, budget: TimeBudget) -> None:
        self.channel = channel
        self.budget = budget
        self.is_awaited = True
        self._arrived: bytes | ChannelClosedError | FrameTooLongError | None = None
        self._held_up_s: float | None = None  # the match itself, at the last look of this interval
        self._released_s = time.perf_counter()

    def release(self, frame: bytes) -> None:
        """Send a frame, and charge the time until the answer."""
        self.is_awaited = True
        self._released_s = time.perf_counter()
        self.channel.send(frame)

    def receive_soon(self) -> bytes | None:
        """Return the answer if it is here, or arrives at once; else None. See `Channel` for the errors."""
        if self._arrived is not None:
            return self._taken()
        body = self.channel.receive_soon()
        if body is not None:
            self.is_awaited = False
            self.budget.quick_answers += 1
        return body

    def receive_before_measuring(self) -> bytes | None:
        """Return the answer, None if it does not arrive until the interval has to be measured."""
        if self._arrived is not None:
            return self._taken()
        if self._held_up_s is not None:  # measured already while another program was awaited: `look` ends that
            return None
        body = self.channel.receive(max(0.0, self._released_s + MEASURED_AFTER_S - time.perf_counter()))
        if body is not None:
            self.is_awaited = False
            self.budget.answered_within(time.perf_counter() - self._released_s)
        return body

    def receive(self, timeout_s: float) -> bytes | None:
        """Return the answer, None if it does not arrive in time. See `Channel` for the errors."""
        if self._arrived is not None:
            return self._taken()
        body = self.channel.receive(timeout_s)
        if body is not None:
            self.is_awaited, self._held_up_s = False, None
            self.budget.answered(time.perf_counter())
        return body

    def look(self, overslept_s: float = 0.0) -> None:
        """Charge the time since the last look, and note an answer or an error: `receive` returns or raises it.

        Without an awaited answer there is nothing to charge, and what was noted before stays. ``overslept_s`` is how
        much longer than it wanted the match has just waited: it was stopped (Ctrl-Z).
        """
        if not self.is_awaited:
            return
        now_s, held_up_s = time.perf_counter(), process_stats.held_up_here_s()
        # If the match stood still, or had no processor, the answer may have arrived long before.
        lost_s = 0.0 if self._held_up_s is None else max(0.0, overslept_s, held_up_s - self._held_up_s)
        self._held_up_s = held_up_s
        try:
            self._arrived = self.channel.receive(0.0)
        except (ChannelClosedError, FrameTooLongError) as error:
            self._arrived = error
        if self._arrived is None:
            self.budget.look(now_s, lost_s)
        else:
            self.is_awaited, self._held_up_s = False, None
            self.budget.answered(now_s, lost_s)

    def close(self) -> None:
        """Give the pipes back."""
        self.is_awaited = False
        self.channel.close()

    def _taken(self) -> bytes | None:
        arrived, self._arrived = self._arrived, None
        if isinstance(arrived, Exception):
            raise arrived
        return arrived


class WaitBudget:
    """The wall time that a half may wait for all its programs together.

    It ends a half on a computer that is too busy for it: there no program reaches a limit of its own.
    """

    def __init__(self, limit_s: float) -> None:
        self._limit_s = self._left_s = limit_s

    def spend(self, wall_s: float) -> None:
        """Take wall time away.

        Raises:
            HostError: none is left.
        """
        self._left_s -= wall_s
        if self._left_s < 0:
            message = f"the match waited {self._limit_s:.0f} s for programs, but none reached a limit of its own"
            help_ = "this computer is too busy: run fewer programs beside the match, and play it again"
            raise HostError(message, help_, code=HOST_TOO_BUSY)


def wait_together(channels: Sequence[TimedChannel], timeout_s: float, wait_budget: WaitBudget) -> None:
    """Wait until one of several awaited programs answers, at most ``timeout_s``, and charge all of them.

    Raises:
        HostError: nothing is left of ``wait_budget``.
    """
    began_s = time.perf_counter()
    pipes.wait_for_any([timed.channel for timed in channels], timeout_s)
    waited_s = time.perf_counter() - began_s
    for timed in channels:
        timed.look(waited_s - timeout_s)
    wait_budget.spend(min(waited_s, timeout_s))
