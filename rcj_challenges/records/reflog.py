"""The reflog: events, one JSON object a line, in the format and key order of the original (reference, 5)."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from rcj_challenges.core.play import Event, Fault, RefereeOutput, Snapshot
from rcj_challenges.core.timing import s_from_ticks
from rcj_challenges.records.lines import json_line

PROGRAM_FAULT = "PROGRAM_FAULT"


def fault_event(fault: Fault, tick: int) -> Event:
    """Return the event for a program's failure; ``tick`` is the one in which the referee learns of it."""
    payload = {"robot_name": fault.robot, "kind": fault.kind, "detail": fault.detail}
    return Event(tick, PROGRAM_FAULT, payload | ({"timed": True} if fault.timed else {}))


def events_of(snapshot: Snapshot, output: RefereeOutput) -> tuple[Event, ...]:
    """Return the events of one tick in the order of the reflog: programs that failed, then what the rules emitted.

    The same function serves a match that is played and one that is judged again, so both have the same reflog.
    """
    if not snapshot.faults:
        return output.events
    return (*(fault_event(fault, snapshot.tick) for fault in snapshot.faults), *output.events)


def reflog_lines(events: Iterable[Event], datetime: str) -> bytes:
    """Return lines of ``reflog.jsonl``; ``datetime`` is the wall clock in UTC."""
    return b"".join(json_line({"datetime": datetime, **_fields(event)}) for event in events)


def event_line(half: int, event: Event) -> dict[str, Any]:
    """Return one event as it stands in ``referee.jsonl`` and ``result.json``."""
    return {"half": half, "tick": event.tick, **_fields(event)}


def _fields(event: Event) -> dict[str, Any]:
    return {"matchtime": s_from_ticks(event.tick), "event": event.name, "payload": event.payload}
