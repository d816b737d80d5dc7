"""Lines on the floor are the same in snapshots and videos of either renderer as on the replay page."""

import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import mujoco
import numpy as np
import pytest
from PIL import Image

from rcj_challenges.records.testing import write_made_up_run
from rcj_challenges.scenario.load import load_text
from rcj_challenges.views.drawing.shapes import floor_outline
from rcj_challenges.views.replay.things import visible_things
from rcj_challenges.views.video.camera import Camera
from rcj_challenges.views.video.colours import GATE, LINE
from rcj_challenges.views.video.footage import Footage
from rcj_challenges.views.video.ground import paint_ground, whole_field
from rcj_challenges.views.video.lettering import Lettering
from rcj_challenges.views.video.solid_model import solid_model
from rcj_challenges.views.video.timeline import moment_at
from rcj_challenges.views.video.topdown import TopDown

HEAD = "schema_version: 1\nid: lines\ntitle: Lines\nextends: soccersim_v2\n"
NO_GOALS = (
    "field: {goals: {blue_goal: null, yellow_goal: null}}\ngroups: {in_play: null, penalty_areas: null}\n"
    "zones: {blue_goal: null, yellow_goal: null, blue_penalty_area: null, yellow_penalty_area: null%s}\n"
)
SIZE = (600, 700)


@pytest.fixture(scope="module")
def footage(tmp_path_factory):
    return Footage.open(write_made_up_run(tmp_path_factory.mktemp("runs"), ticks=40))


def playing(footage, text):
    """Return the footage as if it were of another scenario."""
    scenario = load_text(HEAD + text).scenario
    return replace(footage, scenario=scenario, things=visible_things(scenario))


def is_line(footage, point, colour=LINE):
    """Return whether a point of the floor is painted in a colour, seen from above."""
    view = whole_field(footage, SIZE, 0)
    column, row = (int(value) for value in view.px(*point))
    found = np.asarray(paint_ground(footage, SIZE, view))[row - 1 : row + 2, column - 1 : column + 2].astype(int)
    return bool((np.abs(found - colour).sum(axis=2) < 12).any())


def painted(footage, colour=LINE):
    """Return middle and half size of each line of a colour on the floor of the 3-D model."""
    model = solid_model(footage, (64, 64), 0, Lettering(), shadows=False)
    bars = [k for k in range(model.ngeom) if model.geom_type[k] == mujoco.mjtGeom.mjGEOM_BOX]
    sought = np.array(colour) / 255
    return [
        (model.geom_pos[k], model.geom_size[k]) for k in bars if np.allclose(model.geom_rgba[k][:3], sought, atol=0.01)
    ]


def crosses_the_middle(lines):
    return any(abs(x) < 0.01 and abs(y) < 0.01 and size[0] > 0.6 for (x, y, _), size in lines)


def test_a_field_with_goals_has_a_halfway_line(footage):
    shown = playing(footage, "")
    assert is_line(shown, (0.45, 0))
    assert crosses_the_middle(painted(shown))


def test_a_field_without_goals_has_no_halfway_line(footage):
    shown = playing(footage, NO_GOALS % "")
    assert not is_line(shown, (0.45, 0))
    assert not crosses_the_middle(painted(shown))


LARGE = ", big: {shape: circle, centre_m: [0.6, 0], radius_m: 0.5, drawn: true}"


def test_a_zone_larger_than_the_floor_is_painted_on_the_floor_only(footage):
    shown = playing(footage, NO_GOALS % LARGE)
    assert is_line(shown, (0.6, 0.5))
    assert not is_line(shown, (0.68, 0.493))
    assert all(abs(x) < 0.66 for (x, _, _), _ in painted(shown))


def test_lines_end_at_the_walls_that_cut_the_corners(footage):
    zone = ", most: {shape: rect, x_min_m: 0, drawn: true}"
    shown = playing(footage, NO_GOALS.replace("goals:", "corner_cut_m: 0.3, goals:") % zone)
    assert not is_line(shown, (0.6, 0.7))
    outline = floor_outline(shown.scenario.zones["most"], shown.scenario.field)
    assert all(abs(x) + abs(y) <= 0.65 + 0.75 - 0.3 + 1e-9 for x, y in outline)


