"""Events and times as short lines of text, for terminals."""

from __future__ import annotations

from rcj_challenges.facts.play import Fault
from rcj_challenges.facts.sanitize import sanitize
from rcj_challenges.facts.timing import s_from_ticks


def clock(seconds: float) -> str:
    """Return a match time as ``m:ss.s``."""
    tenths = round(seconds * 10)
    return f"{tenths // 600}:{tenths // 10 % 60:02d}.{tenths % 10}"


def fault_line(fault: Fault) -> str:
    """Return one line for a program's fault."""
    return f"{clock(s_from_ticks(fault.tick)):>7}  {fault.robot}: {fault.kind}: {sanitize(fault.detail)}"
