"""Of a damaged record everything that can be shown is shown, with a sentence about what is wrong."""

import errno
import json
import os
import shutil
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.folder import REFEREE_LOG, TRAJECTORY_PARTS
from rcj_challenges.records.recorded_scenario import read_scenario
from rcj_challenges.records.referee_log import read_referee_log
from rcj_challenges.records.salvage import read_halves, read_run
from rcj_challenges.records.testing import (
    begun_run,
    write_made_up_run,
)
from rcj_challenges.records.trajectory import Trajectory

TICKS = 60


@pytest.fixture(scope="module")
def good(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_made_up_run(tmp_path_factory.mktemp("runs"), ticks=TICKS, halves=2)


def damaged(good: Path, folder: Path, data: bytes) -> Path:
    shutil.copytree(good, folder)
    (folder / "trajectory.npz").write_bytes(data)
    return folder


def whole(good: Path) -> bytes:
    return (good / "trajectory.npz").read_bytes()


def test_a_whole_record_has_no_problem(good: Path) -> None:
    run = read_run(good)
    assert run.problems == ()
    assert [half.ticks for half in run.halves] == [TICKS, TICKS]


def test_of_a_file_that_lost_its_end_the_first_half_is_whole(good: Path, tmp_path: Path) -> None:
    run = read_run(damaged(good, tmp_path / "run", whole(good)[: int(len(whole(good)) * 0.7)]))
    first, second = run.halves
    sound = Trajectory.open(good).halves
    assert list(first.snapshots()) == list(sound[0].snapshots())
    assert first.placements == sound[0].placements
    assert 0 < second.ticks < TICKS
    assert np.array_equal(second.substeps, sound[1].substeps[: second.ticks])
    assert second.info.teams == {"blue": "yellow", "yellow": "blue"}
    assert "damaged" in run.problems[0]
    assert str(first.ticks + second.ticks) in run.problems[0]
    assert f"1.9 s of half 1, {second.ticks * 0.032:.1f} s of half 2" in run.problems[0]


def test_of_a_file_that_lost_the_facts_of_its_half_the_poses_are_kept(good: Path, tmp_path: Path) -> None:
    run = read_run(damaged(good, tmp_path / "run", whole(good)[:9000]))
    (half,) = run.halves
    assert half.info.team_names == {"blue": "Hanse", "yellow": "Alster"}
    assert half.info.half == 1
    assert half.ticks > 20
    assert half.heights[-1, 0] == pytest.approx(0.0375)
    assert half.heights[-1, 6] == pytest.approx(0.021)


def test_of_a_run_that_somebody_broke_off_it_is_said_in_words(good: Path, tmp_path: Path) -> None:
    folder = Path(shutil.copytree(good, tmp_path / "run"))
    result = json.loads((folder / "result.json").read_bytes())
    broken_off = json.dumps({**result, "complete": False, "stopped": "KeyboardInterrupt"})
    (folder / "result.json").write_text(broken_off, encoding="utf-8")
    (problem,) = read_run(folder).problems
    assert problem.startswith("This run was not played to its end (it was interrupted): what was recorded is shown, ")


def test_where_no_pose_is_left_everything_stands_at_its_start_for_the_events_to_be_shown(
    good: Path, tmp_path: Path
) -> None:
    run = read_run(damaged(good, tmp_path / "run", b"nothing of ours"))
    assert [half.ticks for half in run.halves] == [TICKS, TICKS]
    assert run.halves[0].substeps[5, 3, 0].tolist() == pytest.approx([-0.3, 0.3, -1.57])
    assert "stands at its start" in run.problems[0]


def test_who_shows_poses_gets_none_that_nobody_recorded(good: Path, tmp_path: Path) -> None:
    folder = damaged(good, tmp_path / "run", b"nothing of ours")
    with pytest.raises(RecordError, match="the trajectory is damaged"):
        read_halves(folder, read_scenario(folder), None, standing=False)


def test_of_a_file_whose_facts_are_lost_with_the_result_teams_are_called_by_their_seats(
    good: Path, tmp_path: Path
) -> None:
    folder = damaged(good, tmp_path / "run", whole(good)[:9000])
    (half,), _ = read_halves(folder, read_scenario(folder), None)
    assert half.info.team_names == {"blue": "blue", "yellow": "yellow"}
    assert half.info.scores == {"blue": 0, "yellow": 0}


def test_of_a_killed_run_whose_touches_are_lost_the_poses_are_kept(tmp_path: Path) -> None:
    """As after a power cut: what was written last need not be on the disk."""
    writer = begun_run(tmp_path, 100)
    killed = Path(shutil.copytree(writer.folder, tmp_path / "killed"))
    writer.finish({"complete": False})
    sound = read_run(killed)
    (touches,) = (killed / TRAJECTORY_PARTS).glob("half-1.touches")
    assert touches.stat().st_size
    touches.write_bytes(touches.read_bytes()[:-2])
    run = read_run(killed)
    assert np.array_equal(run.halves[0].substeps, sound.halves[0].substeps)
    assert len(sound.problems) == 1
    assert run.problems[0] == sound.problems[0]
    assert "3.2 s of half 1" in run.problems[1]


def test_a_flipped_bit_costs_nothing_but_a_warning(good: Path, tmp_path: Path) -> None:
    data = bytearray(whole(good))
    data[5000] ^= 0x40
    run = read_run(damaged(good, tmp_path / "run", bytes(data)))
    assert [half.ticks for half in run.halves] == [TICKS, TICKS]
    assert run.problems


@settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    cut=st.integers(0, 60_000),
    damage=st.lists(st.tuples(st.integers(0, 60_000), st.integers(0, 255)), max_size=20),
)
def test_any_damage_leaves_something_to_show(
    cut: int, damage: list, good: Path, tmp_path_factory: pytest.TempPathFactory
) -> None:
    data = bytearray(whole(good))
    for place, byte in damage:
        data[place % len(data)] = byte
    folder = damaged(good, tmp_path_factory.mktemp("runs") / "run", bytes(data[: len(data) - cut % len(data)]))
    run = read_run(folder)
    assert run.halves
    assert all(half.ticks and half.heights.shape == (half.ticks, 7) for half in run.halves)


