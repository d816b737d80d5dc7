"""The trajectory: all that the referee saw of a run, written during play, so that it can be judged again.

A file of chunks (`chunks`). Its header names entities and things. A chunk ``{"half": …}`` begins a half with its facts;
then comes one chunk for each 25 ticks: the number of rows and notes of what is rare (start, placements, faults, radio
messages to the referee) as JSON, the rows (`row_dtype`), and the pairs of things that touched (uint16). The chunk
``{"end": true}`` ends the trajectory of a run that closed its record.
"""

from __future__ import annotations

import struct
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import asdict, dataclass, field
from functools import cache
from itertools import chain
from pathlib import Path
from typing import Any, Self

import numpy as np
import numpy.typing as npt
from pydantic import TypeAdapter

from rcj_challenges.core.play import Fault, HalfInfo, Placement, Snapshot
from rcj_challenges.core.timing import SUBSTEPS_PER_TICK
from rcj_challenges.records.chunks import DAMAGE, ChunkWriter, read_chunks
from rcj_challenges.records.codes import RECORD_DAMAGED
from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.folder import TRAJECTORY
from rcj_challenges.records.result import read_result
from rcj_challenges.scenario.roster import Roster

TICKS_PER_CHUNK = 25
"""0.8 s of the match: a kill loses less than one second."""

_NOT_PACKED = 0  # poses of a simulation are noise in their lower bits: packing takes 0.2 s a half and saves a third
_ROWS_AT_ONCE = 512
_FLOATS_OF_POSES, _FLOATS_BESIDE = 3 * SUBSTEPS_PER_TICK, 2  # of each entity: height and tilt beside its poses
_NO_TOUCHES = ((),) * SUBSTEPS_PER_TICK

Array = npt.NDArray[Any]


def row_dtype(entities: int) -> np.dtype[np.void]:
    """Return the layout of one tick, for that many entities."""
    return np.dtype(
        [
            ("substeps", "<f4", (SUBSTEPS_PER_TICK, entities, 3)),
            ("heights", "<f4", (entities,)),
            ("uprights", "<f4", (entities,)),
            ("touch_counts", "<u2", (SUBSTEPS_PER_TICK,)),
        ]
    )


# --- writing ----------------------------------------------------------------------------------------------------------


