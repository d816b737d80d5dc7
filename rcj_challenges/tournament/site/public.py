"""The public part of a match: faults by kind, never in detail, and nothing that programs sensed or printed."""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Collection, Iterable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rcj_challenges.core.timing import s_from_ticks
from rcj_challenges.records.folder import REPLAY
from rcj_challenges.records.reflog import PROGRAM_FAULT
from rcj_challenges.views.sentences import clock

FAULT_WORDS = {
    "crash": "crashed",
    "exit": "ended too early",
    "start": "could not be started",
    "start_timeout": "took too long to start",
    "step_timeout": "took too long for one step",
    "half_timeout": "took too much time altogether",
    "memory": "used too much memory",
    "protocol": "sent something that is not understood",
    "output_flood": "printed too much",
}
"""By the kind of a fault."""

_PUBLIC_RESULT = (
    "record", "scenario", "title", "started", "seed", "entrants", "score", "ranking", "halves", "digest", "simulated_s",
    "versions", "marks",
)  # fmt: skip


_BLOCK = re.compile(r'<script\b[^>]*\bid="([^"]+)"[^>]*>(.*?)</script>', re.DOTALL)
"""A data block of a replay page: a script with an id."""
_PUBLIC_FAULT = ("robot", "team", "half", "tick", "kind")


def fault_words(kind: str) -> str:
    """Return a verb: ``crashed``."""
    return FAULT_WORDS.get(kind, kind.replace("_", " "))


def fault_moment(fault: Mapping[str, Any], period: str) -> str:
    """Return ``half 1, 0:09.6``; empty if the record is damaged."""
    return f"{period} {fault['half']}, {clock(s_from_ticks(fault['tick']))}" if "tick" in fault else ""


def public_result(result: Mapping[str, Any]) -> dict[str, Any]:
    """Return the public part of a ``result.json``."""
    return {
        **{key: result[key] for key in _PUBLIC_RESULT if key in result},
        "events": [_public_event(event) for event in result.get("events", ())],
        "faults": [{key: fault[key] for key in _PUBLIC_FAULT if key in fault} for fault in result.get("faults", ())],
    }


def public_stats(stats: Mapping[str, Any]) -> dict[str, Any]:
    """Return the public part of the statistics of a match."""
    return {key: stats[key] for key in ("simulated_s", "play_s", "teams", "balls", "other_calls") if key in stats}


def _public_event(event: Mapping[str, Any]) -> dict[str, Any]:
    if event["event"] != PROGRAM_FAULT:
        return dict(event)
    payload = event["payload"]
    return {**event, "payload": {key: payload[key] for key in ("robot_name", "kind") if key in payload}}


def fault_counts(faults: Iterable[Mapping[str, Any]]) -> Counter[str]:
    """Return the number of faults of each kind."""
    return Counter(str(fault["kind"]) for fault in faults)


# --- the replay page --------------------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class ReplayData:
    """The data of a replay page: the viewer's facts, and packed poses by half."""

    facts: dict[str, Any]
    poses: dict[int, str]


def read_replay(page: str) -> ReplayData:
    """Read a replay page of `views.replay` back; sensor recordings and printed text are left behind.

    Raises:
        ValueError: this is not a replay page.
    """
    blocks = dict(_BLOCK.findall(page))
    facts = json.loads(blocks.get("facts", ""))
    if not isinstance(facts, dict) or not isinstance(facts.get("halves"), list):
        raise ValueError("no facts of a replay")  # noqa: TRY004 - of the same kind as text that is not JSON
    poses = {half["half"]: blocks.get(f"half-{half['half']}", "") for half in facts["halves"]}
    return ReplayData(facts, poses)


def replay_of(record: Path | None) -> ReplayData | None:
    """Return the replay of a record; None if there is none, or it cannot be read."""
    with suppress(OSError, ValueError):
        return None if record is None else read_replay((record / REPLAY).read_text("utf-8"))
    return None


def public_facts(
    facts: Mapping[str, Any], own: Iterable[tuple[int, str]] = (), without_logos: Collection[str] = ()
) -> dict[str, Any]:
    """Return the facts of a replay without details of faults, except those of ``own`` (half, robot).

    The logos of the seats ``without_logos`` are left out.
    """
    own = frozenset(own)
    return {
        **facts,
        "teams": [
            {key: value for key, value in one.items() if key != "logo" or one["name"] not in without_logos}
            for one in facts["teams"]
        ],
        "sensors": {},
        "problem": "",
        "halves": [
            {
                **half,
                "faults": [
                    fault if (half["half"], fault["robot"]) in own else {**fault, "detail": fault_words(fault["kind"])}
                    for fault in half["faults"]
                ],
            }
            for half in facts["halves"]
        ],
        "events": [_public_moment(event, own) for event in facts["events"]],
    }


def _public_moment(event: Mapping[str, Any], own: frozenset[tuple[int, str]]) -> dict[str, Any]:
    payload = dict(event["payload"])
    if event["name"] != PROGRAM_FAULT or (event["half"], payload.get("robot_name")) in own:
        return dict(event)
    robot, kind = str(payload.get("robot_name", "")), str(payload.get("kind", ""))
    about = f"The program of {robot} {fault_words(kind)}."
    return {
        **event, "about": about, "payload_text": "", "says": "", "caption": about,
        "payload": [["robot_name", robot], ["kind", kind]],
    }  # fmt: skip
