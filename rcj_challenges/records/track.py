"""The trajectory while a match runs: three append-only files for each half.

- ``half-1.touches``: pairs of thing indices, two little-endian uint16 each.
- ``half-1.notes.jsonl``: the half's facts in the first line, then what is rare: start, placements, faults.
- ``half-1.poses``: one row of fixed size for each tick (`row_dtype`). It is written last, so a row that is there has
  its touches and notes before it: what a kill cuts off is cut off at a whole tick.
"""

from __future__ import annotations

import struct
from dataclasses import asdict
from itertools import chain
from pathlib import Path
from typing import Any

import numpy as np

from rcj_challenges.facts.play import HalfInfo, Placement, Snapshot
from rcj_challenges.facts.timing import SUBSTEPS_PER_TICK
from rcj_challenges.records.folder import naming
from rcj_challenges.records.lines import json_line

TICKS_BETWEEN_WRITES = 25
"""0.8 s of the match: a kill loses less than one second."""

_FLOATS_OF_POSES, _FLOATS_BESIDE = 3 * SUBSTEPS_PER_TICK, 2  # of each entity: height and tilt beside its poses
_NO_TOUCHES = ((),) * SUBSTEPS_PER_TICK


def row_dtype(entities: int) -> np.dtype[np.void]:
    """Return the layout of one tick in ``half-n.poses``, for that many entities."""
    return np.dtype(
        [
            ("substeps", "<f4", (SUBSTEPS_PER_TICK, entities, 3)),
            ("heights", "<f4", (entities,)),
            ("uprights", "<f4", (entities,)),
            ("touch_counts", "<u2", (SUBSTEPS_PER_TICK,)),
        ]
    )


def part_paths(folder: Path, half: int) -> tuple[Path, Path, Path]:
    """Return the paths of poses, touches and notes of a half."""
    return tuple(folder / f"half-{half}.{end}" for end in ("poses", "touches", "notes.jsonl"))  # type: ignore[return-value]


class TrackWriter:
    """Appends one half to its three files."""

    def __init__(self, folder: Path, half: HalfInfo, entities: int) -> None:
        """Open the files.

        Args:
            folder: where the parts lie.
            half: its facts, written first.
            entities: how many entities every snapshot has.
        """
        self._pack_poses = struct.Struct(f"<{_FLOATS_OF_POSES * entities}f").pack
        self._pack_rest = struct.Struct(f"<{_FLOATS_BESIDE * entities}f{SUBSTEPS_PER_TICK}H").pack
        self._rows = bytearray()
        self._touches = bytearray()
        self._notes = bytearray(json_line({"half": asdict(half)}))
        poses, touches, notes = part_paths(folder, half.half)
        self._files = tuple(path.open("xb", buffering=0) for path in (touches, notes, poses))
        self.ticks = 0
        self._write()

    def append(self, snapshot: Snapshot, placements: tuple[Placement, ...], poses: bytes = b"") -> None:
        """Add one tick; tick 0 is the start, whatever number of sub-steps it has.

        Args:
            snapshot: what the referee saw.
            placements: what it put elsewhere.
            poses: those of the snapshot as they are written; left out: made here, which takes longer than all the rest.

        Raises:
            ValueError: a tick is missing or comes twice.
        """
        tick = snapshot.tick
        if tick == 0:
            start = {**snapshot._asdict(), "faults": [asdict(fault) for fault in snapshot.faults]}
            del start["heard"]  # nobody has said anything before the half begins
            self._notes += json_line({"tick": 0, "start": start})
        elif tick != self.ticks + 1:
            raise ValueError(f"tick {tick} after tick {self.ticks}: a record takes every tick once, in order")
        else:
            self._append_row(snapshot, poses)
        if placements:
            self._notes += json_line({"tick": tick, "placements": [_placement_list(p) for p in placements]})
        if snapshot.faults and tick:
            self._notes += json_line({"tick": tick, "faults": [asdict(fault) for fault in snapshot.faults]})
        if snapshot.heard:
            self._notes += json_line({"tick": tick, "told": snapshot.heard})
        if tick % TICKS_BETWEEN_WRITES == 0:
            self._write()

    def _append_row(self, snapshot: Snapshot, poses: bytes) -> None:
        touches = snapshot.touches
        if touches == _NO_TOUCHES:
            counts = (0, 0, 0, 0)
        else:
            counts = tuple(map(len, touches))  # type: ignore[assignment]
            numbers = [*chain.from_iterable(chain.from_iterable(touches))]
            self._touches += struct.pack(f"<{len(numbers)}H", *numbers)
        self._rows += poses or self._pack_poses(*chain.from_iterable(chain.from_iterable(snapshot.substeps)))
        self._rows += self._pack_rest(*snapshot.heights, *snapshot.uprights, *counts)
        self.ticks = snapshot.tick

    def close(self) -> None:
        """Write what is left and close the files."""
        self._write()
        for file in self._files:
            file.close()

    def _write(self) -> None:
        for file, pending in zip(self._files, (self._touches, self._notes, self._rows), strict=True):
            write_all(file, pending)


def write_all(file: Any, pending: bytearray) -> None:
    """Write everything, and take from ``pending`` what is written: an unbuffered file may take less than it was given.

    Raises:
        OSError: it takes no more; with its name. What is left in ``pending`` may be written later: a disk is not full
            for ever.
    """
    with naming(file.name):
        while pending:
            del pending[: file.write(pending)]


def _placement_list(placement: Placement) -> list[Any]:
    """Return a placement as it is written; what lies still as it was written when nothing rolled yet."""
    at = [placement.entity, placement.x_m, placement.y_m, placement.yaw_rad, placement.parked]
    velocity = [placement.vx_mps, placement.vy_mps]
    return [*at, *velocity] if any(velocity) else at