@pytest.mark.parametrize(
    ("name", "text", "says"),
    [
        ("result.json", None, "no record of a run"),
        ("result.json", '{"hello": 1}', "result.json is damaged"),
        ("result.json", '{"record": 1, "comp', "result.json cannot be read"),
        ("result.json", "[]", "result.json is damaged"),
        ("scenario.json", "[]", "scenario.json is damaged"),
        ("scenario.json", '{"id": "x"', "scenario.json is damaged"),
        ("scenario.json", None, "scenario.json is missing"),
        ("trajectory.npz", None, "trajectory is missing"),
    ],
)
def test_what_is_no_record_is_refused_by_the_name_of_the_file(
    name: str, text: str | None, says: str, good: Path, tmp_path: Path
) -> None:
    folder = tmp_path / "run"
    shutil.copytree(good, folder)
    (folder / name).unlink()
    if text is not None:
        (folder / name).write_text(text, "utf-8")
    with pytest.raises(RecordError, match=says):
        read_run(folder)


def test_a_trajectory_that_is_no_file_is_told_by_its_name(good: Path, tmp_path: Path) -> None:
    shutil.copytree(good, tmp_path / "run")
    (tmp_path / "run" / "trajectory.npz").unlink()
    (tmp_path / "run" / "trajectory.npz").mkdir()
    with pytest.raises(RecordError, match=r"^run: trajectory\.npz cannot be read: "):
        read_run(tmp_path / "run")


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
    with pytest.raises(RecordError) as raised:
        read_run(good)
    assert str(raised.value) == f"{good.name}: {name} cannot be read: Permission denied"


_DEEP = b"[" * 100_000


@pytest.mark.parametrize("name", ["result.json", "scenario.json"])
def test_a_file_that_is_nested_too_deeply_is_damaged(good: Path, tmp_path: Path, name: str) -> None:
    folder = damaged(good, tmp_path / "run", whole(good))
    (folder / name).write_bytes(_DEEP)
    with pytest.raises(RecordError, match=f"^run: {name} (cannot be read: nested too deeply|is damaged)"):
        read_run(folder)


def test_a_line_of_the_referees_log_that_is_nested_too_deeply_is_no_line(good: Path, tmp_path: Path) -> None:
    folder = damaged(good, tmp_path / "run", whole(good))
    lines, _ = read_referee_log(folder)
    with (folder / REFEREE_LOG).open("ab") as log:
        log.write(_DEEP + b"\n")
    assert read_referee_log(folder) == (lines, 1)
