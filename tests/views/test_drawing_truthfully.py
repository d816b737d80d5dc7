"""The drawing shows gates that turn with robots, zones larger than the paper, and every colour that has a name."""

import colorsys
import math
import re
import xml.etree.ElementTree as ET

import pytest

from rcj_challenges.scenario.load import load, load_text
from rcj_challenges.scenario.models.places import CircleZone, HalfPlaneZone, PolygonZone, RectZone
from rcj_challenges.views.drawing import draw_scenario
from rcj_challenges.views.drawing.shapes import zone_outline

SVG = "{http://www.w3.org/2000/svg}"
PX_PER_M = 460
LEFT_M, TOP_M = -0.75, 0.95  # of the paper: half the field, the goal's depth, and a margin of 0.1 m
PAPER = (-1.0, -1.0, 1.0, 1.0)
HEAD = "schema_version: 1\nid: seen\ntitle: Seen\nextends: soccersim_v2\n"


def drawn(text: str) -> ET.Element:
    loaded = load_text(HEAD + text)
    return ET.fromstring(draw_scenario(loaded.scenario, loaded.roster))


def texts(picture: ET.Element) -> list[str]:
    return [element.text or "" for element in picture.iter(f"{SVG}text")]


def titled(picture: ET.Element, title: str) -> list[ET.Element]:
    return [element for element in picture.iter() if element.findtext(f"{SVG}title") == title]


def ends(line: ET.Element) -> list[tuple[float, float]]:
    """Return both ends of a line on the field, in m."""
    x1, y1, x2, y2 = (float(line.get(key)) for key in ("x1", "y1", "x2", "y2"))
    return [(LEFT_M + x / PX_PER_M, TOP_M - y / PX_PER_M) for x, y in ((x1, y1), (x2, y2))]


# --- gates that move with something -----------------------------------------------------------------------------------


def robot_with_a_gate(yaw_rad: float) -> ET.Element:
    start = f"{{x_m: 0.3, y_m: 0, yaw_rad: {yaw_rad}, noise_m: [0, 0]}}"
    return drawn(
        f"robots: {{Y1: {{start: {start}}}}}\ngates: {{nose: {{from_m: [0.1, -0.05], to_m: [0.1, 0.05], anchor: Y1}}}}\n"
    )


@pytest.mark.parametrize(
    ("yaw_rad", "posts"),
    [
        (0, [(0.4, -0.05), (0.4, 0.05)]),
        (math.pi, [(0.2, 0.05), (0.2, -0.05)]),
        (math.pi / 2, [(0.35, 0.1), (0.25, 0.1)]),
    ],
)
def test_a_gate_in_front_of_a_robot_is_drawn_where_the_robot_looks(yaw_rad, posts):
    (gate,) = titled(robot_with_a_gate(yaw_rad), "nose")
    for post, where in zip(ends(gate), posts, strict=True):
        assert post == pytest.approx(where, abs=0.001)


def test_the_mark_of_a_gate_turns_with_its_robot():
    (mark,) = titled(robot_with_a_gate(math.pi), "forward")
    (x, _), (tip_x, _) = ends(mark)
    assert tip_x > x  # ahead of this gate is the robot itself, which looks towards -x


def test_a_gate_of_a_turned_box_turns_with_the_box():
    picture = drawn(
        "obstacles: {bin: {shape: box, centre_m: [0.3, 0], size_m: [0.1, 0.1], yaw_rad: 3.14159265, movable: true}}\n"
        "gates: {mouth: {from_m: [0.1, -0.05], to_m: [0.1, 0.05], anchor: bin}}\n"
    )
    (gate,) = titled(picture, "mouth")
    assert ends(gate)[0] == pytest.approx((0.2, 0.05), abs=0.001)


def test_the_legend_says_from_where_a_gate_that_moves_is_measured():
    entries = " ".join(texts(robot_with_a_gate(0)))
    assert "(0.1, -0.05) to (0.1, 0.05), moving with Y1 (x forward, y left)" in re.sub(r"\s+", " ", entries)


def test_for_a_robot_that_looks_along_minus_x_the_legend_says_so():
    picture = drawn(
        "kits: {v2: {looks_along: '-x'}}\ngates: {nose: {from_m: [0.1, -0.05], to_m: [0.1, 0.05], anchor: Y1}}\n"
    )
    assert "moving with Y1 (x backward, y right)" in re.sub(r"\s+", " ", " ".join(texts(picture)))


def test_the_legend_says_what_the_mark_of_a_gate_means():
    assert "Gates (m; the short mark points forward)" in texts(robot_with_a_gate(0))


# --- zones larger than the paper --------------------------------------------------------------------------------------

LARGE = {
    "a band": RectZone(shape="rect", x_min_m=-5, x_max_m=5, y_min_m=0.2, y_max_m=0.4),
    "a circle": CircleZone(shape="circle", centre_m=(0.9, 0), radius_m=0.5),
    "a circle around all": CircleZone(shape="circle", centre_m=(0, 0), radius_m=9),
    "a polygon": PolygonZone(shape="polygon", points_m=((0, 0), (4, 1), (0, 3), (0.5, 1))),
    "a half": HalfPlaneZone(shape="half_plane", through_m=(0.2, 0), normal=(1, 0.3)),
}


