"""The feed of a recorded match, cut into steps of its time: a stage releases them by its clock."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import chain
from typing import Any

from rcj_challenges.views.live.feed import json_message, pose_message
from rcj_challenges.views.replay.packing import unpacked

STEP_S = 0.5
"""Rare enough for many spectators, often enough for one moment of all of them."""


@dataclass(frozen=True, slots=True)
class RecordedFeed:
    """A whole feed.

    Attributes:
        facts: of the page before the first tick.
        data: all messages.
        ends: by step, the bytes of ``data`` of what has happened when the step of `STEP_S` is over.
        planned_s: how long it takes at least, if no half ends early, breaks included.
        goals: their time in s, half, tick, team and score.
    """

    facts: dict[str, Any]
    data: bytes
    ends: tuple[int, ...]
    planned_s: float
    goals: tuple[tuple[float, int, int, str, str], ...]


def recorded_feed(facts: Mapping[str, Any], poses: Mapping[int, str], half_time_s: float) -> RecordedFeed:
    """Return the feed of a match.

    Args:
        facts: of its replay page, as all may see them.
        poses: packed, by half.
        half_time_s: the length of the breaks.

    Raises:
        ValueError: the poses are damaged.
    """
    tick_s, halves, data = facts["tick_s"], facts["halves"], bytearray()
    ends: list[int] = []
    goals: list[tuple[float, int, int, str, str]] = []
    begins_s = 0.0
    for half in halves:
        number, last, sent = half["half"], half["ticks"], -1
        rows, news = unpacked(poses[number], len(facts["channels"]), len(facts["entities"])), list(_news(facts, half))
        while sent < last:
            until = min(last, math.floor(((len(ends) + 1) * STEP_S - begins_s) / tick_s))
            if until > sent:  # else it is the break before this half
                data += _begin(half) if sent < 0 else b""
                data += pose_message(number, sent + 1, rows[sent + 1 : until + 1].tobytes())
                data += b"".join(json_message(one) for one in news if sent < one["tick"] <= until)
                sent = until
            ends.append(len(data))
        goals += [
            (begins_s + event["tick"] * tick_s, number, event["tick"], event["team"], event["standing"])
            for event in facts["events"]
            if event["half"] == number and event["kind"] == "goal"
        ]
        begins_s += last * tick_s + half_time_s
    data += json_message(
        {"say": "over", "replay": False, **{key: facts[key] for key in ("about", "places", "complete")}}
    )
    ends[-1:] = [len(data)]
    planned = [half["planned_ticks"] for half in halves]
    planned += planned[-1:] * (facts["halves_planned"] - len(planned))
    before = {
        **facts, "halves": [], "events": [], "places": [], "sensors": {}, "complete": False, "problem": "",
        "about": facts["about"][:1], "half_ticks_planned": planned, "feed_every_s": STEP_S,
    }  # fmt: skip
    planned_s = sum(planned) * tick_s + (len(planned) - 1) * half_time_s
    return RecordedFeed(before, bytes(data), tuple(ends), planned_s, tuple(goals))


def _begin(half: Mapping[str, Any]) -> bytes:
    nothing: dict[str, Any] = {key: [] for key in ("score_changes", "counted", "phases", "held", "jumps", "faults")}
    return json_message({"say": "half", "facts": {**half, "ticks": 0, **nothing}})


def _news(facts: Mapping[str, Any], half: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
    """Yield what happens in a half, as messages of a live match."""
    happens = chain(
        ((tick, {"score": score}) for tick, score in half["score_changes"]),
        ((tick, {"counted": counted}) for tick, counted in half["counted"]),
        ((tick, {"phase": phase}) for tick, *phase in half["phases"]),
        ((tick, {"held": held}) for tick, held in half["held"]),
        ((tick, {"jumps": [entity]}) for entity, ticks in enumerate(half["jumps"]) for tick in ticks),
        ((fault["tick"], {"faults": [fault]}) for fault in half["faults"]),
        ((event["tick"], {"events": [event]}) for event in facts["events"] if event["half"] == half["half"]),
    )
    for tick, what in happens:
        yield {"say": "news", "half": half["half"], "tick": tick, "events": [], **what}
