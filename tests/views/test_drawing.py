"""The drawing shows what the referee tests, from the same numbers."""

import math
import os
import re
import subprocess
import sys
import xml.etree.ElementTree as ET
from functools import cache
from itertools import combinations, product
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rcj_challenges.scenario.load import load, load_text
from rcj_challenges.scenario.models.places import CircleZone, HalfPlaneZone, RectZone
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.views.drawing import draw_scenario
from rcj_challenges.views.drawing.labels import Label, Surroundings, place_labels
from rcj_challenges.views.drawing.shapes import zone_outline, zone_words

SVG = "{http://www.w3.org/2000/svg}"
SHIPPED = ("match", "fast_shooter", "pass_the_ball", "precision_lidar")
ROOT = Path(__file__).resolve().parents[2]
RECIPES = re.findall(
    r"^```yaml\n(.*?)^```$", (ROOT / "docs" / "recipes.md").read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL
)
ALL = [
    *(pytest.param(path, id=path.stem) for path in sorted((ROOT / "scenarios").rglob("*.yaml"))),
    *(pytest.param(text, id=text.split("id: ")[1].split()[0]) for text in RECIPES),
]
PAPER = (-1.0, -1.0, 1.0, 1.0)


@cache
def _svg(name: str, *overrides: str) -> str:
    loaded = load(name, overrides)
    return draw_scenario(loaded.scenario, loaded.roster)


def drawn(name: str, *overrides: str) -> ET.Element:
    return ET.fromstring(_svg(name, *overrides))


def texts(picture: ET.Element) -> list[str]:
    return [element.text or "" for element in picture.iter(f"{SVG}text")]


@pytest.mark.parametrize("name", SHIPPED)
def test_every_zone_spot_gate_and_robot_is_labelled(name):
    scenario = load(name).scenario
    labels = texts(drawn(name))
    for thing in (*scenario.zones, *scenario.spots, *scenario.gates, *scenario.robots, *scenario.balls):
        assert any(thing in label for label in labels), thing


@pytest.mark.parametrize(("colour", "stroke"), [("red", "#ff0000"), ("'#12ab34'", "#12ab34")])
def test_a_zone_that_has_a_colour_is_drawn_in_it(colour, stroke):
    strokes = [path.get("stroke") for path in drawn("match", f"zones.pitch.colour={colour}").iter(f"{SVG}path")]
    assert strokes.count(stroke) == 1


def test_the_drawing_moves_when_a_number_changes():
    before = {element.get("d") for element in drawn("match").iter(f"{SVG}path")}
    after = {element.get("d") for element in drawn("match", "zones.blue_goal.x_max_m=0.1").iter(f"{SVG}path")}
    assert before != after


def test_the_legend_tells_the_number_that_the_referee_tests():
    assert any(
        "-0.2 < x < 0.1, 0.745 < y < 0.849" in text for text in texts(drawn("match", "zones.blue_goal.x_max_m=0.1"))
    )


# Width and height of a character, in px, by what kind of text it is: as in wide fonts, of which readers may have one.
CHARACTER = {
    "label": (6.1, 11),
    "number": (8, 13),
    "axis": (5.6, 10),
    "title": (9, 16),
    "head": (7, 12),
    "entry": (6, 11),
}


def boxes(picture: ET.Element, *kinds: str) -> list[tuple[str, tuple[float, float, float, float]]]:
    """Return all texts of some kinds with what they cover: left, top, right, bottom in px."""
    found = []
    for element in picture.iter(f"{SVG}text"):
        width, height = CHARACTER[element.get("class")]
        if kinds and element.get("class") not in kinds:
            continue
        text, x, y = element.text, float(element.get("x")), float(element.get("y"))
        wide = len(text) * width
        left = x - wide / 2 if element.get("class") in ("label", "number") else x
        found.append((text, (left, y - 0.8 * height, left + wide, y + 0.2 * height)))
    return found


def overlap(a: tuple[float, ...], b: tuple[float, ...]) -> bool:
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]


@cache
def picture_of(source: Path | str) -> tuple[Scenario, ET.Element]:
    loaded = load(source) if isinstance(source, Path) else load_text(source)
    return loaded.scenario, ET.fromstring(draw_scenario(loaded.scenario, loaded.roster))


