"""Where a record cannot be written: the message names the place and what to do; exit code 2, no traceback, no report."""

import errno
import io
import os
import shutil
import subprocess
import sys
import time
from pathlib import Path
from types import SimpleNamespace

import pytest

from rcj_challenges.cli import stdio
from rcj_challenges.core.errors import HostError, RcjError
from rcj_challenges.core.files import write_new
from rcj_challenges.records.result import read_result
from tests.cli.in_this_process import here

COMMAND = [sys.executable, "-m", "rcj_challenges"]
POSIX = pytest.mark.skipif(os.name != "posix", reason="the limit for the size of files is POSIX's")


@pytest.fixture
def command(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]):
    """Run a command in the test's folder; returns its exit code and what it said."""

    def run(*arguments: str) -> tuple[object, str, str]:
        code = here(monkeypatch, tmp_path, *arguments)
        out, complaint = capsys.readouterr()
        assert "Traceback" not in complaint
        assert not list(tmp_path.glob("rcj-challenge-report-*")), complaint
        return code, out, complaint

    return run


@POSIX
@pytest.mark.parametrize("more", [[], ["--record", "sensors"]], ids=["poses", "sensors"])
def test_a_full_disk_is_reported_with_the_file_and_what_helps(tmp_path: Path, duel: list[str], more: list[str]) -> None:
    arguments = ["run", *duel, "--duration=60", "--no-replay", "--quiet", *more]
    done = subprocess.run(
        ["bash", "-c", 'ulimit -f 60; exec "$@"', "bash", *COMMAND, *arguments],
        cwd=tmp_path, capture_output=True, text=True, encoding="utf-8", timeout=120, check=False,
    )  # fmt: skip
    assert done.returncode == 2
    assert not list(tmp_path.glob("rcj-challenge-report-*"))
    (folder,) = tmp_path.glob("runs/*")
    assert done.stderr.startswith("error[cannot-write-record]: ")
    assert f"{folder.relative_to(tmp_path)}/" in done.stderr
    assert "File too large" in done.stderr
    assert not read_result(folder).complete


@POSIX
def test_a_record_deleted_meanwhile_is_no_internal_error(tmp_path: Path, duel: list[str]) -> None:
    process = subprocess.Popen(
        [*COMMAND, "run", *duel, "--duration=20", "--quiet"], cwd=tmp_path, stderr=subprocess.PIPE, text=True
    )
    until = time.monotonic() + 60
    while not any(log.stat().st_size for log in tmp_path.glob("runs/*/referee.jsonl")):
        assert time.monotonic() < until
        time.sleep(0.02)
    shutil.rmtree(tmp_path / "runs")
    _, complaint = process.communicate(timeout=120)
    assert process.returncode == 2, complaint
    assert complaint.startswith("error[cannot-write-record]: ")
    assert complaint.count("runs/") == 1
    assert not list(tmp_path.glob("rcj-challenge-report-*"))


def test_many_matches_are_not_begun_where_none_can_be_recorded(tmp_path: Path, duel: list[str], command) -> None:
    (tmp_path / "a file").write_text("", encoding="utf-8")
    code, printed, complaint = command("simulate", *duel, "--seeds=1..500", "--out", "a file", "--json")
    assert (code, printed) == (2, "")
    assert complaint.count("error[") == 1
    assert "a file is not a folder" in complaint


def test_message_about_a_folder_without_a_result_names_what_is_missing(tmp_path: Path, command) -> None:
    (tmp_path / "moved").mkdir()
    for reads in ("stats", "replay", "view"):
        code, _, complaint = command(reads, "moved")
        assert code == 2
        assert complaint.startswith("error[no-record]: no record 'moved': there is no result.json in this folder\n")


def test_output_that_finds_no_room_is_reported_with_the_file_that_it_goes_to(tmp_path: Path, monkeypatch) -> None:
    class Full(io.TextIOWrapper):
        def write(self, _: str) -> int:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    with (tmp_path / "told.txt").open("wb") as file:
        stream = Full(file)
        monkeypatch.setattr(sys, "stdout", stream)
        with pytest.raises(HostError) as raised:
            stdio.print_json({})
        where = f" ({tmp_path / 'told.txt'})" if sys.platform == "linux" else ""
        assert raised.value.code == "cannot-write-output"
        assert raised.value.help
        assert str(raised.value) == f"the output{where} cannot be written: No space left on device"


@POSIX
def test_only_a_full_disk_of_the_output_is_taken_for_one(tmp_path: Path, monkeypatch) -> None:
    full = OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
    with (tmp_path / "told.txt").open("w", encoding="utf-8") as file:
        monkeypatch.setattr(sys, "stdout", file)
        assert not stdio.is_output_error(full)
        monkeypatch.setattr(os, "fstatvfs", lambda _: SimpleNamespace(f_bavail=0))
        assert stdio.is_output_error(full)
        assert not stdio.is_output_error(OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), "record"))


def test_a_starter_without_room_leaves_nothing_that_is_in_the_way(tmp_path: Path, monkeypatch) -> None:
    opens = Path.open

    class Full(io.BytesIO):
        def write(self, _: object) -> int:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    def opened(path: Path, *arguments: str, **options: str) -> object:
        opens(path, *arguments, **options).close()
        return Full()

    monkeypatch.setattr(Path, "open", opened)
    with pytest.raises(RcjError) as raised:
        write_new(tmp_path / "a.yaml", b"id: a")
    assert raised.value.code == "cannot-write"
    assert list(tmp_path.iterdir()) == []
