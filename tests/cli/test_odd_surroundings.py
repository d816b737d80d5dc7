"""Where commands are started by cron, by services, in pipes, in folders that are gone: the exit code stays true."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from rcj_challenges.records.result import read_result
from tests.cli.in_this_process import here

COMMAND = [sys.executable, "-m", "rcj_challenges"]
POSIX = pytest.mark.skipif(os.name != "posix", reason="files are closed and pipes broken as POSIX has it")


@pytest.fixture
def match(duel: list[str]) -> list[str]:
    """A command that plays a short match."""
    return [*COMMAND, "run", *duel, "--duration=0.5"]


def in_shell(line: str, command: list[str], cwd: Path, **more: object) -> subprocess.CompletedProcess[str]:
    """Run a command as ``"$@"`` in a line of the shell."""
    return subprocess.run(
        ["bash", "-c", line, "bash", *command],
        cwd=cwd, capture_output=True, text=True, encoding="utf-8", timeout=120, check=False, **more,
    )  # fmt: skip


def the_record(folder: Path) -> Path:
    (record,) = folder.glob("runs/*")
    return record


@pytest.mark.parametrize("arguments", [["validate", "match"], ["check", "robot.py", "--no-play"]])
def test_what_lies_in_the_current_folder_is_never_run_by_us(tmp_path: Path, arguments: list[str]) -> None:
    """It may be a team's: Python itself would take its random.py for the one of the library, with ``-m``."""
    (tmp_path / "robot.py").write_text("from controller import Robot\n", encoding="utf-8")
    for name in ("bisect", "calendar", "copy", "fractions", "json", "numbers", "queue", "random", "string", "struct"):
        (tmp_path / f"{name}.py").write_text("open('ran', 'w').close()\n", encoding="utf-8")
    done = subprocess.run([*COMMAND, *arguments], cwd=tmp_path, capture_output=True, text=True, timeout=60, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    assert not (tmp_path / "ran").exists()


@POSIX
def test_a_match_is_played_where_no_stream_is_open(tmp_path: Path, match: list[str]) -> None:
    done = in_shell('exec "$@" <&- >&- 2>&-', [*match, "--no-replay", "--json"], tmp_path)
    assert done.returncode == 0
    assert read_result(the_record(tmp_path)).complete
    assert not list(tmp_path.glob("rcj-challenge-report-*"))


@POSIX
@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs a file that is always full")
def test_wrong_input_exits_with_2_when_stderr_is_full(tmp_path: Path) -> None:
    assert in_shell('exec "$@" 2>/dev/full', [*COMMAND, "run", "no_such_scenario"], tmp_path).returncode == 2


@POSIX
def test_a_folder_that_is_gone_is_no_fault_of_ours(tmp_path: Path, match: list[str]) -> None:
    place = tmp_path / "gone"
    place.mkdir()
    line = 'rmdir ../gone; exec "$@"'
    done = in_shell(line, [*match, "--no-replay", "--quiet", "--out", str(tmp_path / "runs")], place)
    assert (done.returncode, done.stderr) == (0, "")
    place.mkdir()
    done = in_shell(line, [*match, "--no-replay"], place)
    assert done.returncode == 2
    assert "cannot make a folder for the record in runs" in done.stderr


@POSIX
def test_a_name_that_is_no_text_is_shown_as_far_as_it_can_be(
    tmp_path: Path, duel: list[str], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    name = os.fsdecode(b"blue=Ha\xffn\nse")  # as Python hands on what it is started with
    assert here(monkeypatch, tmp_path, "run", *duel, "--duration=0.5", "--quiet", "--team-name", name) == 0
    assert capsys.readouterr().err == ""
    assert read_result(the_record(tmp_path)).entrants["blue"].name == "Ha n se"
    assert Path(the_record(tmp_path), "replay.html").exists()


def test_json_is_whole_also_where_the_output_has_few_letters(tmp_path: Path, match: list[str]) -> None:
    narrow = os.environ | {"PYTHONUTF8": "0", "PYTHONIOENCODING": "latin-1"}
    name = "Lübeck \N{ROBOT FACE}"  # one letter that Latin 1 has, and one that it has not
    command = [*match, "--json", "--no-replay", "--team-name", f"blue={name}"]
    done = subprocess.run(command, cwd=tmp_path, env=narrow, capture_output=True, timeout=120, check=False)
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout.decode("utf-8"))["entrants"]["blue"]["name"] == name


def test_a_fault_of_ours_is_reported_whatever_letters_the_command_line_has(tmp_path: Path) -> None:
    breaks = "import rcj_challenges.scenario.load as l\nl.load = None\nfrom rcj_challenges.cli import main\nmain()\n"
    command = [sys.executable, "-c", breaks, "run", "a\udcffb"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, timeout=120, check=False)
    assert done.returncode == 3
    (report,) = tmp_path.glob("rcj-challenge-report-*.txt")
    assert "Traceback" in report.read_text("utf-8")
    assert b"Traceback" not in done.stderr
