"""The 3-D model of pictures: floor, walls, lines, gates and obstacles are where the scenario has them. No OpenGL."""

import math

import mujoco
import numpy as np
import pytest

from rcj_challenges.views.palette import PALETTE, css_colour, rgb
from rcj_challenges.views.video.footage import Footage
from rcj_challenges.views.video.scene import build_scene
from tests.made_up_runs import write_made_up_run
from tests.views.video_scenes import JUDGED_GATE, NO_GOALS, playing

RED = (255, 0, 0)
GATE, LINE, WALL = (rgb(PALETTE[name]) for name in ("gate", "line", "wall"))
BOX, CYLINDER = mujoco.mjtGeom.mjGEOM_BOX, mujoco.mjtGeom.mjGEOM_CYLINDER


@pytest.fixture(scope="module")
def footage(tmp_path_factory):
    return Footage.open(write_made_up_run(tmp_path_factory.mktemp("runs"), ticks=10))


def geoms(footage, colour):
    """Return type, place, size and yaw of all geoms of a colour."""
    model = build_scene(footage, (64, 64), fine=False)
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    return [
        (
            int(model.geom_type[k]),
            data.geom_xpos[k].tolist(),
            model.geom_size[k].tolist(),
            math.atan2(data.geom_xmat[k][3], data.geom_xmat[k][0]),
        )
        for k in range(model.ngeom)
        if np.allclose(model.geom_rgba[k][:3], np.array(colour) / 255, atol=0.01)
    ]


def lines(footage, colour=LINE):
    """Return both ends of each line on the floor, without the half width by which it is longer."""
    found = []
    for kind, (x, y, z), (along, across, _), yaw in geoms(footage, colour):
        if kind == BOX and z < 0.001:
            dx, dy = ((along - across) * part for part in (math.cos(yaw), math.sin(yaw)))
            found.append(((x - dx, y - dy), (x + dx, y + dy)))
    return found


def has_line(footage, start, end, colour=LINE):
    return any(
        np.allclose(line, (start, end), atol=1e-6) or np.allclose(line, (end, start), atol=1e-6)
        for line in lines(footage, colour)
    )


def test_penalty_areas_have_their_owners_colours(footage):
    shown = playing(footage, "")
    for colour, y in (("blue", 0.59), ("yellow", -0.59)):
        assert has_line(shown, (-0.35, y), (0.35, y), rgb(css_colour(colour)))


def test_walls_leave_the_goals_open(footage):
    shown = playing(footage, "")
    ends = [x for kind, (x, y, z), _, _ in geoms(shown, WALL) if kind == BOX and 0.74 < y < 0.8]
    assert len(ends) == 4  # a pane and its rim on each side
    assert min(map(abs, ends)) > 0.2


def test_field_without_walls_has_lines_at_its_edges_and_more_floor(footage):
    out = ", out: {shape: circle, centre_m: [1, 0], radius_m: 0.1, drawn: true, colour: red}"
    shown = playing(footage, NO_GOALS.replace("field: {", "field: {walls: false, ") % out)
    assert geoms(shown, WALL) == []
    assert has_line(shown, (0.65, 0.75), (0.65, -0.75))
    assert len(lines(shown, RED)) == 72
    model = build_scene(shown, (64, 64), fine=False)
    assert np.abs(model.mesh_vert).max() == pytest.approx(1.65)


def test_zone_larger_than_the_floor_ends_at_the_walls(footage):
    large = ", big: {shape: circle, centre_m: [0.6, 0], radius_m: 0.5, drawn: true}"
    bounds = np.abs(np.array(lines(playing(footage, NO_GOALS % large)))).max(axis=(0, 1))
    assert bounds == pytest.approx((0.65, 0.75))


@pytest.mark.parametrize(("key", "colour"), [("", LINE), (", colour: red", RED)])
def test_zone_is_drawn_in_its_own_colour(footage, key, colour):
    base = f", base: {{shape: rect, x_min_m: 0.3, x_max_m: 0.5, y_min_m: 0.2, y_max_m: 0.4, drawn: true{key}}}"
    shown = playing(footage, NO_GOALS % base)
    assert has_line(shown, (0.3, 0.2), (0.5, 0.2), colour)
    assert has_line(shown, (0.5, 0.2), (0.5, 0.4), colour)


