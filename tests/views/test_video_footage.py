"""What a recorded run holds for pictures: poses at any time, score, names; also of damaged and unfinished runs."""

import json
import shutil
from pathlib import Path

import numpy as np
import pytest

from rcj_challenges.facts.play import Placement, Verdict
from rcj_challenges.facts.timing import TICK_S
from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.testing import half_info, made_up_snapshot, small_header, small_scenario, write_made_up_run
from rcj_challenges.records.trajectory import Trajectory
from rcj_challenges.records.writer import RecordWriter
from rcj_challenges.views.video import footage as footage_module
from rcj_challenges.views.video.footage import Footage

BALL = 6


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return write_made_up_run(tmp_path_factory.mktemp("runs"), ticks=900)


def test_poses_between_samples_are_interpolated_but_not_over_placements(folder):
    half, track = Footage.open(folder).halves[0], Trajectory.open(folder).halves[0]
    before, after = track.substeps[249, -1], track.substeps[250, 0]
    assert half.poses(250 * TICK_S)[:, :3] == pytest.approx(before)
    assert half.poses(250 * TICK_S + 0.004)[:, :2] == pytest.approx((before[:, :2] + after[:, :2]) / 2, abs=1e-6)
    # After tick 400 the ball is placed in the middle: until the next sample it is where it was.
    assert half.poses(400 * TICK_S + 0.007)[BALL, :2] == pytest.approx(track.substeps[399, -1, BALL, :2])
    assert half.poses(400 * TICK_S + 0.008)[BALL, :2] == pytest.approx(track.substeps[400, 0, BALL, :2])


def test_placements_at_kick_off_hold_from_the_first_picture_on(tmp_path):
    scenario = small_scenario(halves=1, half_s=1)
    header = small_header(scenario)
    writer = RecordWriter(tmp_path, header)
    writer.begin_half(half_info(scenario, 1, 10, header))
    placed = (Placement(BALL, 0.2, -0.1, 0.0), Placement(0, 0.0, 0.0, 0.0, parked=True))
    for tick in range(11):
        writer.tick(made_up_snapshot(tick, 6), Verdict(placements=() if tick else placed), b"")
    writer.end_half(Verdict())
    (half,) = Footage.open(writer.finish({"wall_s": 1.0})).halves
    start = half.poses(0.0)
    assert start[BALL, :2] == pytest.approx((0.2, -0.1))
    assert np.isnan(start[0]).all()
    assert start[1, :2] == pytest.approx(made_up_snapshot(0, 6).substeps[-1][1][:2])
    assert np.isnan(half.poses(0.004)[0]).all()


def test_parked_and_damaged_poses_are_nan(folder):
    half = Footage.open(folder).halves[0]
    samples = half.samples.copy()
    samples[:, 0, 0], samples[:, 1, 1], samples[:, BALL, 0] = 1000.0, np.nan, np.inf
    away = type(half)(half.info, half.ticks, samples, half.heights, half.jumps)
    assert np.isnan(away.poses(3.0)[[0, 1, BALL]]).all()
    assert np.isnan(away.smoothed(BALL, 3.0, 0.8)).all()
    assert not np.isnan(away.poses(3.0)[2]).any()


def test_stopped_run_is_shown_as_far_as_it_was_recorded(tmp_path):
    folder = write_made_up_run(tmp_path, ticks=100, halves=1)
    result = json.loads((folder / "result.json").read_bytes())
    (folder / "result.json").write_text(json.dumps({**result, "complete": False, "stopped": "power cut"}), "utf-8")
    footage = Footage.open(folder)
    assert footage.halves[0].length_s == pytest.approx(3.2)
    assert len(footage.warnings) == 1


def test_damaged_log_costs_only_the_captions(tmp_path, monkeypatch):
    folder = write_made_up_run(tmp_path, ticks=500, halves=1)
    log = folder / "referee.jsonl"
    log.write_bytes(b"\x00\xff{]\n" + log.read_bytes())
    footage = Footage.open(folder)
    assert footage.story.unreadable == 1
    assert len(footage.warnings) == 1
    monkeypatch.setattr(footage_module, "tell", lambda *_: {}["no such seat"])
    footage = Footage.open(folder)
    assert footage.story.events == []
    assert len(footage.warnings) == 1


def test_damaged_result_costs_nothing_that_the_trajectory_has(tmp_path):
    folder = write_made_up_run(tmp_path, ticks=500, names=("Hanse", "Alster"))
    whole = Footage.open(folder)
    (folder / "result.json").write_text("{", encoding="utf-8")
    footage = Footage.open(folder)
    assert len(footage.warnings) == 1
    assert dict(footage.titles) == {"blue": "Hanse", "yellow": "Alster"}
    assert footage.story.events == whole.story.events != []
    assert footage.story.score_changes == whole.story.score_changes


def test_truncated_trajectory_is_shown_as_far_as_it_goes(folder, tmp_path):
    cut = Path(shutil.copytree(folder, tmp_path / "run"))
    path = cut / "trajectory.npz"
    path.write_bytes(path.read_bytes()[: path.stat().st_size * 7 // 10])
    first, second = Footage.open(cut).halves
    assert first.ticks == 900
    assert 0 < second.ticks < 900
    assert second.poses(second.length_s)[BALL, :2] == pytest.approx(first.poses(second.length_s)[BALL, :2])


@pytest.mark.parametrize("file", ["scenario.json", "trajectory.npz"])
def test_run_without_scenario_or_trajectory_cannot_be_shown(tmp_path, file):
    folder = write_made_up_run(tmp_path, ticks=100)
    (folder / file).write_bytes((folder / file).read_bytes()[:500])
    with pytest.raises(RecordError):
        Footage.open(folder)
