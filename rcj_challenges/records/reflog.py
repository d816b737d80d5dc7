"""The reflog: what happened, one JSON object a line, in the format and key order of the original (reference, 5)."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import asdict
from typing import Any

from rcj_challenges.facts.play import Event, Fault, Firing, RefereeOutput, Snapshot
from rcj_challenges.facts.timing import s_from_ticks
from rcj_challenges.records.lines import json_line, number_or_none

PROGRAM_FAULT = "PROGRAM_FAULT"


def fault_event(fault: Fault, tick: int) -> Event:
    """Return the event that tells of a program's failure; ``tick`` is the one at which the referee heard of it."""
    payload = {"robot_name": fault.robot, "kind": fault.kind, "detail": fault.detail}
    return Event(tick, PROGRAM_FAULT, payload | ({"timed": True} if fault.timed else {}))


def events_of(snapshot: Snapshot, output: RefereeOutput) -> tuple[Event, ...]:
    """Return the events of one tick in the order of the reflog: programs that failed, then what the rules emitted.

    Whoever judges a trajectory again gets the same reflog through this function.
    """
    if not snapshot.faults:
        return output.events
    return (*(fault_event(fault, snapshot.tick) for fault in snapshot.faults), *output.events)


def reflog_lines(events: Iterable[Event], datetime: str) -> bytes:
    """Return lines of ``reflog.jsonl``; ``datetime`` is the wall clock in UTC."""
    return b"".join(
        json_line(
            {
                "datetime": datetime,
                "matchtime": s_from_ticks(event.tick),
                "event": event.name,
                "payload": event.payload,
            }
        )
        for event in events
    )


def firing_line(half: int, firing: Firing) -> dict[str, Any]:
    """Return one firing as it stands in ``referee.jsonl``."""
    line: dict[str, Any] = {"half": half, "kind": "firing", **asdict(firing)}
    line["measured"] = number_or_none(firing.measured)
    line["limit"] = number_or_none(firing.limit)
    for key in ("other", "place"):
        if line[key] is None:
            del line[key]
    return line


def event_line(half: int, event: Event) -> dict[str, Any]:
    """Return one event as it stands in ``referee.jsonl`` and ``result.json``."""
    return {
        "half": half,
        "tick": event.tick,
        "matchtime": s_from_ticks(event.tick),
        "event": event.name,
        "payload": event.payload,
    }
