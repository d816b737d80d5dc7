"""The sample programs of the technical challenges: those can be played, and played well."""

from __future__ import annotations

import importlib
import json
import math
import statistics
import sys

import pytest
from typer.testing import CliRunner

from rcj_challenges.cli.commands import load_app
from rcj_challenges.scenario.resources import TEAMS_FOLDER
from scripts.copy_library import stale_copies

MEDIANS = {
    # What must be reached over seeds 1 to 10. In the first one the best of 28 human teams made 21, see docs/champions.md.
    "fast_shooter": 21,
    "pass_the_ball": 66,
    "precision_lidar": 11,
}


@pytest.fixture
def play(tmp_path):
    """Return a function that plays a challenge with its sample team and returns the result."""

    def run(name: str, *options: str) -> dict:
        done = CliRunner().invoke(load_app(), ["run", name, "--out", str(tmp_path), "--json", "--no-replay", *options])
        assert done.exit_code == 0, done.exception
        return json.loads(done.stdout)

    return run


@pytest.fixture
def champion(monkeypatch):
    """Return a function that imports a module of a champion's program."""

    def load(folder: str, module: str):
        monkeypatch.syspath_prepend(str(TEAMS_FOLDER / folder))
        before = set(sys.modules)
        found = importlib.import_module(module)
        for name in set(sys.modules) - before:
            monkeypatch.delitem(sys.modules, name)  # other champions use the same names
        return found

    return load


def test_each_champion_has_the_library_as_it_is():
    assert list(stale_copies()) == []


@pytest.mark.parametrize("name", MEDIANS)
def test_a_champion_scores_within_half_a_minute(play, name):
    result = play(name, "--duration", "10")
    assert result["faults"] == []
    assert result["score"]["yellow"] > 0


@pytest.mark.nightly
@pytest.mark.parametrize(("name", "median"), MEDIANS.items())
def test_champions_reach_their_medians_over_ten_seeds(play, name, median):
    results = [play(name, "--seed", str(seed)) for seed in range(1, 11)]
    assert [result["faults"] for result in results] == [[]] * 10
    assert statistics.median(result["score"]["yellow"] for result in results) >= median


def test_the_fast_shooter_takes_the_quickest_shot_between_the_posts(champion):
    shot = champion("fast_shooter/score_goal", "shot")
    here, along_the_line = (0.0, -0.0755), 0.0
    best = shot.best_goal_shot(here, along_the_line, (0.3, 0.0))
    assert abs(0.3 + 0.745 / math.tan(best.direction)) < 0.18
    assert best.run_up[1] < -0.05
    assert 4.5 < best.seconds < 5.5
    assert best.seconds < shot.best_goal_shot((-0.2, -0.0755), along_the_line, (0.3, 0.0)).seconds
    assert shot.best_goal_shot(here, along_the_line, (0.3, -0.729)) is None


def test_a_passed_ball_leaves_the_face_in_the_wanted_direction(champion):
    touch = champion("pass_the_ball", "pass_library.touch")
    for coming, wanted in ((0.0, math.pi / 2), (math.pi / 2, 3.0), (0.3, 1.2), (-1.0, 1.0)):
        velocity = (0.3 * math.cos(coming), 0.3 * math.sin(coming))
        x, y = touch.after_touch(velocity, touch.face_for(velocity, wanted))
        assert math.atan2(y, x) == pytest.approx(wanted, abs=0.001)


def test_a_passer_computes_where_and_when_it_meets_the_ball(champion):
    touch = champion("pass_the_ball", "pass_library.touch")
    way, time = touch.meeting((0.0, 0.0), (0.2, 0.0), (0.1, -0.1), math.pi / 2, 0.06)
    assert (way, time) == pytest.approx((0.04, 0.5))
    assert touch.meeting((0.0, 0.0), (0.0, 0.2), (0.1, -0.1), math.pi / 2, 0.06) is None


def test_the_formation_is_found_by_the_faces_that_the_lidar_sees(champion):
    obstacles = champion("precision_lidar/score_goal", "obstacles")
    for formation in obstacles.FORMATIONS:
        faces = [(x + dx, y - 0.0375) for x, y in formation for dx in (-0.03, -0.01, 0.01, 0.03)]
        assert obstacles.formation_of(faces) == formation
    # A robot at the origin that looks at the goal: reading 0 is the front, they go on clockwise.
    ranges = [math.inf] * 360
    ranges[0], ranges[350], ranges[90] = 0.66, 0.67, 0.6
    points = obstacles.points_before_goal((0.0, 0.0), math.pi / 2, ranges)
    assert points == [pytest.approx((0.0, 0.66)), pytest.approx((-0.1163, 0.6598), abs=1e-4)]


def test_a_free_way_past_the_obstacles_is_taken_straight_and_else_over_the_cushion(champion):
    lanes = champion("precision_lidar/score_goal", "lanes")
    obstacles = champion("precision_lidar/score_goal", "obstacles")
    all_left, in_the_middle = obstacles.FORMATIONS[1], obstacles.FORMATIONS[6]
    direction = lanes.straight_direction((0.0, 0.0), all_left)
    assert -0.18 < 0.745 / math.tan(direction) < -0.134
    assert lanes.straight_direction((0.0, 0.0), in_the_middle) is None
    assert 0.3 < abs(math.sin(lanes.cushion_direction((0.0, 0.0), in_the_middle))) < 0.7
