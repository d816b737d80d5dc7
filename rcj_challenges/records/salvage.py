"""What can still be shown of a run whose trajectory is cut off or damaged.

`Trajectory.open` refuses such a file: whoever judges a match again must have all of it. Those who only look are served
with what is there: the ticks up to the damage, and where no pose is left, everything at its start and the events.
"""

from __future__ import annotations

import ast
import contextlib
import math
import struct
import zipfile
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from rcj_challenges.facts.errors import format_error
from rcj_challenges.facts.play import HalfInfo
from rcj_challenges.facts.timing import SUBSTEPS_PER_TICK, s_from_ticks, ticks_from_s
from rcj_challenges.records.changed import refusing_changes
from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.folder import SCENARIO, TRAJECTORY, TRAJECTORY_PARTS, read_file
from rcj_challenges.records.recorded_scenario import read_scenario
from rcj_challenges.records.result import RunResult, read_result
from rcj_challenges.records.track import row_dtype
from rcj_challenges.records.trajectory import DAMAGE, HalfTrack, Notes, Trajectory, read_notes, read_parts
from rcj_challenges.scenario.halves import half_length_s
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.scenario.seats import teams_by_seat
from rcj_challenges.scenario.starting import start_pose

_LOCAL = struct.Struct("<4s5H3I2H")
_LOCAL_MAGIC = b"PK\x03\x04"
_ZIP64 = 0xFFFFFFFF
_NPY = struct.Struct("<8sH")
_NPY_MAGIC = b"\x93NUMPY\x01\x00"
_MOST_TICKS = 1_000_000

Array = npt.NDArray[Any]


@dataclass(frozen=True)
class RunRecord:
    """A run, as far as it can be read.

    Attributes:
        result: ``result.json``.
        scenario: as it was played.
        halves: those with at least one tick.
        problems: sentences about what is missing or damaged; empty if all is well.
    """

    result: RunResult
    scenario: Scenario
    halves: tuple[HalfTrack, ...]
    problems: tuple[str, ...]


def read_run(folder: Path) -> RunRecord:
    """Read a run that is finished, still going on, was killed, or is damaged.

    Raises:
        RecordError: there is nothing in the folder that could be shown.
    """
    result = read_result(folder)
    scenario = read_scenario(folder)
    with refusing_changes(folder, scenario):
        halves, problems = read_halves(folder, scenario, result)
    return RunRecord(result, scenario, halves, problems)


def read_halves(
    folder: Path, scenario: Scenario, result: RunResult | None, *, standing: bool = True
) -> tuple[tuple[HalfTrack, ...], tuple[str, ...]]:
    """Return the halves with at least one tick, as far as they go, and sentences about what is missing or damaged.

    Args:
        folder: of the run.
        scenario: as it was played.
        result: of the run; None if that cannot be read.
        standing: whether halves of which no pose is left are returned with everything at its start: for who shows
            their events.

    Raises:
        RecordError: there is nothing in the folder that could be shown.
    """
    damage = ""
    try:
        trajectory = Trajectory.open(folder)
        _must_belong(trajectory, scenario, folder)
        halves = trajectory.halves
    except RecordError as error:
        if not _can_be_salvaged(folder):
            raise
        halves, damage = _salvaged(folder, scenario, result, standing=standing)
        if not halves:
            raise
        damage += f" ({error})"
    halves = tuple(_fitting(half, scenario) for half in halves if half.ticks)
    if not halves:
        how = "match was over" if result is not None and result.complete else "run was stopped"
        raise RecordError(f"{folder.name}: the {how} before its first tick: there is nothing to show")
    problems = [damage] if damage else []
    if result is not None and not result.complete:
        stopped = "it was interrupted" if result.stopped == KeyboardInterrupt.__name__ else result.stopped
        why = f" ({stopped})" if stopped else ""
        problems.insert(0, f"This run was not played to its end{why}: what was recorded is shown, {_so_far(halves)}.")
    return halves, tuple(problems)


def _so_far(halves: Iterable[HalfTrack]) -> str:
    """Return how far a record goes, in words."""
    return ", ".join(f"{s_from_ticks(half.ticks):.1f} s of half {half.info.half}" for half in halves)


def _must_belong(trajectory: Trajectory, scenario: Scenario, folder: Path) -> None:
    roster = Roster.of(scenario)
    if trajectory.entities != roster.entities:
        raise RecordError(f"{folder.name}: {TRAJECTORY} belongs to another scenario than {SCENARIO}")


