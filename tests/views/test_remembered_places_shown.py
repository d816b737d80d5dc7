"""What drawing and replay show of spots that rules set."""

import pytest

from rcj_challenges.scenario.load import load_text
from rcj_challenges.views.drawing import draw_scenario
from rcj_challenges.views.drawing.placement_areas import placement_areas
from rcj_challenges.views.replay.things import visible_things
from tests.views.sheets import HEAD

SPOTS = "spots: {found: {x_m: 0, y_m: 0.2}, lost: {x_m: 0.3, y_m: 0.1}}\ngroups: {both: [found, lost]}\n"
START, LATER = "{trigger: half_started}", "{trigger: touches, entity: robots, other: ball}"


def loaded(*actions, more="", trigger=START, rule="", rules=""):
    text = f"rules:\n  r: {{triggers: [{trigger}], {rule}actions: [{', '.join(actions)}]}}\n"
    return load_text(HEAD + SPOTS + more + text + rules)


def set_to(what, spot="found"):
    return f"{{action: set_spot, spot: {spot}, to: {what}}}"


def test_the_picture_marks_it_in_the_colour_of_what_rules_put_and_tells_where_it_begins():
    one = loaded(set_to("ball"), trigger=LATER)
    picture = draw_scenario(one.scenario, one.roster)
    assert ">found: 0, 0.2 when a half starts; rules set it<" in picture
    assert ">lost: 0.3, 0.1<" in picture
    orange = [line for line in picture.split("<line")[1:] if 'stroke="#f08c00"' in line]
    assert len(orange) == 2
    assert all("found" in line for line in orange)
    assert ">found<" in picture


NEAR = (
    "  near: {triggers: [{trigger: holds, conditions: [{distance: [Y1, found], at_most: 0.3}]}], "
    "actions: [{action: emit, event: NEAR}]}\n"
)


class TestSetAsTheHalfStarts:
    """What a rule sets as each half starts is never at its position in the file, so it is not drawn there."""

    @pytest.mark.parametrize("to", ["{uniform_in: blue_goal}", "[0.1, 0]", "ball", "lost"])
    def test_the_picture_does_not_show_it_where_it_never_is(self, to):
        one = loaded(set_to(to), rules=NEAR)
        picture = draw_scenario(one.scenario, one.roster)
        assert ">found: rules set it when a half starts<" in picture
        assert ">0.3 from found<" in picture
        assert ">found: 0, 0.2" not in picture
        assert 'class="distance"' not in picture
        assert ">found<" not in picture

    def test_where_chance_hides_it_is_drawn(self):
        one = loaded(set_to("{uniform_in: blue_goal}"))
        assert "<title>put found</title>" in draw_scenario(one.scenario, one.roster)

    @pytest.mark.parametrize(
        "more",
        [
            "phases: [later], ",
            "conditions: [{word: halftime, equals: 2}], ",
            "exclusive: one, ",
        ],
    )
    def test_a_spot_that_rules_may_leave_unset_is_drawn_at_its_position_in_the_file(self, more):
        one = loaded(set_to("ball"), more="phases: {later: {}}\nmatch: {halves: 2}\n", rule=more)
        assert ">found: 0, 0.2 when a half starts; rules set it<" in draw_scenario(one.scenario, one.roster)

    def test_no_position_has_been_sent_when_a_half_starts(self):
        one = loaded(set_to("{told: Y1}"))
        assert ">found: 0, 0.2 when a half starts; rules set it<" in draw_scenario(one.scenario, one.roster)


@pytest.mark.parametrize(
    "at",
    [
        "{spot: found}", "{choice: [found]}", "{nearest_free: found}", "{relative_to: found, offset_m: [0.1, 0]}",
        "{spot: drawn}",
    ],
)  # fmt: skip
def test_what_is_put_where_it_was_remembered_has_no_known_place(at):
    draw = "draws: {drawn: {values: [found]}}\n"
    put = f"{{action: place, entity: ball, at: {at}, mirror: {{axis: x}}}}"
    still, moved = loaded(put, more=draw), loaded(set_to("Y1"), put, more=draw)
    assert len(placement_areas(still.scenario, still.roster)) == 1
    assert placement_areas(moved.scenario, moved.roster) == {}


def test_of_a_group_the_others_are_drawn():
    put = "{action: place, entity: ball, at: {choice: [both]}, mirror: {axis: x}}"
    one = loaded(set_to("Y1"), put)
    assert [area.words() for area in placement_areas(one.scenario, one.roster)] == ["(-0.3, 0.1)"]


def test_pages_and_videos_show_the_spots_that_stay_where_they_are():
    one = loaded(set_to("ball"))
    names = [spot["name"] for spot in visible_things(one.scenario)["spots"]]
    assert "lost" in names
    assert "found" not in names
