"""Of a field of any size the whole picture can be read on a page: its texts keep their size, and its scale does not."""

from itertools import combinations

import pytest

from tests.views.test_drawing import SVG, boxes, overlap, picture_of

HARVEST = """
schema_version: 1
id: harvest
title: Harvest
extends: empty_field
field: {width_m: WIDTH, length_m: LENGTH}
robots:
  B2: null
  B3: null
  Y1: null
  Y2: null
  Y3: null
  B1: {start: {x_m: 0.4, y_m: 0.4, noise_m: [0, 0]}}
  G1: {colour: green, number: 1, kit: v2, start: {x_m: -0.4, y_m: 0.4, yaw_rad: 0}}
entrants: {blue: {robots: {B2: null, B3: null}}, yellow: null, green: {radio_channel: 4, robots: {G1: robot.py}}}
obstacles: {post: {shape: cylinder, centre_m: [0.3, -0.3], radius_m: 0.05}}
balls: {ball: {start_m: [-0.4, -0.4]}}
zones: {pitch: {x_min_m: -0.6, x_max_m: 0.6, y_min_m: -0.6, y_max_m: 0.6}}
spots: {well: {x_m: -0.2, y_m: 0}}
gates: {door: {from_m: [0.1, 0.5], to_m: [-0.1, 0.5]}}
"""


def harvest(width_m: float, length_m: float) -> str:
    return HARVEST.replace("WIDTH", str(width_m)).replace("LENGTH", str(length_m))


@pytest.mark.parametrize(("width_m", "length_m"), [(10, 10), (10, 2), (1.3, 10), (3, 3), (5, 4)])
class TestLargeFields:
    def test_the_drawing_fits_on_a_page_and_the_field_fills_it(self, width_m, length_m):
        _, picture = picture_of(harvest(width_m, length_m))
        field = _corners(picture, "the field, inside its walls")
        width, height = field[2] - field[0], field[3] - field[1]
        assert width <= 1000
        assert height <= 1500
        assert width > 900 or height > 1300
        assert width / height == pytest.approx(width_m / length_m, rel=0.01)

    def test_all_texts_can_be_read(self, width_m, length_m):
        _, picture = picture_of(harvest(width_m, length_m))
        found = boxes(picture, "label", "number", "axis")
        assert {"B1", "G1", "post", "ball", "pitch", "well", "door"} <= {text for text, _ in found}
        assert [(one, other) for (one, a), (other, b) in combinations(found, 2) if overlap(a, b)] == []
        right, bottom = float(picture.get("width")), float(picture.get("height"))
        assert [text for text, (x, y, x2, y2) in boxes(picture) if x < 0 or y < 0 or x2 > right or y2 > bottom] == []

    def test_the_name_of_a_robot_stands_in_its_body_or_beside_it_in_dark_letters(self, width_m, length_m):
        _, picture = picture_of(harvest(width_m, length_m))
        body = _corners(picture, "B1 at its start")
        inside = [box for text, box in boxes(picture, "number") if text == "B1"]
        beside = [box for text, box in boxes(picture, "label") if text == "B1"]
        assert len(inside) + len(beside) == 1
        assert all(body[0] <= box[0] and box[2] <= body[2] for box in inside)
        assert not any(overlap(body, box) for box in beside)

    def test_marks_keep_their_size(self, width_m, length_m):
        _, picture = picture_of(harvest(width_m, length_m))
        across = [line for line in picture.iter(f"{SVG}line") if _title(line) == "well"]
        assert max(float(line.get("x2")) - float(line.get("x1")) for line in across) == pytest.approx(11, abs=0.2)
        (forward,) = [line for line in picture.iter(f"{SVG}line") if _title(line) == "forward"]
        assert abs(float(forward.get("y2")) - float(forward.get("y1"))) == pytest.approx(23, abs=0.2)


def _title(element) -> str:
    return element.findtext(f"{SVG}title") or ""


def _corners(picture, title: str) -> tuple[float, float, float, float]:
    """Return left, top, right, bottom of the outline that has a title, in px."""
    (path,) = [path for path in picture.iter(f"{SVG}path") if _title(path) == title]
    numbers = [float(one) for one in path.get("d").replace("M", "").replace("L", "").replace("Z", "").split()]
    return min(numbers[::2]), min(numbers[1::2]), max(numbers[::2]), max(numbers[1::2])