def test_a_zone_beside_the_floor_is_not_painted(footage):
    shown = playing(footage, NO_GOALS % ", far: {shape: circle, centre_m: [3, 0], radius_m: 0.2, drawn: true}")
    assert floor_outline(shown.scenario.zones["far"], shown.scenario.field) == []
    assert len(painted(shown)) == len(painted(playing(footage, NO_GOALS % "")))


RED = (255, 0, 0)
BASE = ", base: {shape: rect, x_min_m: 0.3, x_max_m: 0.5, y_min_m: 0.2, y_max_m: 0.4, drawn: true%s}"


@pytest.mark.parametrize(("colour", "told", "line"), [("", None, LINE), (", colour: red", "red", RED)])
def test_a_base_is_painted_in_its_own_colour(footage, colour, told, line):
    shown = playing(footage, NO_GOALS % (BASE % colour))
    assert is_line(shown, (0.4, 0.2), line)
    assert len([x for (x, _, _), _ in painted(shown, line) if 0.25 < x < 0.55]) == 4
    (zone,) = (zone for zone in shown.things["zones"] if zone["name"] == "base")
    assert zone.get("colour") == told


DOOR = "\ngates: {door: {from_m: [0.1, 0.4], to_m: [0.5, 0.4]%s}}\n"
JUDGED = (
    "rules: {through: {triggers: [{trigger: crosses, entity: Y3, gate: door}],"
    " actions: [{action: score, entrant: yellow, points: 1}], says: A gate.}}\n"
)


def test_a_gate_by_which_a_rule_judges_is_painted_with_its_way_forward(footage):
    # A film of a race in which nobody sees the finish tells nothing.
    shown = playing(footage, (DOOR % "") + JUDGED)
    assert is_line(shown, (0.2, 0.4), GATE)
    assert is_line(shown, (0.3, 0.43), GATE)  # forward: who drives so has the first post on the left hand
    assert not is_line(shown, (0.3, 0.37), GATE)
    (line, line_size), (mark, mark_size) = painted(shown, GATE)
    assert list(line[:2]) == pytest.approx([0.3, 0.4])
    assert line_size[0] == pytest.approx(0.2, abs=0.005)
    assert list(mark[:2]) == pytest.approx([0.3, 0.425])
    assert mark_size[0] == pytest.approx(0.025, abs=0.005)


def test_other_gates_are_not_painted(footage):
    shown = playing(footage, DOOR % "")
    assert not is_line(shown, (0.2, 0.4), GATE)
    assert painted(shown, GATE) == []


# A gate across the way of Y1, 12 cm before its middle, 10 cm wide.
BUMPER = "\ngates: {door: {from_m: [0.12, 0.05], to_m: [0.12, -0.05], anchor: Y1}}\n" + JUDGED


def before(moment, robot, ahead_m, left_m=0.0):
    """Return the point of the floor that lies so far before a robot and on its left."""
    x_m, y_m, yaw_rad, _ = moment.half.poses(moment.t_s)[robot]
    c, s = np.cos(yaw_rad), np.sin(yaw_rad)
    return x_m + c * ahead_m - s * left_m, y_m + s * ahead_m + c * left_m


