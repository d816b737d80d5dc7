"""Distances that rules measure from what stands still are dotted lines in the drawing, with their numbers in the legend."""

from __future__ import annotations

import math
import re
from functools import cache
from io import BytesIO
from itertools import pairwise

import numpy as np
import pytest
from PIL import Image

from rcj_challenges.scenario.load import load_text
from rcj_challenges.scenario.models.places import RectZone
from rcj_challenges.views.drawing import draw_scenario
from rcj_challenges.views.drawing.around import lines_around, measure
from rcj_challenges.views.drawing.png import ZOOM, png_from_svg

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
CIRCLE = re.compile(r'<circle cx="([\d.]+)" cy="([\d.]+)" r="([\d.]+)"[^>]*class="reach"[^>]*><title>([^<]*)</title>')
PX_PER_M, HALF_WIDTH_M, HALF_LENGTH_M = 460.0, 0.75, 0.95  # with the margin of 0.1 m and a goal's depth


def drawn(conditions: str, action: str = "{action: end}") -> str:
    loaded = load_text(SMALL % (conditions, action))
    return draw_scenario(loaded.scenario, loaded.roster)


def reaches(picture: str) -> list[tuple[float, float, float, str]]:
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
            [(0.1, 0.2, 0.1, "0.1 m from hill"), (0.1, 0.2, 0.3, "0.3 m from hill")],  # which nobody counts
        ),
        (NEAR % ("hill", "at_most: {counter: none_yet}"), []),
        (NEAR % ("hill", "at_most: {counter: yellow}"), []),
        (NEAR % ("hill", "at_most: 0.2") + ", " + NEAR % ("hill", "at_most: 0.2"), [(0.1, 0.2, 0.2, "0.2 m from hill")]),
        ("{condition: any_of, conditions: [" + NEAR % ("hill", "at_most: 0.2") + "]}", [(0.1, 0.2, 0.2, "0.2 m from hill")]),
    ],
)  # fmt: skip
def test_a_distance_is_a_circle(condition, circles):
    assert reaches(drawn(condition)) == circles


def test_a_counter_that_rules_count_is_told_to_be_so_at_first_only():
    picture = drawn(NEAR % ("hill", "at_most: {counter: reach_m}"), "{action: count, counter: reach_m, by: 0.1}")
    assert reaches(picture) == [(0.1, 0.2, 0.3, "0.3 m from hill (reach_m at first; rules count it)")]


def test_the_legend_has_its_number():
    picture = drawn(NEAR % ("hill", "at_most: 0.2"))
    assert ">Distances that rules measure (m)<" in picture
    assert ">0.2 from hill<" in picture
    assert "Distances" not in drawn("")


def test_of_a_spot_that_rules_set_it_is_drawn_where_the_half_begins():
    (circle,) = reaches(drawn(NEAR % ("hill", "at_most: 0.2"), "{action: set_spot, spot: hill, to: ball}"))
    assert circle == (0.1, 0.2, 0.2, "0.2 m from hill when a half starts; rules set it")


def test_from_where_something_may_not_be_moved():
    text = (SMALL % ("", "{action: end}")).replace(
        "{trigger: half_started}", "{trigger: displaced, entity: B1, from: [0.3, 0.3], distance_m: 0.05}"
    )
    loaded = load_text(text)
    assert reaches(draw_scenario(loaded.scenario, loaded.roster)) == [(0.3, 0.3, 0.05, "0.05 m from (0.3, 0.3)")]


PLACES = """
zones:
  round: {shape: circle, centre_m: [0, 0.4], radius_m: 0.1}
  ring: {shape: circle, centre_m: [0, 0], radius_m: 0.3, inverted: true}
  ell: {shape: polygon, points_m: [[-0.4, -0.3], [-0.1, -0.3], [-0.1, -0.2], [-0.3, -0.2], [-0.3, 0.1], [-0.4, 0.1]]}
  side: {shape: rect, x_min_m: 0.3}
  box: {shape: rect, x_min_m: -0.2, x_max_m: 0.2, y_min_m: -0.1, y_max_m: 0.1}
  edge: {shape: rect, x_min_m: -0.5, x_max_m: 0.5, y_min_m: -0.7, y_max_m: 0.7, inverted: true}
  slope: {shape: half_plane, through_m: [0, -0.6], normal: [-1, -3]}
gates: {line: {from_m: [-0.2, 0.1], to_m: [0.2, 0.2]}, nose: {from_m: [0, 0], to_m: [0.1, 0], anchor: Y1}}
"""
LINE = re.compile(r'<path d="([^"]*)"[^>]*class="reach"[^>]*><title>([^<]*)</title>')
FAR_M = 0.07
PAPER = (-HALF_WIDTH_M, -HALF_LENGTH_M, HALF_WIDTH_M, HALF_LENGTH_M)


