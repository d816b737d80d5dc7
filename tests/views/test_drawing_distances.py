"""Distances that rules measure, in the drawing."""

import re

import pytest

from rcj_challenges.scenario.load import load_text
from rcj_challenges.views.drawing import draw_scenario

SMALL = """schema_version: 1
id: small
title: Small
extends: soccersim_v2
spots: {hill: {x_m: 0.1, y_m: 0.2}}
groups: {marks: [hill, centre]}
counters: {reach_m: {initial: 0.3}, none_yet: {}}
rules:
  near:
    triggers: [{trigger: half_started}]
    conditions: [%s]
    actions: [%s]
"""
NEAR = "{condition: distance, entity: Y1, to: %s, %s}"
CIRCLE = re.compile(
    r'<circle cx="([\d.]+)" cy="([\d.]+)" r="([\d.]+)"[^>]*class="distance"[^>]*><title>([^<]*)</title>'
)
PX_PER_M, HALF_WIDTH_M, HALF_LENGTH_M = 460.0, 0.75, 0.95  # with the margin of 0.1 m and a goal's depth


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
        (NEAR % ("hill", "at_most: 0.2"), [(0.1, 0.2, 0.2, "0.2 m from hill")]),
        (NEAR % ("[-0.3, 0]", "at_least: 0.15"), [(-0.3, 0.0, 0.15, "0.15 m from (-0.3, 0)")]),
        (
            NEAR % ("hill", "at_least: 0.1, at_most: 0.2"),
            [(0.1, 0.2, 0.1, "0.1 m from hill"), (0.1, 0.2, 0.2, "0.2 m from hill")],
        ),
        ("{condition: spot_free, spot: hill, clearance_m: 0.12}", [(0.1, 0.2, 0.12, "0.12 m from hill")]),
        (
            "{condition: spot_free, spot: marks, of: none}",
            [(0.1, 0.2, 0.08, "0.08 m from hill"), (0.0, 0.0, 0.08, "0.08 m from centre")],
        ),
        ("{condition: spot_free, spot: hill, clearance_m: 0}", []),
        (NEAR % ("marks", "at_most: 0.1"), [(0.1, 0.2, 0.1, "0.1 m from hill"), (0.0, 0.0, 0.1, "0.1 m from centre")]),
        (NEAR % ("ball", "at_most: 0.1"), []),  # it moves
        (
            NEAR % ("hill", "at_least: 0.1, at_most: {counter: reach_m}"),
            [(0.1, 0.2, 0.1, "0.1 m from hill"), (0.1, 0.2, 0.3, "0.3 m from hill")],  # no rule changes the counter
        ),
        (NEAR % ("hill", "at_most: {counter: none_yet}"), []),
        (NEAR % ("hill", "at_most: {counter: yellow}"), []),
        (NEAR % ("hill", "at_most: 0.2") + ", " + NEAR % ("hill", "at_most: 0.2"), [(0.1, 0.2, 0.2, "0.2 m from hill")]),
        ("{condition: any_of, conditions: [" + NEAR % ("hill", "at_most: 0.2") + "]}", [(0.1, 0.2, 0.2, "0.2 m from hill")]),
    ],
)  # fmt: skip
def test_distance_from_a_spot_or_a_point_is_a_circle(condition, circles):
    assert circles_of(drawn(condition)) == circles


def test_distance_that_is_counted_is_the_initial_one():
    picture = drawn(NEAR % ("hill", "at_most: {counter: reach_m}"), "{action: count, counter: reach_m, by: 0.1}")
    assert circles_of(picture) == [(0.1, 0.2, 0.3, "0.3 m from hill (reach_m at first; rules count it)")]


def test_distance_is_in_the_legend():
    picture = drawn(NEAR % ("hill", "at_most: 0.2"))
    assert ">Distances that rules measure (m)<" in picture
    assert ">0.2 from hill<" in picture
    assert "Distances" not in drawn("")


def test_distance_from_a_spot_that_rules_set_is_drawn_where_the_half_begins():
    (circle,) = circles_of(drawn(NEAR % ("hill", "at_most: 0.2"), "{action: set_spot, spot: hill, to: ball}"))
    assert circle == (0.1, 0.2, 0.2, "0.2 m from hill when a half starts; rules set it")


def test_distance_of_the_displaced_trigger_is_a_circle():
    text = (SMALL % ("", "{action: end}")).replace(
        "{trigger: half_started}", "{trigger: displaced, entity: B1, from: [0.3, 0.3], distance_m: 0.05}"
    )
    loaded = load_text(text)
    assert circles_of(draw_scenario(loaded.scenario, loaded.roster)) == [(0.3, 0.3, 0.05, "0.05 m from (0.3, 0.3)")]


PLACES = """
zones:
  triangle: {shape: polygon, points_m: [[-0.4, -0.3], [-0.1, -0.3], [-0.1, 0.1]]}
  miles: {shape: rect, x_min_m: 0.3, x_max_m: 1000}
gates: {line: {from_m: [-0.2, 0.1], to_m: [0.2, 0.2]}, nose: {from_m: [0, 0], to_m: [0.1, 0], anchor: Y1}}
obstacles: {fence: {shape: wall, from_m: [0.2, -0.6], to_m: [0.4, -0.6], thickness_m: 0.02}}
"""
BAND = re.compile(r'<path d="([^"]*)" [^>]*stroke-width="([\d.]+)"[^>]*class="distance"[^>]*><title>([^<]*)</title>')


def bands(to: str) -> list[tuple[list[tuple[float, float]], float, str]]:
    """Return the bands as the outline around which they lie, their reach, and their title."""
    loaded = load_text((SMALL % (NEAR % (to, "at_most: 0.07"), "{action: end}")) + PLACES)
    found = []
    for path, width, title in BAND.findall(draw_scenario(loaded.scenario, loaded.roster)):
        points = [(float(x), float(y)) for x, y in re.findall(r"(-?[\d.]+) (-?[\d.]+)", path)]
        outline = [(round(x / PX_PER_M - HALF_WIDTH_M, 2), round(HALF_LENGTH_M - y / PX_PER_M, 2)) for x, y in points]
        found.append((outline, round(float(width) / 2 / PX_PER_M, 3), title))
    return found


@pytest.mark.parametrize(
    ("to", "outline"),
    [
        ("triangle", [(-0.4, -0.3), (-0.1, -0.3), (-0.1, 0.1)]),
        ("line", [(-0.2, 0.1), (0.2, 0.2)]),
        ("fence", [(0.2, -0.6), (0.4, -0.6)]),
    ],
)
def test_distance_from_a_zone_a_gate_or_a_wall_is_a_band_around_it(to, outline):
    assert bands(to) == [(outline, 0.07, f"0.07 m from {to}")]


def test_band_of_an_endless_zone_ends_beside_the_paper():
    ((outline, _, _),) = bands("miles")
    assert min(x for x, _ in outline) == pytest.approx(0.3)
    assert max(x for x, _ in outline) == pytest.approx(HALF_WIDTH_M + 0.07)


def test_distance_from_something_that_moves_is_not_drawn():
    assert bands("nose") == []


def test_distances_are_clipped_at_the_walls():
    picture = drawn(NEAR % ("hill", "at_most: 0.2"))
    assert '<clipPath id="within-the-walls">' in picture
    assert re.search(r'<circle [^>]*clip-path="url\(#within-the-walls\)" class="distance"', picture)
