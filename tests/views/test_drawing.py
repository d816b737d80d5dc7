"""The drawing of a scenario: what is drawn where, its markers and its legend."""

import math
import re
import xml.etree.ElementTree as ET
from functools import cache
from itertools import combinations
from pathlib import Path

import pytest

from rcj_challenges.scenario.load import load, load_text
from rcj_challenges.views.drawing import draw_scenario

SVG = "{http://www.w3.org/2000/svg}"
ROOT = Path(__file__).resolve().parents[2]
SCENARIOS = sorted((ROOT / "scenarios").rglob("*.yaml"))
PX_PER_M, MARGIN_M = 290, 50 / 290
LEFT_M, TOP_M = -0.65 - MARGIN_M, 0.85 + MARGIN_M  # of the paper: half the field and the goal's depth
HEAD = "schema_version: 2\nid: seen\ntitle: Seen\nextends: soccersim_v2\n"
NO_GOALS = (
    "field: {goals: {blue_goal: null, yellow_goal: null}}\nzones: {blue_goal: null, yellow_goal: null}\n"
    "groups: {in_play: null}\n"
)


@cache
def drawn(source: Path | str) -> ET.Element:
    loaded = load(source) if isinstance(source, Path) or source == "match" else load_text(HEAD + source)
    return ET.fromstring(draw_scenario(loaded.scenario, loaded.roster))


def legend(picture: ET.Element) -> list[str]:
    return [element.text for element in picture.iter(f"{SVG}text") if element.get("class") == "entry"]


def titled(picture: ET.Element, title: str) -> list[ET.Element]:
    """Return the shapes with a title, without markers."""
    return [element for element in picture if element.tag != f"{SVG}g" and element.findtext(f"{SVG}title") == title]


def markers(picture: ET.Element) -> dict[str, ET.Element]:
    """Return the markers in the drawing by the names of what they mark."""
    found = {element.findtext(f"{SVG}title"): element for element in picture.iter(f"{SVG}g")}
    return {name: element for name, element in found.items() if name}


def box_of(marker: ET.Element) -> tuple[float, float, float, float]:
    rect = marker.find(f"{SVG}rect")
    x, y, width, height = (float(rect.get(key)) for key in ("x", "y", "width", "height"))
    return x, y, x + width, y + height


def place_of(marker: ET.Element) -> tuple[float, float]:
    """Return the middle of a marker on the field, in m."""
    left, top, right, bottom = box_of(marker)
    return LEFT_M + (left + right) / 2 / PX_PER_M, TOP_M - (top + bottom) / 2 / PX_PER_M


def overlap(a: tuple[float, ...], b: tuple[float, ...]) -> bool:
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]


def ends(line: ET.Element) -> list[tuple[float, float]]:
    """Return both ends of a line on the field, in m."""
    x1, y1, x2, y2 = (float(line.get(key)) for key in ("x1", "y1", "x2", "y2"))
    return [(LEFT_M + x / PX_PER_M, TOP_M - y / PX_PER_M) for x, y in ((x1, y1), (x2, y2))]


def extent_px(path: ET.Element) -> tuple[float, float, float, float]:
    points = re.findall(r"(-?[\d.]+) (-?[\d.]+)", path.get("d"))
    xs, ys = [float(x) for x, _ in points], [float(y) for _, y in points]
    return min(xs), min(ys), max(xs), max(ys)


def extent_m(path: ET.Element) -> tuple[float, float, float, float]:
    left, top, right, bottom = extent_px(path)
    return LEFT_M + left / PX_PER_M, TOP_M - bottom / PX_PER_M, LEFT_M + right / PX_PER_M, TOP_M - top / PX_PER_M


# --- markers and legend -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("source", SCENARIOS, ids=lambda path: path.stem)
def test_everything_has_a_marker_or_a_name_and_a_line_in_the_legend(source):
    scenario, picture = load(source).scenario, drawn(source)
    lines, marked = legend(picture), markers(picture)
    for name in (*scenario.zones, *scenario.gates, *scenario.spots, *scenario.obstacles, *scenario.balls):
        assert (name in marked) != (f"{name}: a rule puts it when a half starts" in lines)
    for name in scenario.robots:
        assert bool(titled(picture, name)) != (f"{name}: a rule puts it when a half starts" in lines)
    for name in (*scenario.zones, *scenario.gates, *scenario.spots, *scenario.balls, *scenario.robots):
        assert any(line.startswith(f"{name}: ") for line in lines)


