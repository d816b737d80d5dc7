"""The feed of a recorded match, cut into steps of its time: a stage releases them by its clock."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from operator import itemgetter
from typing import Any

from rcj_challenges.views.live.feed import json_message, news_message, pose_message
from rcj_challenges.views.replay.packing import unpacked
from rcj_challenges.views.timeline import CHANGES

_NOTHING_YET = {"ticks": 0, **dict.fromkeys((*CHANGES, "jumps", "faults"), ())}
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
    tick_s, halves, data, begins_s = facts["tick_s"], facts["halves"], bytearray(), 0.0
    ends: list[int] = []
    goals: list[tuple[float, int, int, str, str]] = []
    for half in halves:
        number, last, sent = half["half"], half["ticks"], -1
        rows = unpacked(poses[number], len(facts["channels"]), len(facts["entities"]))
        while sent < last:
            until = min(last, math.floor(((len(ends) + 1) * STEP_S - begins_s) / tick_s))
            if until > sent:  # else it is the break before this half
                if sent < 0:
                    data += json_message({"say": "half", "facts": half | _NOTHING_YET})
                data += pose_message(number, sent + 1, rows[sent + 1 : until + 1].tobytes())
                data += news_message(number, _happened(facts, half, sent, until))
                sent = until
            ends.append(len(data))
        goals += [
            (begins_s + event["tick"] * tick_s, number, event["tick"], event["team"], event["standing"])
            for event in facts["events"]
            if event["half"] == number and event["kind"] == "goal"
        ]
        begins_s += last * tick_s + half_time_s
    over = {key: facts[key] for key in ("about", "places", "complete")}
    data += json_message({"say": "over", "replay": False, **over})
    ends[-1:] = [len(data)]
    planned = [half["planned_ticks"] for half in halves]
    planned += planned[-1:] * (facts["halves_planned"] - len(planned))
    before = {
        **facts, "halves": [], "events": [], "places": [], "sensors": {}, "complete": False, "problem": "",
        "about": facts["about"][:1], "half_ticks_planned": planned, "feed_every_s": STEP_S,
    }  # fmt: skip
    planned_s = sum(planned) * tick_s + (len(planned) - 1) * half_time_s
    return RecordedFeed(before, bytes(data), tuple(ends), planned_s, tuple(goals))


def _happened(facts: Mapping[str, Any], half: Mapping[str, Any], after: int, until: int) -> dict[str, Any]:
    """Return what happens in a half after a tick, up to another: parts of its lists."""

    def part(rows: Iterable[Any], tick: Callable[[Any], int]) -> list[Any]:
        return [row for row in rows if after < tick(row) <= until]

    events = (event for event in facts["events"] if event["half"] == half["half"])
    return {
        **{name: part(half[name], itemgetter(0)) for name in CHANGES},
        "jumps": {entity: some for entity, ticks in enumerate(half["jumps"]) if (some := part(ticks, int))},
        "faults": part(half["faults"], itemgetter("tick")),
        "events": part(events, itemgetter("tick")),
    }
