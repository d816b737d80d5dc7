"""From the parts that grew while a match ran to the one ``trajectory.npz`` that stays."""

from __future__ import annotations

import json
import shutil
import zipfile
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from rcj_challenges.facts.errors import is_held
from rcj_challenges.records.folder import RECORD_VERSION, TRAJECTORY, TRAJECTORY_PARTS, replaced, when_free
from rcj_challenges.records.track import part_paths, row_dtype

_ROWS_AT_ONCE = 2048
_FIXED_DATE = (1980, 1, 1, 0, 0, 0)  # the earliest a ZIP can hold: equal runs give equal files

Array = npt.NDArray[Any]


def pack_trajectory(folder: Path, header: Mapping[str, Any], halves: Sequence[int]) -> Path:
    """Write ``trajectory.npz`` from the parts, by streaming, and remove them. Returns its path.

    Args:
        folder: of the run.
        header: what all halves share: entities, things, scenario, seed.
        halves: the numbers of those that were begun.
    """
    parts = folder / TRAJECTORY_PARTS
    path = folder / TRAJECTORY
    if path.exists():  # somebody interrupted us between the last two lines
        shutil.rmtree(parts, ignore_errors=True)
        return path
    with replaced(path) as file, zipfile.ZipFile(file, "w", zipfile.ZIP_STORED) as archive:
        _add(archive, "header", [_as_bytes({**header, "record": RECORD_VERSION, "halves": list(halves)})])
        for half in halves:
            _pack_half(archive, parts, half, len(header["entities"]))
    _remove(parts)
    return path


def _remove(parts: Path) -> None:
    """Remove the parts. What another program has open (Windows) stays: all of it is in the trajectory."""
    try:
        when_free(lambda: shutil.rmtree(parts))
    except OSError as error:
        if not is_held(error):
            raise


def _pack_half(archive: zipfile.ZipFile, parts: Path, half: int, entities: int) -> None:
    poses, touches, notes = part_paths(parts, half)
    dtype = row_dtype(entities)
    ticks = poses.stat().st_size // dtype.itemsize
    for field in dtype.names or ():
        base, shape = dtype[field].base, dtype[field].shape
        blocks = (np.ascontiguousarray(block[field]) for block in _blocks(poses, dtype, ticks))
        _add(archive, f"half{half}_{field}", blocks, base, (ticks, *shape))
    pairs = np.fromfile(touches, "<u2").reshape(-1, 2)
    _add(archive, f"half{half}_touch_pairs", [pairs])
    _add(archive, f"half{half}_notes", [np.fromfile(notes, np.uint8)])


def _blocks(path: Path, dtype: np.dtype[np.void], rows: int) -> Iterator[Array]:
    """Yield the rows of a file, some thousands at a time: the whole half is never in memory."""
    with path.open("rb") as file:
        for first in range(0, rows, _ROWS_AT_ONCE):
            yield np.fromfile(file, dtype, min(_ROWS_AT_ONCE, rows - first))


def _as_bytes(value: Mapping[str, Any]) -> Array:
    return np.frombuffer(json.dumps(value).encode(), np.uint8)


def _add(
    archive: zipfile.ZipFile,
    name: str,
    blocks: Iterable[Array],
    dtype: np.dtype[Any] | None = None,
    shape: tuple[int, ...] | None = None,
) -> None:
    """Add one array, given in blocks along its first axis (or as the only block)."""
    blocks = iter(blocks)
    if dtype is None or shape is None:
        only = next(blocks)
        dtype, shape, blocks = only.dtype, only.shape, iter([only])
    entry = zipfile.ZipInfo(f"{name}.npy", _FIXED_DATE)
    with archive.open(entry, "w", force_zip64=True) as file:
        described = {"descr": np.lib.format.dtype_to_descr(dtype), "fortran_order": False, "shape": shape}  # type: ignore[no-untyped-call]
        np.lib.format.write_array_header_1_0(file, described)  # type: ignore[no-untyped-call]
        for block in blocks:
            file.write(block.tobytes())
