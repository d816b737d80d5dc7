"""The drawing shows what the referee tests, from the same numbers."""

import math
import xml.etree.ElementTree as ET

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.scenario.load import load
from rcj_challenges.scenario.models.places import CircleZone, HalfPlaneZone, RectZone
from rcj_challenges.views.drawing import draw_scenario
from rcj_challenges.views.drawing.shapes import zone_outline, zone_words

SVG = "{http://www.w3.org/2000/svg}"
SHIPPED = ("match", "fast_shooter", "pass_the_ball", "precision_lidar")
PAPER = (-1.0, -1.0, 1.0, 1.0)


def drawn(name: str, *overrides: str) -> ET.Element:
    loaded = load(name, overrides)
    return ET.fromstring(draw_scenario(loaded.scenario, loaded.roster))


def texts(picture: ET.Element) -> list[str]:
    return [element.text or "" for element in picture.iter(f"{SVG}text")]


@pytest.mark.parametrize("name", SHIPPED)
def test_every_zone_spot_gate_and_robot_is_labelled(name):
    scenario = load(name).scenario
    labels = texts(drawn(name))
    for thing in (*scenario.zones, *scenario.spots, *scenario.gates, *scenario.robots, *scenario.balls):
        assert any(thing in label for label in labels), thing


def test_the_drawing_moves_when_a_number_changes():
    before = {element.get("d") for element in drawn("match").iter(f"{SVG}path")}
    after = {element.get("d") for element in drawn("match", "zones.blue_goal.x_max_m=0.1").iter(f"{SVG}path")}
    assert before != after


def test_the_legend_tells_the_number_that_the_referee_tests():
    assert any(
        "-0.2 < x < 0.1, 0.745 < y < 0.849" in text for text in texts(drawn("match", "zones.blue_goal.x_max_m=0.1"))
    )


def test_labels_do_not_cover_each_other():
    boxes = []
    for element in drawn("match").iter(f"{SVG}text"):
        if element.get("class") == "label":
            half = len(element.text or "") * 6.1 / 2
            x, y = float(element.get("x")), float(element.get("y"))
            boxes.append((x - half, y - 9, x + half, y + 2))
    for k, a in enumerate(boxes):
        for b in boxes[k + 1 :]:
            assert not (a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3])


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
