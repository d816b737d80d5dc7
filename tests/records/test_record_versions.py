"""A record of another version is refused with a code; the current one is kept in the golden files."""

import json
import shutil
from pathlib import Path

import pytest

from rcj_challenges.records.chunks import ChunkWriter, read_chunks
from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.folder import RECORD_VERSION
from rcj_challenges.records.result import read_result
from rcj_challenges.records.run_record import read_run
from rcj_challenges.records.sensors import read_sensors
from rcj_challenges.records.trajectory import Trajectory
from rcj_challenges.views.replay import write_replay
from rcj_challenges.views.stats import run_stats
from tests.goldens.plays import RECORD
from tests.made_up_runs import write_made_up_run

OLD = Path(__file__).parent / "version-1"
"""The result of a match as version 1 wrote it."""


def code(read, folder: Path) -> str:
    with pytest.raises(RecordError) as refused:
        read(folder)
    return refused.value.diagnostics[0].code


def test_record_of_this_version_is_kept_and_read_whole() -> None:
    assert read_result(RECORD).record == RECORD_VERSION
    run = read_run(RECORD)
    assert run.problems == ()
    assert [half.ticks for half in run.halves] == [half.ticks for half in run.result.halves]


@pytest.mark.parametrize("read", [read_result, Trajectory.open, read_run, run_stats, write_replay])
def test_record_of_an_earlier_version_is_refused(read, tmp_path: Path) -> None:
    assert code(read, Path(shutil.copytree(OLD, tmp_path / "run"))) == "record-too-old"


@pytest.mark.parametrize("read", [read_result, Trajectory.open, read_run, run_stats, write_replay])
def test_record_of_a_later_version_is_refused(read, tmp_path: Path) -> None:
    folder = write_made_up_run(tmp_path, ticks=5, halves=1)
    result = json.loads((folder / "result.json").read_text("utf-8"))
    (folder / "result.json").write_text(json.dumps(result | {"record": RECORD_VERSION + 1}), "utf-8")
    assert code(read, folder) == "record-too-new"


@pytest.mark.parametrize(("version", "refused"), [(1, "record-too-old"), (RECORD_VERSION + 1, "record-too-new")])
def test_file_of_chunks_of_another_version_is_refused(version, refused, tmp_path: Path, monkeypatch) -> None:
    folder = tmp_path / "run" / "sensors"
    folder.mkdir(parents=True)
    with monkeypatch.context() as patch:
        patch.setattr("rcj_challenges.records.chunks.RECORD_VERSION", version)
        ChunkWriter(folder / "half-1.sensors", {}, 1).close()
    assert code(read_chunks, folder / "half-1.sensors") == refused
    assert code(read_sensors, folder.parent) == refused