@pytest.mark.parametrize("source", ALL)
def test_no_two_texts_of_any_shipped_drawing_overlap(source):
    _, picture = picture_of(source)
    found = boxes(picture, "label", "number", "axis")
    assert len(found) > 5
    assert [(one, other) for (one, a), (other, b) in combinations(found, 2) if overlap(a, b)] == []


@pytest.mark.parametrize("source", ALL)
def test_every_text_of_any_shipped_drawing_stays_inside_the_picture(source):
    _, picture = picture_of(source)
    width, height = float(picture.get("width")), float(picture.get("height"))
    outside = [text for text, box in boxes(picture)
               if box[0] < 0 or box[1] < 0 or box[2] > width or box[3] > height]  # fmt: skip
    assert outside == []


@pytest.mark.parametrize("source", ALL)
def test_no_label_covers_a_robot_or_a_ball_or_a_round_obstacle(source):
    scenario, picture = picture_of(source)
    bodies = {name: (robot.start.x_m, robot.start.y_m, 0.0375) for name, robot in scenario.robots.items()}
    bodies |= {name: (*ball.start_m, ball.radius_m) for name, ball in scenario.balls.items()}
    bodies |= {name: (*thing.centre_m, thing.radius_m) for name, thing in scenario.obstacles.items()
               if thing.shape == "cylinder"}  # fmt: skip
    for name, (x, y, radius) in bodies.items():
        (left, top), (right, bottom) = px(scenario, (x - radius, y + radius)), px(scenario, (x + radius, y - radius))
        covering = [text for text, box in boxes(picture, "label") if overlap(box, (left, top, right, bottom))]
        assert covering == [], name


def px(scenario: Scenario, point: tuple[float, float]) -> tuple[float, float]:
    """Return where a point of the field is on the paper: 460 px to a metre, 0.1 m of margin around field and goals."""
    depth = max((goal.depth_m for goal in scenario.field.goals.values()), default=0.0)
    half_x, half_y = scenario.field.width_m / 2 + 0.1, scenario.field.length_m / 2 + depth + 0.1
    return (point[0] + half_x) * 460, (half_y - point[1]) * 460


@pytest.mark.parametrize("source", ALL)
def test_a_label_stands_beside_its_spot_or_a_line_leads_from_it_to_the_spot(source):
    scenario, picture = picture_of(source)
    ends = {(line.get("x2"), line.get("y2")) for line in picture.iter(f"{SVG}line") if line.get("class") == "leader"}
    for name, spot in scenario.spots.items():
        x, y = px(scenario, (spot.x_m, spot.y_m))
        near = [box for text, box in boxes(picture, "label") if text == name
                and box[0] - 20 < x < box[2] + 20 and box[1] - 20 < y < box[3] + 20]  # fmt: skip
        assert near or (f"{x:.1f}", f"{y:.1f}") in ends, name


@pytest.mark.parametrize("source", ALL)
def test_the_name_of_an_area_stands_in_it(source):
    scenario, picture = picture_of(source)
    for name, zone in scenario.zones.items():
        if zone.shape == "circle" and not zone.inverted:
            (x, y), radius = px(scenario, zone.centre_m), zone.radius_m * 460
            ((_, box),) = [one for one in boxes(picture, "label") if one[0] == name]
            assert max(math.dist((x, y), corner) for corner in ((box[0], box[1]), (box[2], box[3]))) < radius


@pytest.mark.parametrize("radius_m", [0.02, 0.03, 0.04, 0.05, 0.06, 0.07, 0.08])
@pytest.mark.parametrize("name", ["a", "nest", "treasure", "a_long_name_of_a_zone"])
def test_a_name_stands_in_a_small_circle_or_beside_it_and_not_across_its_line(name, radius_m):
    zone = f"zones: {{{name}: {{shape: circle, centre_m: [0.1, 0], radius_m: {radius_m}}}}}\n"
    scenario, picture = picture_of(f"schema_version: 1\nid: small\ntitle: Small\nextends: empty_field\n{zone}")
    (x, y), radius = px(scenario, (0.1, 0)), radius_m * 460
    ((_, (left, top, right, bottom)),) = [one for one in boxes(picture, "label") if one[0] == name]
    farthest = max(math.dist((x, y), corner) for corner in product((left, right), (top, bottom)))
    nearest = math.dist((x, y), (min(max(x, left), right), min(max(y, top), bottom)))
    assert farthest < radius or radius < nearest < radius + 12
    assert not [line for line in picture.iter(f"{SVG}line") if line.get("class") == "leader"]  # it is near enough


