"""Records with pipes, devices or huge files: reading one would block for ever, or never end."""

import os
import shutil
import sys
from pathlib import Path

import pytest

from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.referee_log import read_referee_log
from rcj_challenges.records.result import read_result
from rcj_challenges.records.run_record import read_run
from rcj_challenges.records.sensors import read_sensors
from tests.made_up_runs import write_made_up_run

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="Windows has no pipes among its files")


def pipe_in_place_of(path: Path) -> None:
    path.unlink(missing_ok=True)
    os.mkfifo(path)


@pytest.fixture(scope="module")
def sound(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_made_up_run(tmp_path_factory.mktemp("runs"), ticks=20)


@pytest.mark.parametrize(
    ("name", "read"),
    [
        ("result.json", read_result),
        ("scenario.json", read_run),
        ("trajectory.chunks", read_run),
        ("referee.jsonl", read_referee_log),
        ("sensors/half-1.sensors", read_sensors),
    ],
)
def test_pipe_in_place_of_a_file_is_refused(name: str, read, sound: Path, tmp_path: Path) -> None:
    folder = Path(shutil.copytree(sound, tmp_path / "run"))
    (folder / name).parent.mkdir(exist_ok=True)
    pipe_in_place_of(folder / name)
    with pytest.raises(RecordError) as refused:
        read(folder)
    assert refused.value.diagnostics[0].code == "record-not-a-file"
    assert Path(name).name in refused.value.message


@pytest.mark.parametrize(
    ("name", "read"),
    [("result.json", read_result), ("referee.jsonl", read_referee_log), ("trajectory.chunks", read_run)],
)
def test_file_that_is_larger_than_any_run_makes_is_refused(name: str, read, sound: Path, tmp_path: Path) -> None:
    folder = Path(shutil.copytree(sound, tmp_path / "run"))
    os.truncate(folder / name, 600_000_000)  # it takes no room on the disk
    with pytest.raises(RecordError) as refused:
        read(folder)
    assert refused.value.diagnostics[0].code == "record-too-large"


def test_link_to_a_device_is_refused(sound: Path, tmp_path: Path) -> None:
    folder = Path(shutil.copytree(sound, tmp_path / "run"))
    (folder / "result.json").unlink()
    (folder / "result.json").symlink_to("/dev/zero")
    with pytest.raises(RecordError, match=r"result\.json"):
        read_result(folder)


def test_link_to_a_file_is_read(sound: Path, tmp_path: Path) -> None:
    folder = Path(shutil.copytree(sound, tmp_path / "run"))
    (folder / "referee.jsonl").rename(tmp_path / "elsewhere")
    (folder / "referee.jsonl").symlink_to(tmp_path / "elsewhere")
    assert read_referee_log(folder) == read_referee_log(sound)
