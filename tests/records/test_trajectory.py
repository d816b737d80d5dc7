"""What the referee saw is read back as it was; a kill loses less than a second; what is damaged is refused."""

import contextlib
import shutil
from dataclasses import asdict
from pathlib import Path

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from rcj_challenges.core.play import Fault, Placement, RefereeOutput, Snapshot
from rcj_challenges.records import chunks
from rcj_challenges.records.chunks import ChunkWriter
from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.trajectory import TICKS_PER_CHUNK, Trajectory
from rcj_challenges.records.writer import RecordWriter
from tests.made_up_runs import (
    half_info,
    made_up_snapshot,
    small_header,
    small_scenario,
    write_made_up_run,
)

FILE = "trajectory.chunks"
_ENTITIES = 3  # two robots and the ball
_float32 = st.floats(width=32, allow_nan=False, allow_infinity=False)  # physics that is not finite ends the match
_pose = st.tuples(_float32, _float32, _float32)
_pair = st.tuples(st.integers(0, 2), st.integers(3, 4))
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
    """A half of up to 60 ticks in which rare things happen."""
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
            messages=((1, draw(st.text())),) if odd and tick else (),
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


@given(played=_played())
def test_every_snapshot_is_read_back_equal(played: list, tmp_path_factory: pytest.TempPathFactory) -> None:
    writer = _begun(tmp_path_factory.mktemp("runs"))
    for snapshot, placements in played:
        writer.tick(snapshot, RefereeOutput(placements=placements), b"")
    writer.end_half(RefereeOutput())
    assert not Trajectory.open(writer.folder).finished
    writer.finish()
    assert _read_back(writer.folder) == played
    assert Trajectory.open(writer.folder).finished
    shutil.rmtree(writer.folder)


def test_a_run_that_stopped_loses_less_than_a_second(tmp_path: Path) -> None:
    writer = _begun(tmp_path)
    for tick in range(93):
        writer.tick(made_up_snapshot(tick, 2), RefereeOutput(), b"")
    half = Trajectory.open(writer.folder).halves[0]
    assert 0 <= (92 - half.ticks) * 0.032 < 1
    assert list(half.snapshots()) == [made_up_snapshot(tick, 2) for tick in range(1, half.ticks + 1)]
    writer.finish({"complete": False})


@pytest.mark.parametrize("lost", [0, 1, 50, 400, 4_000, 5_000, 12_000])
def test_a_file_that_a_kill_cut_off_gives_its_whole_chunks(lost: int, tmp_path: Path) -> None:
    writer = _begun(tmp_path)
    for tick in range(101):
        placements = (Placement(0, 1.0, 2.0, 3.0),) if tick in (1, 100) else ()
        writer.tick(made_up_snapshot(tick, 2), RefereeOutput(placements=placements), b"")
    killed = Path(shutil.copytree(writer.folder, tmp_path / "killed"))
    writer.finish({"complete": False})
    data = (killed / FILE).read_bytes()
    (killed / FILE).write_bytes(data[: len(data) - lost])
    trajectory = Trajectory.open(killed)
    half = trajectory.halves[0]
    assert half.ticks % TICKS_PER_CHUNK == 0
    assert half.ticks == 100 if lost == 0 else 0 < half.ticks < 100
    assert list(half.snapshots()) == [made_up_snapshot(tick, 2) for tick in range(1, half.ticks + 1)]
    assert set(half.placements) == ({1, 100} if lost == 0 else {1})
    assert not trajectory.finished


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
    (folder / FILE).write_bytes(data)
    return folder


def _code(folder: Path) -> str:
    with pytest.raises(RecordError) as refused:
        Trajectory.open(folder)
    return refused.value.diagnostics[0].code


def test_a_folder_without_a_result_is_not_a_record(tmp_path: Path) -> None:
    assert _code(tmp_path) == "record-incomplete"


@example(place=212, byte=9)  # a bit that a block of zlib leaves free
@given(place=st.integers(0, 40_000), byte=st.integers(0, 255))
def test_a_changed_byte_is_noticed(place: int, byte: int, good: Path, tmp_path_factory: pytest.TempPathFactory) -> None:
    data = bytearray((good / FILE).read_bytes())
    data[place % len(data)] = byte
    folder = _copy_with(good, tmp_path_factory.mktemp("damaged"), bytes(data))
    with contextlib.suppress(RecordError):
        trajectory = Trajectory.open(folder)
        header_bytes = data.index(b"\n")  # it has no checksum
        is_same = chunks.read_chunks(folder / FILE).chunks == chunks.read_chunks(good / FILE).chunks
        assert is_same or place % len(data) <= header_bytes
        assert [half.ticks for half in trajectory.halves] == [30]


