"""Where rules put things: every place that a draw can decide, a kick can be aimed at, or a mirror turns over."""

import re

import pytest

from rcj_challenges.scenario.load import load_text
from rcj_challenges.views.drawing import draw_scenario
from rcj_challenges.views.drawing.placement_areas import placement_areas

HEAD = (
    "schema_version: 2\nid: shots\ntitle: Shots\nextends: soccersim_v2\nflags: {away: {}}\n"
    "spots: {left: {x_m: -0.3, y_m: 0.05}, right: {x_m: 0.3, y_m: 0.05}}\n"
    "groups: {both: [left, right]}\n"
)


def loaded(actions, trigger="trigger: half_started", more="", head="draws: {side: {values: [left, right]}}\n"):
    text = f"phases: {{later: {{}}}}\n{head}rules: {{{more}it: {{triggers: [{{{trigger}}}], actions: [{actions}]}}}}\n"
    return load_text(HEAD + text)


def places(actions, **parts):
    """Return where actions put the ball, or roll it to."""
    one = loaded(actions, **parts)
    return [area.words() for area, names in placement_areas(one.scenario, one.roster).items() if names == ["ball"]]


def put(at, more=""):
    return f"{{action: place, entity: ball, at: {at}{more}}}"


def kick(towards, more=""):
    return put("{point: [0.1, 0]}", f", kick: {{towards: {towards}, speed_mps: 1}}{more}")


AWAY = ", mirror: {axis: y, when: away}"
MIRRORED = ", mirror: {axis: y}"


@pytest.mark.parametrize(
    "at", ["{spot: side}", "{choice: [side]}", "{choice: [both]}", "{nearest_free: both}", "{furthest_free: both}"]
)
def test_mirrored_placement_on_drawn_spots_has_a_place_for_each(at):
    # As written the spots are drawn as such.
    assert places(put(at, AWAY)) == ["(-0.3, -0.05)", "(0.3, -0.05)"]
    assert places(put(at)) == []


@pytest.mark.parametrize(
    "towards", ["{spot: side}", "{choice: [side]}", "{nearest_free: both}", "{furthest_free: both}"]
)
def test_kick_is_aimed_at_each_spot_that_a_draw_can_decide(towards):
    where = ["rolls towards (-0.3, 0.05)", "rolls towards (0.3, 0.05)"]
    assert places(kick(towards)) == ["(0.1, 0)", *where]
    assert places(kick(towards, MIRRORED)) == ["(0.1, 0)", *(word.replace("0.05", "-0.05") for word in where)]


def test_kick_at_a_spot_or_a_start_is_an_aim():
    assert places(kick("{spot: left}")) == ["(0.1, 0)", "rolls towards (-0.3, 0.05)"]
    assert places(kick("start")) == ["(0.1, 0)", "rolls towards (0, 0)"]
    assert places(kick("{start: true}")) == ["(0.1, 0)", "rolls towards (0, 0)"]


NOISE = ", noise_m: [0.08, 0.02]"


def test_noise_makes_a_place_of_a_spot_or_a_start():
    assert places(put("{spot: left}", NOISE)) == ["(-0.3, 0.05), ± 0.08, 0.02"]
    assert places(put("start", NOISE)) == ["(0, 0), ± 0.08, 0.02"]
    assert places(put("{relative_to: left}", NOISE)) == ["(-0.3, 0.05), ± 0.08, 0.02"]


def test_noise_of_placement_and_start_add_up():
    one = loaded(f"{{action: place, entity: Y1, at: start{NOISE}}}, {{action: place, entity: Y2, at: start}}")
    areas = placement_areas(one.scenario, one.roster)
    assert {area.words(): names for area, names in areas.items()} == {"(-0.3, -0.3), ± 0.155, 0.095": ["Y1"]}


def test_offset_from_a_spot_is_a_point():
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


# --- layouts ----------------------------------------------------------------------------------------------------------


# --- spots that rules set ---------------------------------------------------------------------------------------------