def _fitting(half: HalfTrack, scenario: Scenario) -> HalfTrack:
    """Return a half without notes of things or seats that the scenario does not have."""
    entities, seats = half.substeps.shape[2], set(scenario.entrants)
    placements = {
        tick: tuple(placement for placement in placed if 0 <= placement.entity < entities)
        for tick, placed in half.placements.items()
        if tick >= 0
    }
    info = half.info
    start = half.start
    if start is not None and not (
        start.substeps
        and len(start.heights) == len(start.uprights) == len(start.substeps[-1]) == entities
        and all(len(pose) == 3 for pose in start.substeps[-1])
    ):
        start = None
    if not set(info.teams) | set(info.scores) <= seats or not set(info.scores) <= set(info.teams):
        raise RecordError(f"half {info.half} was played by other seats than the scenario has")
    return replace(half, placements=placements, start=start)


def _can_be_salvaged(folder: Path) -> bool:
    return (folder / SCENARIO).exists() and ((folder / TRAJECTORY).exists() or (folder / TRAJECTORY_PARTS).exists())


def _salvaged(
    folder: Path, scenario: Scenario, result: RunResult | None, *, standing: bool
) -> tuple[tuple[HalfTrack, ...], str]:
    """Return the halves that can be shown, and the sentence that says what is wrong."""
    roster = Roster.of(scenario)
    numbers = range(1, scenario.match.halves + 1)
    path = folder / TRAJECTORY
    try:
        arrays = _arrays(read_file(path)) if path.exists() else _loose(folder, numbers, len(roster.entities))
    except OSError as error:
        raise RecordError(f"{folder.name}: {TRAJECTORY} cannot be read: {format_error(error)}") from error
    tracks = [_track(arrays, half, scenario, result, len(roster.entities)) for half in numbers]
    found = tuple(track for track in tracks if track is not None)
    if found:
        ticks = sum(track.ticks for track in found)
        return found, f"The recorded poses are damaged: {ticks} ticks of them could be read, {_so_far(found)}."
    still = tuple(
        _standing(_info(scenario, result, half.half), min(half.ticks, _MOST_TICKS), scenario, roster)
        for half in (result.halves if result is not None and standing else ())
    )
    return still, "The recorded poses are damaged: events and scores are shown, everything stands at its start."


def _loose(folder: Path, halves: Iterable[int], entities: int) -> dict[str, Array]:
    """Return the arrays of halves that were not packed yet, without those that cannot be read at all."""
    found: dict[str, Array] = {}
    for half in halves:
        with contextlib.suppress(*DAMAGE):
            fields = read_parts(folder / TRAJECTORY_PARTS, half, entities)
            found |= {f"half{half}_{name}": array for name, array in fields.items()}
    return found


def _arrays(data: bytes) -> dict[str, Array]:
    """Return the arrays of an ``.npz`` by its local headers, each as far as it goes: the directory may be cut off."""
    found = {}
    at = data.find(_LOCAL_MAGIC)
    while 0 <= at <= len(data) - _LOCAL.size:
        _, _, _, method, _, _, _, packed, _, name_size, extra_size = _LOCAL.unpack_from(data, at)
        begin = at + _LOCAL.size
        name = data[begin : begin + name_size].decode("ascii", "replace")
        extra = data[begin + name_size : begin + name_size + extra_size]
        if packed == _ZIP64 and len(extra) >= 20:
            packed = struct.unpack_from("<Q", extra, 12)[0]
        begin += name_size + extra_size
        if method == zipfile.ZIP_STORED and name.endswith(".npy"):
            array = _rows(data[begin : begin + packed])
            if array is not None:
                found[name.removesuffix(".npy")] = array
        at = data.find(_LOCAL_MAGIC, begin)
    return found


