"""Messages say what to write instead, where there is one usual way out."""

from __future__ import annotations

import pytest

from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.load import load_text
from tests.scenario.writing import HEAD, complaints, rule

PILLAR = "obstacles: {pillar: {shape: cylinder, centre_m: [0.4, 0], radius_m: 0.05}}\n"


def test_whoever_puts_something_beside_a_fixed_obstacle_learns_of_movable_and_of_spots():
    (text,) = complaints(
        PILLAR + rule(action="{action: place, entity: Y1, at: {relative_to: pillar, offset_m: [0.2, 0]}}")
    )
    assert text == (
        "rules.r.actions[0] (place): 'pillar' is a fixed obstacle; expected an entity or spot: with movable: true it "
        "is an entity, and a spot of the same place can stand for it"
    )


def test_whoever_takes_a_fixed_obstacle_for_an_entity_learns_of_movable():
    (text,) = complaints(PILLAR + rule(action="{action: remove, entity: pillar}"))
    assert text == (
        "rules.r.actions[0] (remove): 'pillar' is a fixed obstacle; expected an entity: with movable: true it is one"
    )


def test_a_group_with_a_fixed_obstacle_says_the_same():
    (text,) = complaints(
        PILLAR + "groups: {things: [ball, pillar]}\n" + rule(action="{action: remove, entity: things}")
    )
    assert text.endswith("contains 'pillar', a fixed obstacle; expected an entity: with movable: true it is one")


def test_what_is_no_obstacle_gets_no_such_advice():
    (text,) = complaints(rule(action="{action: remove, entity: centre}"))
    assert text.endswith("'centre' is a spot; expected an entity")


def test_two_entrants_on_one_channel_are_told_which_key_to_write():
    (text,) = complaints(
        "robots: {P1: {colour: pink, number: 1, kit: v2, start: {x_m: 0.5, y_m: 0, yaw_rad: 0}}}\n"
        "entrants: {pink: {radio_channel: 2, robots: {P1: robot.py}}}\n"
    )
    assert text.endswith("they would hear each other: write another radio_channel, such as 4")


@pytest.mark.parametrize(
    ("body", "remedy"),
    [
        (
            "placements: {l: [{entity: B3, at: start}]}\n" + rule(action="{action: place, layout: l}"),
            "write placements.l anew without it",
        ),
        (rule(action="{action: remove, entity: B3}"), "write rules.r anew without it"),
    ],
)
def test_what_still_names_a_removed_robot_is_to_be_written_anew(body, remedy):
    text = complaints("robots: {B3: null}\nentrants: {blue: {robots: {B3: null}}}\n" + body)
    assert any("it was removed in a.yaml:5" in line and line.endswith(remedy) for line in text), text


def test_a_seat_that_still_names_a_removed_robot_is_to_give_it_up():
    (text,) = complaints("robots: {B3: null}\n")
    assert text.endswith("it was removed in a.yaml:5; write 'B3: null' here too")


@pytest.mark.parametrize(
    ("body", "hint"),
    [
        (
            rule("{trigger: speed, entity: Y1, at_least: 1}"),
            "'speed' is a condition: {trigger: holds, condition: {condition: speed, …}} waits for it",
        ),
        (
            rule(rest="    conditions: [{condition: touches, entity: Y1, other: ball}]\n"),
            "'touches' is a trigger: it stands in 'triggers'",
        ),
        (rule(action="{action: touches, entity: Y1, other: ball}"), "'touches' is a trigger: it stands in 'triggers'"),
        (rule("{trigger: score, entrant: yellow}"), "'score' is an action: it stands in 'actions'"),
        (rule(action="{action: in_zone}"), "'in_zone' is a condition: it stands in 'conditions'"),
    ],
)
def test_a_word_of_another_list_is_told_where_it_belongs(body, hint):
    (text,) = complaints(body)
    assert text.endswith(f"; {hint}")


def test_a_word_of_no_list_gets_no_such_hint():
    with pytest.raises(ScenarioError, match=r"unknown trigger 'nonsense'; there are [a-z_, ]+$"):
        load_text(HEAD + rule("{trigger: nonsense}"), file="a.yaml")
