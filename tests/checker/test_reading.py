"""The process that reads a team's sources: it ends with who asked, and by itself."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path, PurePosixPath

import pytest

from rcj_challenges.checker import reader, reading

NAME = PurePosixPath("robot.py")
# Python compares each name with each other one: that takes minutes.
SLOW = f"f({', '.join(f'a{number}=1' for number in range(100_000))})\n"


def test_who_stops_waiting_for_the_reader_leaves_none_behind(monkeypatch: pytest.MonkeyPatch) -> None:
    started = []

    class Interrupted(subprocess.Popen):
        def communicate(self, told: bytes | None = None, timeout: float | None = None) -> tuple[bytes, bytes]:
            started.append(self)
            try:
                super().communicate(told, 0.2)
            except subprocess.TimeoutExpired:
                raise KeyboardInterrupt from None
            pytest.fail("this file was to be read for longer")

    monkeypatch.setattr(subprocess, "Popen", Interrupted)
    with pytest.raises(KeyboardInterrupt):
        reading.read_sources({NAME: SLOW.encode()})
    (process,) = started
    try:
        assert process.wait(5) is not None
    finally:
        process.kill()


@pytest.mark.skipif(sys.platform == "win32", reason="processor time is limited by POSIX alone")
def test_a_reader_whose_check_was_killed_comes_to_its_end_by_itself() -> None:
    ask = "import reader, resource; reader.limit_itself(); print(*resource.getrlimit(resource.RLIMIT_CPU))"
    told = subprocess.run(
        [sys.executable, "-c", ask], cwd=Path(reader.__file__).parent, capture_output=True, text=True, check=True
    )
    limits_s = [int(limit) for limit in told.stdout.split()]
    assert reading.PATIENCE_S < max(limits_s) <= 2 * reading.PATIENCE_S


def _reading(names: list[str], in_a_round: int, monkeypatch: pytest.MonkeyPatch) -> dict[str, str]:
    """Return what is wrong with files of which so many are read before patience ends; of a hard one nothing is."""

    def ask(paths: list[PurePosixPath], _files: object) -> tuple[list[reading.Source], str]:
        done = [path.name.startswith("hard") for path in paths[:in_a_round]]
        return [reading.Source()] * (done.index(True) if True in done else len(done)), "slow"

    monkeypatch.setattr(reading, "_ask", ask)
    found = reading.read_sources({PurePosixPath(f"{name}.py"): b"" for name in names})
    assert [path.stem for path in found] == names
    return {path.stem: source.wrong for path, source in found.items() if source.wrong}


def test_a_large_library_that_is_not_read_at_once_on_a_busy_computer_is_read_on(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Which of its files is in hand when patience ends is chance."""
    assert _reading([f"part_{number}" for number in range(9)], 2, monkeypatch) == {}


def test_a_file_that_takes_too_long_by_itself_is_told_wherever_it_stands(monkeypatch: pytest.MonkeyPatch) -> None:
    assert _reading(["part_1", "hard_1", "part_2", "hard_2"], 3, monkeypatch) == {"hard_1": "slow", "hard_2": "slow"}


def test_of_what_nobody_came_to_no_fault_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    names = [*(f"hard_{number}" for number in range(30)), "robot"]
    wrong = _reading(names, 1, monkeypatch)
    assert wrong["hard_0"] == "slow"
    assert wrong["robot"] == "unread"