@pytest.mark.parametrize("camera", ["field", "follow-ball"])
@pytest.mark.parametrize("t_s", [0.0, 0.5, 1.0])
def test_from_above_a_gate_that_moves_with_a_robot_is_where_the_robot_is(footage, camera, t_s):
    shown = playing(footage, BUMPER)
    robot = shown.roster.index["Y1"]
    stage = TopDown(shown, SIZE, 0, Camera.named(camera, shown.roster), Lettering())
    moment = moment_at(shown, t_s, 1)
    picture, view = np.asarray(stage.picture(moment)).astype(int), stage.projection(moment)

    def is_gate(ahead_m, left_m=0.0):
        column, row = (int(value) for value in view.px(*before(moment, robot, ahead_m, left_m)))
        if not (2 <= column < SIZE[0] - 2 and 2 <= row < SIZE[1] - 2):
            return None  # what a camera that follows does not show
        found = picture[row - 1 : row + 2, column - 1 : column + 2]
        return bool((np.abs(found - GATE).sum(axis=2) < 60).any())

    assert {is_gate(0.12, left_m) for left_m in (-0.045, 0.0, 0.045)} <= {True, None}
    assert is_gate(0.15) in (True, None)  # its mark forward, which points away from the robot
    assert not any(is_gate(*point) for point in ((0.08, 0.0), (0.12, 0.08), (0.12, -0.08), (-0.12, 0.0)))


def test_from_above_a_gate_is_not_there_while_its_robot_is_off_the_field(footage):
    shown = playing(footage, BUMPER)
    half = shown.halves[0]
    samples = half.samples.copy()
    samples[:, shown.roster.index["Y1"]] = np.nan
    away = replace(shown, halves=(replace(half, samples=samples),))
    stage = TopDown(away, SIZE, 0, Camera.named("field", away.roster), Lettering())
    picture = np.asarray(stage.picture(moment_at(away, 0.5, 1))).astype(int)
    assert not (np.abs(picture - GATE).sum(axis=2) < 60).any()


def test_in_three_dimensions_a_gate_that_moves_is_a_body_of_its_own(footage):
    # A robot's own body would lift it with the robot, and a ball's would roll it.
    shown = playing(footage, BUMPER)
    model = solid_model(shown, (64, 64), 0, Lettering(), shadows=False)
    (line, line_size), (mark, mark_size) = painted(shown, GATE)
    assert list(line[:2]) == pytest.approx([0.12, 0.0])
    assert line_size[0] == pytest.approx(0.05, abs=0.005)
    assert list(mark[:2]) == pytest.approx([0.145, 0.0])
    assert mark_size[0] == pytest.approx(0.025, abs=0.005)
    body = model.body("Y1/gates")
    assert body.mocapid[0] >= 0
    assert model.geom_bodyid[model.body_geomadr[body.id] : model.body_geomadr[body.id] + 2].tolist() == [body.id] * 2


def test_in_three_dimensions_a_gate_that_moves_is_where_the_robot_is(tmp_path):
    """In a process of its own: the graphics backend is chosen before MuJoCo is loaded."""
    write_made_up_run(tmp_path, ticks=40)
    out = tmp_path / "s.png"
    code = f"""
import sys
from pathlib import Path
from rcj_challenges.views.video import gl_probe
reason = gl_probe.why_not_solid()
if reason:
    print(reason); sys.exit(77)
gl_probe.why_not_solid = lambda: None  # asked once is enough
sys.path.insert(0, {str(Path(__file__).parent)!r})
from test_lines_on_the_floor import BUMPER, before, playing
from rcj_challenges.views.video.footage import Footage
from rcj_challenges.views.video.make import Look, studio
from rcj_challenges.views.video.timeline import moment_at
shown = playing(Footage.open(next(Path({str(tmp_path)!r}).iterdir())), BUMPER)
moment = moment_at(shown, 0.5, 1)
with studio(shown, Look((640, 720), "top", "3d")) as made_in:
    made_in.frame(moment).save({str(out)!r})
    print(*made_in._stage._px((*before(moment, shown.roster.index["Y1"], 0.13), 0.0)))
"""
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, cwd=Path(__file__).parents[2], check=False
    )
    if done.returncode == 77:
        pytest.skip(done.stdout)
    assert done.returncode == 0, done.stderr
    at = tuple(map(float, done.stdout.split()))
    with Image.open(out) as picture:
        red, green, blue = np.moveaxis(np.asarray(picture.convert("RGB")).astype(int), 2, 0)
    ys, xs = np.nonzero((red > green + 60) & (blue > green + 20))  # pink, as nothing else
    assert len(xs) > 20
    assert np.hypot(xs.mean() - at[0], ys.mean() - at[1]) < 8