@pytest.mark.parametrize("zone", LARGE.values(), ids=list(LARGE))
def test_a_zone_larger_than_the_paper_ends_at_its_edge(zone):
    outline = zone_outline(zone, PAPER)
    assert len(outline) >= 3
    assert all(abs(x) <= 1 + 1e-9 and abs(y) <= 1 + 1e-9 for x, y in outline)


def test_a_zone_that_fits_keeps_its_corners():
    zone = PolygonZone(shape="polygon", points_m=((0, 0), (0.5, 0), (0.2, 0.1), (0, 0.5)))
    assert zone_outline(zone, PAPER) == list(zone.points_m)


def test_of_a_zone_beside_the_paper_nothing_is_shown():
    assert zone_outline(CircleZone(shape="circle", centre_m=(3, 0), radius_m=0.5), PAPER) == []


def test_a_zone_beside_the_paper_stands_in_the_legend_only():
    picture = drawn("zones: {far: {shape: circle, centre_m: [4, 0], radius_m: 0.1}}\n")
    assert [text for text in texts(picture) if "far" in text] == ["far: within 0.1 of (4, 0)"]


def test_all_but_a_zone_beside_the_paper_is_all_of_the_floor():
    picture = drawn("zones: {most: {shape: circle, centre_m: [4, 0], radius_m: 0.1, inverted: true}}\n")
    (most,) = titled(picture, "all but most")
    assert extent(most) == pytest.approx((-0.65, -0.75, 0.65, 0.75), abs=0.001)
    assert "most" in texts(picture)


# --- zones with open sides --------------------------------------------------------------------------------------------


def extent(path: ET.Element) -> tuple[float, float, float, float]:
    """Return the smallest x and y and the largest x and y of a path, in m."""
    points = re.findall(r"(-?[\d.]+) (-?[\d.]+)", path.get("d"))
    xs, ys = [LEFT_M + float(x) / PX_PER_M for x, _ in points], [TOP_M - float(y) / PX_PER_M for _, y in points]
    return min(xs), min(ys), max(xs), max(ys)


OPEN = {
    "{shape: half_plane, through_m: [0, 0.5], normal: [0, 1], drawn: true}": (-0.65, 0.5, 0.65, 0.75),
    "{shape: rect, x_min_m: -0.35, x_max_m: 0.35, y_min_m: 0.59, drawn: true}": (-0.35, 0.59, 0.35, 0.75),
    "{shape: rect, x_max_m: -0.1}": (-0.65, -0.75, -0.1, 0.75),
    "{shape: half_plane, through_m: [0, 0.5], normal: [0, 1], inverted: true}": (-0.65, -0.75, 0.65, 0.75),
    "{shape: circle, centre_m: [0, 0], radius_m: 0.3, inverted: true}": (-0.65, -0.75, 0.65, 0.75),
    # Of what lies behind the floor the goals are the end.
    "{shape: rect, y_min_m: 0.8}": (-0.65, 0.8, 0.65, 0.85),
}


@pytest.mark.parametrize(("zone", "ends_at"), OPEN.items(), ids=list(OPEN))
def test_a_zone_with_an_open_side_ends_where_the_floor_does_and_covers_no_goal(zone, ends_at):
    picture = drawn(f"zones: {{yonder: {zone}}}\n")
    (shape,) = [*titled(picture, "yonder"), *titled(picture, "all but yonder")]
    assert extent(shape) == pytest.approx(ends_at, abs=0.001)


def test_the_name_of_a_zone_with_an_open_side_stands_on_the_floor():
    picture = drawn("zones: {finish: {shape: half_plane, through_m: [0, 0.5], normal: [0, 1]}}\n")
    (name,) = [element for element in picture.iter(f"{SVG}text") if element.text == "finish"]
    assert 0.5 < TOP_M - float(name.get("y")) / PX_PER_M < 0.75


def test_all_but_the_floor_is_what_lies_around_it():
    picture = drawn(
        "zones: {outside: {shape: rect, x_min_m: -1, x_max_m: 1, y_min_m: -1, y_max_m: 1, inverted: true}}\n"
    )
    (outside,) = titled(picture, "all but outside")
    assert extent(outside) == pytest.approx((-0.75, -0.95, 0.75, 0.95), abs=0.001)


# --- lines of the field -----------------------------------------------------------------------------------------------

NO_GOALS = (
    "field: {goals: {blue_goal: null, yellow_goal: null}}\nzones: {blue_goal: null, yellow_goal: null}\n"
    "groups: {in_play: null}\n"
)


def test_a_field_without_goals_has_no_halfway_line():
    picture = drawn(NO_GOALS)
    assert titled(picture, "halfway line, y = 0") == []
    assert len(titled(picture, "y = 0")) == 1
    assert len(titled(drawn(""), "halfway line, y = 0")) == 1