def scenario_with_places():
    return load_text((SMALL % (NEAR % ("line", f"at_most: {FAR_M}"), "{action: end}")) + PLACES).scenario


@pytest.mark.parametrize("name", ["round", "ring", "ell", "side", "box", "edge", "slope", "line"])
def test_the_line_around_a_place_is_all_that_is_as_far_from_it(name):
    scenario = scenario_with_places()
    place = scenario.zones.get(name) or scenario.gates[name]
    away_m = measure(place)
    lines = lines_around(place, FAR_M, PAPER)
    drawn_points = [one for line in lines for one in finely(line)]
    assert drawn_points
    assert all(abs(away_m(x, y) - FAR_M) < 5e-4 for x, y in drawn_points)
    # Whoever looks for it on a grid finds no place of it that is not drawn.
    left, bottom, right, top = PAPER
    for x in (left + 0.05 * k for k in range(1, round((right - left) / 0.05))):
        for y in (bottom + 0.05 * k for k in range(1, round((top - bottom) / 0.05))):
            if abs(away_m(x, y) - FAR_M) < 0.02:
                assert min(math.dist((x, y), one) for one in drawn_points) < 0.035


def test_a_zone_that_reaches_for_miles_is_followed_on_the_paper_only():
    # The picture of one of 400 km would have taken minutes, and all memory.
    zone = RectZone(shape="rect", x_min_m=0.3, x_max_m=2e5, y_min_m=-2e5, y_max_m=2e5)
    ((start, end),) = lines_around(zone, FAR_M, PAPER)
    assert sorted((start, end)) == [pytest.approx((0.23, y), abs=0.011) for y in (-HALF_LENGTH_M, HALF_LENGTH_M)]


def finely(line: list[tuple[float, float]]) -> list[tuple[float, float]]:
    shares = [k / 100 for k in range(101)] if len(line) == 2 else [0.0, 0.5]
    pairs = pairwise(line)
    return [(ax + s * (bx - ax), ay + s * (by - ay)) for (ax, ay), (bx, by) in pairs for s in shares]


@pytest.mark.parametrize(
    ("to", "titles"),
    [
        ("line", ["0.07 m from line"]),
        ("box", ["0.07 m from box"]),
        ("goals", ["0.07 m from blue_goal", "0.07 m from yellow_goal"]),
        ("nose", []),  # it moves
    ],
)
def test_a_distance_from_a_zone_or_a_gate_is_drawn_and_stands_in_the_legend(to, titles):
    text = (SMALL % (NEAR % (to, f"at_most: {FAR_M}"), "{action: end}")) + PLACES
    loaded = load_text(text.replace("groups: {", "groups: {goals: [blue_goal, yellow_goal], "))
    picture = draw_scenario(loaded.scenario, loaded.roster)
    assert [title for _, title in LINE.findall(picture)] == titles
    assert all(f">{title.replace(' m from', ' from')}<" in picture for title in titles)


HALF_FLOOR_M = (0.65, 0.75)


@cache  # the one without a condition is what all of them are compared with
def pixels(condition: str) -> np.ndarray:
    """Return the picture of the field, without the legend, as it is seen."""
    with Image.open(BytesIO(png_from_svg(drawn(condition)))) as picture:
        scale = ZOOM * PX_PER_M
        return np.asarray(picture.convert("L").crop((0, 0, round(1.5 * scale), round(1.9 * scale)))).astype(int)


@pytest.mark.parametrize(
    ("to", "far_m", "in_a_goal"),
    [
        ("[0.6, 0]", 0.12, False),  # beside a wall
        ("[0, 0.72]", 0.1, True),  # before a goal: what lies in it is on the floor
        ("[0.62, 0.72]", 0.1, False),  # where a wall cuts the corner
        ("pitch", 0.02, True),  # a line around a zone that is as wide as the field
    ],
)
@pytest.mark.nightly
def test_no_distance_is_drawn_behind_the_walls(to, far_m, in_a_goal):
    # Nothing is ever there, so that nothing is measured there.
    changed = np.abs(pixels(NEAR % (to, f"at_most: {far_m}")) - pixels("")) > 8
    rows, columns = np.nonzero(changed)
    xs = columns / (ZOOM * PX_PER_M) - HALF_WIDTH_M
    ys = HALF_LENGTH_M - rows / (ZOOM * PX_PER_M)
    width_m, length_m = HALF_FLOOR_M
    on_floor = (np.abs(xs) < width_m) & (np.abs(ys) < length_m) & (np.abs(xs) + np.abs(ys) < width_m + length_m - 0.058)
    in_goal = (np.abs(xs) < 0.2) & (np.abs(ys) < length_m + 0.1)
    assert (on_floor | in_goal).all()
    assert on_floor.any() or in_goal.any()
    assert (in_goal & ~on_floor).any() == in_a_goal
