"""Obstacles in videos and snapshots: where they stand, how large and how turned; and the board of one team or of three."""

import math
from dataclasses import replace

import mujoco
import numpy as np
import pytest
from PIL import Image

from rcj_challenges.records.testing import write_made_up_run
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.views.video.board import Board
from rcj_challenges.views.video.colours import BOARD
from rcj_challenges.views.video.footage import Footage
from rcj_challenges.views.video.lettering import Lettering
from rcj_challenges.views.video.solid_model import solid_model
from rcj_challenges.views.video.sprites import sprites_of
from rcj_challenges.views.video.timeline import moment_at
from tests.views.test_lines_on_the_floor import is_line, playing

RED = (255, 0, 0)
POST = "{shape: cylinder, centre_m: [0.4, 0], radius_m: 0.05, height_m: 0.1, colour: red%s}"
CRATE = "{shape: box, centre_m: [0.4, 0], size_m: [0.3, 0.04], height_m: 0.1, yaw_rad: 0.7853982, colour: red%s}"
FENCE = "{shape: wall, from_m: [0.3, -0.1], to_m: [0.5, 0.1], thickness_m: 0.04, height_m: 0.1, colour: red}"
ALONG, ACROSS = (0.48, 0.08), (0.48, -0.08)  # ends of the diagonals of a long thing that is turned by 45°
HALF = math.hypot(0.2, 0.2) / 2


@pytest.fixture(scope="module")
def footage(tmp_path_factory):
    return Footage.open(write_made_up_run(tmp_path_factory.mktemp("runs"), ticks=40))


def with_obstacle(footage, obstacle):
    shown = playing(footage, f"obstacles: {{it: {obstacle}}}\n")
    return replace(shown, roster=Roster.of(shown.scenario))


def red_geoms(footage):
    """Return type, size and, in the world, place and yaw of all that is red in the 3-D model."""
    model = solid_model(footage, (64, 64), 0, Lettering(), shadows=False)
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    return [
        (
            model.geom_type[k],
            model.geom_size[k],
            data.geom_xpos[k],
            math.atan2(data.geom_xmat[k][3], data.geom_xmat[k][0]),
        )
        for k in range(model.ngeom)
        if np.allclose(model.geom_rgba[k][:3], (1, 0, 0), atol=0.01)
    ]


def of_colour(picture, colour=RED):
    """Return which pixels of a picture have a colour."""
    return np.abs(np.asarray(picture)[..., :3].astype(int) - colour).sum(axis=2) < 30


@pytest.mark.parametrize(
    ("obstacle", "inside", "beside"),
    [
        (POST % "", (0.44, 0), (0.46, 0)),
        (CRATE % "", ALONG, ACROSS),
        (FENCE, ALONG, ACROSS),
    ],
)
def test_a_fixed_obstacle_is_painted_on_the_floor_seen_from_above(footage, obstacle, inside, beside):
    shown = with_obstacle(footage, obstacle)
    assert is_line(shown, (0.4, 0), RED)
    assert is_line(shown, inside, RED)
    assert not is_line(shown, beside, RED)


@pytest.mark.parametrize(
    ("obstacle", "kind", "size"),
    [
        (POST % "", mujoco.mjtGeom.mjGEOM_CYLINDER, [0.05, 0.05]),
        (CRATE % "", mujoco.mjtGeom.mjGEOM_BOX, [0.15, 0.02, 0.05]),
        (FENCE, mujoco.mjtGeom.mjGEOM_BOX, [HALF, 0.02, 0.05]),
    ],
)
def test_a_fixed_obstacle_stands_in_the_3_d_picture_as_in_the_match(footage, obstacle, kind, size):
    ((found, found_size, place, yaw),) = red_geoms(with_obstacle(footage, obstacle))
    assert found == kind
    assert found_size[: len(size)] == pytest.approx(size)
    assert place == pytest.approx([0.4, 0, 0.05])
    assert kind == mujoco.mjtGeom.mjGEOM_CYLINDER or yaw % math.pi == pytest.approx(math.pi / 4)


@pytest.mark.parametrize(
    ("obstacle", "kind", "size"),
    [
        (POST % ", movable: true", mujoco.mjtGeom.mjGEOM_CYLINDER, [0.05, 0.05]),
        (CRATE % ", movable: true", mujoco.mjtGeom.mjGEOM_BOX, [0.15, 0.02, 0.05]),
    ],
)
def test_a_movable_obstacle_is_as_large_as_in_the_match(footage, obstacle, kind, size):
    shown = with_obstacle(footage, obstacle)
    ((found, found_size, _, _),) = red_geoms(shown)  # where it is a picture is told, frame by frame
    assert found == kind
    assert found_size[: len(size)] == pytest.approx(size)
    assert not is_line(shown, (0.4, 0), RED)  # it is no part of the floor


@pytest.mark.parametrize(
    ("obstacle", "wide_m", "tall_m"), [(POST % ", movable: true", 0.1, 0.1), (CRATE % ", movable: true", 0.3, 0.04)]
)
def test_a_movable_obstacle_has_a_sprite_of_its_size_with_its_x_to_the_right(footage, obstacle, wide_m, tall_m):
    (entity,) = (one for one in with_obstacle(footage, obstacle).things["entities"] if one["name"] == "it")
    (sprite,) = sprites_of(entity, 400, Lettering())
    frame = Image.new("RGB", (200, 200))
    sprite.put(frame, (100, 100), 0.0)
    rows, columns = np.nonzero(of_colour(frame))
    # Around it runs a rim of a darker colour.
    assert np.ptp(columns) == pytest.approx(400 * wide_m, abs=8)
    assert np.ptp(rows) == pytest.approx(400 * tall_m, abs=8)
    assert (columns.mean(), rows.mean()) == pytest.approx((99.5, 99.5), abs=1)


@pytest.mark.parametrize("names", [("Hanse",), ("Hanse", "Alster", "Elbe")])
def test_the_board_names_one_team_or_three_side_by_side_around_its_middle(footage, names):
    teams = [*footage.titles, "third"][: len(names)]
    shown = replace(footage, titles=dict(zip(teams, names, strict=True)))
    board = Board(shown, (1280, 720), Lettering())
    frame = Image.new("RGB", (1280, 720))
    board.write(frame, moment_at(shown, 0.5, None))
    strip = np.abs(np.asarray(frame)[: board.height].astype(int) - BOARD).sum(axis=2) > 60
    written = np.flatnonzero(strip[:, 200:1080].any(axis=0)) + 200  # without clock and half
    assert (written[0] + written[-1]) / 2 == pytest.approx(640, abs=25)
    assert bool(np.ptp(written) > 300) is (len(names) > 1)
