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
