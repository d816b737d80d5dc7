"""What a recorded run holds for pictures: poses at any time; also of damaged and unfinished runs."""

from pathlib import Path

import numpy as np
import pytest

from rcj_challenges.core.play import Placement, RefereeOutput
from rcj_challenges.core.timing import TICK_S
from rcj_challenges.records.trajectory import Trajectory
from rcj_challenges.views.video.footage import Footage
from tests.made_up_runs import made_up_snapshot, small_scenario, write_made_up_run, write_run
from tests.views.replay_play import write_storied_run

BALL = 6


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_made_up_run(tmp_path_factory.mktemp("runs"), ticks=450)


def test_poses_between_ticks_are_interpolated_but_not_over_placements(folder):
    half, track = Footage.open(folder).halves[0], Trajectory.open(folder).halves[0]
    before, after = track.substeps[249, -1], track.substeps[250, -1]
    assert half.poses_at(250 * TICK_S)[:, :2] == pytest.approx(before[:, :2], abs=1e-4)
    assert half.poses_at(250.5 * TICK_S)[:, :2] == pytest.approx((before[:, :2] + after[:, :2]) / 2, abs=1e-4)
    # After tick 400 the ball is placed in the middle: until the next tick it is where it was.
    assert half.poses_at(400.9 * TICK_S)[BALL, :2] == pytest.approx(track.substeps[399, -1, BALL, :2], abs=1e-4)
    assert half.poses_at(401 * TICK_S)[BALL, :2] == pytest.approx(track.substeps[400, -1, BALL, :2], abs=1e-4)


def test_placements_at_kick_off_hold_from_the_first_picture_on(tmp_path):
    placed = (Placement(BALL, 0.2, -0.1, 0.0), Placement(0, 0.0, 0.0, 0.0, parked=True))
    play = [(made_up_snapshot(tick, 6), RefereeOutput(placements=() if tick else placed)) for tick in range(11)]
    folder = write_run(tmp_path, small_scenario(halves=1, half_s=1), lambda _half: play, ticks=10)
    (half,) = Footage.open(folder).halves
    start = half.poses_at(0.0)
    assert start[BALL, :2] == pytest.approx((0.2, -0.1))
    assert np.isnan(start[0]).all()
    assert np.isnan(half.poses_at(0.004)[0]).all()
    assert np.isnan(half.smoothed(0, 0.0, 0.01)).all()


def test_lights_and_pictures_are_those_of_the_moment(tmp_path):
    footage = Footage.open(write_storied_run(tmp_path))
    half = footage.halves[0]
    for tick, colour, lights in ((30, (0, 128, 0), []), (125, (0, 0, 255), [(0, "red"), (4, "red")])):
        (picture,) = footage.pictures(half, "B1", tick * TICK_S)
        assert (picture.size, picture.getcolors()) == ((8, 6), [(48, colour)])
        assert [(one.entity, one.colour) for one in footage.lights(half, tick * TICK_S)] == lights
    assert footage.pictures(half, "B2", 4.0) == []
    assert footage.pictures(footage.halves[1], "B1", 1.0) == []


def test_a_damaged_sensor_recording_leaves_the_rest(tmp_path):
    folder = write_storied_run(tmp_path)
    (folder / "sensors" / "half-1.sensors").write_bytes(b"{}\n")
    footage = Footage.open(folder)
    assert footage.warnings
    assert footage.lights(footage.halves[0], 4.0) == []
