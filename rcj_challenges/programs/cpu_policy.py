"""Decides whether programs busy-wait and which CPUs they may use.

Only speed depends on it, never results or limits (ADR 10). While the match simulates a tick the programs' CPU falls
asleep, and waking it takes as long as two programs compute: so while a CPU is free, one program busy-waits for the next
tick, and programs that compute little leave the match its CPU. On a computer without a free CPU none busy-waits, and
programs that compute less than the match share its CPU and its caches.
"""

from __future__ import annotations

import contextlib
import ctypes
import math
import os
import sys
import time
from collections.abc import Callable, Mapping
from typing import NamedTuple

from rcj_challenges.core.timing import TICK_S
from rcj_challenges.programs import process_stats

ENABLED = sys.platform == "linux"
"""The switch: False leaves all programs to the system's scheduler."""

SOON_S = 0.001  # programs sleep through longer ticks, in which another computes or the match waits
LITTLE = 0.4  # share of a CPU; programs that use less would not be done sooner on the match's CPU (ADR 10)
UNHURRIED_S = TICK_S / 2  # in longer ticks it does not matter which program is on which CPU
_POLL_INTERVAL_TICKS = 64
_sched_getcpu = getattr(ctypes.CDLL(None), "sched_getcpu", None) if ENABLED else None


class CpuShare(NamedTuple):
    """How programs share the CPUs with the match."""

    is_batch: bool = False  # one that is woken interrupts no other, nor the match while it releases the others
    leaves_cpu: int | None = None  # the CPU that they leave to the match
    keeps_to_cpu: int | None = None  # the only CPU that they may use


DEFAULT_SHARE = CpuShare()


class CpuPolicy:
    """Decides at every tick of one half.

    Attributes:
        share: of the programs from now on; another object only if it changes.
    """

    def __init__(self, computed_s: Callable[[], Mapping[int, float]]) -> None:
        """Begin; ``computed_s`` returns for how long each living program has computed, by robot."""
        self.share = DEFAULT_SHARE
        self._granted_cpus, self._all_cpus = process_stats.processors(), process_stats.all_processors()
        self._computed_s_now = computed_s
        self._computed_s: Mapping[int, float] = {}
        self._began_s, self._ticks, self._was_full = -math.inf, 0, False
        self._polled_s, self._ours_s = math.nan, 0.0
        self._busy_waiting: set[int] = set()

    def should_busy_wait(self, robot: int) -> bool:
        """Return whether a program busy-waits for the next tick; called once a tick, before programs are released."""
        now_s = time.perf_counter()
        was_soon, self._began_s = now_s - self._began_s < SOON_S, now_s
        self._ticks += 1
        phase = self._ticks % _POLL_INTERVAL_TICKS
        if phase == 0 and ENABLED:
            self._poll(now_s)
        # Before a poll the one that busy-waits has to sleep: it would be counted.
        waits = was_soon and self.share.is_batch and phase != _POLL_INTERVAL_TICKS - 1
        if waits:
            self._busy_waiting.add(robot)
        return waits

    def give_all_cpus(self) -> None:
        """Let programs use all CPUs until the next poll: the match waits for one that computes, and needs none."""
        if self.share != CpuShare(self.share.is_batch):
            self.share = CpuShare(self.share.is_batch)

    def _poll(self, now_s: float) -> None:
        """Measure whether a CPU is free, and whether one is enough for the programs."""
        running, was_full = process_stats.running(), self._was_full
        lasted_s, self._polled_s = now_s - self._polled_s, now_s
        ours_s, self._ours_s = self._ours_s, time.thread_time()
        before_s, self._computed_s = self._computed_s, self._computed_s_now()
        # Those that busy-waited did nothing else, and of one that has ended meanwhile nothing is known.
        counted = [robot for robot in self._computed_s if robot in before_s and robot not in self._busy_waiting]
        busy = sum(max(0.0, self._computed_s[robot] - before_s[robot]) for robot in counted) / lasted_s
        ours, tick_s = (self._ours_s - ours_s) / lasted_s, lasted_s / _POLL_INTERVAL_TICKS
        self._busy_waiting.clear()
        # Of the whole computer, not only those granted to us: on a large one others may be busy elsewhere.
        self._was_full = running >= self._all_cpus > 0
        share = DEFAULT_SHARE
        if 0 < running < self._granted_cpus:
            is_little = tick_s < SOON_S and busy < LITTLE
            share = CpuShare(is_batch=True, leaves_cpu=current_cpu() if is_little else None)
        elif self._was_full and was_full and tick_s < UNHURRIED_S and busy < ours:
            # Programs that compute less than the match gain nothing from a share of other CPUs.
            share = CpuShare(keeps_to_cpu=current_cpu())
        if share != self.share:
            self.share = share


def current_cpu() -> int | None:
    """Return the number of the CPU of this thread; None if the system does not say."""
    cpu = -1 if _sched_getcpu is None else int(_sched_getcpu())
    return cpu if cpu >= 0 else None


def apply(pid: int, share: CpuShare) -> None:
    """Apply a share to all threads of a process, within the CPUs of this one. A process that has ended is ignored."""
    if sys.platform != "linux":
        return
    policy = os.SCHED_BATCH if share.is_batch else os.SCHED_OTHER
    ours = os.sched_getaffinity(0)
    cpus = (ours - {share.leaves_cpu} if share.keeps_to_cpu is None else ours & {share.keeps_to_cpu}) or ours
    with contextlib.suppress(OSError):
        for thread in os.listdir(f"/proc/{pid}/task"):  # noqa: PTH208 - a match waits
            with contextlib.suppress(OSError):  # it has ended
                os.sched_setscheduler(int(thread), policy, os.sched_param(0))
                os.sched_setaffinity(int(thread), cpus)
