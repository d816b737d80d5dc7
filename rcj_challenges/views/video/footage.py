"""A recorded run: poses at any time, score, events, and what is missing."""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from rcj_challenges.facts.amounts import Score
from rcj_challenges.facts.play import HalfInfo
from rcj_challenges.facts.timing import SUBSTEP_S, SUBSTEPS_PER_TICK, TICK_S, s_from_ticks
from rcj_challenges.records.changed import refusing_changes
from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.recorded_scenario import read_scenario
from rcj_challenges.records.referee_log import damaged_lines
from rcj_challenges.records.result import RunResult, read_result
from rcj_challenges.records.salvage import read_halves
from rcj_challenges.records.trajectory import HalfTrack
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.views.naming import changes_sides, titles, told_apart
from rcj_challenges.views.replay.packing import PARKED_BEYOND_M, put_at_start
from rcj_challenges.views.replay.story import Story, tell
from rcj_challenges.views.replay.things import visible_things
from rcj_challenges.views.standing import counted_line, shows_score

Poses = npt.NDArray[np.float64]
"""``[entity] -> x, y, yaw, z``: metres and radians; NaN for what is not on the field."""

_DAMAGE = (KeyError, TypeError, ValueError, AttributeError)
"""What reading damaged lines of the referee's log raises."""


@dataclass(frozen=True)
class HalfFootage:
    """One half.

    Attributes:
        info: number, teams and scores at its start.
        ticks: how many were recorded.
        samples: ``[1 + 4 T, E, 3]``, x, y, yaw every 8 ms from tick 0 on.
        heights: ``[1 + T, E]``, z of the centres at each tick.
        jumps: by tick, the entities that the referee moved after it.
    """

    info: HalfInfo
    ticks: int
    samples: npt.NDArray[np.float32]
    heights: npt.NDArray[np.float32]
    jumps: Mapping[int, tuple[int, ...]]

    @classmethod
    def of(cls, track: HalfTrack) -> HalfFootage:
        """Convert a recorded half."""
        entities = track.substeps.shape[2]
        poses, heights = _start(track)
        return cls(
            info=track.info,
            ticks=track.ticks,
            samples=np.concatenate([poses[None], track.substeps.reshape(-1, entities, 3)]),
            heights=np.concatenate([heights[None], track.heights]),
            jumps={
                tick: tuple({placement.entity for placement in placements})
                for tick, placements in track.placements.items()
                if tick
            },
        )

    @property
    def length_s(self) -> float:
        """Recorded length in s of the match."""
        return s_from_ticks(self.ticks)

    def tick_at(self, t_s: float) -> int:
        """Return the last tick that is over at a time of the half."""
        return min(int(round(t_s / TICK_S, 6)), self.ticks)

    def poses(self, t_s: float) -> Poses:
        """Return all poses at a time of the half.

        Between two samples of the trajectory (8 ms) poses are interpolated; what the referee moves jumps.
        """
        last = len(self.samples) - 1
        exact = min(max(round(t_s / SUBSTEP_S, 6), 0.0), float(last))
        sample = int(exact)
        share = exact - sample
        found = np.empty((self.samples.shape[1], 4))
        found[:, :3] = self.samples[sample]
        tick = sample // SUBSTEPS_PER_TICK
        found[:, 3] = self.heights[tick]
        if share:
            change = self.samples[sample + 1].astype(np.float64) - found[:, :3]
            change[:, 2] = np.remainder(change[:, 2] + np.pi, 2 * np.pi) - np.pi
            if sample % SUBSTEPS_PER_TICK == 0:
                change[list(self.jumps.get(tick, ()))] = 0.0
            found[:, :3] += share * change
        with np.errstate(invalid="ignore"):  # a damaged file may hold infinities
            away = ~(np.abs(found).max(axis=1) < PARKED_BEYOND_M)
        found[away] = np.nan
        return found

    def smoothed(self, entity: int, t_s: float, window_s: float) -> tuple[float, float, float]:
        """Return x, y, yaw of an entity, averaged around a time, for a calm camera; NaN while it is off the field."""
        first, last = ((t_s + way * window_s / 2) / SUBSTEP_S for way in (-1, 1))
        rows = np.clip(np.linspace(first, last, 15).round().astype(int), 0, len(self.samples) - 1)
        poses = self.samples[rows, entity].astype(np.float64)
        with np.errstate(invalid="ignore"):
            poses = poses[np.abs(poses).max(axis=1) < PARKED_BEYOND_M]
        if not len(poses):
            return (math.nan, math.nan, math.nan)
        yaw_rad = math.atan2(np.sin(poses[:, 2]).mean(), np.cos(poses[:, 2]).mean())
        return (float(poses[:, 0].mean()), float(poses[:, 1].mean()), yaw_rad)