def test_a_chunk_that_does_not_begin_as_one_is_damaged(good: Path, tmp_path: Path) -> None:
    data = (good / FILE).read_bytes()
    folder = _copy_with(good, tmp_path, data[::-1].replace(b"KNHC", b"KNHX", 1)[::-1])
    assert chunks.read_chunks(folder / FILE).is_damaged
    assert _code(folder) == "record-damaged"


@pytest.mark.parametrize("cut", [1, 20, 300, 5000])
def test_a_finished_trajectory_that_lost_its_end_is_refused(cut: int, good: Path, tmp_path: Path) -> None:
    assert _code(_copy_with(good, tmp_path, (good / FILE).read_bytes()[:-cut])) == "record-damaged"


@pytest.mark.parametrize(
    "data", [b"", b"PK\x03\x04 something else", b"[]\n", b'{"record": null}\n', b'{"record": 2}\n']
)
def test_another_file_is_refused(data: bytes, good: Path, tmp_path: Path) -> None:
    assert _code(_copy_with(good, tmp_path, data)) == "record-damaged"


START = {"tick": 0, "substeps": [[[0.0, 0.0, 0.0]] * 3], "heights": [0.0] * 3, "uprights": [1.0] * 3, "touches": [],
         "faults": []}  # fmt: skip
SECOND_HALF = asdict(half_info(small_scenario(1, 2), 2, 100, small_header(small_scenario(1, 2))))


def test_a_half_that_fits_can_follow(tmp_path: Path) -> None:
    writer = _begun(tmp_path)
    trajectory = writer._trajectory._file
    trajectory.append(trajectory.pack({"half": SECOND_HALF}))
    trajectory.append(trajectory.pack({"rows": 0, "notes": [{"tick": 0, "start": START}]}))
    writer.finish({"complete": False})
    _, second = Trajectory.open(writer.folder).halves
    assert second.start is not None


@pytest.mark.parametrize(
    ("head", "body"),
    [
        ({"rows": 1, "notes": []}, b"too short"),
        ({"rows": 0, "notes": []}, b"\0\0\0\0"),
        ({"rows": 0, "notes": [{"tick": 1, "placements": [[0]]}]}, b""),
        ({"rows": 0, "notes": [{"tick": 1, "faults": [{"robot": "B1"}]}]}, b""),
        ({"rows": 0, "notes": [{"tick": 1, "placements": [[9, 0, 0, 0]]}]}, b""),
        ({"rows": 0, "notes": [{"tick": 1, "told": [[9, "text"]]}]}, b""),
        ({"rows": 0, "notes": [{"tick": 0, "start": {**START, "heights": [0.0]}}]}, b""),
        ({"rows": 0, "notes": [{"tick": 0, "start": {**START, "substeps": [[[0.0, 0.0]] * 3]}}]}, b""),
        ({"rows": 0, "notes": [{"tick": 0, "start": {**START, "touches": [[[0, 99]]]}}]}, b""),
        ({"half": {"half": 1}}, b""),
        ({"half": {**SECOND_HALF, "team_names": []}}, b""),
        ({"half": {**SECOND_HALF, "teams": {"blue": 1, "yellow": 2}}}, b""),
    ],
)
def test_chunks_that_do_not_fit_each_other_are_refused(head, body, tmp_path: Path) -> None:
    writer = _begun(tmp_path)
    trajectory = writer._trajectory._file
    trajectory.append(trajectory.pack(head, body))
    writer.finish({"complete": False})
    assert _code(writer.folder) == "record-damaged"


def test_a_chunk_that_unpacks_to_more_than_a_record_may_have_is_refused(tmp_path: Path, monkeypatch) -> None:
    writer = ChunkWriter(tmp_path / "bomb", {}, 9)
    writer.append(writer.pack({"rows": 0}, bytes(100_000)))
    writer.close()
    monkeypatch.setattr(chunks, "MAX_FILE_BYTES", 50_000)
    found = chunks.read_chunks(tmp_path / "bomb")
    assert found.is_damaged
    assert found.chunks == ()
