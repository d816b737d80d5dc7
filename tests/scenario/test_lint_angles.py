"""Lint of angles that somebody wrote in degrees."""

import pytest

from rcj_challenges.scenario.lint.table import lint
from rcj_challenges.scenario.load import load_text
from tests.scenario.writing import HEAD, rule


def found(body):
    return [str(one) for one in lint(load_text(HEAD + body, file="a.yaml")) if one.kind == "angle_in_degrees"]


def test_a_start_that_looks_in_degrees():
    (text,) = found("robots: {Y1: {start: {x_m: 0.5, y_m: 0, yaw_rad: 90}}}\n" + rule())
    assert text.partition("warning: ")[2] == (
        "robots.Y1.start.yaw_rad: angles are in rad, and 90 rad are more than a full turn, which is 6.2832; if degrees are "
        "meant, write 1.5708; else leave the full turns out [angle_in_degrees]"
    )


@pytest.mark.parametrize(
    ("body", "count"),
    [
        (rule(action="{action: place, entity: Y1, at: start, facing: -180}"), 1),
        (rule(action="{action: place, entity: Y1, at: start, facing: -3.1416}"), 0),
        (rule(action="{action: place, entity: Y1, at: start, facing: keep}"), 0),
        (rule(rest="    conditions: [{condition: looks, entity: Y1, heading_rad: 45}]\n"), 1),
        ("obstacles: {box: {shape: box, centre_m: [0.5, 0.5], size_m: [0.1, 0.1], yaw_rad: 45}}\n" + rule(), 1),
        ("params: {way: 90}\nrobots: {Y1: {start: {yaw_rad: {param: way}}}}\n" + rule(), 1),
        ("robots: {Y1: {start: {yaw_rad: 4.7124}}}\n" + rule(), 0),
        # A full turn, as people round it; 6.2832 is what the reference says of a laser scanner.
        ("robots: {Y1: {devices: {laser: {device: lidar, field_of_view_rad: 6.2832}}}}\n" + rule(), 0),
        (rule(action="{action: place, entity: Y1, at: start, facing: -6.284}"), 0),
    ],
)
def test_wherever_an_angle_stands(body, count):
    assert len(found(body)) == count


@pytest.mark.parametrize("hand", ["place", "move"])
def test_a_hand_that_turns_a_robot_in_degrees(hand):
    keyframes = f"[{{at_s: 0}}, {{at_s: 1, {hand}: {{Y1: [0, -0.3, 1.57], Y2: [0.4, -0.3, -90]}}}}]"
    (text,) = found(rule() + f"expect: {{it_turns: {{keyframes: {keyframes}, lasts_s: 2}}}}\n")
    assert f"expect.it_turns.keyframes[1].{hand}.Y2[2]: angles are in rad, and -90 rad" in text
    assert "write -1.5708" in text
