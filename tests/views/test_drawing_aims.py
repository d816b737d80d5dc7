"""The picture marks every place that a draw can decide, and every place that a kick can be aimed at."""

import pytest

from rcj_challenges.referee.script import ScriptedPlay, half_of
from rcj_challenges.scenario.load import load_text
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.views.drawing import draw_scenario
from rcj_challenges.views.drawing.areas import placement_areas
from rcj_challenges.views.drawing.shapes import point_words

HEAD = (
    "schema_version: 1\nid: shots\ntitle: Shots\nextends: soccersim_v2\nflags: {away: {}}\n"
    "spots: {left: {x_m: -0.3, y_m: 0.05}, right: {x_m: 0.3, y_m: 0.05}}\n"
    "groups: {both: [left, right]}\n"
)


def loaded(actions, trigger="trigger: half_started", more="", head="draws: {side: {values: [left, right]}}\n"):
    text = f"phases: {{later: {{}}}}\n{head}rules: {{{more}it: {{triggers: [{{{trigger}}}], actions: [{actions}]}}}}\n"
    return load_text(HEAD + text)


def places(actions, **parts):
    """Return what the legend says of actions that put the ball somewhere."""
    one = loaded(actions, **parts)
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


NOISE = ", noise_m: [0.08, 0.02]"


def test_noise_around_a_spot_or_a_start_is_drawn():
    assert places(put("{spot: left}", NOISE)) == ["(-0.3, 0.05), ± 0.08, 0.02"]
    assert places(put("start", NOISE)) == ["(0, 0), ± 0.08, 0.02"]
    assert places(put("{relative_to: left}", NOISE)) == ["(-0.3, 0.05), ± 0.08, 0.02"]


def test_where_a_robot_is_put_at_its_start_with_noise_that_of_the_start_is_around_it():
    one = loaded(f"{{action: place, entity: Y1, at: start{NOISE}}}, {{action: place, entity: Y2, at: start}}")
    areas = placement_areas(one.scenario, one.roster)
    assert {area.words(): who for area, who in areas.items()} == {"(-0.3, -0.3), ± 0.155, 0.095": ["Y1"]}


def test_a_mirrored_start_keeps_its_noise():
    one = loaded("{action: place, entity: Y1, at: start, mirror: {axis: x}}")
    assert [area.words() for area in placement_areas(one.scenario, one.roster)] == ["(0.3, -0.3), ± 0.075, 0.075"]


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


# --- beside a robot ---------------------------------------------------------------------------------------------------

BESIDE_Y1 = "{relative_to: Y1, offset_m: [0.1, 0]}"
IN_FRONT = "{relative_to: Y1, offset_m: [0.1, 0], turns: true}"
SET_DOWN = "{action: place, entity: Y1, at: %s%s}, "


def test_beside_a_robot_at_its_start_there_is_a_place_as_wide_as_the_noise_of_the_start():
    assert places(put(BESIDE_Y1)) == ["(-0.2, -0.3), ± 0.075, 0.075"]
    assert places(put(IN_FRONT)) == ["(-0.3, -0.2), ± 0.075, 0.075"]
    assert places(kick("{relative_to: Y1}")) == ["(0.1, 0)", "rolls towards (-0.3, -0.3), ± 0.075, 0.075"]


def test_a_mirror_turns_over_the_way_from_a_robot_but_not_what_turns_with_it():
    mirrored = ", mirror: {axis: x, when: away}"
    assert places(put(BESIDE_Y1, mirrored)) == ["(-0.2, -0.3), ± 0.075, 0.075", "(-0.4, -0.3), ± 0.075, 0.075"]
    assert places(put(IN_FRONT, mirrored)) == ["(-0.3, -0.2), ± 0.075, 0.075"]


def test_beside_a_robot_that_was_put_somewhere_just_before_the_place_is_known_at_any_time():
    before = SET_DOWN % ("{point: [0.2, 0.1]}", ", facing: 0")
    for trigger in ("trigger: half_started", "trigger: time_reached, at_s: 5"):
        assert places(before + put(IN_FRONT), trigger=trigger) == ["(0.3, 0.1)"]
        assert places(before + put(BESIDE_Y1), trigger=trigger) == ["(0.3, 0.1)"]


def test_where_a_robot_may_be_anywhere_there_is_no_place_that_could_be_drawn():
    assert places(put(BESIDE_Y1), trigger="trigger: time_reached, at_s: 5") == []
    assert places(SET_DOWN % ("{uniform_in: pitch}", "") + put(BESIDE_Y1)) == []
    assert places("{action: remove, entity: Y1}, " + put(BESIDE_Y1)) == []
    facing_away = SET_DOWN % ("{point: [0.2, 0.1]}", ", facing: {random: true}")
    assert places(facing_away + put(IN_FRONT)) == []


def test_what_an_earlier_rule_puts_at_the_start_of_a_half_counts():
    earlier = "first: {triggers: [{trigger: half_started}], %sactions: [{action: place, entity: Y1, at: {spot: left}}]}"
    assert places(put(BESIDE_Y1), more=f"{earlier % ''}, ") == ["(-0.2, 0.05)"]
    perhaps = "conditions: [{condition: flag, flag: away}], "
    assert places(put(BESIDE_Y1), more=f"{earlier % perhaps}, ") == ["(-0.2, -0.3), ± 0.075, 0.075", "(-0.2, 0.05)"]
    asleep = "phases: [later], "
    assert places(put(BESIDE_Y1), more=f"{earlier % asleep}, ") == ["(-0.2, -0.3), ± 0.075, 0.075"]


