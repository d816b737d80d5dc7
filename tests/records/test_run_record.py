"""Of a damaged record everything that can be shown is shown, with a sentence about what is wrong."""

import contextlib
import errno
import json
import os
import shutil
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.folder import REFEREE_LOG
from rcj_challenges.records.referee_log import RefereeLog, read_referee_log
from rcj_challenges.records.run_record import read_run
from rcj_challenges.records.trajectory import Trajectory
from tests.made_up_runs import (
    begun_run,
    write_made_up_run,
)

FILE = "trajectory.chunks"
TICKS = 60


@pytest.fixture(scope="module")
def good(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_made_up_run(tmp_path_factory.mktemp("runs"), ticks=TICKS, halves=2)


def damaged(good: Path, folder: Path, data: bytes) -> Path:
    shutil.copytree(good, folder)
    (folder / FILE).write_bytes(data)
    return folder


def whole(good: Path) -> bytes:
    return (good / FILE).read_bytes()


def code(folder: Path, named: str = "") -> str:
    """Return the code with which a record is refused, in an error that names something."""
    with pytest.raises(RecordError) as refused:
        read_run(folder)
    assert named in refused.value.message
    return refused.value.diagnostics[0].code


def test_a_whole_record_has_no_problem(good: Path) -> None:
    run = read_run(good)
    assert run.problems == ()
    assert [half.ticks for half in run.halves] == [TICKS, TICKS]


def test_of_a_file_that_lost_its_end_the_first_half_is_whole(good: Path, tmp_path: Path) -> None:
    run = read_run(damaged(good, tmp_path / "run", whole(good)[: int(len(whole(good)) * 0.8)]))
    first, second = run.halves
    sound = Trajectory.open(good).halves
    assert list(first.snapshots()) == list(sound[0].snapshots())
    assert first.placements == sound[0].placements
    assert 0 < second.ticks < TICKS
    assert np.array_equal(second.substeps, sound[1].substeps[: second.ticks])
    assert second.info.teams == {"blue": "yellow", "yellow": "blue"}
    (problem,) = run.problems
    assert f"{first.ticks + second.ticks} ticks" in problem
    assert f"1.9 s of half 1, {second.ticks * 0.032:.1f} s of half 2" in problem


def test_an_interrupted_run_is_described_in_words(good: Path, tmp_path: Path) -> None:
    folder = Path(shutil.copytree(good, tmp_path / "run"))
    result = json.loads((folder / "result.json").read_bytes())
    broken_off = json.dumps({**result, "complete": False, "stopped": "KeyboardInterrupt"})
    (folder / "result.json").write_text(broken_off, encoding="utf-8")
    (problem,) = read_run(folder).problems
    assert problem.startswith("This run was not played to its end (it was interrupted): what was recorded is shown, ")


def test_where_no_pose_is_left_there_is_nothing_to_show(good: Path, tmp_path: Path) -> None:
    data = whole(good)
    assert code(damaged(good, tmp_path / "run", data[: data.index(b"\n") + 1] + b"nothing of ours")) == "record-damaged"


def test_a_run_that_ended_before_its_first_tick_has_nothing_to_show(tmp_path: Path) -> None:
    writer = begun_run(tmp_path, 0)
    writer.finish({"complete": False})
    assert code(writer.folder) == "record-empty"


@given(
    cut=st.integers(0, 60_000),
    damage=st.lists(st.tuples(st.integers(0, 60_000), st.integers(0, 255)), max_size=20),
)
def test_any_damage_leaves_the_ticks_before_it_or_is_refused(
    cut: int, damage: list, good: Path, tmp_path_factory: pytest.TempPathFactory
) -> None:
    data = bytearray(whole(good))
    for place, byte in damage:
        data[place % len(data)] = byte
    folder = damaged(good, tmp_path_factory.mktemp("runs") / "run", bytes(data[: len(data) - cut % len(data)]))
    with contextlib.suppress(RecordError):
        run = read_run(folder)
        assert all(half.ticks and half.heights.shape == (half.ticks, 7) for half in run.halves)


@pytest.mark.parametrize(
    ("name", "text", "expected"),
    [
        ("result.json", None, "record-incomplete"),
        ("result.json", '{"hello": 1}', "record-damaged"),
        ("result.json", '{"record": 2, "comp', "record-unreadable"),
        ("result.json", "[]", "record-damaged"),
        ("scenario.json", "[]", "record-damaged"),
        ("scenario.json", '{"id": "x"', "record-damaged"),
        ("scenario.json", None, "record-incomplete"),
        ("trajectory.chunks", None, "record-incomplete"),
    ],
)
def test_a_file_that_is_missing_or_damaged_is_named(
    name: str, text: str | None, expected: str, good: Path, tmp_path: Path
) -> None:
    folder = tmp_path / "run"
    shutil.copytree(good, folder)
    (folder / name).unlink()
    if text is not None:
        (folder / name).write_text(text, "utf-8")
    assert code(folder, name) == expected


def test_a_scenario_that_was_changed_to_one_that_cannot_be_played_is_refused(good: Path, tmp_path: Path) -> None:
    folder = Path(shutil.copytree(good, tmp_path / "run"))
    scenario = json.loads((folder / "scenario.json").read_text("utf-8"))
    scenario["robots"]["B1"]["kit"] = "v3"
    (folder / "scenario.json").write_text(json.dumps(scenario), "utf-8")
    assert code(folder, "robots.B1.kit") == "record-damaged"


def test_a_trajectory_of_another_scenario_is_refused(good: Path, tmp_path: Path) -> None:
    other = write_made_up_run(tmp_path, ticks=5, halves=1, robots_per_team=1)
    assert code(damaged(good, tmp_path / "run", whole(other))) == "record-damaged"


@pytest.mark.parametrize("name", ["result.json", "scenario.json"])
def test_a_file_that_cannot_be_read_is_not_taken_for_damaged(
    good: Path, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    opened = os.open

    def refuses(path: str | Path, *arguments: int, **more: int) -> int:
        if Path(path).name == name:
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES), str(path))
        return opened(path, *arguments, **more)

    monkeypatch.setattr(os, "open", refuses)
    assert code(good, f"{name} cannot be read") == "record-unreadable"


_DEEP = b"[" * 100_000


@pytest.mark.parametrize("name", ["result.json", "scenario.json"])
def test_a_file_that_is_nested_too_deeply_is_damaged(good: Path, tmp_path: Path, name: str) -> None:
    folder = damaged(good, tmp_path / "run", whole(good))
    (folder / name).write_bytes(_DEEP)
    assert code(folder, name) in {"record-unreadable", "record-damaged"}


def test_a_line_of_the_referees_log_that_is_nested_too_deeply_is_no_line(good: Path, tmp_path: Path) -> None:
    folder = damaged(good, tmp_path / "run", whole(good))
    ticks = read_referee_log(folder).ticks
    with (folder / REFEREE_LOG).open("ab") as log:
        log.write(_DEEP + b"\n")
    assert read_referee_log(folder) == RefereeLog(ticks, damaged_lines=1)
