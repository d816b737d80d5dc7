"""Events and times as short lines of text, for terminals."""

from __future__ import annotations

from rcj_challenges.facts.play import Event, Fault
from rcj_challenges.facts.timing import s_from_ticks

_CONTROL = dict.fromkeys((*range(32), *range(127, 160)), "�")
# What separates lines and paragraphs breaks a line as a control character does, and Pillow cannot draw it.
_CONTROL |= dict.fromkeys((0x2028, 0x2029), " ")
# Marks that turn the direction of text would let a name rearrange the line it stands in.
_CONTROL |= dict.fromkeys([*range(0x202A, 0x202F), *range(0x2066, 0x206A), 0x200E, 0x200F, 0x061C], "")


def plain(text: object, longest: int = 200) -> str:
    """Return text that is safe in a terminal: no control characters, no direction marks, not endless."""
    shown = str(text).translate(_CONTROL)
    return shown if len(shown) <= longest else shown[: longest - 1] + "…"


def clock(seconds: float) -> str:
    """Return a match time as ``m:ss.s``."""
    tenths = round(seconds * 10)
    return f"{tenths // 600}:{tenths // 10 % 60:02d}.{tenths % 10}"


def event_line(event: Event) -> str:
    """Return one line for an event: match time, name, payload."""
    told = ", ".join(f"{key} {'none' if value is None else plain(value)}" for key, value in event.payload.items())
    return f"{clock(s_from_ticks(event.tick)):>7}  {event.name}" + (f"  {told}" if told else "")


def fault_line(fault: Fault) -> str:
    """Return one line for a program's fault."""
    return f"{clock(s_from_ticks(fault.tick)):>7}  {fault.robot}: {fault.kind}: {plain(fault.detail)}"
