"""An answer that arrives while the match waits for another program is kept until it is asked for."""

from __future__ import annotations

import math
import time

import pytest

from rcj_challenges.programs.pipes import ChannelClosedError
from rcj_challenges.programs.time_budget import ProcessTimes, TimeBudget, TimeLimits
from rcj_challenges.programs.timed_channel import TimedChannel


class FrameQueue:
    """A channel on which frames, or the end, have arrived already."""

    def __init__(self, *frames: bytes | Exception) -> None:
        self.frames = list(frames)

    def receive(self, _timeout_s: float) -> bytes | None:
        if not self.frames:
            return None
        frame = self.frames.pop(0)
        if isinstance(frame, Exception):
            raise frame
        return frame


def timed(*frames: bytes | Exception) -> TimedChannel:
    budget = TimeBudget(TimeLimits(30, 5, 120), lambda: ProcessTimes(0.0, {}), lambda _thread: False)
    return TimedChannel(FrameQueue(*frames), budget)  # type: ignore[arg-type]


def test_answer_that_another_wait_noted_survives_further_looks() -> None:
    channel = timed(b"hello")
    channel.look()  # while another program is waited for
    channel.look()  # as its own wait begins
    assert channel.receive(0.0) == b"hello"


def test_end_that_another_wait_noted_survives_further_looks() -> None:
    channel = timed(ChannelClosedError())
    channel.look()
    channel.look()
    with pytest.raises(ChannelClosedError):
        channel.receive(0.0)


def test_interval_that_was_measured_during_another_wait_is_closed_by_its_own_wait() -> None:
    channel = timed(b"start")
    channel.look()
    assert channel.receive(0.0) == b"start"
    channel.is_awaited = True
    channel.look()  # while another program is awaited: measured from here on
    channel.channel.frames.append(b"step")  # type: ignore[attr-defined]
    assert channel.receive_before_measuring() is None
    channel.look(math.inf)
    assert channel.receive(0.0) == b"step"
    assert channel.budget._measured is None


def test_match_that_did_something_else_since_the_last_look_charges_no_idle_time() -> None:
    channel = timed(b"start")
    channel.look()
    channel.receive(0.0)
    channel.is_awaited = True
    channel.look()
    time.sleep(0.05)  # the match waits for the end of another program
    channel.look(math.inf)
    assert channel.budget.charged_s < 0.02
