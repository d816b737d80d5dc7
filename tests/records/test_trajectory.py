"""What the referee saw is read back as it was; what is damaged or foreign is refused with a clear message."""

import contextlib
import json
import shutil
import struct
import zipfile
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from rcj_challenges.facts.play import Fault, Placement, RefereeOutput, Snapshot
from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.testing import (
    half_info,
    made_up_snapshot,
    small_header,
    small_scenario,
    write_made_up_run,
)
from rcj_challenges.records.trajectory import Trajectory
from rcj_challenges.records.writer import RecordWriter

_ENTITIES = 3  # two robots and the ball
_float32 = st.floats(width=32, allow_nan=False, allow_infinity=False)  # physics that is not finite ends the match
_pose = st.tuples(_float32, _float32, _float32)
_pair = st.tuples(st.integers(0, 4), st.integers(5, 300))
_fault = st.builds(
    Fault, st.sampled_from(["B1", "Y1"]), st.just("crash"), st.integers(0, 9), st.just(1), st.text(), st.text()
)
_placement = st.builds(
    Placement,
    st.integers(0, 2),
    *[st.floats(allow_nan=False, allow_infinity=False)] * 3,
    st.booleans(),
    *[st.just(0.0) | st.floats(-3, 3)] * 2,
)


@st.composite
def _played(draw: st.DrawFn) -> list[tuple[Snapshot, tuple[Placement, ...]]]:
    """A half of up to 60 ticks of which nothing is likely."""
    rare = draw(st.lists(st.integers(0, 60), max_size=6))
    played = []
    for tick in range(draw(st.integers(0, 60)) + 1):
        odd = tick in rare
        substeps = draw(st.lists(st.lists(_pose, min_size=3, max_size=3), min_size=4, max_size=4)) if odd else None
        snapshot = Snapshot(
            tick=tick,
            substeps=substeps or made_up_snapshot(tick, 2).substeps,
            heights=draw(st.lists(_float32, min_size=3, max_size=3)) if odd else [0.0] * 3,
            uprights=[1.0] * _ENTITIES,
            touches=draw(st.tuples(*[st.lists(_pair, max_size=3).map(tuple)] * 4)) if odd else ((),) * 4,
            faults=tuple(draw(st.lists(_fault, max_size=2))) if odd else (),
        )
        played.append((snapshot, tuple(draw(st.lists(_placement, max_size=2))) if odd else ()))
    return played


def _begun(out: Path) -> RecordWriter:
    scenario = small_scenario(1, 1)
    header = small_header(scenario)
    writer = RecordWriter(out, header)
    writer.begin_half(half_info(scenario, 1, 100, header))
    return writer


def _read_back(folder: Path) -> list[tuple[Snapshot, tuple[Placement, ...]]]:
    half = Trajectory.open(folder).halves[0]
    snapshots = [half.start, *half.snapshots()]
    return [(snapshot, half.placements.get(snapshot.tick, ())) for snapshot in snapshots]


