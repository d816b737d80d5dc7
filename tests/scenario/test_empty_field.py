"""The preset empty_field: floor, walls and robots, and nothing that an author has to take away."""

from __future__ import annotations

import pytest

from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.lint.registry import lint
from rcj_challenges.scenario.load import load, load_text

HEAD = "schema_version: 2\nid: it\ntitle: It\nextends: %s\nmatch: {half_s: 60}\n"


@pytest.fixture(scope="module")
def empty():
    return load_text(HEAD % "empty_field", file="it.yaml").scenario


def test_it_has_the_floor_and_the_robots_of_the_match(empty):
    full = load_text(HEAD % "soccersim_v2", file="it.yaml").scenario
    for section in ("kits", "robots", "entrants"):
        assert getattr(empty, section) == getattr(full, section)
    assert empty.field == full.field.model_copy(update={"goals": {}})


def test_nothing_else_is_on_it(empty):
    assert (empty.balls, empty.groups, empty.rules) == ({}, {}, {})
    assert (list(empty.zones), list(empty.spots)) == (["pitch"], ["centre"])


def test_a_ball_and_places_of_the_authors_own_can_be_put_on_it():
    own = load_text(
        HEAD
        % "empty_field"
        + "balls: {ball: {start_m: [0, 0]}}\nzones: {blue_goal: {shape: circle, centre_m: [0, 0.5], radius_m: 0.1}}\n"
        "rules: {in: {triggers: [{trigger: enters, entity: ball, zone: blue_goal}],"
        " actions: [{action: score, entrant: blue}], says: It is in.}}\n",
        file="it.yaml",
    )
    assert own.scenario.balls["ball"] == load("match").scenario.balls["ball"]
    assert lint(own) == []


OPEN = HEAD % "empty_field" + "field: {walls: false}\n"


def test_without_walls_a_robot_may_start_beyond_the_edge_and_rules_cannot_name_walls():
    far = load_text(OPEN + "spots: {far: {x_m: 1.6, y_m: 0}}\nrobots: {B1: {start: {x_m: 1.5}}}\n")
    assert "off-the-field" not in {one.code for one in lint(far)}
    touch = "rules: {r: {triggers: [{trigger: touches, entity: B1, other: walls}], actions: [{action: end}]}}\n"
    with pytest.raises(ScenarioError) as caught:
        load_text(OPEN + touch)
    assert [one.code for one in caught.value.diagnostics] == ["unknown-name"]
