"""The private folder of a program is measured and removed, whatever the program made of it."""

from __future__ import annotations

import math
import mmap
import os
import shutil
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

from rcj_challenges.programs import scratch

linux = pytest.mark.skipif(sys.platform != "linux", reason="not reported elsewhere")
posix = pytest.mark.skipif(sys.platform == "win32", reason="paths of Windows end before this depth")


def nest(folder: Path, depth: int) -> None:
    """Make folders inside each other, deeper than a path can be long, with a file in the innermost."""
    descriptor = os.open(folder, os.O_RDONLY)
    for _ in range(depth):
        os.mkdir("d" * 20, dir_fd=descriptor)
        inner = os.open("d" * 20, os.O_RDONLY, dir_fd=descriptor)
        os.close(descriptor)
        descriptor = inner
    os.close(os.open("file", os.O_WRONLY | os.O_CREAT, dir_fd=descriptor))
    os.close(descriptor)


def test_files_count_by_their_size_and_for_at_least_a_block(tmp_path: Path) -> None:
    (tmp_path / "large").write_bytes(bytes(100_000))
    assert scratch.has_more_than(tmp_path, 99_999)
    assert not scratch.has_more_than(tmp_path, 100_000)
    (tmp_path / "empty").touch()
    (tmp_path / "folder").mkdir()
    assert scratch.has_more_than(tmp_path, 100_000 + 2 * scratch._ENTRY_BYTES - 1)
    assert not scratch.has_more_than(tmp_path, 100_000 + 2 * scratch._ENTRY_BYTES)


@linux
def test_a_deleted_file_that_is_open_counts_by_its_size_also_if_it_is_mapped(tmp_path: Path) -> None:
    before = scratch.nameless_bytes(os.getpid(), -1, tmp_path)
    with (tmp_path / "table").open("wb+") as file:
        file.write(bytes(100_000))
        file.flush()
        with mmap.mmap(file.fileno(), 4096), mmap.mmap(-1, 4096):  # the second one is memory and no file
            assert scratch.nameless_bytes(os.getpid(), -1, tmp_path) == before
            (tmp_path / "table").unlink()
            assert scratch.nameless_bytes(os.getpid(), -1, tmp_path) == before + 100_000


@linux
def test_a_deleted_folder_that_is_open_counts_by_the_blocks_of_the_names_that_were_in_it(tmp_path: Path) -> None:
    folder = tmp_path / "folder"
    folder.mkdir()
    names = [folder / f"{number:0>200}" for number in range(300)]
    for name in names:
        name.touch()
    before = scratch.nameless_bytes(os.getpid(), -1, tmp_path)
    for name in names:
        name.unlink()
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        folder.rmdir()
        held = 512 * os.fstat(descriptor).st_blocks
        if not held:
            pytest.skip("this file system gives the room back at once")
        assert scratch.nameless_bytes(os.getpid(), -1, tmp_path) == before + held
    finally:
        os.close(descriptor)


@posix
def test_folders_nested_too_deep_to_be_measured_are_more_than_any_limit_allows(tmp_path: Path) -> None:
    inner = tmp_path / "inner"
    inner.mkdir()
    nest(inner, 400)
    assert scratch.has_more_than(tmp_path, 10**12)
    scratch.remove(tmp_path)
    assert not tmp_path.exists()


@posix
def test_links_are_removed_and_not_followed(tmp_path: Path) -> None:
    outside = tmp_path / "outside"
    outside.mkdir()
    (outside / "kept").touch()
    private = tmp_path / "private"
    private.mkdir()
    (private / "link").symlink_to(outside)
    nest(private, 300)
    scratch.remove(private)
    assert not private.exists()
    assert (outside / "kept").exists()


@posix
def test_folders_without_permissions_are_removed(tmp_path: Path) -> None:
    private = tmp_path / "private"
    (private / "a" / "b" / "c").mkdir(parents=True)
    (private / "a" / "b" / "file").touch()
    for folder in (private / "a" / "b", private / "a", private):
        folder.chmod(0)
    scratch.remove(private)
    assert not private.exists()


def test_a_folder_that_is_not_there_is_no_error(tmp_path: Path) -> None:
    scratch.remove(tmp_path / "none")
    assert not scratch.has_more_than(tmp_path / "none", 0)


def test_whoever_fills_a_disk_has_written_more_than_a_share(monkeypatch: pytest.MonkeyPatch) -> None:
    def share_bytes(free_bytes: int) -> float:
        monkeypatch.setattr(shutil, "disk_usage", lambda _: SimpleNamespace(free=free_bytes))
        return scratch.share_bytes(Path(), 4)

    # It is full when less than a megabyte is left: of four that wrote alike each has more than this then.
    assert share_bytes(41_000_000) == 9_000_000
    assert share_bytes(1_500_000) == math.inf, "full before anybody wrote"