@settings(max_examples=40, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(played=_played())
def test_every_snapshot_is_read_back_equal_while_running_and_afterwards(
    played: list, tmp_path_factory: pytest.TempPathFactory
) -> None:
    writer = _begun(tmp_path_factory.mktemp("runs"))
    for snapshot, placements in played:
        writer.tick(snapshot, RefereeOutput(placements=placements), b"")
    writer.end_half(RefereeOutput())
    assert _read_back(writer.folder) == played
    assert not Trajectory.open(writer.folder).finished
    writer.finish()
    assert _read_back(writer.folder) == played
    assert Trajectory.open(writer.folder).finished
    shutil.rmtree(writer.folder)


def test_what_lies_still_is_written_as_before_balls_could_be_kicked(tmp_path: Path) -> None:
    writer = _begun(tmp_path)
    placed = (Placement(2, 0.1, 0.2, 0.0), Placement(2, 0.1, 0.2, 0.0, vx_mps=0.6))
    writer.tick(made_up_snapshot(0, 2), RefereeOutput(placements=placed), b"")
    writer.end_half(RefereeOutput())
    (notes,) = writer.folder.rglob("half-1.notes.jsonl")
    (line,) = [json.loads(text) for text in notes.read_text("utf-8").splitlines() if "placements" in text]
    assert line["placements"] == [[2, 0.1, 0.2, 0.0, False], [2, 0.1, 0.2, 0.0, False, 0.6, 0.0]]
    writer.finish()
    assert Trajectory.open(writer.folder).halves[0].placements[0] == placed


def test_a_run_that_stopped_loses_less_than_a_second(tmp_path: Path) -> None:
    writer = _begun(tmp_path)
    for tick in range(93):
        writer.tick(made_up_snapshot(tick, 2), RefereeOutput(), b"")
    half = Trajectory.open(writer.folder).halves[0]
    assert 0 <= (92 - half.ticks) * 0.032 < 1
    assert list(half.snapshots()) == [made_up_snapshot(tick, 2) for tick in range(1, half.ticks + 1)]
    writer.finish({"complete": False})


@pytest.mark.parametrize("lost", range(0, 400, 7))
def test_a_file_that_was_cut_off_anywhere_still_gives_its_whole_ticks(lost: int, tmp_path: Path) -> None:
    writer = _begun(tmp_path)
    for tick in range(51):
        writer.tick(made_up_snapshot(tick, 2), RefereeOutput(), b"")
    poses = next(writer.folder.rglob("*.poses"))
    whole = poses.stat().st_size
    with poses.open("r+b") as file:
        file.truncate(whole - lost)
    half = Trajectory.open(writer.folder).halves[0]
    row = whole // 50
    assert half.ticks == (whole - lost) // row
    assert list(half.snapshots()) == [made_up_snapshot(tick, 2) for tick in range(1, half.ticks + 1)]
    writer.finish({"complete": False})


def test_notes_of_ticks_whose_poses_were_never_written_are_left_out(tmp_path: Path) -> None:
    writer = _begun(tmp_path)
    for tick in range(26):
        placements = (Placement(0, 1.0, 2.0, 3.0),) if tick == 25 else ()
        writer.tick(made_up_snapshot(tick, 2), RefereeOutput(placements=placements), b"")
    poses = next(writer.folder.rglob("*.poses"))
    with poses.open("r+b") as file:
        file.truncate(poses.stat().st_size - 1)
    notes = next(writer.folder.rglob("*.notes.jsonl"))
    with notes.open("ab") as file:
        file.write(b'{"tick": 26, "placem')
    half = Trajectory.open(writer.folder).halves[0]
    assert half.ticks == 24
    assert not half.placements
    writer.finish({"complete": False})


def test_a_tick_that_is_missing_or_comes_twice_is_refused(tmp_path: Path) -> None:
    writer = _begun(tmp_path)
    writer.tick(made_up_snapshot(1, 2), RefereeOutput(), b"")
    for wrong in (1, 3):
        with pytest.raises(ValueError, match="every tick once"):
            writer.tick(made_up_snapshot(wrong, 2), RefereeOutput(), b"")
    writer.finish({"complete": False})


# --- bad input ----------------------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def good(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_made_up_run(tmp_path_factory.mktemp("runs"), ticks=30, halves=1)


def _copy_with(good: Path, tmp_path: Path, data: bytes) -> Path:
    folder = tmp_path / "20210618-001159-match"
    shutil.copytree(good, folder)
    (folder / "trajectory.npz").write_bytes(data)
    return folder


def test_no_record_at_all_is_said_so(tmp_path: Path) -> None:
    with pytest.raises(RecordError, match=r"no record of a run \(result.json is missing\)"):
        Trajectory.open(tmp_path)


@settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(cut=st.integers(0, 40_000), place=st.integers(0, 40_000), byte=st.integers(0, 255))
def test_a_damaged_file_is_refused_or_read_never_a_crash(
    cut: int, place: int, byte: int, good: Path, tmp_path_factory: pytest.TempPathFactory
) -> None:
    data = bytearray((good / "trajectory.npz").read_bytes())
    data[place % len(data)] = byte
    folder = _copy_with(good, tmp_path_factory.mktemp("damaged"), bytes(data[: max(0, len(data) - cut % 3 * cut)]))
    with contextlib.suppress(RecordError):
        assert Trajectory.open(folder).halves[0].ticks == 30


def test_a_zip_of_something_else_is_refused(good: Path, tmp_path: Path) -> None:
    with zipfile.ZipFile(tmp_path / "other.npz", "w") as archive:
        archive.writestr("notes.txt", "hello")
    folder = _copy_with(good, tmp_path, (tmp_path / "other.npz").read_bytes())
    with pytest.raises(RecordError, match="damaged or none of ours"):
        Trajectory.open(folder)


def test_pickled_objects_are_never_loaded(good: Path, tmp_path: Path) -> None:
    np.savez(tmp_path / "evil.npz", header=np.array([{"record": 1}], dtype=object))
    folder = _copy_with(good, tmp_path, (tmp_path / "evil.npz").read_bytes())
    with pytest.raises(RecordError, match=r"damaged or none of ours$"):
        Trajectory.open(folder)


def test_what_numpy_advises_its_callers_is_not_told_to_users(good: Path, tmp_path: Path) -> None:
    folder = _copy_with(good, tmp_path, b"no zip at all")
    with pytest.raises(RecordError) as caught:
        Trajectory.open(folder)
    assert "pickle" not in str(caught.value)
    assert str(caught.value).endswith("the trajectory is damaged or none of ours")


def test_a_newer_record_is_refused_naming_what_is_needed(good: Path, tmp_path: Path) -> None:
    header = np.frombuffer(json.dumps({"record": 99, "halves": 0, "entities": []}).encode(), np.uint8)
    np.savez(tmp_path / "newer.npz", header=header)
    folder = _copy_with(good, tmp_path, (tmp_path / "newer.npz").read_bytes())
    with pytest.raises(RecordError, match="needs a newer rcj-challenges"):
        Trajectory.open(folder)


def test_arrays_that_do_not_fit_each_other_are_refused(good: Path, tmp_path: Path) -> None:
    with np.load(good / "trajectory.npz") as arrays:
        wrong = {name: arrays[name] for name in arrays.files}
    wrong["half1_heights"] = wrong["half1_heights"][:-1]
    np.savez(tmp_path / "wrong.npz", **wrong)
    folder = _copy_with(good, tmp_path, (tmp_path / "wrong.npz").read_bytes())
    with pytest.raises(RecordError, match="heights of half 1"):
        Trajectory.open(folder)


def test_the_packed_file_is_plain_numpy(good: Path) -> None:
    with np.load(good / "trajectory.npz") as arrays:
        assert arrays["half1_substeps"].shape == (30, 4, 7, 3)
        assert arrays["half1_substeps"].dtype == np.float32
        x = struct.unpack("<f", struct.pack("<f", made_up_snapshot(30, 6).substeps[3][0][0]))[0]
        assert arrays["half1_substeps"][29, 3, 0, 0] == x