@pytest.mark.parametrize("source", SCENARIOS, ids=lambda path: path.stem)
def test_markers_do_not_overlap_and_stay_inside_the_picture(source):
    picture = drawn(source)
    boxes = [box_of(marker) for marker in picture.iter(f"{SVG}g")]
    assert [(a, b) for a, b in combinations(boxes, 2) if overlap(a, b)] == []
    right, bottom = float(picture.get("width")), float(picture.get("height"))
    assert all(x >= 0 and y >= 0 and x2 <= right and y2 <= bottom for x, y, x2, y2 in boxes)


def test_number_in_the_drawing_is_that_in_the_legend():
    picture = drawn("match")
    numbers = [element.findtext(f"{SVG}text") for element in picture.iter(f"{SVG}g")]
    in_drawing, in_legend = numbers[: len(numbers) // 2], numbers[len(numbers) // 2 :]
    assert in_drawing == in_legend == [str(k) for k in range(1, len(in_legend) + 1)]


def test_legend_has_the_numbers_that_the_referee_tests():
    assert "hill: -0.2 < x < 0.1, y > 0.4" in legend(
        drawn("zones: {hill: {shape: rect, x_min_m: -0.2, x_max_m: 0.1, y_min_m: 0.4}}\n")
    )


def test_marker_of_a_zone_is_in_it():
    picture = drawn("zones: {finish: {shape: half_plane, through_m: [0, 0.5], normal: [0, 1]}}\n")
    assert 0.5 < place_of(markers(picture)["finish"])[1] < 0.75


def test_names_are_escaped():
    loaded = load("match", ["title='<script>alert(1)</script>'"])
    assert not list(ET.fromstring(draw_scenario(loaded.scenario, loaded.roster)).iter(f"{SVG}script"))


# --- zones and field --------------------------------------------------------------------------------------------------


def test_field_without_walls_has_no_walls_in_its_picture():
    picture = drawn(NO_GOALS.replace("field: {", "field: {walls: false, "))
    assert titled(picture, "the field, inside its walls") == []
    assert len(titled(picture, "the field")) == 1


def test_without_walls_the_picture_reaches_to_what_is_on_the_floor():
    more = "spots: {far: {x_m: -0.9, y_m: 0.9}}\nzones: {bay: {shape: circle, anchor: far, radius_m: 0.3, drawn: true}, blue_goal: null"
    picture = drawn(NO_GOALS.replace("field: {", "field: {walls: false, ").replace("zones: {blue_goal: null", more))
    assert "far: -0.9, 0.9" in legend(picture)
    left, top, _, _ = extent_px(titled(picture, "bay")[0])
    assert min(left, top) > 0


def test_spot_that_is_drawn_on_the_field_is_a_dot_in_its_colour():
    picture = drawn("spots: {seen: {x_m: 0.1, y_m: 0, drawn: true, colour: red}, unseen: {x_m: 0, y_m: 0.2}}")
    fills = {name: [one.get("fill") for one in titled(picture, name)] for name in ("seen", "unseen")}
    assert fills == {"seen": ["#ff0000"], "unseen": [None, None]}


@pytest.mark.parametrize(("colour", "stroke"), [("red", "#ff0000"), ("'#12ab34'", "#12ab34")])
def test_zone_is_drawn_in_its_colour(colour, stroke):
    picture = drawn(f"zones: {{hill: {{shape: circle, centre_m: [0, 0], radius_m: 0.2, colour: {colour}}}}}")
    assert titled(picture, "hill")[0].get("stroke") == stroke


@pytest.mark.parametrize(
    ("zone", "expected"),
    [
        ("{shape: rect, x_min_m: -0.2, x_max_m: 0.1, y_min_m: 0.4, y_max_m: 0.5}", (-0.2, 0.4, 0.1, 0.5)),
        ("{shape: circle, centre_m: [0.1, 0.2], radius_m: 0.3}", (-0.2, -0.1, 0.4, 0.5)),
        ("{shape: half_plane, through_m: [0, 0.5], normal: [0, 1], drawn: true}", (-0.65, 0.5, 0.65, 0.75)),
        ("{shape: rect, x_min_m: -0.35, x_max_m: 0.35, y_min_m: 0.59}", (-0.35, 0.59, 0.35, 0.75)),
        # Zones behind the floor end where the goals do; what is inverted ends at the paper.
        ("{shape: rect, y_min_m: 0.8}", (-0.65, 0.8, 0.65, 0.85)),
        (
            "{shape: rect, x_min_m: -1, x_max_m: 1, y_min_m: -1, y_max_m: 1, inverted: true}",
            (LEFT_M, -TOP_M, -LEFT_M, TOP_M),
        ),
    ],
)
def test_zone_is_drawn_as_far_as_it_reaches(zone, expected):
    picture = drawn(f"zones: {{yonder: {zone}}}\n")
    (shape,) = [*titled(picture, "yonder"), *titled(picture, "all but yonder")]
    assert extent_m(shape) == pytest.approx(expected, abs=0.001)


def test_zone_beside_the_paper_is_only_in_the_legend():
    picture = drawn("zones: {far: {shape: circle, centre_m: [4, 0], radius_m: 0.1}}\n")
    assert "far: within 0.1 of (4, 0)" in legend(picture)
    assert "far" not in markers(picture)


@pytest.mark.parametrize(("width_m", "length_m"), [(10, 10), (10, 2), (1.3, 10), (3, 3), (5, 4)])
def test_field_of_any_size_fits_on_a_page_and_marks_keep_their_size(width_m, length_m):
    field = f"field: {{width_m: {width_m}, length_m: {length_m}, goals: {{blue_goal: null, yellow_goal: null}}}}\n"
    picture = drawn(NO_GOALS.replace(NO_GOALS.splitlines()[0] + "\n", field) + "spots: {well: {x_m: -0.2, y_m: 0}}\n")
    left, top, right, bottom = extent_px(titled(picture, "the field, inside its walls")[0])
    assert right - left <= 481
    assert bottom - top <= 721
    assert right - left > 475 or bottom - top > 715
    assert (right - left) / (bottom - top) == pytest.approx(width_m / length_m, rel=0.01)
    across = [float(line.get("x2")) - float(line.get("x1")) for line in titled(picture, "well")]
    assert max(across) == pytest.approx(10.4, abs=0.2)


# --- gates ------------------------------------------------------------------------------------------------------------


def robot_with_a_gate(yaw_rad: float) -> ET.Element:
    start = f"{{x_m: 0.3, y_m: 0, yaw_rad: {yaw_rad}, noise_m: [0, 0]}}"
    gate = "{from_m: [0.1, -0.05], to_m: [0.1, 0.05], anchor: Y1}"
    return drawn(f"robots: {{Y1: {{start: {start}}}}}\ngates: {{nose: {gate}}}\n")


@pytest.mark.parametrize(
    ("yaw_rad", "posts"),
    [
        (0, [(0.4, -0.05), (0.4, 0.05)]),
        (math.pi, [(0.2, 0.05), (0.2, -0.05)]),
        (math.pi / 2, [(0.35, 0.1), (0.25, 0.1)]),
    ],
)
def test_gate_in_front_of_a_robot_is_drawn_where_the_robot_looks(yaw_rad, posts):
    (gate,) = titled(robot_with_a_gate(yaw_rad), "nose")
    for post, expected in zip(ends(gate), posts, strict=True):
        assert post == pytest.approx(expected, abs=0.001)


def test_forward_mark_of_a_gate_turns_with_its_robot():
    (mark,) = titled(robot_with_a_gate(math.pi), "forward")
    (x, _), (tip_x, _) = ends(mark)
    assert tip_x > x  # forward through this gate is towards the robot, which looks towards -x


# --- robots and balls -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("colour", "body", "letters"),
    [("red", "#ff0000", "number"), ("rebeccapurple", "#663399", "number"), ("white", "#ffffff", "number dark")],
)
def test_robot_is_drawn_in_its_colour_with_a_readable_name(colour, body, letters):
    robot = f"{{colour: {colour}, number: 1, kit: v2, start: {{x_m: 0.3, y_m: 0, yaw_rad: 0}}}}"
    picture = drawn(f"robots: {{P1: {robot}}}\nentrants: {{yellow: {{robots: {{P1: robot.py}}}}}}\n")
    assert titled(picture, "P1")[0].get("fill") == body
    assert [element.get("class") for element in picture.iter(f"{SVG}text") if element.text == "P1"] == [letters]


