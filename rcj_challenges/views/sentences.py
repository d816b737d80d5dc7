"""Events and times as short lines of text, for terminals."""

from __future__ import annotations

from rcj_challenges.facts.play import Event, Fault
from rcj_challenges.facts.shown import shown
from rcj_challenges.facts.timing import s_from_ticks


def clock(seconds: float) -> str:
    """Return a match time as ``m:ss.s``."""
    tenths = round(seconds * 10)
    return f"{tenths // 600}:{tenths // 10 % 60:02d}.{tenths % 10}"


def event_line(event: Event) -> str:
    """Return one line for an event: match time, name, payload."""
    told = ", ".join(f"{key} {'none' if value is None else shown(value)}" for key, value in event.payload.items())
    return f"{clock(s_from_ticks(event.tick)):>7}  {event.name}" + (f"  {told}" if told else "")


def fault_line(fault: Fault) -> str:
    """Return one line for a program's fault."""
    return f"{clock(s_from_ticks(fault.tick)):>7}  {fault.robot}: {fault.kind}: {shown(fault.detail)}"
