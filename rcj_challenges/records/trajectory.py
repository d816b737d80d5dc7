"""Reading a trajectory: of a run that is finished, still going on, or was killed.

The referee can be run on what `HalfTrack.snapshots` yields: it gives back the very snapshots of the match.
"""

from __future__ import annotations

import os
import tokenize
import warnings
import zipfile
import zlib
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NamedTuple, Self

import numpy as np
import numpy.typing as npt

from rcj_challenges.facts.play import Fault, HalfInfo, Placement, Snapshot
from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.folder import TRAJECTORY, TRAJECTORY_PARTS, check_version, open_file, read_file
from rcj_challenges.records.lines import parsed
from rcj_challenges.records.recorded_scenario import read_scenario
from rcj_challenges.records.result import read_result
from rcj_challenges.records.track import part_paths, row_dtype
from rcj_challenges.scenario.roster import Roster

Array = npt.NDArray[Any]
_ROWS_AT_ONCE = 512
DAMAGE = (
    OSError, EOFError, ValueError, KeyError, TypeError, IndexError, zipfile.BadZipFile, zlib.error,
    NotImplementedError, AttributeError, OverflowError, MemoryError, SyntaxError, tokenize.TokenError,
)  # fmt: skip
"""What numpy, zipfile and json raise on bytes that are not what they should be."""


class _MisfitError(ValueError):
    """Arrays that are read, and are not those of a trajectory."""


def _why(error: Exception) -> str:
    """Return why a trajectory cannot be read, where we or the system say it: what numpy says is for who calls it."""
    why = str(error) if isinstance(error, _MisfitError) else error.strerror if isinstance(error, OSError) else None
    return f": {why}" if why else ""


@dataclass(frozen=True)
class HalfTrack:
    """One half. ``T`` ticks (row ``i`` is tick ``i + 1``), ``E`` entities; metres and radians, float32.

    Attributes:
        info: the half's facts, as the referee got them.
        start: the snapshot of tick 0, None if the run was killed before it was written.
        substeps: ``[T, 4, E, 3]``, x, y, yaw.
        heights: ``[T, E]``, z of the centre.
        uprights: ``[T, E]``, cosine of the tilt.
        touch_counts: ``[T, 4]``, how many pairs touched in each sub-step.
        touch_pairs: ``[N, 2]``, pairs of thing indices, one after the other.
        placements: what was put elsewhere after a tick, by tick.
        faults: programs that failed, by the tick at which the referee heard of it.
        heard: what robots told the referee by radio, by the tick at which it heard it: (entity, text).
        poses_are_lost: whether none of its poses is left, and everything stands at its start instead.
    """

    info: HalfInfo
    start: Snapshot | None
    substeps: Array
    heights: Array
    uprights: Array
    touch_counts: Array
    touch_pairs: Array
    placements: Mapping[int, tuple[Placement, ...]]
    faults: Mapping[int, tuple[Fault, ...]]
    heard: Mapping[int, tuple[tuple[int, str], ...]] = field(default_factory=dict)
    poses_are_lost: bool = False

    @property
    def ticks(self) -> int:
        """How many ticks there are."""
        return len(self.substeps)

    def snapshots(self) -> Iterator[Snapshot]:
        """Yield the snapshots of tick 1 and on, equal to those that were recorded."""
        ends = np.cumsum(self.touch_counts.sum(axis=1, dtype=np.int64))
        for first in range(0, self.ticks, _ROWS_AT_ONCE):
            rows = slice(first, first + _ROWS_AT_ONCE)
            substeps = self.substeps[rows].tolist()
            heights, uprights = self.heights[rows].tolist(), self.uprights[rows].tolist()
            counts, stops = self.touch_counts[rows].tolist(), ends[rows].tolist()
            for offset, stop in enumerate(stops):
                tick = first + offset + 1
                yield Snapshot(
                    tick=tick,
                    substeps=[[tuple(pose) for pose in substep] for substep in substeps[offset]],
                    heights=heights[offset],
                    uprights=uprights[offset],
                    touches=self._touches(counts[offset], stop),
                    faults=self.faults.get(tick, ()),
                    heard=self.heard.get(tick, ()),
                )

    def _touches(self, counts: list[int], stop: int) -> tuple[tuple[tuple[int, int], ...], ...]:
        total = sum(counts)
        if not total:
            return ((),) * len(counts)
        pairs = [tuple(pair) for pair in self.touch_pairs[stop - total : stop].tolist()]
        ends = np.cumsum(counts).tolist()
        return tuple(tuple(pairs[end - count : end]) for end, count in zip(ends, counts, strict=True))


