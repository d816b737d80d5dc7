"""Lines on the floor are the same in snapshots and videos of either renderer as on the replay page."""

from dataclasses import replace

import mujoco
import numpy as np
import pytest

from rcj_challenges.records.testing import write_made_up_run
from rcj_challenges.scenario.load import load_text
from rcj_challenges.views.drawing.shapes import floor_outline
from rcj_challenges.views.replay.things import visible_things
from rcj_challenges.views.video.colours import GATE, LINE
from rcj_challenges.views.video.footage import Footage
from rcj_challenges.views.video.ground import paint_ground, whole_field
from rcj_challenges.views.video.lettering import Lettering
from rcj_challenges.views.video.solid_model import solid_model

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


@pytest.mark.parametrize(
    "text",
    [
        pytest.param(DOOR % "", id="no rule judges by it"),
        pytest.param((DOOR % ", anchor: Y1") + JUDGED, id="it moves with a robot"),
    ],
)
def test_other_gates_are_not_painted(footage, text):
    shown = playing(footage, text)
    assert not is_line(shown, (0.2, 0.4), GATE)
    assert painted(shown, GATE) == []
