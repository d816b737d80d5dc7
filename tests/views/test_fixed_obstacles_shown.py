"""Fixed obstacles in rule sheets and drawings: who touches them, what they keep, how far from them is judged."""

import pytest

from rcj_challenges.scenario.load import load_text
from rcj_challenges.views.drawing import draw_scenario
from tests.views.sheets import sentence
from tests.views.test_drawing_distances import CIRCLE, NEAR, SMALL

POLES = (
    "obstacles: {p1: {shape: cylinder, centre_m: [0.5, 0], radius_m: 0.02}, "
    "p2: {shape: cylinder, centre_m: [-0.5, 0], radius_m: 0.02}, "
    "fence: {shape: wall, from_m: [-0.1, 0.5], to_m: [0.1, 0.5]}}\n"
    "groups: {poles: [p1, p2]}\nflags: {touched: {per: poles}}\n"
)


@pytest.mark.parametrize(
    ("touch", "words"),
    [
        ("entity: Y3, other: each", "For each of the poles, when Y3 touches it:"),
        ("entity: each, other: Y3", "For each of the poles, when Y3 touches it:"),
        ("entity: poles, other: robots", "For each of the poles, when one of the robots touches one of the poles:"),
    ],
)
def test_whoever_is_written_first_the_obstacle_is_touched(touch, words):
    rule = f"for_each: poles, triggers: [{{trigger: touches, {touch}}}], actions: [{{action: end}}]"
    assert words in sentence(rule, POLES)


def test_a_rule_that_goes_over_them_names_who_touches_them():
    told = "{action: emit, event: HIT, payload: {who: {word: other_name}, where: {position_of: other}}}"
    rule = f"for_each: poles, triggers: [{{trigger: touches, entity: each, other: robots}}], actions: [{told}]"
    assert "where: the position of the robot that touches it" in sentence(rule, POLES)


@pytest.mark.parametrize(
    ("robots", "words"),
    [("Y3", "One of the poles is touched by yellow."), ("robots", "One of the poles is touched by the team.")],
)
def test_the_team_is_that_of_who_touches_it(robots, words):
    rule = (
        f"for_each: poles, triggers: [{{trigger: touches, entity: {robots}, other: each}}], "
        "actions: [{action: set_flag, flag: touched, entity: each}], says: '{each} is touched by {team}'"
    )
    assert words in sentence(rule, POLES)
    assert "its flag “touched” is set" in sentence(rule, POLES)


def drawn(to: str) -> str:
    text = SMALL.replace("groups: {marks: [hill, centre]}\n", POLES)
    loaded = load_text(text % (NEAR % (to, "at_most: 0.1"), "{action: end}"))
    return draw_scenario(loaded.scenario, loaded.roster)


def test_a_distance_from_them_is_drawn_around_their_centre():
    assert [words for *_, words in CIRCLE.findall(drawn("poles"))] == ["0.1 m from p1", "0.1 m from p2"]


def test_a_distance_from_a_wall_is_a_band_around_it():
    assert "<title>0.1 m from fence</title>" in drawn("fence")
