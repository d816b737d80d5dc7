"""A field without walls: 1 m more floor, then a border that stops everything and is nothing else."""

import math

import pytest

from rcj_challenges.devices.base import Eye
from rcj_challenges.referee.bodies import Bodies
from rcj_challenges.world.camera_renderer import WALL, CameraRenderer
from tests.devices.device_bench import Bench
from tests.world.physics_stage import BALL_R, FULL, HALF_CUBE, Stage

OPEN = {
    "field": {"walls": False, "goals": None},
    "obstacles": {"post": {"shape": "cylinder", "centre_m": [0.2, 0.3], "radius_m": 0.02}},
}
EDGE_X_M = 0.65


@pytest.fixture(scope="module")
def stage() -> Stage:
    return Stage(**OPEN)


def test_robot_drives_beyond_the_edge_and_is_stopped_one_metre_behind_it_by_what_is_no_wall(stage: Stage) -> None:
    stage.put("Y1", 0.5, 0.0)
    stage.drive("Y1", FULL, FULL)
    snapshots = stage.play(6)
    x_m, y_m, _ = snapshots[-1].substeps[-1][stage.index("Y1")]
    assert (x_m, y_m) == pytest.approx((EDGE_X_M + 1 - HALF_CUBE, 0), abs=0.002)
    assert {pair for one in snapshots for touches in one.touches for pair in touches} == set()
    stage.park("Y1")


def test_ball_comes_back_from_the_border(stage: Stage) -> None:
    stage.put("ball", 0.0, 0.0)
    stage.roll("ball", 1.0, 0.0)
    places = [one.substeps[-1][stage.index("ball")][0] for one in stage.play(4)]
    assert max(places) == pytest.approx(EDGE_X_M + 1 - BALL_R, abs=0.04)
    assert places[-1] < max(places) - 0.2
    stage.park("ball")


def test_rays_pass_the_border() -> None:
    sensors = {"lidar": {"device": "lidar"}, "bumper": {"device": "touch_sensor"}}
    bench = Bench("soccersim_2021", {"field": OPEN["field"], "robots": {"Y1": {"devices": sensors}}})
    bench.enable("Y1", "lidar", "bumper")
    bench.place("Y1", EDGE_X_M + 1 - HALF_CUBE, 0.0)
    bench.drive("Y1", FULL, FULL)
    bench.play(10)
    assert all(math.isinf(one) for one in bench.read("Y1", "lidar"))
    assert bench.read("Y1", "bumper") == [0.0]


def test_cameras_see_floor_behind_the_edge_and_no_wall(stage: Stage) -> None:
    look = Eye(bearing_rad=0.0, ahead_m=0.03, height_m=0.06, width=32, height=24, fov_rad=1.0, down=0.5)
    stage.put("Y1", 1.2, 0.0)
    camera = CameraRenderer(stage.scenario, stage.roster, stage.world)
    (picture,) = camera.take([(stage.index("Y1"), look)])
    assert WALL not in picture
    stage.park("Y1")


@pytest.mark.parametrize(("x_m", "fits"), [(EDGE_X_M, True), (1.6, True), (1.64, False), (2.0, False)])
def test_rules_may_put_things_on_all_of_the_floor(stage: Stage, x_m: float, fits: bool) -> None:
    bodies = Bodies(stage.scenario, stage.roster)
    assert bodies.fits(stage.index("Y1"), (x_m, 0.7, 0.0), {}, 0.0) is fits
