"""The process that reads a team's sources ends with the check, and by itself."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path, PurePosixPath

import pytest

from rcj_challenges.checker import reader, reading
from rcj_challenges.checker.reading import Source
from rcj_challenges.checker.unreadable import describe_error

NAME = PurePosixPath("robot.py")
# Python compares each name with each other one: that takes minutes.
SLOW = f"f({', '.join(f'a{number}=1' for number in range(100_000))})\n"


def test_interrupted_check_leaves_no_reader_behind(monkeypatch: pytest.MonkeyPatch) -> None:
    started = []

    class Interrupted(subprocess.Popen):
        def communicate(self, data: bytes | None = None, timeout: float | None = None) -> tuple[bytes, bytes]:
            started.append(self)
            try:
                super().communicate(data, 0.2)
            except subprocess.TimeoutExpired:
                raise KeyboardInterrupt from None
            pytest.fail("this file was to be read for longer")

    monkeypatch.setattr(subprocess, "Popen", Interrupted)
    monkeypatch.setattr(reading, "MAX_BYTES", len(SLOW))
    monkeypatch.setattr(reading, "MAX_ALL_BYTES", len(SLOW))
    with pytest.raises(KeyboardInterrupt):
        reading.read_sources({NAME: SLOW.encode()})
    (process,) = started
    try:
        assert process.wait(5) is not None
    finally:
        process.kill()


@pytest.mark.skipif(sys.platform == "win32", reason="processor time is limited by POSIX alone")
def test_a_reader_exits_by_itself_after_its_check_was_killed() -> None:
    ask = "import reader, resource; reader.limit_itself(); print(*resource.getrlimit(resource.RLIMIT_CPU))"
    done = subprocess.run(
        [sys.executable, "-c", ask], cwd=Path(reader.__file__).parent, capture_output=True, text=True, check=True
    )
    limits_s = [int(limit) for limit in done.stdout.split()]
    assert reading.PATIENCE_S < max(limits_s) <= 2 * reading.PATIENCE_S


def _reading(names: list[str], in_a_round: int, monkeypatch: pytest.MonkeyPatch) -> dict[str, str]:
    """Return what is wrong with files of which so many are read before patience ends; of a hard one nothing is."""

    def ask(paths: list[PurePosixPath], _files: object, _max_imports: int) -> tuple[list[reading.Source], str]:
        done = [path.name.startswith("hard") for path in paths[:in_a_round]]
        return [reading.Source()] * (done.index(True) if True in done else len(done)), "slow"

    monkeypatch.setattr(reading, "_ask", ask)
    found = reading.read_sources({PurePosixPath(f"{name}.py"): name.encode() for name in names})
    assert [path.stem for path in found] == names
    return {path.stem: source.wrong for path, source in found.items() if source.wrong}


def test_large_library_that_is_not_read_at_once_is_read_on(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Which of its files is in hand when patience ends is chance."""
    assert _reading([f"part_{number}" for number in range(9)], 2, monkeypatch) == {}


def test_file_that_takes_too_long_by_itself_is_reported_wherever_it_stands(monkeypatch: pytest.MonkeyPatch) -> None:
    assert _reading(["part_1", "hard_1", "part_2", "hard_2"], 3, monkeypatch) == {"hard_1": "slow", "hard_2": "slow"}


def test_files_that_are_not_reached_are_reported_as_unread(monkeypatch: pytest.MonkeyPatch) -> None:
    names = [*(f"hard_{number}" for number in range(30)), "robot"]
    wrong = _reading(names, 1, monkeypatch)
    assert wrong["hard_0"] == "slow"
    assert wrong["robot"] == "unread"


def test_files_beyond_the_bound_are_not_read_and_equal_ones_count_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(reading, "MAX_BYTES", 100)
    monkeypatch.setattr(reading, "MAX_ALL_BYTES", 200)
    names = {"a": "x", "b": "y", "c": "y", "d": "z", "e": "xx", "robot": "w"}
    files = {PurePosixPath(f"{name}.py"): f"{letter} = 1".encode().ljust(90) for name, letter in names.items()}
    files[PurePosixPath("e.py")] = b"#" * 101
    found = reading.read_sources(files, [PurePosixPath("robot.py")])
    wrong = {path.stem: source.wrong for path, source in found.items()}
    assert wrong == {"a": "", "b": "unread", "c": "unread", "d": "unread", "e": "large", "robot": ""}


def test_imports_beyond_the_bound_are_not_read(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(reading, "MAX_IMPORTS", 6)
    sources = {"a": b"import x, y", "b": b"from x import y, z", "c": b"import x, z", "d": b"import y"}
    found = reading.read_sources({PurePosixPath(f"{name}.py"): source for name, source in sources.items()})
    assert {path.stem: source.wrong for path, source in found.items()} == {"a": "", "b": "", "c": "imports", "d": ""}


@pytest.mark.parametrize(
    "encoding", ["utf-8", "latin-1", "cp1252", "iso-8859-15", "koi8-r", "gbk", "shift_jis", "euc-kr"]
)
def test_files_in_usual_encodings_are_read(encoding: str) -> None:
    assert reader.read_source(f"# coding: {encoding}\nimport a\n".encode(), "robot.py")["imports"]


@pytest.mark.parametrize(
    "source",
    [
        b"# coding: punycode\n",
        b"\xef\xbb\xbf# coding: punycode\n",
        b"\n# vim: set fileencoding=IDNA :\n",
        b"#\r# coding: punycode\r",
        b"# coding: unicode_escape\n",
    ],
)
def test_files_in_odd_encodings_are_not_decoded(source: bytes) -> None:
    assert reader.read_source(source + b"a" * 70_000, "robot.py")["wrong"] == "odd_encoding"


def test_words_about_encodings_below_the_second_line_mean_nothing() -> None:
    assert "imports" in reader.read_source(b"import a\n# coding: punycode\n", "robot.py")


@pytest.mark.parametrize("head", [b"", b"# coding: utf-8\n", b"\xef\xbb\xbf"])
def test_a_comment_that_is_not_utf8_is_refused_with_its_line(head: bytes) -> None:
    """Python refuses such a file when it runs it; `compile` passes over comments."""
    error = reader.read_source(head + b"import a\n# f\xfcr\n", "robot.py")
    assert error["line"] == head.count(b"\n") + 2
    assert describe_error(Source(wrong=error["wrong"], message=error["message"]), b"")[0] == "sources.encoding"
