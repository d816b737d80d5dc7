"""The drawing of a team's designs."""

import math
import re
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest
from typer.testing import CliRunner

from rcj_challenges.cli.commands import load_app
from rcj_challenges.core.diagnostics import DiagnosticError
from rcj_challenges.views.drawing.designs import draw_designs
from tests.scenario.test_designs import design, judged
from tests.views.test_drawing import extent_px, legend, titled

TEAMS = Path(__file__).resolve().parents[2] / "examples" / "teams"
WORKSHOP = ("workshop_classic", "workshop_keeper", "workshop_striker")


def drawn(text: str) -> ET.Element:
    return ET.fromstring(draw_designs("Us", judged(text)))


def centre_and_radius(picture: ET.Element) -> tuple[tuple[float, float], float]:
    (cylinder,) = titled(picture, "the cylinder of 0.12 m")
    return (float(cylinder.get("cx")), float(cylinder.get("cy"))), float(cylinder.get("r"))


def places(picture: ET.Element, title: str) -> list[tuple[float, float]]:
    (shape,) = titled(picture, title)
    return [(float(x), float(y)) for x, y in re.findall(r"(-?[\d.]+) (-?[\d.]+)", shape.get("d"))]


def test_robot_is_drawn_to_scale_in_its_cylinder_with_its_front_at_the_top():
    picture = drawn(design(", shape: flat_front, jaws_m: [0.006, 0.05]"))
    (x, y), radius = centre_and_radius(picture)
    left, top, right, _ = extent_px(*titled(picture, "body"))
    assert (right - left) / (2 * radius) == pytest.approx(0.075 / 0.12, rel=0.02)
    assert (left + right) / 2 == pytest.approx(x, abs=0.2)
    assert (y - top) / radius == pytest.approx(0.8 * 0.0375 / 0.06, rel=0.01)
    assert extent_px(*titled(picture, "left jaw"))[2] < x < extent_px(*titled(picture, "right jaw"))[0]
    assert extent_px(*titled(picture, "left jaw"))[1] < top
    assert all(titled(picture, f"wheel {number}") for number in range(4))


@pytest.mark.parametrize(("chassis", "colour"), [("", "#495057"), (", wheel_ring_m: 0.06", "#c92a2a")])
def test_cylinder_is_red_if_the_robot_does_not_fit(chassis, colour):
    (cylinder,) = titled(drawn(design(chassis)), "the cylinder of 0.12 m")
    assert cylinder.get("stroke") == colour


@pytest.mark.parametrize(
    ("device", "middle_rad", "wide_rad"),
    [
        ("camera, field_of_view_rad: 1.0", 0, 1.0),
        ("camera, bearing_rad: 1.5708", math.pi / 2, 1.0472),
        ("sonar, bearing_rad: 3.1416", math.pi, 0),
        ("touch_sensor, bearing_rad: -1.5708, angle_rad: 0.8", -math.pi / 2, 0.8),
    ],
)
def test_views_begin_at_the_device_and_are_as_wide_as_what_it_takes_in(device, middle_rad, wide_rad):
    picture = drawn(design(devices=f", it: {{device: {device}}}"))
    (apex_x, apex_y), *rim = places(picture, "what it looks at")
    bearings = [math.atan2(apex_x - x, apex_y - y) for x, y in (rim[0], rim[-1])]
    off = [math.remainder(bearing - middle_rad, math.tau) for bearing in bearings]
    assert off == pytest.approx([-wide_rad / 2, wide_rad / 2], abs=0.01)


def test_panorama_and_lidar_look_all_around():
    picture = drawn(design(devices=", it: {device: camera, field_of_view_rad: 6.2832, ahead_m: 0}"))
    rim, (centre, _) = places(picture, "what it looks at"), centre_and_radius(picture)
    distances = [math.dist(centre, point) for point in rim]
    assert max(distances) - min(distances) < 1


def test_legend_has_every_device_with_its_price_and_each_design_its_cost():
    picture = drawn(design(devices=", front eye: {device: camera}, kicker: {device: kicker}"))
    lines = legend(picture)
    assert {"omni drive, 1200", "front eye: camera, 600", "kicker, 400", "m1: motor of wheel 1"} <= set(lines)
    heads = [element.text for element in picture.iter() if element.get("class") == "head"]
    assert "striker (robots 1, 2 and 3): 2200 of 3000 points" in heads


def test_problems_of_a_design_are_in_the_legend():
    text = design(", mass_kg: 1")
    words = " ".join(legend(drawn(text)))
    assert all(problem.message in words for problem in judged(text).problems)


@pytest.mark.parametrize("name", WORKSHOP)
def test_command_draws_the_designs_of_a_team(tmp_path, name):
    out = tmp_path / "design.svg"
    done = CliRunner().invoke(load_app(), ["draw", "workshop", "--design", str(TEAMS / name), "--out", str(out)])
    assert done.exit_code == 0
    picture = ET.fromstring(out.read_text(encoding="utf-8"))
    assert len(titled(picture, "body")) == (2 if name == "workshop_keeper" else 1)


@pytest.mark.parametrize(("scenario", "team"), [("match", "workshop_striker"), ("workshop", "ball_chaser")])
def test_what_has_no_design_is_not_drawn(scenario, team):
    with pytest.raises(DiagnosticError):
        load_app()(["draw", scenario, "--design", str(TEAMS / team)], standalone_mode=False)