class TrajectoryWriter:
    """Appends the halves of a run, tick by tick; ``ticks`` is the number of those of the half."""

    def __init__(self, folder: Path, scenario_id: str, seed: int, roster: Roster) -> None:
        """Create the file in the folder of a run.

        Raises:
            OSError: it cannot be written.
        """
        header = {
            "scenario": scenario_id,
            "seed": seed,
            "entities": list(roster.entities),
            "robots": roster.robots,
            "balls": roster.balls,
            "things": list(roster.things),
        }
        entities = len(roster.entities)
        self._row_bytes = row_dtype(entities).itemsize
        self._pack_poses = struct.Struct(f"<{_FLOATS_OF_POSES * entities}f").pack
        self._pack_rest = struct.Struct(f"<{_FLOATS_BESIDE * entities}f{SUBSTEPS_PER_TICK}H").pack
        self._file = ChunkWriter(folder / TRAJECTORY, header, _NOT_PACKED)
        self._rows = bytearray()
        self._touches = bytearray()
        self._notes: list[dict[str, Any]] = []
        self._is_ended = False
        self.ticks = 0

    def begin_half(self, half: HalfInfo) -> None:
        """Begin a half; its tick 0 comes next."""
        self._flush()
        self.ticks = 0
        self._file.append(self._file.pack({"half": asdict(half)}))

    def append(self, snapshot: Snapshot, placements: tuple[Placement, ...], poses: bytes = b"") -> None:
        """Add one tick; tick 0 is the start, whatever number of sub-steps it has.

        ``poses`` are those of the snapshot as written; left out: made here, which takes longer than all the rest.

        Raises:
            ValueError: a tick is missing or comes twice.
        """
        tick = snapshot.tick
        if tick not in (0, self.ticks + 1):
            raise ValueError(f"tick {tick} after tick {self.ticks}: a record takes every tick once, in order")
        if not tick or placements or snapshot.faults or snapshot.messages:
            self._notes.append(_note(snapshot, placements))
        if tick:
            self._append_row(snapshot, poses)
        if tick % TICKS_PER_CHUNK == 0:
            self._flush()

    def _append_row(self, snapshot: Snapshot, poses: bytes) -> None:
        touches = snapshot.touches
        if touches != _NO_TOUCHES:
            numbers = [*chain.from_iterable(chain.from_iterable(touches))]
            self._touches += struct.pack(f"<{len(numbers)}H", *numbers)
        self._rows += poses or self._pack_poses(*chain.from_iterable(chain.from_iterable(snapshot.substeps)))
        self._rows += self._pack_rest(*snapshot.heights, *snapshot.uprights, *map(len, touches))
        self.ticks = snapshot.tick

    def close(self) -> None:
        """End the trajectory. Can be called again, also after an interruption or a full disk."""
        self._flush()
        if not self._is_ended:
            self._is_ended = True
            self._file.append(self._file.pack({"end": True}))
        self._file.close()

    def _flush(self) -> None:
        if self._rows or self._notes:
            head = {"rows": len(self._rows) // self._row_bytes, "notes": self._notes}
            chunk = self._file.pack(head, bytes(self._rows + self._touches))
            self._notes = []
            self._rows.clear()
            self._touches.clear()
            self._file.append(chunk)


def _note(snapshot: Snapshot, placements: Iterable[Placement]) -> dict[str, Any]:
    note: dict[str, Any] = {"tick": snapshot.tick}
    faults = [asdict(fault) for fault in snapshot.faults]
    if not snapshot.tick:
        note["start"] = {**snapshot._asdict(), "faults": faults}
        del note["start"]["messages"]  # nothing is sent before the half begins
    elif faults:
        note["faults"] = faults
    if placements:
        note["placements"] = [[*asdict(placement).values()] for placement in placements]
    if snapshot.messages:
        note["told"] = snapshot.messages
    return note


# --- reading ----------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class HalfTrack:
    """One half. ``T`` ticks (row ``i`` is tick ``i + 1``), ``E`` entities; metres and radians, float32.

    Attributes:
        start: the snapshot of tick 0, None if the run was killed before it was written.
        substeps: ``[T, 4, E, 3]``, x, y, yaw.
        heights: ``[T, E]``, z of the centre.
        uprights: ``[T, E]``, cosine of the tilt.
        touch_counts: ``[T, 4]``, number of pairs that touched in each sub-step.
        touch_pairs: ``[N, 2]``, pairs of thing indices, one after the other.
        placements: what the referee moved after a tick, by tick.
        faults: of programs, by the tick in which the referee learned of it.
        messages: to the referee by radio, by the tick in which they arrived: (entity, text).
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
    messages: Mapping[int, tuple[tuple[int, str], ...]] = field(default_factory=dict)

    @property
    def ticks(self) -> int:
        """Number of ticks."""
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
                    messages=self.messages.get(tick, ()),
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
        robots, balls: number of robots; of balls.
        things: the entities, then fixed obstacles, then ``walls``: what touches are pairs of.
        finished: False if the run was killed or is still played.
        damage: what is wrong after the last half, in words; empty if the file is intact.
    """

    entities: tuple[str, ...]
    robots: int
    balls: int
    things: tuple[str, ...]
    finished: bool
    halves: tuple[HalfTrack, ...]
    damage: str = ""

    @classmethod
    def open(cls, folder: Path) -> Self:
        """Read the whole trajectory of a run; a damaged one is refused, as it cannot be judged again.

        Raises:
            RecordError: there is none, or it is damaged, foreign, or of another version.
        """
        trajectory = cls.read(folder)
        if trajectory.damage:
            raise RecordError.damaged(f"{folder.name}: {trajectory.damage}")
        return trajectory

    @classmethod
    def read(cls, folder: Path) -> Self:
        """Read the trajectory of a run up to where it is damaged.

        Raises:
            RecordError: there is none, or it is foreign, or of another version.
        """
        result = read_result(folder)
        found = read_chunks(folder / TRAJECTORY)
        try:
            header = found.header
            entities = tuple(map(str, header["entities"]))
            robots, balls = int(header["robots"]), int(header["balls"])
            things = tuple(map(str, header["things"]))
        except DAMAGE as error:
            raise RecordError(RECORD_DAMAGED, f"{folder.name}: the header of {TRAJECTORY} is damaged") from error
        halves, read = _halves(found.chunks, len(entities), len(things))
        finished = read == len(found.chunks) > 0 and "end" in found.chunks[-1][0]
        damage = ""
        if found.is_damaged or read < len(found.chunks) or (result.complete and not finished):
            damage = f"{TRAJECTORY} is damaged"
        return cls(entities, robots, balls, things, finished, halves, damage)


def _halves(
    chunks: Iterable[tuple[dict[str, Any], bytes]], entities: int, things: int
) -> tuple[tuple[HalfTrack, ...], int]:
    """Return the halves that chunks hold, up to the first that does not fit, and the number of their chunks."""
    halves: list[_HalfReader] = []
    read = 0
    try:
        for head, body in chunks:
            if "half" in head:
                halves.append(_HalfReader(_info(head["half"], len(halves) + 1), entities, things))
            elif "end" not in head:
                halves[-1].add(head, body)
            read += 1
    except DAMAGE:
        pass
    return tuple(half.track() for half in halves), read


class _HalfReader:
    def __init__(self, info: HalfInfo, entities: int, things: int) -> None:
        self._info = info
        self._entities = entities
        self._things = things
        self._dtype = row_dtype(entities)
        self._rows = [np.zeros(0, self._dtype)]
        self._pairs = [np.zeros((0, 2), "<u2")]
        self._notes: dict[str, dict[int, Any]] = {"start": {}, "placements": {}, "faults": {}, "told": {}}

    def add(self, head: Mapping[str, Any], body: bytes) -> None:
        """Add a chunk; one that does not fit raises one of `DAMAGE`, and nothing of it is added."""
        rows: Array = np.frombuffer(body, self._dtype, head["rows"])
        pairs: Array = np.frombuffer(body, "<u2", offset=rows.nbytes).reshape(-1, 2)
        if len(pairs) != int(rows["touch_counts"].sum(dtype=np.int64)):
            raise ValueError("not as many pairs as there are touches")
        if pairs.max(initial=0) >= self._things:
            raise ValueError("a touch of what does not take part")
        notes = [(int(note["tick"]), key, parse(note[key])) for note in head["notes"]
                 for key, parse in _NOTES.items() if key in note]  # fmt: skip
        for tick, key, found in notes:
            self._check(tick, key, found)
        for tick, key, found in notes:
            self._notes[key][tick] = found
        self._rows.append(rows)
        self._pairs.append(pairs)

    def _check(self, tick: int, key: str, found: Any) -> None:
        """Raise ValueError for a note about what does not take part."""
        if key == "start":
            lengths = {len(found.heights), len(found.uprights), *map(len, found.substeps)}
            things = chain.from_iterable(chain.from_iterable(found.touches))
            fits = lengths == {self._entities} and all(0 <= one < self._things for one in things) and found.substeps
        elif key == "placements":
            fits = all(0 <= one.entity < self._entities for one in found)
        else:
            fits = key == "faults" or all(0 <= entity < self._entities for entity, _ in found)
        if tick < 0 or not fits:
            raise ValueError("a note about what does not take part")

    def track(self) -> HalfTrack:
        """Return all that was added."""
        rows = np.concatenate(self._rows)
        return HalfTrack(
            info=self._info,
            start=self._notes["start"].get(0),
            **{name: np.ascontiguousarray(rows[name]) for name in self._dtype.names or ()},
            touch_pairs=np.concatenate(self._pairs),
            placements=self._notes["placements"],
            faults=self._notes["faults"],
            messages=self._notes["told"],
        )


@cache
def _adapter(kind: Any) -> TypeAdapter[Any]:
    return TypeAdapter(kind)


def _info(data: Any, half: int) -> HalfInfo:
    """Return the facts of a half; raise ValueError if they are of another half or contradict each other."""
    info: HalfInfo = _adapter(HalfInfo).validate_python(data)
    seats = set(info.teams)
    if info.half != half or not (set(info.teams.values()) == set(info.scores) == set(info.team_names) == seats):
        raise ValueError("facts that contradict each other")
    return info


_NOTES: Mapping[str, Callable[[Any], Any]] = {
    "start": lambda data: _adapter(Snapshot).validate_python(data),
    "placements": lambda placed: tuple(Placement(*placement) for placement in placed),
    "faults": lambda failed: _adapter(tuple[Fault, ...]).validate_python(failed),
    "told": lambda sent: _adapter(tuple[tuple[int, str], ...]).validate_python(sent),
}
"""The parser of each kind of note."""
