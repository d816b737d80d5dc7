"""A recorded run for pictures: poses at any time, score and events."""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt
from PIL import Image

from rcj_challenges.core.amounts import Score
from rcj_challenges.core.play import HalfInfo
from rcj_challenges.core.timing import TICK_S, s_from_ticks
from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.run_record import read_run
from rcj_challenges.records.sensors import SensorHalf, SensorTrack, read_sensors
from rcj_challenges.records.trajectory import HalfTrack
from rcj_challenges.scenario.halves import in_half
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.views.naming import titles
from rcj_challenges.views.replay.events import EventFacts
from rcj_challenges.views.replay.packing import frames_of, length_unit, units
from rcj_challenges.views.replay.things import bodies_in, visible_things
from rcj_challenges.views.standing import counted_line
from rcj_challenges.views.timeline import Timeline, timeline_of

Poses = npt.NDArray[np.float64]
"""``[entity] -> x, y, yaw, z``: metres and radians; NaN for what is not on the field."""


@dataclass(frozen=True)
class HalfFootage:
    """One half: poses, ``[1 + T, E, 4]``, x, y, yaw, z at each tick; and jumps, ``[T, E]``.

    An entity that was put elsewhere after a tick jumps, so that it does not glide there.
    """

    info: HalfInfo
    poses: npt.NDArray[np.float64]
    jumps: npt.NDArray[np.bool_]

    @classmethod
    def of(cls, track: HalfTrack) -> HalfFootage:
        """Convert a recorded half: it has the poses of the replay page."""
        unit_m = length_unit(track)
        frames, worth = frames_of(track, unit_m), units(unit_m)
        poses = np.stack([frames.columns[name] * worth[name] for name in ("x", "y", "yaw", "z")], axis=2)
        poses[frames.columns["x"] == np.iinfo(np.int16).max] = np.nan
        jumps = np.zeros(poses.shape[:2], np.bool_)
        for entity, ticks in enumerate(frames.jumps):
            jumps[list(ticks), entity] = True
        return cls(track.info, poses, jumps)

    @property
    def ticks(self) -> int:
        """The number of recorded ticks."""
        return len(self.poses) - 1

    @property
    def length_s(self) -> float:
        """Recorded length in s of the match."""
        return s_from_ticks(self.ticks)

    def tick_at(self, t_s: float) -> int:
        """Return the last tick that is over at a time of the half."""
        return min(int(round(t_s / TICK_S, 6)), self.ticks)

    def poses_at(self, t_s: float) -> Poses:
        """Return all poses at a time of the half, interpolated between ticks."""
        tick = self.tick_at(t_s)
        share = min(max(t_s / TICK_S - tick, 0.0), 1.0)
        if share < 1e-6 or tick == self.ticks:
            return np.array(self.poses[tick])
        change = self.poses[tick + 1] - self.poses[tick]
        change[:, 2] = np.remainder(change[:, 2] + np.pi, 2 * np.pi) - np.pi
        change[self.jumps[tick]] = 0.0
        shown: Poses = self.poses[tick] + share * np.where(np.isnan(change), 0.0, change)
        return shown

    def smoothed(self, entity: int, t_s: float, window_s: float) -> tuple[float, float, float]:
        """Return x, y, yaw of an entity, averaged around a time, for a calm camera; NaN while it is off the field."""
        first, last = (self.tick_at(max(t_s + way * window_s / 2, 0.0)) for way in (-1, 1))
        poses = self.poses[first : last + 1, entity]
        poses = poses[~np.isnan(poses[:, 0])]
        if not len(poses):
            return (math.nan, math.nan, math.nan)
        yaw_rad = math.atan2(np.sin(poses[:, 2]).mean(), np.cos(poses[:, 2]).mean())
        return (float(poses[:, 0].mean()), float(poses[:, 1].mean()), yaw_rad)


class Light(NamedTuple):
    """A light that is lit: index of its robot, its place among so many in a row, and its colour."""

    entity: int
    at: int
    of: int
    colour: str