def _rows(data: bytes) -> Array | None:
    """Return the whole rows of an array that may be cut off."""
    if len(data) < _NPY.size:
        return None
    magic, size = _NPY.unpack_from(data)
    begin = _NPY.size + size
    try:
        head = ast.literal_eval(data[_NPY.size : begin].decode("latin-1"))
        dtype, shape = np.dtype(head["descr"]), head["shape"]
        if magic != _NPY_MAGIC or dtype.hasobject or not shape:
            return None
        row = math.prod(shape[1:])
        rows = min(shape[0], (len(data) - begin) // max(1, row * dtype.itemsize))
        return np.frombuffer(data, dtype, rows * row, begin).reshape(rows, *shape[1:])
    except (*DAMAGE, RecursionError):
        return None


def _track(
    arrays: Mapping[str, Array], half: int, scenario: Scenario, result: RunResult | None, entities: int
) -> HalfTrack | None:
    """Return one half up to the damage: what is not poses may be lost without the poses being so."""
    dtype = row_dtype(entities)
    substeps = arrays.get(f"half{half}_substeps")
    if substeps is None or not len(substeps) or substeps.shape[1:] != dtype["substeps"].shape:
        return None
    ticks = len(substeps)
    resting = _resting_heights(scenario)
    heights = _filled(arrays.get(f"half{half}_heights"), np.tile(np.array(resting, "<f4"), (ticks, 1)))
    uprights = _filled(arrays.get(f"half{half}_uprights"), np.ones((ticks, entities), "<f4"))
    counts = _filled(arrays.get(f"half{half}_touch_counts"), np.zeros((ticks, SUBSTEPS_PER_TICK), "<u2"))
    pairs = arrays.get(f"half{half}_touch_pairs", np.zeros((0, 2), "<u2"))
    wanted = int(counts.sum(dtype=np.int64))
    if pairs.shape[1:] != (2,) or len(pairs) < wanted:
        counts, pairs, wanted = np.zeros_like(counts), np.zeros((0, 2), "<u2"), 0
    try:
        text = arrays[f"half{half}_notes"].tobytes()
        notes = read_notes(text.rpartition(b"\n")[0], ticks)
    except DAMAGE:  # the half's facts are known from the result as well
        notes = Notes(_info(scenario, result, half), None, {}, {}, {})
    return HalfTrack(
        notes.info, notes.start, substeps, heights, uprights, counts, pairs[:wanted], notes.placements, notes.faults,
        notes.heard,
    )  # fmt: skip


def _filled(found: Array | None, resting: Array) -> Array:
    """Return an array of the shape of ``resting`` that begins with what was found."""
    if found is not None and found.shape[1:] == resting.shape[1:] and found.dtype == resting.dtype:
        rows = min(len(found), len(resting))
        resting[:rows] = found[:rows]
    return resting


def _info(scenario: Scenario, result: RunResult | None, half: int) -> HalfInfo:
    """Return a half's facts from the result, where its own notes are lost; from the scenario alone without one."""
    played = {one.half: one for one in result.halves} if result is not None else {}
    entrants = result.entrants if result is not None else {}
    teams = played[half].sides if half in played else teams_by_seat(scenario, half)
    before = played[half - 1].score if half - 1 in played else {}
    return HalfInfo(
        half=half,
        halves=scenario.match.halves,
        ticks=ticks_from_s(half_length_s(scenario.match, half)),
        match_seed=result.seed if result is not None else 0,
        match_id=result.match_id if result is not None else 1,
        team_names={seat: entrants[team].name if team in entrants else team for seat, team in teams.items()},
        teams=dict(teams),
        scores={seat: before.get(team, 0) for seat, team in teams.items()},
    )


def _standing(info: HalfInfo, ticks: int, scenario: Scenario, roster: Roster) -> HalfTrack:
    """Return a half in which everything stands where it starts."""
    poses = np.array([start_pose(scenario, name) for name in roster.entities], "<f4")
    entities = len(poses)
    return HalfTrack(
        info,
        None,
        np.broadcast_to(poses, (ticks, SUBSTEPS_PER_TICK, entities, 3)),
        np.broadcast_to(np.array(_resting_heights(scenario), "<f4"), (ticks, entities)),
        np.broadcast_to(np.ones(entities, "<f4"), (ticks, entities)),
        np.zeros((ticks, SUBSTEPS_PER_TICK), "<u2"),
        np.zeros((0, 2), "<u2"),
        {},
        {},
        poses_are_lost=True,
    )


def _resting_heights(scenario: Scenario) -> list[float]:
    """Return the height of each entity's centre when it stands on the floor."""
    heights = []
    for name in Roster.of(scenario).entities:
        if name in scenario.robots:
            heights.append(scenario.kits[scenario.robots[name].kit].chassis.size_m / 2)
        elif name in scenario.balls:
            heights.append(scenario.balls[name].radius_m)
        else:
            heights.append(scenario.obstacles[name].height_m / 2)
    return heights