def test_robot_with_a_long_name_has_a_marker():
    robot = "{colour: red, number: 1, kit: v2, start: {x_m: 0.3, y_m: 0, yaw_rad: 0}}"
    picture = drawn(f"robots: {{Goalkeeper: {robot}}}\nentrants: {{yellow: {{robots: {{Goalkeeper: robot.py}}}}}}\n")
    assert "Goalkeeper" in markers(picture)


def test_start_noise_is_a_box():
    (area,) = titled(drawn("match"), "B1 starts in here")
    assert extent_m(area) == pytest.approx((0.225, 0.225, 0.375, 0.375), abs=0.001)
    assert "chance shifts a start within its box (±)" in legend(drawn("match"))
    still = ", ".join(f"{name}: {{start: {{noise_m: [0, 0]}}}}" for name in ("B1", "B2", "B3", "Y1", "Y2", "Y3"))
    picture = drawn(f"robots: {{{still}}}\n")
    assert "chance shifts a start within its box (±)" not in legend(picture)


def test_marker_of_the_floor_is_not_in_a_goal():
    left, _, right, bottom = box_of(markers(drawn("match"))["pitch"])
    assert TOP_M - bottom / PX_PER_M < 0.75 + 0.03
    assert right / PX_PER_M + LEFT_M < -0.3
    assert left > 0