@dataclass(frozen=True)
class Footage:
    """All of a run that can be shown; things and events are as on the replay page."""

    scenario: Scenario
    roster: Roster
    things: Mapping[str, Any]
    halves: tuple[HalfFootage, ...]
    timeline: Timeline
    events: list[dict[str, Any]]
    titles: Mapping[str, str]
    warnings: tuple[str, ...] = ()
    sensors: Mapping[int, SensorHalf] = field(default_factory=dict)

    @classmethod
    def open(cls, folder: Path) -> Footage:
        """Read a run: finished, still going on, killed, or with damaged parts.

        Raises:
            RecordError: there is nothing in the folder that could be shown.
        """
        run = read_run(folder)
        timeline = timeline_of(run.scenario, run.halves, run.shown_log)
        names = titles(run.scenario, run.result)
        try:
            sensors, warnings = read_sensors(folder), run.problems
        except RecordError as error:
            sensors, warnings = {}, (*run.problems, f"the sensor recording is damaged and not shown: {error}")
        return cls(
            scenario=run.scenario,
            roster=Roster.of(run.scenario),
            things=visible_things(run.scenario),
            halves=tuple(HalfFootage.of(track) for track in run.halves),
            timeline=timeline,
            events=EventFacts(run.scenario, names).of_timeline(timeline),
            titles=names,
            warnings=warnings,
            sensors=sensors,
        )

    def dressed(self, half: int) -> Footage:
        """Return it with the bodies that robots have in a half; the same if they have them in all."""
        bodies = bodies_in(self.scenario, half)
        if not bodies:
            return self
        entities = [facts | bodies.get(str(index), {}) for index, facts in enumerate(self.things["entities"])]
        return replace(self, scenario=in_half(self.scenario, half), things={**self.things, "entities": entities})

    def half(self, number: int) -> HalfFootage:
        """Return a half by its number (from 1)."""
        return next(half for half in self.halves if half.info.half == number)

    def scores(self, half: HalfFootage, t_s: float) -> dict[str, Score]:
        """Return the points by team at a time of a half."""
        info = half.info
        start = {info.teams[seat]: points for seat, points in info.scores.items()}
        points = _latest(self.timeline.halves[info.half].changes["score_changes"], half.tick_at(t_s), start)
        return {team: points.get(team, 0) for team in self.titles}

    def counted(self, half: HalfFootage, t_s: float) -> tuple[str, ...]:
        """Return the counters that the ranking compares at a time of a half, a line for each team."""
        values = _latest(self.timeline.halves[half.info.half].changes["counted"], half.tick_at(t_s), {})
        lines = {team: counted_line(self.scenario, own) for team, own in values.items()}
        if len(lines) == 1:
            return tuple(lines.values())
        return tuple(f"{self.titles[team]}: {line}" for team, line in lines.items() if team in self.titles)

    def lights(self, half: HalfFootage, t_s: float) -> list[Light]:
        """Return the lights of robots that are lit at a time of a half."""
        found = []
        for index, entity in enumerate(self.things["entities"]):
            if (seen := self._sensed(half, entity["name"], t_s)) is not None:
                track, row = seen
                lights = [(at, one) for at, one in enumerate(track.robot.motors) if one.kind == "led"]
                for place, (at, one) in enumerate(lights):
                    lit = np.nan_to_num(track.motors[row, at])
                    if 1 <= lit <= len(one.facts["colours"]):
                        found.append(Light(index, place, len(lights), one.facts["colours"][int(lit) - 1]))
        return found

    def pictures(self, half: HalfFootage, robot: str, t_s: float) -> list[Image.Image]:
        """Return what the cameras of a robot took last at a time of a half."""
        seen = self._sensed(half, robot, t_s)
        if seen is None:
            return []
        track, row = seen
        newest = {number: data for tick, number, data in track.pictures if tick <= track.ticks[row]}
        return [
            _picture(newest[camera.index], camera.facts["width"], camera.facts["height"])
            for camera in track.robot.cameras
            if camera.index in newest
        ]

    def _sensed(self, half: HalfFootage, robot: str, t_s: float) -> tuple[SensorTrack, int] | None:
        """Return what was recorded of a robot, and the row of its last observation at a time of a half."""
        recorded = self.sensors.get(half.info.half)
        track = recorded.robots.get(robot) if recorded else None
        row = -1 if track is None else int(np.searchsorted(track.ticks, half.tick_at(t_s), "right")) - 1
        return None if track is None or row < 0 else (track, row)

    def recent_event(self, half: HalfFootage, t_s: float, for_s: float) -> dict[str, Any] | None:
        """Return the newest event within ``for_s`` before a time of a half, one that scored before all others."""
        tick = half.tick_at(t_s)
        first, last = (
            bisect_right(self.events, (half.info.half, at), key=lambda event: (event["half"], event["tick"]))
            for at in (tick - for_s / TICK_S, tick)
        )
        recent = self.events[first:last]
        return next((event for event in reversed(recent) if event["scored"]), recent[-1] if recent else None)

    def seat_of(self, half: HalfFootage, team: str) -> dict[str, Any]:
        """Return colour and letter of the seat from which a team plays a half, as on the replay page."""
        seat = next((seat for seat, playing in half.info.teams.items() if playing == team), None)
        return next((one for one in self.things["seats"] if one["name"] == seat), {"colour": "grey", "letter": ""})


def _picture(data: bytes, width: int, height: int) -> Image.Image:
    """Return the picture in a camera's packet."""
    picture = Image.frombytes("P", (width, height), data[1 + 3 * data[0] :])
    picture.putpalette(data[1 : 1 + 3 * data[0]])
    return picture.convert("RGB")


def _latest(changes: Iterable[Sequence[Any]], tick: int, start: dict[str, Any]) -> dict[str, Any]:
    return next((values for at, values in reversed(list(changes)) if at <= tick), start)
