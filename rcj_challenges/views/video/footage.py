"""A recorded run as far as it can be shown: poses at any moment, score, events, and what is missing."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
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
from rcj_challenges.records.refereelog import damaged_lines
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
"""What damaged lines of the referee's log raise in who tells the story."""


@dataclass(frozen=True)
class HalfFootage:
    """One half.

    Attributes:
        info: its facts.
        ticks: how many ticks of it were recorded.
        samples: ``[1 + 4 T, E, 3]``, x, y, yaw every 8 ms from tick 0 on.
        heights: ``[1 + T, E]``, z of the centres at each tick.
        jumps: by tick, the entities that were put elsewhere after it.
    """

    info: HalfInfo
    ticks: int
    samples: npt.NDArray[np.float32]
    heights: npt.NDArray[np.float32]
    jumps: Mapping[int, tuple[int, ...]]

    @classmethod
    def of(cls, track: HalfTrack) -> HalfFootage:
        """Return what of a half is needed here."""
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
        """How long it was recorded, in s of the match."""
        return s_from_ticks(self.ticks)

    def tick_at(self, t_s: float) -> int:
        """Return the last tick that is over at a time of the half."""
        return min(int(round(t_s / TICK_S, 6)), self.ticks)

    def poses(self, t_s: float) -> Poses:
        """Return where everything is at a time of the half.

        Between two samples of the trajectory (8 ms) poses are interpolated; what is put elsewhere jumps.
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

    def mean_place(self, entity: int, t_s: float, window_s: float) -> tuple[float, float]:
        """Return the mean place of an entity around a time, for a camera that follows it calmly; NaN if it is away."""
        first, last = ((t_s + way * window_s / 2) / SUBSTEP_S for way in (-1, 1))
        rows = np.clip(np.linspace(first, last, 15).round().astype(int), 0, len(self.samples) - 1)
        places = self.samples[rows, entity, :2].astype(np.float64)
        with np.errstate(invalid="ignore"):
            here = np.abs(places).max(axis=1) < PARKED_BEYOND_M
        if not here.any():
            return (np.nan, np.nan)
        x_m, y_m = places[here].mean(axis=0).tolist()
        return (x_m, y_m)

    def mean_yaw(self, entity: int, t_s: float, window_s: float) -> float:
        """Return the mean direction of an entity around a time in rad."""
        first, last = ((t_s + way * window_s / 2) / SUBSTEP_S for way in (-1, 1))
        rows = np.clip(np.linspace(first, last, 15).round().astype(int), 0, len(self.samples) - 1)
        yaws = np.nan_to_num(self.samples[rows, entity, 2].astype(np.float64), posinf=0.0, neginf=0.0)
        return float(np.arctan2(np.sin(yaws).mean(), np.cos(yaws).mean()))


@dataclass(frozen=True)
class Footage:
    """All of a run that can be shown.

    Attributes:
        scenario, roster: what was played.
        things: what of it can be seen, as the replay page has it.
        halves: those with at least one tick.
        story: events and score.
        titles: by team, what it is called.
        warnings: what is missing or damaged, a sentence each.
    """

    scenario: Scenario
    roster: Roster
    things: Mapping[str, Any]
    halves: tuple[HalfFootage, ...]
    story: Story
    titles: Mapping[str, str]
    warnings: tuple[str, ...] = ()
    _events: dict[int, list[dict[str, Any]]] = field(default_factory=dict)

    @classmethod
    def open(cls, folder: Path) -> Footage:
        """Read a run: finished, still going on, killed, or with damaged parts.

        Raises:
            RecordError: what is left is not enough for a picture: scenario or trajectory cannot be read.
        """
        warnings: list[str] = []
        result = _read_result(folder, warnings)
        scenario = read_scenario(folder)
        with refusing_changes(folder, scenario):
            return cls._of(folder, scenario, result, warnings)

    @classmethod
    def _of(cls, folder: Path, scenario: Scenario, result: RunResult | None, warnings: list[str]) -> Footage:
        tracks, problems = read_halves(folder, scenario, result, standing=False)
        warnings += problems
        story = _tell(folder, scenario, tracks, result, warnings)
        events: dict[int, list[dict[str, Any]]] = {}
        for event in story.events:
            events.setdefault(event["half"], []).append(event)
        return cls(
            scenario=scenario,
            roster=Roster.of(scenario),
            things=visible_things(scenario),
            halves=tuple(HalfFootage.of(track) for track in tracks),
            story=story,
            titles=_titles(scenario, result, tracks[0].info),
            warnings=tuple(warnings),
            _events=events,
        )

    def half(self, number: int) -> HalfFootage:
        """Return a half by its number (from 1)."""
        return next(half for half in self.halves if half.info.half == number)

    def scores(self, half: HalfFootage, t_s: float) -> dict[str, Score]:
        """Return the points by team at a time of a half."""
        info, tick = half.info, half.tick_at(t_s)
        standing = {info.teams[seat]: points for seat, points in info.scores.items()}
        for at, points in self.story.score_changes.get(info.half, ()):
            if at <= tick:
                standing = points
        return {team: standing.get(team, 0) for team in self.titles}

    @property
    def shows_score(self) -> bool:
        """Whether there are points to show."""
        return shows_score(self.scenario)

    def counted(self, half: HalfFootage, t_s: float) -> tuple[str, ...]:
        """Return what counts in the ranking beside the score at a time of a half, a line for each team."""
        tick, values = half.tick_at(t_s), {}
        for at, counted in self.story.counted.get(half.info.half, ()):
            if at <= tick:
                values = counted
        lines = {team: counted_line(self.scenario, own) for team, own in values.items()}
        if len(lines) == 1:
            return tuple(lines.values())
        return tuple(f"{self.titles[team]}: {line}" for team, line in lines.items() if team in self.titles)

    def events(self, half: int) -> list[dict[str, Any]]:
        """Return the events of a half in order, as the replay page tells them."""
        return self._events.get(half, [])

    def recent_events(self, half: HalfFootage, t_s: float, for_s: float, most: int) -> list[dict[str, Any]]:
        """Return the newest events that happened within ``for_s`` before a time of a half, the oldest first."""
        events, tick = self.events(half.info.half), half.tick_at(t_s)
        stop = bisect_right(events, tick, key=lambda event: event["tick"])
        recent = [event for event in events[max(0, stop - most) : stop] if t_s - event["tick"] * TICK_S < for_s]
        return recent[-most:]

    def colour_of(self, half: HalfFootage, team: str) -> str:
        """Return the CSS colour that a team plays in during a half."""
        return str(self._seat_of(half, team).get("colour", "grey"))

    def letter_of(self, half: HalfFootage, team: str) -> str:
        """Return what the labels of a team's robots begin with during a half; empty where that tells nothing."""
        return str(self._seat_of(half, team).get("letter", ""))

    def _seat_of(self, half: HalfFootage, team: str) -> dict[str, Any]:
        seat = next((seat for seat, playing in half.info.teams.items() if playing == team), None)
        return next((found for found in self.things["seats"] if found["name"] == seat), {})


def _start(track: HalfTrack) -> tuple[npt.NDArray[np.float32], npt.NDArray[np.float32]]:
    """Return poses and heights of tick 0, after what was placed at it."""
    if track.start is None:
        return track.substeps[0, 0].astype(np.float32), track.heights[0].astype(np.float32)
    poses = np.array(track.start.substeps[-1], np.float32)
    put_at_start(poses, track.placements.get(0, ()))
    poses[np.isinf(poses[:, 0])] = np.nan  # between it and a place on the field there is nothing
    return poses, np.array(track.start.heights, np.float32)


def _read_result(folder: Path, warnings: list[str]) -> RunResult | None:
    try:
        return read_result(folder)
    except RecordError as error:
        warnings.append(f"{error}; names are those that the trajectory knows")
        return None


def _tell(
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
