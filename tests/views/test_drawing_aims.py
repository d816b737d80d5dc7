"""The picture marks every place that a draw can decide, and every place that a kick can be aimed at."""

import pytest

from rcj_challenges.scenario.load import load_text
from rcj_challenges.views.drawing import draw_scenario
from rcj_challenges.views.drawing.areas import placement_areas

HEAD = (
    "schema_version: 1\nid: shots\ntitle: Shots\nextends: soccersim_v2\nflags: {away: {}}\n"
    "spots: {left: {x_m: -0.3, y_m: 0.05}, right: {x_m: 0.3, y_m: 0.05}}\n"
    "groups: {both: [left, right]}\ndraws: {side: {values: [left, right]}}\n"
)


def places(action):
    """Return what the legend says of an action that puts the ball somewhere."""
    text = f"rules: {{it: {{triggers: [{{trigger: half_started}}], actions: [{action}]}}}}\n"
    one = load_text(HEAD + text)
    found = [area.words() for area, who in placement_areas(one.scenario, one.roster).items() if who == ["ball"]]
    picture = draw_scenario(one.scenario, one.roster)
    assert all(f">ball: {words}<" in picture for words in found)
    return found


def put(at, more=""):
    return f"{{action: place, entity: ball, at: {at}{more}}}"


def kick(towards, more=""):
    return put("{point: [0.1, 0]}", f", kick: {{towards: {towards}, speed_mps: 1}}{more}")


AWAY = ", mirror: {axis: y, when: away}"
MIRRORED = ", mirror: {axis: y}"


@pytest.mark.parametrize(
    "at", ["{spot: side}", "{choice: [side]}", "{choice: [both]}", "{nearest_free: both}", "{furthest_free: both}"]
)
def test_what_is_put_where_a_draw_decides_is_drawn_mirrored_for_each_of_its_values(at):
    # As written the spots are drawn as such.
    assert places(put(at, AWAY)) == ["(-0.3, -0.05)", "(0.3, -0.05)"]
    assert places(put(at)) == []


@pytest.mark.parametrize(
    "towards", ["{spot: side}", "{choice: [side]}", "{nearest_free: both}", "{furthest_free: both}"]
)
def test_a_kick_is_aimed_at_each_spot_that_a_draw_can_decide(towards):
    where = ["rolls towards (-0.3, 0.05)", "rolls towards (0.3, 0.05)"]
    assert places(kick(towards)) == ["(0.1, 0)", *where]
    assert places(kick(towards, MIRRORED)) == ["(0.1, 0)", *(word.replace("0.05", "-0.05") for word in where)]


def test_a_kick_at_a_spot_and_at_the_start_is_drawn_as_an_aim():
    assert places(kick("{spot: left}")) == ["(0.1, 0)", "rolls towards (-0.3, 0.05)"]
    assert places(kick("start")) == ["(0.1, 0)", "rolls towards (0, 0)"]
    assert places(kick("{start: true}")) == ["(0.1, 0)", "rolls towards (0, 0)"]


def test_what_is_told_by_its_way_from_a_spot_is_drawn():
    beside = "{relative_to: left, offset_m: [0.1, 0]}"
    assert places(put(beside)) == ["(-0.2, 0.05)"]
    assert places(put(beside, MIRRORED)) == ["(-0.2, -0.05)"]
    assert places(kick(beside, MIRRORED)) == ["(0.1, 0)", "rolls towards (-0.2, -0.05)"]
    assert places(put("{relative_to: left}")) == []
    assert places(kick("{relative_to: side}")) == [
        "(0.1, 0)",
        "rolls towards (-0.3, 0.05)",
        "rolls towards (0.3, 0.05)",
    ]


def test_beside_a_robot_there_is_no_place_that_could_be_drawn():
    assert places(put("{relative_to: Y1, offset_m: [0.1, 0]}", MIRRORED)) == []
