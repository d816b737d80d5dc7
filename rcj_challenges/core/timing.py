"""The tick: the one unit of time in which everything is judged and every program is stepped.

Source: the original's worlds use a basic time step of 32 ms (reference, section 3); four physics sub-steps of 8 ms
are what MuJoCo needs to keep the ball on the floor (ADR 2).
"""

from __future__ import annotations

import math

TICK_MS = 32
TICK_S = 0.032
SUBSTEPS_PER_TICK = 4
SUBSTEP_S = TICK_S / SUBSTEPS_PER_TICK


def ticks_from_s(duration_s: float) -> int:
    """Return the number of ticks that cover a duration, rounded up (15 s = 469 ticks).

    A value that is a whole number of ticks up to floating-point noise is not rounded up further.
    """
    exact = duration_s / TICK_S
    nearest = round(exact)
    return nearest if math.isclose(exact, nearest, rel_tol=1e-9, abs_tol=1e-9) else math.ceil(exact)


def whole_ticks_within_s(duration_s: float) -> int:
    """Return the number of ticks that a duration has room for, rounded down (2 s = 62 ticks): "at most so long"."""
    up = ticks_from_s(duration_s)
    return up if math.isclose(up * TICK_S, duration_s, rel_tol=1e-9, abs_tol=1e-9) else max(0, up - 1)


def s_from_ticks(ticks: int) -> float:
    """Return simulated seconds at a tick, rounded to the millisecond so that 3560 ticks are 113.92."""
    return round(ticks * TICK_MS / 1000, 3)