@dataclass(frozen=True)
class Footage:
    """All of a run that can be shown.

    Attributes:
        scenario, roster: what was played.
        things: what of it is visible, as on the replay page.
        halves: those with at least one tick.
        story: events and score.
        titles: display name of each team.
        warnings: what is missing or damaged, a sentence each.
    """

    scenario: Scenario
    roster: Roster
    things: Mapping[str, Any]
    halves: tuple[HalfFootage, ...]
    story: Story
    titles: Mapping[str, str]
    warnings: tuple[str, ...] = ()

    @classmethod
    def open(cls, folder: Path) -> Footage:
        """Read a run: finished, still going on, killed, or with damaged parts.

        Raises:
            RecordError: scenario or trajectory cannot be read, so that there is nothing to show.
        """
        warnings: list[str] = []
        result = None
        try:
            result = read_result(folder)
        except RecordError as error:
            warnings.append(f"{error}; names are taken from the trajectory")
        scenario = read_scenario(folder)
        with refusing_changes(folder, scenario):
            tracks, problems = read_halves(folder, scenario, result, standing=False)
            warnings += problems
            return cls(
                scenario=scenario,
                roster=Roster.of(scenario),
                things=visible_things(scenario),
                halves=tuple(HalfFootage.of(track) for track in tracks),
                story=_story(folder, scenario, tracks, result, warnings),
                titles=_titles(scenario, result, tracks[0].info),
                warnings=tuple(warnings),
            )

    def half(self, number: int) -> HalfFootage:
        """Return a half by its number (from 1)."""
        return next(half for half in self.halves if half.info.half == number)

    def scores(self, half: HalfFootage, t_s: float) -> dict[str, Score]:
        """Return the points by team at a time of a half."""
        info = half.info
        start = {info.teams[seat]: points for seat, points in info.scores.items()}
        points = _latest(self.story.score_changes.get(info.half, ()), half.tick_at(t_s), start)
        return {team: points.get(team, 0) for team in self.titles}

    @property
    def shows_score(self) -> bool:
        """Whether there are points to show."""
        return shows_score(self.scenario)

    def counted(self, half: HalfFootage, t_s: float) -> tuple[str, ...]:
        """Return the counters that the ranking compares at a time of a half, a line for each team."""
        values = _latest(self.story.counted.get(half.info.half, ()), half.tick_at(t_s), {})
        lines = {team: counted_line(self.scenario, own) for team, own in values.items()}
        if len(lines) == 1:
            return tuple(lines.values())
        return tuple(f"{self.titles[team]}: {line}" for team, line in lines.items() if team in self.titles)

    def recent_events(self, half: HalfFootage, t_s: float, for_s: float, limit: int) -> list[dict[str, Any]]:
        """Return the newest events within ``for_s`` before a time of a half, the oldest first."""
        events = [event for event in self.story.events if event["half"] == half.info.half]
        stop = bisect_right(events, half.tick_at(t_s), key=lambda event: event["tick"])
        return [event for event in events[max(0, stop - limit) : stop] if t_s - event["tick"] * TICK_S < for_s]

    def scoring_event(self, half: int, tick: int) -> str:
        """Return the name of the event that changed the score at a tick, such as ``Goal``."""
        events = (event for event in self.story.events if (event["half"], event["tick"]) == (half, tick))
        return next((str(event["name"]).replace("_", " ").capitalize() for event in events if event["scored"]), "Score")

    def seat_of(self, half: HalfFootage, team: str) -> dict[str, Any]:
        """Return colour and letter of the seat from which a team plays a half, as on the replay page."""
        seat = next((seat for seat, playing in half.info.teams.items() if playing == team), None)
        return next((one for one in self.things["seats"] if one["name"] == seat), {"colour": "grey", "letter": ""})


def _latest(changes: Iterable[Sequence[Any]], tick: int, start: dict[str, Any]) -> dict[str, Any]:
    """Return the last of ``[tick, values]`` that is not after a tick."""
    return next((values for at, values in reversed(list(changes)) if at <= tick), start)


def _start(track: HalfTrack) -> tuple[npt.NDArray[np.float32], npt.NDArray[np.float32]]:
    """Return poses and heights of tick 0, after what was placed at it."""
    if track.start is None:
        return track.substeps[0, 0].astype(np.float32), track.heights[0].astype(np.float32)
    poses = np.array(track.start.substeps[-1], np.float32)
    put_at_start(poses, track.placements.get(0, ()))
    poses[np.isinf(poses[:, 0])] = np.nan  # between it and a place on the field there is nothing
    return poses, np.array(track.start.heights, np.float32)


def _story(
    folder: Path, scenario: Scenario, tracks: Sequence[HalfTrack], result: RunResult | None, warnings: list[str]
) -> Story:
    try:
        story = tell(folder, scenario, tracks, result)
        story.events = sorted(story.events, key=lambda event: (event["half"], event["tick"]))
    except (*_DAMAGE, OSError):
        warnings.append(f"{folder.name}: the referee's log is damaged: no captions, and the score does not change")
        return Story()
    if story.unreadable:
        warnings.append(f"{folder.name}: {damaged_lines(story.unreadable)} and left out")
    return story


def _titles(scenario: Scenario, result: RunResult | None, first: HalfInfo) -> dict[str, str]:
    if result is not None:
        return titles(scenario, result)
    names = {first.teams[seat]: name or seat for seat, name in first.team_names.items()}
    return told_apart(names, sides_change=changes_sides(scenario))