def test_robot_and_ball_of_a_mirrored_layout_are_drawn_together():
    layout = (
        "placements: {shot: [{entity: Y1, at: {point: [0.2, -0.3]}, facing: 0}, "
        "{entity: ball, at: {relative_to: Y1, offset_m: [0.1, -0.05]}}]}\n"
    )
    action = "{action: place, layout: shot, mirror: {axis: y, when: away}}"
    assert places(action, head=layout) == ["(0.3, -0.35)", "(0.3, 0.35)"]


def test_what_stays_where_it_is_has_no_place_of_its_own():
    on = "{action: place, entity: ball, at: {relative_to: ball}, kick: {towards: {point: [0.1, 0.2]}, speed_mps: 1}}"
    assert places(on) == ["rolls towards (0.1, 0.2)"]


def test_the_referee_puts_the_ball_where_the_picture_shows_it():
    actions = SET_DOWN % ("{point: [0.2, 0.1]}", ", facing: 2.2") + put(IN_FRONT)
    scenario = loaded(actions).scenario
    play = ScriptedPlay(scenario, Roster.of(scenario), half_of(scenario, 1, 1))
    play.play()
    assert places(actions) == [point_words((round(play.pose("ball")[0], 3), round(play.pose("ball")[1], 3)))]


# --- layouts ----------------------------------------------------------------------------------------------------------


def test_what_no_rule_puts_is_not_drawn():
    layout = "placements: {unused: [{entity: ball, at: {point: [0.2, -0.3]}}]}\n"
    assert places("{action: end}", head=layout) == []


BESIDE = "{action: place, entity: ball, at: {relative_to: %s, offset_m: [0.1, 0]}}"
WHO = "draws: {side: {values: [left, right]}, who: {values: [Y1, B1]}, either: {values: [left, Y1]}}\n"
STILL = "robots: {Y1: {start: {noise_m: [0, 0]}}, B1: {start: {noise_m: [0, 0]}}}\n"


@pytest.mark.parametrize(
    "at", ["{spot: side}", "{choice: [side]}", "{choice: [both]}", "{choice: [left, [0.3, 0.05]]}"]
)
def test_a_place_beside_what_was_put_where_a_draw_decides_is_drawn_for_each_of_its_values(at):
    first = f"{{action: place, entity: Y1, at: {at}}}"
    assert sorted(places(f"{first}, {BESIDE % 'Y1'}")) == ["(-0.2, 0.05)", "(0.4, 0.05)"]


def test_a_place_beside_what_was_put_on_one_spot_of_which_a_rule_sets_another_is_not_known():
    first = "{action: place, entity: Y1, at: {spot: side}}"
    moves = "{action: set_spot, spot: left, to: ball}, "
    assert places(f"{moves}{first}, {BESIDE % 'Y1'}") == []


def test_a_place_beside_who_is_drawn_is_drawn_for_each_of_them():
    assert places(BESIDE % "who", head=WHO + STILL) == ["(-0.2, -0.3)", "(0.4, 0.3)"]
    assert places(BESIDE % "either", head=WHO + STILL) == ["(-0.2, 0.05)", "(-0.2, -0.3)"]


def test_a_place_beside_who_is_drawn_later_is_not_known():
    assert places(BESIDE % "who", trigger="trigger: time_reached, at_s: 2", head=WHO + STILL) == []


# --- spots that rules set ---------------------------------------------------------------------------------------------


def spot_set_to(to, more=""):
    """Return what the legend says of where a rule sets a spot."""
    one = loaded(f"{{action: set_spot, spot: left, to: {to}{more}}}")
    found = [area.words() for area, who in placement_areas(one.scenario, one.roster).items() if who == ["left"]]
    picture = draw_scenario(one.scenario, one.roster)
    assert all(f">left: {words}<" in picture for words in found)
    return found


def test_where_chance_may_set_a_spot_is_drawn():
    assert spot_set_to("{on_line: [[-0.2, -0.3], [0.2, -0.3]]}") == ["(-0.2, -0.3) to (0.2, -0.3)"]
    assert spot_set_to("{uniform_in: pitch}") == ["in pitch"]
    line = "{on_line: [[-0.2, -0.3], [0.2, -0.3]]}, mirror: {axis: y}"
    assert spot_set_to(line) == ["(-0.2, 0.3) to (0.2, 0.3)"]


def test_a_point_to_which_a_rule_sets_a_spot_is_drawn_and_its_mirror_image():
    assert spot_set_to("[0.12, 0.34]") == ["(0.12, 0.34)"]
    both = spot_set_to("[0.12, 0.34]", ", mirror: {axis: y, when: away}")
    assert sorted(both) == ["(0.12, -0.34)", "(0.12, 0.34)"]


@pytest.mark.parametrize("to", ["ball", "right", "blue_goal", "{told: Y1}"])
def test_a_spot_that_is_set_to_where_something_is_has_no_place_of_its_own(to):
    assert spot_set_to(to) == []
