"""Private folders: those of a match that lives are its own, those of a match that was killed are removed by the next."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from fake_match import SPEC, FakeMatch, Played, play_on

from rcj_challenges.programs import private_folders
from rcj_challenges.programs.private_folders import LOCK_FILE, PREFIX, PrivateFolders, remove_left_overs

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
posix = pytest.mark.skipif(sys.platform == "win32", reason="Windows has other links and owners")

MATCH = """
import sys
from pathlib import Path
sys.path[:0] = [sys.argv[2], sys.argv[3]]
from fake_match import SPEC, FakeMatch, Played, play_on
match = FakeMatch(Path(sys.argv[1]))
with match.pool() as pool:
    program = pool.add(SPEC, match.team("from controller import Robot\\nrobot = Robot()\\nwhile robot.step(32) != -1: pass\\n"), "robot.py")
    pool.launch()
    play_on(program, Played(), 1)
    print("plays", flush=True)
    sys.stdin.read()
"""


@pytest.fixture
def temporary(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A temporary folder of this test's own, which this process has not looked through yet."""
    folder = tmp_path / "temporary"
    folder.mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(folder))
    private_folders.remove_left_overs_once.cache_clear()
    yield folder
    private_folders.remove_left_overs_once.cache_clear()


@contextmanager
def match_elsewhere(temporary: Path, folder: Path) -> Iterator[subprocess.Popen[str]]:
    """A match in a process of its own, in the middle of its play."""
    folder.mkdir()
    command = [sys.executable, "-c", MATCH, str(folder), str(HERE), str(ROOT)]
    environment = os.environ | dict.fromkeys(("TMPDIR", "TEMP", "TMP"), str(temporary))
    pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "encoding": "utf-8"}
    with subprocess.Popen(command, env=environment, **pipes) as process:  # type: ignore[call-overload]
        assert process.stdout is not None
        assert process.stdout.readline() == "plays\n"
        yield process
        if process.poll() is None:
            process.kill()


def play(folder: Path) -> None:
    """Play a match in this process, from the launch of its program to its end."""
    match = FakeMatch(folder)
    with match.pool() as pool:
        program = pool.add(SPEC, match.team("patterns/prints_on_every_tick"), "prints_on_every_tick.py")
        pool.launch()
        play_on(program, Played(), 1)


def left_over(temporary: Path, name: str = "dead") -> Path:
    """The place of a match that is dead."""
    place = temporary / f"{PREFIX}{name}"
    (place / "rcj-Y1-x" / "controllers").mkdir(parents=True)
    (place / "rcj-Y1-x" / "controllers" / "robot.py").touch()
    (place / LOCK_FILE).touch()
    return place


def test_what_a_killed_match_left_is_removed_by_the_next_one_and_that_of_a_living_match_is_not(
    temporary: Path, tmp_path: Path
) -> None:
    with match_elsewhere(temporary, tmp_path / "living"):
        (lives,) = temporary.iterdir()
        with match_elsewhere(temporary, tmp_path / "dies") as dies:
            (left,) = set(temporary.iterdir()) - {lives}
            dies.kill()
            dies.wait()
            assert any(path.name == "controllers" for path in left.rglob("*"))
            before = sorted(lives.rglob("*"))
            play(tmp_path)
            # Its program ends with it, in a moment: what that may still have written, a later match removes.
            remove_left_overs(temporary)
        assert list(temporary.iterdir()) == [lives]
        assert sorted(lives.rglob("*")) == before != []


def test_several_matches_in_one_process_leave_each_other_alone(temporary: Path) -> None:
    first, second = PrivateFolders(), PrivateFolders()
    remove_left_overs(temporary)
    assert {first.place, second.place} == {path.resolve() for path in temporary.iterdir()}
    first.close()
    remove_left_overs(temporary)
    assert [path.resolve() for path in temporary.iterdir()] == [second.place]
    second.close()
    second.close()
    assert list(temporary.iterdir()) == []


def test_a_process_looks_for_left_overs_but_once(temporary: Path, tmp_path: Path) -> None:
    first = left_over(temporary)
    play(tmp_path)
    assert not first.exists()
    second = left_over(temporary)
    play(tmp_path)
    assert second.exists()