def spot_set_to(to, more=""):
    """Return where a rule sets a spot."""
    one = loaded(f"{{action: set_spot, spot: left, to: {to}{more}}}")
    return [area.words() for area, names in placement_areas(one.scenario, one.roster).items() if names == ["left"]]


def test_spot_set_at_random_has_a_line_or_a_zone():
    assert spot_set_to("{on_line: [[-0.2, -0.3], [0.2, -0.3]]}") == ["(-0.2, -0.3) to (0.2, -0.3)"]
    assert spot_set_to("{uniform_in: pitch}") == ["in pitch"]
    line = "{on_line: [[-0.2, -0.3], [0.2, -0.3]]}, mirror: {axis: y}"
    assert spot_set_to(line) == ["(-0.2, 0.3) to (0.2, 0.3)"]


def test_spot_set_to_a_point_has_that_point_and_its_mirror_image():
    assert spot_set_to("[0.12, 0.34]") == ["(0.12, 0.34)"]
    both = spot_set_to("[0.12, 0.34]", ", mirror: {axis: y, when: away}")
    assert sorted(both) == ["(0.12, -0.34)", "(0.12, 0.34)"]


@pytest.mark.parametrize("to", ["ball", "right", "blue_goal", "{told: Y1}"])
def test_spot_set_to_where_something_is_has_no_place(to):
    assert spot_set_to(to) == []


# --- in the drawing ---------------------------------------------------------------------------------------------------

MIRRORED_LAYOUT = """
flags: {changed: {initial: false}}
zones: {garden: {shape: rect, x_min_m: 0.2, x_max_m: 0.4, y_min_m: 0.1, y_max_m: 0.3}}
placements:
  corner:
    - {entity: B1, at: {point: [0.1, 0.2]}, mirror: {axis: x}}
    - {entity: B2, at: {point: [0.15, 0.25]}}
    - {entity: Y1, at: start}
    - {entity: ball, at: {spot: left}}
  elsewhere:
    - {entity: B3, at: {uniform_in: garden}, mirror: {axis: both}}
spots: {left: {x_m: -0.2, y_m: 0.05}}
rules:
  over: {triggers: [{trigger: half_started}], actions: [{action: place, layout: corner, mirror: {axis: y, when: changed}}]}
  away: {triggers: [{trigger: half_ended}], actions: [{action: place, layout: elsewhere}]}
"""


def test_layout_is_mirrored_by_its_own_mirror_and_that_of_the_action():
    one = load_text("schema_version: 2\nid: mirrored\ntitle: Mirrored\nextends: soccersim_v2\n" + MIRRORED_LAYOUT)
    found = {}
    for area, names in placement_areas(one.scenario, one.roster).items():
        found.setdefault(names[0], set()).add(area.words())
    assert found == {
        "B1": {"(-0.1, 0.2)", "(-0.1, -0.2)"},
        "B2": {"(0.15, 0.25)", "(0.15, -0.25)"},
        "Y1": {"(-0.3, 0.3), ± 0.075, 0.075"},
        "ball": {"(-0.2, -0.05)"},
        "B3": {"in garden, mirrored (x becomes -x and y becomes -y)"},
    }


def test_places_are_drawn_with_one_number_for_the_same_things():
    one = loaded(
        "{action: place, entity: B1, at: {choice: [[0.1, 0.2], [0.3, 0.2]]}}, {action: place, entity: ball, "
        "at: {uniform_in: pitch}}, {action: place, entity: B2, at: {on_line: [[-0.2, 0], [0.2, 0]]}}"
    )
    picture = draw_scenario(one.scenario, one.roster)
    for title in (
        "put B1 at (0.1, 0.2)", "put B1 at (0.3, 0.2)", "put ball anywhere in here", "put B2 anywhere on this line"
    ):  # fmt: skip
        assert f"<title>{title}</title>" in picture
    assert ">B1: (0.1, 0.2); (0.3, 0.2)<" in picture
    numbers = re.findall(r"<title>put B1</title><rect [^>]*/><text [^>]*>(\d+)</text>", picture)
    assert len(numbers) == 2
    assert len(set(numbers)) == 1