@dataclass(frozen=True)
class Trajectory:
    """All halves of a run.

    Attributes:
        entities: robots, balls, movable obstacles, in this order.
        robots, balls: how many of the entities are robots; how many are balls.
        things: the entities, then fixed obstacles, then ``walls``: what touches are pairs of.
        finished: False if the run was killed or still goes on.
        halves: those that were begun.
    """

    entities: tuple[str, ...]
    robots: int
    balls: int
    things: tuple[str, ...]
    finished: bool
    halves: tuple[HalfTrack, ...]

    def snapshots(self, half: int) -> Iterator[Snapshot]:
        """Yield the snapshots of a half (1-based) from tick 1 on; its tick 0 is the half's ``start``.

        Raises:
            RecordError: that half was never begun.
        """
        track = next((track for track in self.halves if track.info.half == half), None)
        if track is None:
            raise RecordError(f"the record has no half {half}")
        return track.snapshots()

    @classmethod
    def open(cls, folder: Path) -> Self:
        """Read the trajectory of a run.

        Raises:
            RecordError: there is none, it is damaged, foreign, or written by a newer version.
        """
        packed = folder / TRAJECTORY
        try:
            return cls._packed(packed) if packed.exists() else cls._parts(folder)
        except DAMAGE as error:
            raise RecordError(f"{folder.name}: the trajectory is damaged or none of ours{_why(error)}") from error

    @classmethod
    def _packed(cls, path: Path) -> Self:
        # Opened here, because numpy leaves a file open that it refuses. It takes a damaged header for an old one.
        with warnings.catch_warnings(), open_file(path) as file, np.load(file, allow_pickle=False) as arrays:
            warnings.simplefilter("ignore", UserWarning)
            if "header" not in arrays:
                raise _MisfitError(f"{path.name} has no header")
            header = parsed(arrays["header"].tobytes())
            check_version(header["record"], path.parent)
            entities = len(header["entities"])
            halves = tuple(
                _half(lambda field, half=half: arrays[f"half{half}_{field}"], entities, half)  # type: ignore[misc]
                for half in header["halves"]
            )
        return cls._made(header, halves, finished=True)

    @classmethod
    def _parts(cls, folder: Path) -> Self:
        read_result(folder)  # refuses what is no record
        parts = folder / TRAJECTORY_PARTS
        if not parts.is_dir():
            raise RecordError(f"{folder.name}: the trajectory is missing")
        roster = Roster.of(read_scenario(folder))
        halves: list[HalfTrack] = []
        for half in sorted(int(path.stem.partition("-")[2]) for path in parts.glob("half-*.poses")):
            fields = read_parts(parts, half, len(roster.entities))
            if fields["notes"].size:  # else killed before the half's first line was written
                halves.append(_half(fields.__getitem__, len(roster.entities), half))
        header = {
            "entities": roster.entities,
            "robots": roster.robots,
            "balls": roster.balls,
            "things": roster.things,
        }
        return cls._made(header, tuple(halves), finished=False)

    @classmethod
    def _made(cls, header: Mapping[str, Any], halves: tuple[HalfTrack, ...], *, finished: bool) -> Self:
        return cls(
            entities=tuple(header["entities"]),
            robots=int(header["robots"]),
            balls=int(header["balls"]),
            things=tuple(header["things"]),
            finished=finished,
            halves=halves,
        )


