"""Files that another program has open: Windows refuses to replace or remove them, so that is done later."""

import errno
import os
from collections.abc import Callable
from pathlib import Path

import pytest

from rcj_challenges.records import folder as record_folder
from rcj_challenges.records.errors import UnwritableError
from rcj_challenges.records.folder import replaced

ACCESS_DENIED, SHARING_VIOLATION = 5, 32


def held(path: Path, winerror: int | None) -> PermissionError:
    """Return what Windows raises of a file that is open elsewhere; without ``winerror`` any system's refusal."""
    error = PermissionError(errno.EACCES, "Access is denied", str(path))
    if winerror is not None:
        error.winerror = winerror  # type: ignore[attr-defined, unused-ignore]
    return error


@pytest.fixture
def refuse(monkeypatch: pytest.MonkeyPatch) -> Callable[[object, str, int | None, float], list[Path]]:
    """Let a function refuse a number of times; what it returns grows by each refusal."""

    def refuse(owner: object, name: str, winerror: int | None, times: float) -> list[Path]:
        original, refused = getattr(owner, name), []

        def refusing(path: Path, *arguments: object, **named: object) -> object:
            if len(refused) < times:
                refused.append(path)
                raise held(path, winerror)
            return original(path, *arguments, **named)

        monkeypatch.setattr(owner, name, refusing)
        return refused

    monkeypatch.setattr(record_folder, "_POLL_INTERVAL_S", 0.0)
    return refuse


@pytest.mark.parametrize("winerror", [ACCESS_DENIED, SHARING_VIOLATION])
def test_a_file_that_is_open_elsewhere_for_a_moment_is_replaced_after_that(tmp_path: Path, refuse, winerror) -> None:
    path = tmp_path / "result.json"
    path.write_bytes(b"old")
    refused = refuse(Path, "replace", winerror, 3)
    with replaced(path) as file:
        file.write(b"new")
    assert path.read_bytes() == b"new"
    assert len(refused) == 3
    assert list(tmp_path.iterdir()) == [path]


def test_who_keeps_a_file_open_is_not_waited_for_without_end(tmp_path: Path, refuse, monkeypatch) -> None:
    monkeypatch.setattr(record_folder, "_WAIT_FOR_OTHERS_S", 0.01)
    path = tmp_path / "result.json"
    path.write_bytes(b"old")
    refuse(Path, "replace", ACCESS_DENIED, float("inf"))
    with pytest.raises(PermissionError) as caught, replaced(path) as file:
        file.write(b"new")
    assert path.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [path]
    unwritable = UnwritableError.of(caught.value, tmp_path)
    assert unwritable is not None
    assert "result.json" in unwritable.message
    assert "--out" in unwritable.diagnostics[0].help


def test_a_file_refused_for_another_reason_is_tried_once(tmp_path: Path, refuse) -> None:
    refused = refuse(Path, "replace", None, float("inf"))
    with pytest.raises(PermissionError), replaced(tmp_path / "result.json") as file:
        file.write(b"new")
    assert len(refused) == 1


def test_two_processes_that_write_one_file_at_once_do_not_meet(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    page = tmp_path / "replay.html"
    with replaced(page) as first:
        first.write(b"first")
        monkeypatch.setattr(os, "getpid", lambda: 4711)
        with replaced(page) as second:
            second.write(b"second, and longer")
        assert page.read_bytes() == b"second, and longer"
        monkeypatch.undo()
    assert page.read_bytes() == b"first"
    assert list(tmp_path.iterdir()) == [page]
