"""Events and times as short lines of text, for terminals."""

from __future__ import annotations

import re

from rcj_challenges.core.amounts import HALF, Noun
from rcj_challenges.core.play import Fault
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.core.timing import s_from_ticks
from rcj_challenges.records.reflog import PROGRAM_FAULT

_WHERE = re.compile(r'File "(?:[^"]*[/\\])?([^"/\\]+)", line (\d+)')


def clock(seconds: float) -> str:
    """Return a match time as ``m:ss.s``."""
    tenths = round(seconds * 10)
    return f"{tenths // 600}:{tenths // 10 % 60:02d}.{tenths % 10}"


def event_title(name: str, half: int, halves: int, period: Noun = HALF) -> str:
    """Return the name of an event for spectators: ``GOAL``, ``END OF HALF 1``."""
    if name == PROGRAM_FAULT:
        return "PROGRAM FAILED"
    if name == "MATCH_START" and half > 1:
        return f"START OF {period} {half}".upper()
    is_end = name == "MATCH_FINISH" and half < halves
    return f"END OF {period} {half}".upper() if is_end else name.replace("_", " ")


def fault_sentence(fault: Fault) -> str:
    """Return ``Y1 crashed at robot.py:7: ZeroDivisionError: division by zero``; the place once, where it is known."""
    where = [] if fault.detail.endswith(")") and ", line " in fault.detail else _WHERE.findall(fault.traceback)
    at = f" at {where[-1][0]}:{where[-1][1]}" if where else ""
    what = "crashed" if fault.kind == "crash" else f"failed ({fault.kind.replace('_', ' ')})"
    return f"{fault.robot} {what}{at}: {fault.detail}"


def fault_line(fault: Fault) -> str:
    """Return one line for a program's fault, with the time at which it failed."""
    return f"{clock(s_from_ticks(fault.tick)):>7}  {sanitize(fault_sentence(fault), 300)}"
