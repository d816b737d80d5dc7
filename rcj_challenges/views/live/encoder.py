"""Encodes a match as messages of the feed, with the data of the replay page."""

from __future__ import annotations

import struct
import threading
from collections import deque
from collections.abc import Sequence
from itertools import chain
from typing import Any

import numpy as np

from rcj_challenges.core.play import HalfInfo, RefereeOutput, Snapshot
from rcj_challenges.core.timing import ticks_from_s
from rcj_challenges.match.observers import Observer
from rcj_challenges.records.reflog import events_of
from rcj_challenges.records.sensors import SensedRobot, SensorListener
from rcj_challenges.scenario.halves import half_lengths_s
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.views.live.feed import Feed, json_message, news_message, pose_message
from rcj_challenges.views.live.pace import Pace
from rcj_challenges.views.live.sensor_feed import HalfSensorFeed
from rcj_challenges.views.naming import changes_sides, distinct_names
from rcj_challenges.views.replay.events import EventFacts, fault_facts, half_facts
from rcj_challenges.views.replay.packing import FINEST_M, place_at_start, rounded_poses
from rcj_challenges.views.replay.page import page_facts
from rcj_challenges.views.timeline import TimelineBuilder

_NUMBERS_PER_ENTITY = 5  # x, y, yaw; height; upright
_Kept = tuple[int, bytes, tuple[Snapshot, RefereeOutput] | None]  # tick, poses, and all of it if something happened
_SEEN_BEYOND_M = 3.0
"""How far outside of the field poses are distinguished; what is further (parked robots) is shown at the edge."""


def live_facts(scenario: Scenario, titles: dict[str, str], seed: int) -> dict[str, Any]:
    """Return the facts of the page before the first half; titles are by the seats of the first half."""
    names = {team: titles.get(team) or team for team in scenario.entrants}
    return page_facts(
        scenario,
        distinct_names(names, sides_change=changes_sides(scenario)),
        _unit_m(scenario),
        halves_planned=scenario.match.halves,
        half_ticks_planned=[ticks_from_s(half_s) for half_s in half_lengths_s(scenario.match)],
        about=[("scenario", f"{scenario.title} ({scenario.id})"), ("seed", str(seed))],
        live=True,
    )


def _unit_m(scenario: Scenario) -> float:
    half_m = max(scenario.field.bounds.width_m, scenario.field.bounds.length_m) / 2
    return max(FINEST_M, (half_m + _SEEN_BEYOND_M) / 32_767)


class LiveObserver(Observer):
    """Fills the feed while a match is played.

    A tick only stores its poses; `flush`, called from another thread several times a second, makes messages of them.
    Snapshots are kept only of ticks in which something happened: keeping all of them would cost the match its caches.
    """

    def __init__(self, scenario: Scenario, feed: Feed, pace: Pace) -> None:
        self._scenario = scenario
        self._feed = feed
        self._unit_m = _unit_m(scenario)
        self._half: HalfInfo
        self._sensor_feed: HalfSensorFeed | None = None
        self._builder = TimelineBuilder(scenario)
        self._event_facts = EventFacts(scenario, {})
        self._entities = len(Roster.of(scenario).entities)
        self._row = struct.Struct(f"<{_NUMBERS_PER_ENTITY * self._entities}f")
        self._waiting: deque[_Kept] = deque()
        self._flushing = threading.Lock()
        self.before_tick = pace.before_tick  # type: ignore[method-assign]

    def after_tick(self, snapshot: Snapshot, output: RefereeOutput) -> None:
        """Store what the next `flush` sends."""
        row = self._row.pack(*chain.from_iterable(snapshot.substeps[-1]), *snapshot.heights, *snapshot.uprights)
        is_news = output.changes or output.events or output.firings or output.placements or snapshot.faults
        self._waiting.append((snapshot.tick, row, (snapshot, output) if is_news else None))

    def half_started(self, half: HalfInfo) -> None:
        """Send the facts of the half, after the rest of the one before."""
        self.flush()
        with self._flushing:
            self._half = half
            self._sensor_feed = None
            self._builder.begin_half(half)
            named = {half.teams[seat]: name for seat, name in half.team_names.items() if name}
            self._event_facts = EventFacts(
                self._scenario, distinct_names(named, sides_change=changes_sides(self._scenario))
            )
            facts = half_facts(self._scenario, self._builder.timeline.halves[half.half])
            self._feed.append(json_message({"say": "half", "facts": facts}))

    def sensing(self, half: HalfInfo, robots: Sequence[SensedRobot]) -> Sequence[SensorListener]:
        """Send the facts of the sensor recording; from now on its rows follow."""
        with self._flushing:
            self._sensor_feed = HalfSensorFeed(half, robots)
            self._feed.append(self._sensor_feed.announcement)
        return (self._sensor_feed,)

    def after_last_tick(self, output: RefereeOutput, half: HalfInfo) -> None:
        """Send the output of the rules after the last tick."""
        self.flush()
        with self._flushing:
            self._feed.append(self._tick_message(Snapshot(0, [], [], [], ()), output))

    def flush(self) -> None:
        """Send all that waits, poses first: a reading never comes before the poses of its tick."""
        with self._flushing:
            if batch := [self._waiting.popleft() for _ in range(len(self._waiting))]:
                self._send(batch)
            if self._sensor_feed is not None:
                self._feed.append(self._sensor_feed.messages())

    # --- messages ---------------------------------------------------------------------------------------------------

    def _send(self, batch: list[_Kept]) -> None:
        entities = self._entities
        first, _, start = batch[0]
        numbers = np.frombuffer(b"".join([row for _, row, _ in batch]), "<f4").reshape(len(batch), -1)
        judged = numbers[:, : 3 * entities].reshape(-1, entities, 3).copy()
        if first == 0 and start is not None:
            place_at_start(judged[0], start[1].placements)  # the start is shown as the first tick finds it
        heights, uprights = numbers[:, 3 * entities : 4 * entities], numbers[:, 4 * entities :]
        channels = rounded_poses(judged, heights, uprights, self._unit_m)
        rows = np.stack(list(channels.values()), axis=1).astype("<i2").tobytes()
        news = [self._tick_message(*happened) for _, _, happened in batch if happened is not None]
        self._feed.append(pose_message(self._half.half, first, rows) + b"".join(news))

    def _tick_message(self, snapshot: Snapshot, output: RefereeOutput) -> bytes:
        events, changes = self._builder.add(
            events_of(snapshot, output), output.firings, output.changes, snapshot.faults
        )
        news = {
            **changes,
            "jumps": {placement.entity: [snapshot.tick] for placement in output.placements if snapshot.tick},
            "faults": fault_facts(snapshot.faults),
            "events": [self._event_facts.event(event, self._half.teams) for event in events],
        }
        return news_message(self._half.half, news)
