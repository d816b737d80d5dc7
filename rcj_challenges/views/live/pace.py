"""The pace of a live match: speed, pause, single steps. It only delays the loop."""

from __future__ import annotations

import math
import threading
import time
from collections.abc import Callable
from typing import Any

from rcj_challenges.core.timing import TICK_S

MAX_SPEED = math.inf
"""As fast as the machine can."""

MAX_STEPS = 1_000
SLOWEST, FASTEST = 0.01, 1_000.0

_SLICE_S = 0.5
"""Waits are cut into slices: on some systems a wait without an end cannot be interrupted from the keyboard."""
_FORGIVEN_S = 0.2
"""A match that is later than this does not catch up: its pace counts from now on."""


class Pace:
    """Decides when the next tick may begin; it is steered from another thread.

    Speed is simulated over wall time; `MAX_SPEED` does not wait. ``changed`` is called with `state` after each change,
    by the thread that made it.
    """

    def __init__(
        self,
        speed: float = 1.0,
        changed: Callable[[dict[str, Any]], None] | None = None,
        clock: Callable[[], float] = time.perf_counter,
    ) -> None:
        self._speed = speed
        self._paused = False
        self._steps = 0
        self._over = False
        self._free = speed == MAX_SPEED
        self._changed = changed or (lambda _state: None)
        self._clock = clock
        self._turn = threading.Condition()
        self._anchor_s = clock()
        self._anchor_tick = -1
        self._last_tick = 0

    @property
    def state(self) -> dict[str, Any]:
        """The state that is sent to spectators: ``paused``, and ``speed`` (None: as fast as it can)."""
        return {"paused": self._paused, "speed": None if self._speed == MAX_SPEED else self._speed}

    def before_tick(self, tick: int) -> float:
        """Wait until this tick may begin; returns for how long in s."""
        if self._free:
            return 0.0
        began_s = self._clock()
        with self._turn:
            while (wait_s := self._wait_s(tick)) > 0:
                self._turn.wait(min(wait_s, _SLICE_S))
        return self._clock() - began_s

    def pause(self) -> None:
        """Begin no more ticks."""
        self._set(paused=True)

    def resume(self) -> None:
        """Go on at the speed that is set."""
        self._set(paused=False)

    def step(self, ticks: int = 1) -> None:
        """Pause, and play so many ticks (at most `MAX_STEPS`)."""
        self._set(paused=True, more_steps=ticks)

    def set_speed(self, speed: float) -> None:
        """Play at another speed: from `SLOWEST` to `FASTEST`, or `MAX_SPEED`.

        Raises:
            ValueError: it is none of these.
        """
        if not (SLOWEST <= speed <= FASTEST or speed == MAX_SPEED):
            raise ValueError(f"a speed is from {SLOWEST:g} to {FASTEST:g}, or max")
        self._set(speed=speed)

    def release(self) -> None:
        """Let the match run at full speed, for good."""
        with self._turn:
            self._over = True
            self._free = True
            self._turn.notify_all()

    def _set(self, *, paused: bool | None = None, speed: float | None = None, more_steps: int = 0) -> None:
        with self._turn:
            before = self.state
            self._paused = self._paused if paused is None else paused
            self._speed = self._speed if speed is None else speed
            self._steps = min(MAX_STEPS, self._steps + more_steps) if more_steps else 0
            self._free = self._over or (self._speed == MAX_SPEED and not self._paused)
            self._anchor_tick = -1
            self._turn.notify_all()
            now = self.state
        if now != before:
            self._changed(now)

    def _wait_s(self, tick: int) -> float:
        if self._free:
            return 0.0
        if self._paused:
            if self._steps:
                self._steps -= 1
                return 0.0
            return math.inf
        now_s = self._clock()
        due_s = self._anchor_s + (tick - self._anchor_tick) * TICK_S / self._speed
        again, self._last_tick = tick < self._last_tick, tick
        if self._anchor_tick < 0 or again or now_s - due_s > _FORGIVEN_S:
            # After a change, in a new half, or if the match cannot keep up: count from here.
            self._anchor_s, self._anchor_tick = now_s, tick
            return 0.0
        return due_s - now_s