def read_parts(parts: Path, half: int, entities: int) -> dict[str, Array]:
    """Return the arrays of a half that was not packed, up to its last whole tick.

    Raises:
        OSError: a file of it is missing or cannot be read.
    """
    poses, touches, notes = part_paths(parts, half)
    dtype = row_dtype(entities)
    with open_file(poses) as file:
        rows = np.fromfile(file, dtype, os.fstat(file.fileno()).st_size // dtype.itemsize)
    fields = {name: np.ascontiguousarray(rows[name]) for name in dtype.names or ()}
    pairs = int(fields["touch_counts"].sum(dtype=np.int64))
    with open_file(touches) as file:
        things = np.fromfile(file, "<u2", 2 * pairs)
    fields["touch_pairs"] = things[: len(things) // 2 * 2].reshape(-1, 2)
    text = read_file(notes)
    fields["notes"] = np.frombuffer(text[: text.rfind(b"\n") + 1], np.uint8)
    return fields


def _half(field: Callable[[str], Array], entities: int, half: int) -> HalfTrack:
    """Build a half from its arrays.

    Raises:
        ValueError: they do not fit each other.
    """
    substeps = field("substeps")
    notes = read_notes(field("notes").tobytes(), len(substeps))
    track = HalfTrack(
        notes.info,
        notes.start,
        substeps,
        field("heights"),
        field("uprights"),
        field("touch_counts"),
        field("touch_pairs"),
        notes.placements,
        notes.faults,
        notes.heard,
    )
    ticks, dtype = track.ticks, row_dtype(entities)
    for name in dtype.names or ():
        found: Array = getattr(track, name)
        if found.shape != (ticks, *dtype[name].shape) or found.dtype != dtype[name].base:
            raise _MisfitError(f"{name} of half {half} has the shape {found.shape}")
    if track.touch_pairs.shape != (int(track.touch_counts.sum(dtype=np.int64)), 2):
        raise _MisfitError(f"touches of half {half} are not complete")
    return track


class Notes(NamedTuple):
    """What the lines of notes hold: the half's facts, its start, and by tick what is rare; see `HalfTrack`."""

    info: HalfInfo
    start: Snapshot | None
    placements: dict[int, tuple[Placement, ...]]
    faults: dict[int, tuple[Fault, ...]]
    heard: dict[int, tuple[tuple[int, str], ...]]


def read_notes(text: bytes, ticks: int) -> Notes:
    """Return what the lines of notes hold.

    A kill may leave notes of ticks whose poses were never written; they are left out.
    """
    first, *lines = [parsed(line) for line in text.splitlines()]
    start: Snapshot | None = None
    placements: dict[int, tuple[Placement, ...]] = {}
    faults: dict[int, tuple[Fault, ...]] = {}
    heard: dict[int, tuple[tuple[int, str], ...]] = {}
    for line in lines:
        if line["tick"] > ticks:
            break
        if "start" in line:
            start = _snapshot(line["start"])
        if "placements" in line:
            placements[line["tick"]] = tuple(Placement(*placement) for placement in line["placements"])
        if "faults" in line:
            faults[line["tick"]] = tuple(Fault(**fault) for fault in line["faults"])
        if "told" in line:
            heard[line["tick"]] = tuple((int(entity), str(said)) for entity, said in line["told"])
    return Notes(HalfInfo(**first["half"]), start, placements, faults, heard)


def _snapshot(data: dict[str, Any]) -> Snapshot:
    return Snapshot(
        tick=data["tick"],
        substeps=[[tuple(pose) for pose in substep] for substep in data["substeps"]],
        heights=data["heights"],
        uprights=data["uprights"],
        touches=tuple(tuple((a, b) for a, b in substep) for substep in data["touches"]),
        faults=tuple(Fault(**fault) for fault in data["faults"]),
    )
