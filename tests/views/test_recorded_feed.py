"""A recorded match as a feed in steps of time: all of it, nothing before it has happened."""

import json
import struct
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

from rcj_challenges.core.timing import TICK_S
from rcj_challenges.tournament.site.public import ReplayData, read_replay
from rcj_challenges.views.live.recorded import STEP_S, RecordedFeed, recorded_feed
from rcj_challenges.views.replay import write_replay
from rcj_challenges.views.timeline import CHANGES
from tests.made_up_runs import write_made_up_run

BREAK_S = 3.2


@pytest.fixture(scope="module")
def replay(tmp_path_factory: pytest.TempPathFactory) -> ReplayData:
    folder = write_made_up_run(tmp_path_factory.mktemp("recorded") / "run")
    return read_replay(write_replay(folder).read_text("utf-8"))


@pytest.fixture(scope="module")
def feed(replay: ReplayData) -> RecordedFeed:
    return recorded_feed(replay.facts, replay.poses, BREAK_S)


def messages(data: bytes) -> Iterator[tuple[int, bytes]]:
    """Yield kind and content of whole messages."""
    at = 0
    while at < len(data):
        kind, length = struct.unpack_from("<BI", data, at)
        yield kind, data[at + 5 : at + 5 + length]
        at += 5 + length
    assert at == len(data)


def test_feed_has_all_poses_and_all_that_happened(replay: ReplayData, feed: RecordedFeed) -> None:
    shape = (-1, len(replay.facts["channels"]), len(replay.facts["entities"]))
    rows: dict[int, list[Any]] = {}
    said = []
    for kind, body in messages(feed.data):
        if kind == 1:
            said.append(json.loads(body))
            continue
        half, first = struct.unpack_from("<HI", body)
        assert first == sum(map(len, rows.get(half, [])))
        rows.setdefault(half, []).append(np.frombuffer(body, "<i2", offset=6).reshape(shape))
    for half in replay.facts["halves"]:
        assert sum(map(len, rows[half["half"]])) == half["ticks"] + 1
    assert [one["facts"]["half"] for one in said if one["say"] == "half"] == [
        half["half"] for half in replay.facts["halves"]
    ]
    events = [event for one in said if one["say"] == "news" for event in one.get("events", ())]
    assert sorted(events, key=json.dumps) == sorted(replay.facts["events"], key=json.dumps)
    assert events
    assert said[-1] == {
        "say": "over",
        "replay": False,
        **{key: replay.facts[key] for key in ("about", "places", "complete")},
    }


def test_no_step_has_anything_that_happens_after_it(replay: ReplayData, feed: RecordedFeed) -> None:
    begins, at_s = {}, 0.0
    for half in replay.facts["halves"]:
        begins[half["half"]] = at_s
        at_s += half["ticks"] * TICK_S + BREAK_S
    before = 0
    for step, end in enumerate(feed.ends, 1):
        for kind, body in messages(feed.data[before:end]):
            if kind == 1:
                said = json.loads(body)
                happened_s = at_s - BREAK_S if said["say"] == "over" else begins[(said.get("facts") or said)["half"]]
                news = said if said["say"] == "news" else {}
                rows = [row for name in CHANGES for row in news.get(name, ())]
                ticks = [row[0] for row in rows] + [tick for some in news.get("jumps", {}).values() for tick in some]
                ticks += [one["tick"] for name in ("faults", "events") for one in news.get(name, ())]
                happened_s += max(ticks, default=0) * TICK_S
            else:
                half, first = struct.unpack_from("<HI", body)
                ticks = (len(body) - 6) // (2 * len(replay.facts["channels"]) * len(replay.facts["entities"]))
                happened_s = begins[half] + (first + ticks - 1) * TICK_S
            assert happened_s <= step * STEP_S + 1e-9
            assert happened_s > (step - 1) * STEP_S - TICK_S - 1e-9
        before = end
    assert before == len(feed.data)


def test_facts_before_the_first_tick_tell_nothing_of_the_match(replay: ReplayData, feed: RecordedFeed) -> None:
    facts = feed.facts
    assert [facts[key] for key in ("halves", "events", "places", "complete")] == [[], [], [], False]
    assert facts["about"] == replay.facts["about"][:1]
    other = recorded_feed({**replay.facts, "halves": replay.facts["halves"][:1]}, replay.poses, BREAK_S)
    assert other.facts == facts
    assert (other.planned_s, len(other.ends) < len(feed.ends)) == (feed.planned_s, True)


def test_goals_have_their_moment(replay: ReplayData, feed: RecordedFeed) -> None:
    goals = [event for event in replay.facts["events"] if event["kind"] == "goal"]
    assert [(half, tick, team, score) for _, half, tick, team, score in feed.goals] == [
        (goal["half"], goal["tick"], goal["team"], goal["standing"]) for goal in goals
    ]
    assert goals