# --- spots on obstacles -----------------------------------------------------------------------------------------------

ON_A_BOX = (
    "obstacles: {long_box: {shape: box, centre_m: [0, 0.45], size_m: [0.5, 0.06], yaw_rad: 0.3}}\n"
    "spots: {c1: {x_m: -0.19, y_m: 0.39}, c2: {x_m: 0, y_m: 0.45}, c3: {x_m: 0.19, y_m: 0.51}}\n"
)


def test_on_an_obstacle_stands_its_own_name_and_that_of_no_spot():
    picture = drawn(ON_A_BOX)
    on_the_box = []
    for element in picture.iter(f"{SVG}text"):
        if element.get("class") != "label":
            continue
        x, y = LEFT_M + float(element.get("x")) / PX_PER_M, TOP_M - (float(element.get("y")) - 3.5) / PX_PER_M - 0.45
        along, across = x * math.cos(0.3) + y * math.sin(0.3), y * math.cos(0.3) - x * math.sin(0.3)
        if abs(along) < 0.25 and abs(across) < 0.03:
            on_the_box.append(element.text)
    assert on_the_box == ["long_box"]


def test_a_spot_on_an_obstacle_can_be_seen():
    titles = [element.findtext(f"{SVG}title") for element in drawn(ON_A_BOX)]
    assert titles.index("c1") > titles.index("long_box")


# --- colours ----------------------------------------------------------------------------------------------------------


def team(colour: str) -> ET.Element:
    robot = f"{{colour: {colour}, number: 1, kit: v2, start: {{x_m: 0.3, y_m: 0, yaw_rad: 0}}}}"
    return drawn(f"robots: {{P1: {robot}}}\nentrants: {{yellow: {{robots: {{P1: robot.py}}}}}}\n")


@pytest.mark.parametrize(
    ("colour", "body", "letters"),
    [("red", "#ff0000", "number"), ("rebeccapurple", "#663399", "number"), ("white", "#ffffff", "number dark")],
)
def test_robots_of_any_team_are_drawn_in_its_colour_with_a_name_that_can_be_read(colour, body, letters):
    picture = team(colour)
    (chassis,) = titled(picture, "P1 at its start")
    assert chassis.get("fill") == body
    (name,) = [element for element in picture.iter(f"{SVG}text") if element.text == "P1"]
    assert name.get("class") == letters


@pytest.mark.parametrize(("colour", "shown"), [("RebeccaPurple", "#663399"), ("#00Ff00", "#00ff00")])
def test_colours_stand_in_the_picture_as_numbers_that_every_program_knows(colour, shown):
    picture = drawn(f"balls: {{ball: {{colour: '{colour}'}}}}\n")
    (ball,) = titled(picture, "ball at its start")
    assert ball.get("fill") == shown


def test_the_picture_of_the_match_keeps_the_colours_of_its_teams():
    loaded = load("match")
    picture = ET.fromstring(draw_scenario(loaded.scenario, loaded.roster))
    assert titled(picture, "B1 at its start")[0].get("fill") == "#2563eb"
    assert titled(picture, "Y1 at its start")[0].get("fill") == "#ca8a04"


def test_no_zone_has_the_orange_of_what_rules_put_somewhere():
    zones = ", ".join(f"z{k}: {{shape: circle, centre_m: [0, {k / 20}], radius_m: 0.02}}" for k in range(12))
    picture = drawn(f"zones: {{{zones}}}\n")
    hues = set()
    for k in range(12):
        (zone,) = titled(picture, f"z{k}")
        red, green, blue = (int(zone.get("stroke")[at : at + 2], 16) / 255 for at in (1, 3, 5))
        hues.add(round(360 * colorsys.rgb_to_hsv(red, green, blue)[0]))
    assert len(hues) > 4
    assert [hue for hue in hues if 10 < hue < 60] == []


@pytest.mark.parametrize("colour", ["yellow", "white", "lime", "gold", "pink", "blue", "black", "'#ffd700'"])
def test_the_name_of_a_zone_can_be_read_whatever_its_colour(colour):
    # 4.5 is the least contrast of small text in the Web Content Accessibility Guidelines 2 (1.4.3).
    picture = drawn(f"zones: {{hill: {{shape: circle, centre_m: [0, 0], radius_m: 0.2, colour: {colour}}}}}")
    (label,) = (one for one in picture.iter(f"{SVG}text") if one.text == "hill")
    ink = label.attrib["style"].removeprefix("fill:#")
    shares = [int(ink[k : k + 2], 16) / 255 for k in (0, 2, 4)]
    linear = [share / 12.92 if share <= 0.04045 else ((share + 0.055) / 1.055) ** 2.4 for share in shares]
    luminance = sum(weight * share for weight, share in zip((0.2126, 0.7152, 0.0722), linear, strict=True))
    assert 1.05 / (luminance + 0.05) >= 4.5
