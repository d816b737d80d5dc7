"""Distances that rules measure, in the drawing."""

import re

import pytest

from rcj_challenges.scenario.load import load_text
from rcj_challenges.views.drawing import draw_scenario

SMALL = """schema_version: 2
id: small
title: Small
extends: soccersim_v2
spots: {hill: {x_m: 0.1, y_m: 0.2}}
groups: {marks: [hill, centre]}
counters: {reach_m: {initial: 0.3}}
rules:
  near:
    triggers: [{trigger: half_started}]
    conditions: [%s]
    actions: [%s]
"""
NEAR = "{distance: [Y1, %s], %s}"
CIRCLE = re.compile(
    r'<circle cx="([\d.]+)" cy="([\d.]+)" r="([\d.]+)"[^>]*class="distance"[^>]*><title>([^<]*)</title>'
)
PX_PER_M = 290.0
HALF_WIDTH_M, HALF_LENGTH_M = 0.65 + 50 / PX_PER_M, 0.85 + 50 / PX_PER_M  # with the margin and a goal's depth


def drawn(conditions: str, action: str = "{action: end}") -> str:
    loaded = load_text(SMALL % (conditions, action))
    return draw_scenario(loaded.scenario, loaded.roster)


def circles_of(picture: str) -> list[tuple[float, float, float, str]]:
    """Return the circles as x, y and radius in m, with their titles."""
    found = [(*map(float, one[:3]), one[3]) for one in CIRCLE.findall(picture)]
    return [
        (round(x / PX_PER_M - HALF_WIDTH_M, 2), round(HALF_LENGTH_M - y / PX_PER_M, 2), round(r / PX_PER_M, 3), words)
        for x, y, r, words in found
    ]


@pytest.mark.parametrize(
    ("condition", "circles"),
    [
        (NEAR % ("[-0.3, 0]", "at_least: 0.15"), [(-0.3, 0.0, 0.15, "0.15 m from (-0.3, 0)")]),
        (
            NEAR % ("hill", "at_least: 0.1, at_most: 0.2"),
            [(0.1, 0.2, 0.1, "0.1 m from hill"), (0.1, 0.2, 0.2, "0.2 m from hill")],
        ),
        (
            "{spot_free: marks, of: none}",
            [(0.1, 0.2, 0.08, "0.08 m from hill"), (0.0, 0.0, 0.08, "0.08 m from centre")],
        ),
        ("{spot_free: hill, clearance_m: 0}", []),
        (NEAR % ("ball", "at_most: 0.1"), []),  # it moves
        (NEAR % ("blue_goal", "at_most: 0.1"), []),
        (NEAR % ("hill", "at_most: {counter: reach_m}"), []),
        (NEAR % ("hill", "at_most: 0.2") + ", " + NEAR % ("hill", "at_most: 0.2"), [(0.1, 0.2, 0.2, "0.2 m from hill")]),
        ("{any_of: [" + NEAR % ("hill", "at_most: 0.2") + "]}", [(0.1, 0.2, 0.2, "0.2 m from hill")]),
    ],
)  # fmt: skip
def test_distance_from_a_spot_or_a_point_is_a_circle(condition, circles):
    assert circles_of(drawn(condition)) == circles


def test_distance_is_in_the_legend():
    picture = drawn(NEAR % ("hill", "at_most: 0.2"))
    assert ">Distances that rules measure (m)<" in picture
    assert ">0.2 from hill<" in picture
    assert "Distances" not in drawn("")


def test_distance_of_the_displaced_trigger_is_a_circle():
    text = (SMALL % ("", "{action: end}")).replace(
        "{trigger: half_started}", "{trigger: displaced, entity: B1, from: [0.3, 0.3], distance_m: 0.05}"
    )
    loaded = load_text(text)
    assert circles_of(draw_scenario(loaded.scenario, loaded.roster)) == [(0.3, 0.3, 0.05, "0.05 m from (0.3, 0.3)")]