def test_a_match_that_died_before_it_could_lock_anything_leaves_nothing_either(temporary: Path) -> None:
    left_over(temporary, "early").joinpath(LOCK_FILE).unlink()
    (temporary / f"{PREFIX}earlier").mkdir()
    remove_left_overs(temporary)
    assert list(temporary.iterdir()) == []


def test_only_what_is_called_as_the_place_of_a_match_is_looked_at(temporary: Path) -> None:
    kept = [temporary / "rcj-matches", temporary / "rcj-check-1", temporary / "somebody's"]
    for folder in kept:
        folder.mkdir()
    (temporary / f"{PREFIX}file").touch()
    remove_left_overs(temporary)
    assert sorted(temporary.iterdir()) == sorted([*kept, temporary / f"{PREFIX}file"])


@posix
def test_a_link_in_the_place_of_a_match_is_not_followed(temporary: Path, tmp_path: Path) -> None:
    treasure = left_over(tmp_path)
    (temporary / f"{PREFIX}link").symlink_to(treasure, target_is_directory=True)
    remove_left_overs(temporary)
    assert (treasure / "rcj-Y1-x" / "controllers" / "robot.py").exists()


@posix
@pytest.mark.parametrize("kind", ["link", "link to nothing", "pipe", "folder"])
def test_what_a_program_put_in_the_place_of_the_lock_is_neither_followed_nor_waited_for(
    temporary: Path, tmp_path: Path, kind: str
) -> None:
    place = left_over(temporary)
    lock, outside = place / LOCK_FILE, tmp_path / "outside"
    lock.unlink()
    if kind == "pipe":
        os.mkfifo(lock)
    elif kind == "folder":
        lock.mkdir()
    else:
        lock.symlink_to(outside)
    if kind == "link":
        outside.touch()
    remove_left_overs(temporary)
    assert place.exists(), "nothing proves that it is unused"
    assert outside.exists() == (kind == "link")


@posix
@pytest.mark.skipif(sys.platform == "win32" or os.geteuid() != 0, reason="only root can give folders away")
def test_the_places_of_other_users_are_left_alone(temporary: Path) -> None:
    place = left_over(temporary)
    os.chown(place, 65534, -1)
    remove_left_overs(temporary)
    assert (place / "rcj-Y1-x").exists()


def test_a_place_that_another_match_takes_for_a_left_over_before_it_is_locked_is_left_to_it(
    temporary: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    made, really_locked, opened = [], private_folders.try_lock, os.open

    def taken_before_it_is_opened(*arguments: object, **more: object) -> int:
        if not made:
            made.append("opened too late")
            monkeypatch.setattr(os, "open", opened)
            remove_left_overs(temporary)
        return opened(*arguments, **more)  # type: ignore[arg-type]

    def taken_before_it_is_locked(fd: int) -> bool:
        if len(made) == 1:
            made.append("locked too late")
            remove_left_overs(temporary)
        return really_locked(fd)

    monkeypatch.setattr(os, "open", taken_before_it_is_opened)
    monkeypatch.setattr(private_folders, "try_lock", taken_before_it_is_locked)
    folders = PrivateFolders()
    assert made == ["opened too late", "locked too late"]
    assert [path.resolve() for path in temporary.iterdir()] == [folders.place]
    remove_left_overs(temporary)
    assert (folders.place / LOCK_FILE).exists()
    folders.close()


def test_where_files_cannot_be_locked_matches_play_and_nothing_is_removed(
    temporary: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def none_here(fd: int) -> bool:
        raise OSError("no locks available")

    monkeypatch.setattr(private_folders, "try_lock", none_here)
    left = left_over(temporary)
    folders = PrivateFolders()
    remove_left_overs(temporary)
    assert left.exists()
    assert folders.place.exists()
    folders.close()
    assert not folders.place.exists()


def test_a_temporary_folder_that_cannot_be_read_is_no_reason_not_to_play(tmp_path: Path) -> None:
    remove_left_overs(tmp_path / "none")