CROWD = """
schema_version: 1
id: crowd
title: A crowd of things with a title that is far too long for one line of the legend beside the picture
extends: soccersim_v2
entrants: {blue: null}
robots: {B3: null, B1: {start: {x_m: 0, y_m: 0.3, yaw_rad: 1, noise_m: [0, 0]}}}
spots: {SPOTS}
zones: {odd: {shape: polygon, points_m: [[0, 0], [0.1, 0], [0.2, 0.1], [0.2, 0.2], [0.1, 0.3], [0, 0.3], [-0.1, 0.2]]}}
""".replace("SPOTS", ", ".join(f"a_spot_with_the_number_{k}: {{x_m: {k * 0.01}, y_m: 0.5}}" for k in range(16)))


def test_even_in_a_crowd_each_label_is_readable_and_a_line_tells_what_it_names():
    _, picture = picture_of(CROWD)
    found = boxes(picture, "label", "number", "axis", "title", "head", "entry")
    assert [(one, other) for (one, a), (other, b) in combinations(found, 2) if overlap(a, b)] == []
    assert max(box[2] for _, box in found) <= float(picture.get("width"))
    assert sum(line.get("class") == "leader" for line in picture.iter(f"{SVG}line")) > 5


def test_a_long_name_of_a_robot_stands_beside_it():
    _, picture = picture_of(
        CROWD.replace("B1: {start", "B1: null, goalkeeper: {colour: blue, number: 4, kit: v2, start")
    )
    assert [text for text, _ in boxes(picture, "label") if text == "goalkeeper"]
    assert "goalkeeper" not in [text for text, _ in boxes(picture, "number")]


@given(
    st.lists(st.tuples(st.floats(-50, 740), st.floats(-50, 920), st.integers(1, 40)), min_size=1, max_size=12),
    st.lists(st.tuples(st.floats(0, 600), st.floats(0, 800)), max_size=4),
)
@settings(deadline=None, max_examples=25)
def test_labels_find_room_side_by_side_in_a_picture_of_the_usual_size(things, solids):
    frame = (0.0, 0.0, 690.0, 870.0)
    labels = [Label("x" * length, (x, y), (4.0, 4.0)) for x, y, length in things]
    around = Surroundings(frame, [(x, y, x + 30, y + 30) for x, y in solids])
    placed = place_labels(labels, around)
    assert [one.label for one in placed] == labels
    assert all(p.box[0] >= 0 and p.box[1] >= 0 and p.box[2] <= 690 and p.box[3] <= 870 for p in placed)
    assert not any(overlap(a.box, b.box) for a, b in combinations(placed, 2))
    assert place_labels(labels, around) == placed


@pytest.mark.nightly
def test_the_drawing_is_the_same_in_every_process():
    program = (
        "import sys\n"
        "from rcj_challenges.scenario.load import load\n"
        "from rcj_challenges.views.drawing import draw_scenario\n"
        "one = load('precision_lidar')\n"
        "sys.stdout.buffer.write(draw_scenario(one.scenario, one.roster).encode())\n"
    )
    drawings = {
        subprocess.run(
            [sys.executable, "-c", program], env={**os.environ, "PYTHONHASHSEED": seed}, capture_output=True, check=True
        ).stdout
        for seed in ("1", "2")
    }
    assert len(drawings) == 1


def test_where_rules_put_things_is_drawn_with_what_is_put_there():
    labels = texts(drawn("precision_lidar"))
    assert "put ball" in labels
    assert "B3: (0.148, 0.7)" in labels
    assert "ball: (-0.3, 0) to (0.3, 0)" in labels
    x, y = px(load("match").scenario, (0, 0.1))
    (dot,) = [
        path for path in drawn("match").iter(f"{SVG}path") if path.findtext(f"{SVG}title") == "put B3 at (0, 0.1)"
    ]
    assert f"{x - 0.006 * 460:.1f} {y - 0.006 * 460:.1f}" in dot.get("d")