def test_circle_at_a_spot_is_drawn_around_it(footage):
    ring = NO_GOALS % ", ring: {shape: circle, anchor: mark, radius_m: 0.2, drawn: true, colour: red}"
    shown = playing(footage, ring + "spots: {mark: {x_m: 0.3, y_m: 0.4}}\n")
    assert [math.dist(start, (0.3, 0.4)) for start, _ in lines(shown, RED)] == pytest.approx([0.2] * 72, abs=1e-3)


@pytest.mark.parametrize(("key", "colour"), [("", LINE), (", colour: red", RED)])
def test_spot_is_drawn_as_a_dot_in_its_colour(footage, key, colour):
    shown = playing(footage, f"spots: {{seen: {{x_m: 0.3, y_m: 0.4, drawn: true{key}}}, unseen: {{x_m: 0, y_m: 0}}}}\n")
    dots = [(place, size[0]) for kind, place, size, _ in geoms(shown, colour) if kind == CYLINDER]
    assert [(pytest.approx(place[:2]), radius) for place, radius in dots] == [([0.3, 0.4], 0.012)]


def test_gate_of_a_rule_is_drawn_with_its_forward_mark(footage):
    shown = playing(footage, JUDGED_GATE % "{from_m: [0.1, 0.4], to_m: [0.5, 0.4]}")
    assert has_line(shown, (0.1, 0.4), (0.5, 0.4), GATE)
    assert has_line(shown, (0.3, 0.4), (0.3, 0.45), GATE)  # forward: the first post is on the left


def test_gate_of_no_rule_is_not_drawn(footage):
    assert lines(playing(footage, "gates: {door: {from_m: [0.1, 0.4], to_m: [0.5, 0.4]}}\n"), GATE) == []


def test_gate_that_moves_is_a_body_of_its_own(footage):
    shown = playing(footage, JUDGED_GATE % "{from_m: [0.12, 0.05], to_m: [0.12, -0.05], anchor: Y1}")
    assert has_line(shown, (0.12, 0.05), (0.12, -0.05), GATE)
    model = build_scene(shown, (64, 64), fine=False)
    gate = [k for k in range(model.ngeom) if np.allclose(model.geom_rgba[k][:3], np.array(GATE) / 255)]
    assert {model.body(model.geom_bodyid[k]).name for k in gate} == {"Y1/floor"}


@pytest.mark.parametrize("movable", [False, True])
@pytest.mark.parametrize(
    ("obstacle", "kind", "size", "yaw_rad"),
    [
        ("{shape: cylinder, centre_m: [0.4, 0], radius_m: 0.05, height_m: 0.1", CYLINDER, [0.05, 0.05], 0),
        (
            "{shape: box, centre_m: [0.4, 0], size_m: [0.3, 0.04], height_m: 0.1, yaw_rad: 0.5",
            BOX,
            [0.15, 0.02, 0.05],
            0.5,
        ),
        ("{shape: wall, from_m: [0.3, 0], to_m: [0.5, 0], thickness_m: 0.04, height_m: 0.1", BOX, [0.1, 0.02, 0.05], 0),
    ],
    ids=["cylinder", "box", "wall"],
)
def test_obstacle_looks_as_in_the_match(footage, obstacle, kind, size, yaw_rad, movable):
    if movable and "wall" in obstacle:
        pytest.skip("walls cannot move")
    key = ", movable: true" if movable else ""
    ((found_kind, place, found_size, found_yaw_rad),) = geoms(
        playing(footage, f"obstacles: {{it: {obstacle}{key}, colour: red}}}}\n"), RED
    )
    assert found_kind == kind
    assert found_size[: len(size)] == pytest.approx(size)
    if not movable:  # a movable one is placed in each frame
        assert place == pytest.approx([0.4, 0, 0.05])
        assert found_yaw_rad == pytest.approx(yaw_rad)