# --- what rules put somewhere as a half starts ------------------------------------------------------------------------

AT_ONCE = "rules: {it: {triggers: [{trigger: half_started}], actions: [%s]}}\n"


def test_ball_that_a_rule_places_at_once_is_drawn_there():
    picture = drawn(AT_ONCE % "{action: place, entity: ball, at: {point: [0.2, -0.3]}}")
    (ball,) = titled(picture, "ball")
    assert float(ball.get("cx")) == pytest.approx((0.2 - LEFT_M) * PX_PER_M, abs=0.1)
    assert float(ball.get("cy")) == pytest.approx((TOP_M + 0.3) * PX_PER_M, abs=0.1)
    assert "ball: 0.2, -0.3" in legend(picture)


def test_robot_that_a_layout_turns_is_drawn_as_it_stands_then():
    layout = "placements: {all: [{entity: B1, at: {spot: centre}, facing: 0, mirror: {axis: y}}]}\n"
    picture = drawn(layout + AT_ONCE % "{action: place, layout: all, mirror: {axis: x}}")
    assert "B1: 0, 0, turned by 0°" in legend(picture)
    assert titled(picture, "B1 starts in here") == []


@pytest.mark.parametrize(
    "at", ["{on_line: [[-0.3, 0], [0.3, 0]]}", "{uniform_in: pitch}", "{nearest_free: neutral_spots}"]
)
def test_ball_that_chance_or_play_places_at_once_is_not_drawn_at_its_start(at):
    picture = drawn(AT_ONCE % f"{{action: place, entity: ball, at: {at}}}")
    assert titled(picture, "ball") == []
    assert "ball: a rule puts it when a half starts" in legend(picture)


def test_robot_that_every_drawn_layout_puts_at_the_same_place_is_drawn_there():
    layouts = "{a: [{entity: [B1, B2], at: {point: [0.1, 0]}}], b: [{entity: B1, at: {point: [0.1, 0]}}]}"
    draws = f"placements: {layouts}\ndraws: {{side: {{values: [a, b]}}}}\n"
    lines = legend(drawn(draws + AT_ONCE % "{action: place, layout: {draw: side}}"))
    assert "B1: 0.1, 0, turned by -90°" in lines
    assert "B2: a rule puts it when a half starts" in lines


def test_robot_that_may_stay_at_its_start_is_drawn_there():
    # Whichever team kicks off, the robot of the other one stays at its start.
    assert titled(drawn("match"), "B3")
    assert titled(drawn("match"), "Y3")