MIRRORED = """
schema_version: 1
id: mirrored
title: Mirrored
extends: soccersim_v2
flags: {changed: {initial: false}}
zones: {garden: {shape: rect, x_min_m: 0.2, x_max_m: 0.4, y_min_m: 0.1, y_max_m: 0.3}}
placements:
  corner:
    - {entity: B1, at: {point: [0.1, 0.2]}, mirror: {axis: x}}
    - {entity: B2, at: {point: [0.15, 0.25]}}
    - {entity: Y1, at: start}
    - {entity: ball, at: {spot: centre_left}}
  elsewhere:
    - {entity: B3, at: {uniform_in: garden}, mirror: {axis: both}}
spots: {centre_left: {x_m: -0.2, y_m: 0.05}}
rules:
  over: {triggers: [{trigger: half_started}], actions: [{action: place, layout: corner, mirror: {axis: y, when: changed}}]}
  away: {triggers: [{trigger: half_ended}], actions: [{action: place, layout: elsewhere}]}
"""


def test_what_is_mirrored_is_drawn_where_it_is_put():
    scenario, picture = picture_of(MIRRORED)
    labels = texts(picture)
    # Mirrored by its own mirror, and while the flag is set by that of its layout too.
    assert {"B1: (-0.1, 0.2)", "B1: (-0.1, -0.2)"} <= set(labels)
    assert "B1: (0.1, 0.2)" not in labels
    assert {"B2: (0.15, 0.25)", "B2: (0.15, -0.25)"} <= set(labels)
    # Its start and the spot are drawn as such: where the mirror puts it is a place of its own.
    start = scenario.robots["Y1"].start
    assert f"Y1: ({start.x_m:g}, {-start.y_m:g}), ± 0.075, 0.075" in labels
    assert "ball: (-0.2, -0.05)" in labels
    assert "B3: in garden, mirrored (x becomes -x and y becomes -y)" in labels
    (area,) = [path for path in picture.iter(f"{SVG}path") if path.findtext(f"{SVG}title") == "put B3 anywhere in here"]
    x, y = px(scenario, (-0.2, -0.1))
    assert f"{x:.1f} {y:.1f}" in area.get("d")


def test_of_several_zones_each_is_drawn_as_a_place():
    _, picture = picture_of("""\
extends: soccersim_v2
zones:
  garden: {shape: rect, x_min_m: 0.2, x_max_m: 0.4, y_min_m: 0.1, y_max_m: 0.3}
  yard: {shape: circle, centre_m: [-0.3, 0.2], radius_m: 0.1}
groups: {outside: [garden, yard]}
rules:
  over: {triggers: [{trigger: half_started}], actions: [{action: place, entity: ball, at: {uniform_in: outside}}]}
""")
    assert {"ball: in garden", "ball: in yard"} <= set(texts(picture))
    titles = [path.findtext(f"{SVG}title") for path in picture.iter(f"{SVG}path")]
    assert titles.count("put ball anywhere in here") == 2


def test_a_name_cannot_break_out_of_the_picture():
    loaded = load("match", ["title='<script>alert(1)</script>'"])
    picture = ET.fromstring(draw_scenario(loaded.scenario, loaded.roster))
    assert not list(picture.iter(f"{SVG}script"))


def test_an_open_side_ends_at_the_paper():
    zone = RectZone(shape="rect", x_min_m=-0.35, x_max_m=0.35, y_min_m=0.59)
    assert max(y for _, y in zone_outline(zone, PAPER)) == 1.0
    assert zone_words(zone) == "-0.35 < x < 0.35, y > 0.59"


@given(st.floats(0, 2 * math.pi), st.floats(-0.5, 0.5), st.floats(-0.5, 0.5))
def test_a_half_plane_is_cut_at_its_line(angle, x, y):
    normal = (math.cos(angle), math.sin(angle))
    zone = HalfPlaneZone(shape="half_plane", through_m=(x, y), normal=normal)
    outline = zone_outline(zone, PAPER)
    depths = [(px - x) * normal[0] + (py - y) * normal[1] for px, py in outline]
    assert min(depths) > -1e-9
    assert sum(abs(depth) < 1e-9 for depth in depths) >= 2


def test_all_of_a_circle_is_at_its_radius():
    zone = CircleZone(shape="circle", centre_m=(0.1, 0.2), radius_m=0.3)
    assert all(math.isclose(math.dist(point, (0.1, 0.2)), 0.3) for point in zone_outline(zone, PAPER))
