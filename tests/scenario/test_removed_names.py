"""Names of what a scenario removes from its base, where something still has them: what to do."""

from __future__ import annotations

import pytest

from tests.scenario.writing import complaints, rule


@pytest.mark.parametrize(
    ("body", "remedy"),
    [
        (
            "placements: {l: [{entity: B3, at: start}]}\n" + rule(action="{action: place, layout: l}"),
            "write placements.l anew without it",
        ),
        (rule(action="{action: remove, entity: B3}"), "write rules.r anew without it"),
        # A list is replaced as a whole: nothing is taken out of it by null.
        (
            rule() + "expect: {t: {keyframes: [{at_s: 1, place: {B3: [0, 0]}}], lasts_s: 2}}\n",
            "write expect.t anew without it",
        ),
    ],
)
def test_what_still_names_a_removed_robot_is_to_be_written_anew(body, remedy):
    text = complaints("robots: {B3: null}\nentrants: {blue: {robots: {B3: null}}}\n" + body)
    assert any("it was removed in a.yaml:5" in line and line.endswith(remedy) for line in text), text


@pytest.mark.parametrize(
    ("body", "group"),
    [("zones: {blue_goal: null}\n", "in_play"), ("spots: {centre: null}\n", "neutral_spots")],
)
def test_a_group_of_the_base_that_still_names_what_was_removed_is_to_be_written_anew(body, group):
    text = [one for one in complaints(body + rule("{trigger: half_started}")) if one.startswith("groups.")]
    name = body.partition("{")[2].partition(":")[0]
    said = (
        f"unknown name '{name}': it was removed in a.yaml:5; write groups.{group} anew without it, or '{group}: null'"
    )
    assert [one.partition(": ")[2] for one in text] == [said]


def test_a_group_of_ones_own_that_names_what_the_base_has_removed_is_told_what_there_is():
    head = "schema_version: 1\nid: a\ntitle: A\nextends: empty_field\n"
    (text,) = complaints("groups: {mine: [blue_goal]}\n" + rule("{trigger: half_started}"), head=head)
    assert "groups.mine[0]: unknown name 'blue_goal': it was removed in empty_field.yaml:" in text
    assert "anew" not in text


def test_a_seat_that_still_names_a_removed_robot_is_to_give_it_up():
    (text,) = complaints("robots: {B3: null}\n")
    # The place is in the preset, where nobody can write; so it is named.
    assert text.endswith("it was removed in a.yaml:5; write 'B3: null' under entrants.blue.robots too")
